#include "fit/fit_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/fit/goniometer_data.h"

namespace lrcs {
namespace {

using Json = nlohmann::json;

FitOptions quickly() {
  FitOptions options;
  options.starts = 4;
  options.neighbours = 2;
  return options;
}

std::string json_of(const BrdfMeasurement& data, const char* form, const FitOptions& options = quickly()) {
  return fit_json(fit_brdf(data, form, options), data);
}

void expect_correlation(const Json& correlation, std::size_t size) {
  ASSERT_EQ(correlation.size(), size);
  for (std::size_t i = 0; i < size; ++i) {
    ASSERT_EQ(correlation[i].size(), size);
    EXPECT_EQ(correlation[i][i], 1.0);
    for (std::size_t j = 0; j < size; ++j) {
      ASSERT_TRUE(correlation[i][j].is_number());
      EXPECT_EQ(correlation[i][j], correlation[j][i]);
      EXPECT_LE(std::abs(correlation[i][j].get<double>()), 1.0 + 1e-12);
    }
  }
}

void expect_parameter(const Json& entry) {
  EXPECT_TRUE(entry["value"].is_number());
  EXPECT_TRUE(entry["determined"].is_boolean());
  if (entry["determined"].get<bool>()) {
    EXPECT_TRUE(entry["standard_error"].is_number());
    EXPECT_LE(entry["interval_95"][0], entry["value"]);
    EXPECT_GE(entry["interval_95"][1], entry["value"]);
  } else {
    EXPECT_TRUE(entry["reason"].is_string());
  }
}

TEST(FitJson, HoldsTheKeysOfTheContract) {
  auto bright = goniometer_samples(Lambert(1.0));
  for (BrdfSample& s : bright) s.f_r *= 2.0;
  for (const auto& data : {goniometer_data(published("metal-skin-9p"), 0.03, 1), at_1_06_um(bright)})
    for (const BrdfForm& form : brdf_forms()) {
      const std::string text = json_of(data, form.name.c_str());
      const Json json = Json::parse(text);
      EXPECT_EQ(json["model"], form.name);
      EXPECT_TRUE(json["e_percent"].is_number());
      EXPECT_GT(json["evaluations"], 0);
      EXPECT_EQ(json["seed"], 1);
      EXPECT_TRUE(json["status"].is_string());
      EXPECT_EQ(json["wavelength_m"], 1.06e-6);
      EXPECT_EQ(json["samples"], data.samples.size());
      ASSERT_EQ(json["parameters"].size(), form.parameters.size());
      for (const std::string& name : form.parameters) {
        ASSERT_TRUE(json["parameters"].contains(name)) << name;
        expect_parameter(json["parameters"][name]);
        if (!json["parameters"][name]["determined"].get<bool>()) {
          EXPECT_NE(json["status"].get<std::string>().find(name), std::string::npos);
        }
      }
      expect_correlation(json["correlation"], form.parameters.size());
      EXPECT_EQ(text.find("nan"), std::string::npos);
    }
}

TEST(FitJson, IsTheSameBytesForTheSameSeedOnAnyThread) {
  const auto data = goniometer_data(published("metal-skin-9p"), 0.03, 2);
  const std::string alone = json_of(data, "nine_parameter");
  std::string first, second;
  std::thread a([&] { first = json_of(data, "nine_parameter"); });
  std::thread b([&] { second = json_of(data, "nine_parameter"); });
  a.join();
  b.join();
  EXPECT_EQ(first, alone);
  EXPECT_EQ(second, alone);
}

TEST(FitJson, TakesNamesThatAreNoUtf8) {
  auto data = goniometer_data(Lambert(0.5), 0.03, 3);
  data.name = "t\xf6ne.csv";
  data.notes = {"\xff"};
  EXPECT_EQ(Json::parse(json_of(data, "lambert"))["data"], "t\xef\xbf\xbdne.csv");
}

TEST(FitText, NamesEveryParameterAndWhatIsNotDetermined) {
  const auto data = goniometer_data(published("metal-skin-9p"), 0.03, 4);
  const BrdfFit fit = fit_brdf(data, "nine_parameter", quickly());
  const std::string text = fit_text(fit);
  for (const FittedParameter& p : fit.parameters) {
    EXPECT_NE(text.find("\n" + p.name + " "), std::string::npos) << text;
    if (!p.determined) {
      EXPECT_NE(text.find("not determined: " + p.why_not), std::string::npos) << p.name;
    }
  }
  EXPECT_NE(text.find("1.06 um"), std::string::npos) << text;
}

TEST(ComparisonText, PutsTheModelFirstThatMadeTheData) {
  const auto data = goniometer_data(Brdf(Phong(0.3, 0.5, 25.0)), 0.03, 5);
  std::vector<BrdfFit> fits;
  for (const char* form : {"lambert", "five_parameter", "phong", "cook_torrance_ggx"})
    fits.push_back(fit_brdf(data, form, quickly()));
  const std::string text = comparison_text(fits);
  EXPECT_EQ(text.substr(text.find('\n') + 1, 5), "phong") << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
}

}  // namespace
}  // namespace lrcs
