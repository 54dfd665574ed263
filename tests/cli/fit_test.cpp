// lrcs fit, as a user runs it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "brdf/brdf_form.h"
#include "brdf/library.h"
#include "brdf/material_yaml.h"
#include "tests/cli/made_scene.h"
#include "tests/cli/program.h"

namespace lrcs {
namespace {

using Json = nlohmann::json;

// Little search: clean data of a published set need no more.
const Words quickly{"--starts", "4", "--neighbours", "2"};

std::string made_data(const std::string& material = "metal-skin-5p") {
  return run_lrcs({"brdf", material, "--theta-i", "0,10,30,50", "--step", "4", "-q"}).out;
}

std::string replaced(std::string text, const std::string& piece, const std::string& other) {
  const std::size_t at = text.find(piece);
  if (at == std::string::npos) throw std::invalid_argument("no such piece: " + piece);
  return text.replace(at, piece.size(), other);
}

constexpr const char* columns = "theta_i_deg,theta_r_deg,phi_deg,f_r_per_sr\n";

// A lobe that no model is made for, in six samples.
std::string small_data() {
  return std::string(columns) + "0,10,180,0.3\n0,30,180,0.2\n10,10,180,0.5\n10,40,180,0.15\n30,30,180,0.6\n" +
         "30,-30,180,0.1\n";
}

// Every row with its azimuth turned by 180 deg, or its value times the cosine; the header says so.
std::string in_other_convention(const std::string& data, bool is_turned, bool has_cosine) {
  std::istringstream lines(data);
  std::string text = "# wavelength: 1.06 um\n";
  text += is_turned ? "# azimuth_of_specular: 0\n" : "";
  text += has_cosine ? "# value: brdf_cosine\n" : "";
  text += columns;
  for (std::string line; std::getline(lines, line);) {
    double i = 0.0, r = 0.0, phi = 0.0, f = 0.0;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &i, &r, &phi, &f) != 4) continue;
    if (has_cosine) f *= std::cos(r * std::numbers::pi / 180.0);
    std::array<char, 200> row{};
    std::snprintf(row.data(), row.size(), "%.17g,%.17g,%.17g,%.17g\n", i, r, is_turned ? phi + 180.0 : phi, f);
    text += row.data();
  }
  return text;
}

Json facts(const ScratchFolder& folder, const std::string& name = "fit.json") {
  return Json::parse(folder.read(name));
}

std::string form_of(const std::string& yaml) {
  return yaml.substr(0, yaml.find('\n'));
}

TEST(Fit, OfTheProgramsOwnTableFindsTheMaterialAgain) {
  const ScratchFolder folder;
  folder.write("five.csv", made_data("metal-skin-5p"));
  folder.write("nine.csv", made_data("metal-skin-9p"));
  for (const auto& [data, form, library] :
       {std::array{"five.csv", "five_parameter", "metal-skin-5p"}, {"nine.csv", "nine_parameter", "metal-skin-9p"}}) {
    const Outcome outcome = run_lrcs({"fit", data, "--model", form, "-o", "fit.yaml", "-q"}, {folder.path()});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("parameter"), std::string::npos);
    const Json json = facts(folder);
    EXPECT_LT(json["e_percent"], 1e-10);
    EXPECT_EQ(json["model"], form);
    const Material material = material_from_words((folder.path() / "fit.yaml").string());
    EXPECT_NEAR(material.wavelength, 1.06e-6, 1e-18);
    const BrdfWords words = words_of(material.brdf), truth = words_of(find_in_library(library)->brdf);
    EXPECT_EQ(words.form, truth.form);
    EXPECT_EQ(words.azimuth_of_specular, 180);
    for (std::size_t k = 0; k < words.values.size(); ++k)
      EXPECT_EQ(json["parameters"][words.form->parameters[k]]["value"], words.values[k]);
    for (const std::size_t k : {0U, 2U, 3U, 4U})  // kb, b, a, kd; those of G may lie anywhere in a flat valley
      EXPECT_NEAR(words.values[k] / truth.values[k], 1.0, 1e-3) << words.form->parameters[k];
  }
}

TEST(Fit, WithFiveParametersToDataOfNineIsClose) {
  const ScratchFolder folder;
  folder.write("data.csv", made_data("metal-skin-9p"));
  const Outcome outcome = run_lrcs({"fit", "data.csv", "-o", "fit.yaml", "-q"}, {folder.path()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(facts(folder)["model"], "five_parameter");
  EXPECT_GT(facts(folder)["e_percent"], 1e-6);
  EXPECT_LT(facts(folder)["e_percent"], 2.0);  // docs/methods.md: 1.1 %
}

TEST(Fit, OfAllModelsWritesTheOneThatMadeTheData) {
  const ScratchFolder folder;
  folder.write("truth.yaml", "{model: phong, kd: 0.3, ks: 0.5, m: 25}\n");
  folder.write("data.csv", run_lrcs({"brdf", "truth.yaml", "--theta-i", "0,10,30,50", "-q"}, {folder.path()}).out);
  const Outcome outcome =
      run_lrcs(with({"fit", "data.csv", "--model", "all", "-o", "fit.yaml", "-q"}, quickly), {folder.path()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(form_of(folder.read("fit.yaml")), "model: phong");
  EXPECT_EQ(facts(folder)["model"], "phong");
  for (const BrdfForm& form : brdf_forms())
    EXPECT_NE(outcome.out.find("\n" + form.name + " "), std::string::npos) << form.name;
}

TEST(Fit, OfAllModelsWritesFiveParametersWhereNineFitNoBetter) {
  const ScratchFolder folder;
  folder.write("data.csv", made_data("metal-skin-5p"));
  ASSERT_EQ(run_lrcs(with({"fit", "data.csv", "-m", "all", "-o", "fit.yaml", "-q"}, quickly), {folder.path()}).status,
            0);
  EXPECT_EQ(form_of(folder.read("fit.yaml")), "model: five_parameter");
}

TEST(Fit, WritesAMaterialThatSceneAndTableTake) {
  const ScratchFolder folder;
  folder.write("data.csv", made_data());
  folder.write("box.stl", two_boxes());
  ASSERT_EQ(run_lrcs(with({"fit", "data.csv", "-o", "fit.yaml", "-q"}, quickly), {folder.path()}).status, 0);
  const std::string yaml = folder.read("fit.yaml");
  EXPECT_NE(yaml.find("\nwavelength: 1.06 um\n"), std::string::npos) << yaml;
  EXPECT_NE(yaml.find("\nazimuth_of_specular: 180\n"), std::string::npos) << yaml;
  std::string indented = "\n";
  std::istringstream lines(yaml);
  for (std::string line; std::getline(lines, line);) indented += "    " + line + "\n";
  indented.pop_back();
  folder.write("scene.yaml", scene_with(" {library: metal-skin-5p}", indented));
  const Outcome scene = run_lrcs({"check", "scene.yaml"}, {folder.path()});
  EXPECT_EQ(scene.status, 0) << scene.err;
  const Outcome table = run_lrcs({"brdf", "fit.yaml", "-q"}, {folder.path()});
  EXPECT_EQ(table.status, 0) << table.err;
  EXPECT_NE(table.out.find("five_parameter"), std::string::npos);
}

TEST(Fit, IsTheSameInEveryConventionThatTheHeaderOrAFlagNames) {
  const ScratchFolder folder;
  const std::string data = made_data();
  folder.write("plain.csv", in_other_convention(data, false, false));
  folder.write("turned.csv", in_other_convention(data, true, false));
  folder.write("cosine.csv", in_other_convention(data, false, true));
  folder.write("untold.csv", replaced(replaced(in_other_convention(data, true, true), "# value: brdf_cosine\n", ""),
                                      "# azimuth_of_specular: 0\n", ""));
  const auto fit = [&](const Words& words) {
    const Outcome outcome =
        run_lrcs(with(with({"fit"}, words), with(quickly, {"-o", "fit.yaml", "-q"})), {folder.path()});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return facts(folder);
  };
  const Json plain = fit({"plain.csv"});
  for (const Words& words :
       {Words{"turned.csv"}, {"cosine.csv"}, {"untold.csv", "--azimuth-of-specular", "0", "--value", "brdf_cosine"}}) {
    const Json other = fit(words);
    EXPECT_LT(other["e_percent"], 1e-10);
    EXPECT_EQ(other["azimuth_of_specular"], 180);
    for (const char* name : {"kb", "kr", "b", "a", "kd"})
      EXPECT_NEAR(other["parameters"][name]["value"].get<double>() / plain["parameters"][name]["value"].get<double>(),
                  1.0, 1e-6)
          << words[0] << " " << name;
  }
  EXPECT_GT(fit({"untold.csv"})["e_percent"], 1.0);  // the flags are of effect
}

struct BadData {
  std::string data, message;
};

TEST(BadFitData, IsOneLineThatSaysWhereAndNothingIsWritten) {
  const std::string good = small_data();
  const std::vector<BadData> bad{
      {replaced(good, "0,30,180,0.2", "0,30,180,bright"), "data.csv:3:10: "},
      {replaced(good, "0,30,180,0.2", "0,30,180,nan"), "data.csv:3:10: "},
      {replaced(good, "0,30,180,0.2", "0,30,180,inf"), "data.csv:3:10: "},
      {replaced(good, "0,30,180,0.2", "0,30,180,-0.2"), "data.csv:3:10: expected a value that is not negative"},
      {replaced(good, "0,30,180,0.2", "0,91,180,0.2"), "data.csv:3:3: expected an angle from the normal of at most 90"},
      {replaced(good, "0,30,180,0.2", "0,30,180"), "data.csv:3:"},
      {replaced(good, "0,30,180,0.2", "0,30,180,0.2,1,2"), "data.csv:3:"},
      {replaced(good, "theta_i_deg", "theta_i_rad"), "data.csv:1:1: expected a column 'theta_i_deg', found"},
      {replaced(good, "f_r_per_sr", "f_r"), "data.csv:1:33: expected a column 'f_r_per_sr', found 'f_r'"},
      {replaced(good, ",phi_deg", ""), "data.csv:1:"},
      {std::string(columns) + "0,10,180,0\n0,20,180,0\n", "data.csv: all 2 values of f_r are 0"},
      {std::string(columns) + "0,10,180,1\n0,20,180,1\n10,20,180,1\n10,30,180,1\n",
       "data.csv: 4 samples, but five_parameter has 5 parameters"},
      {columns, "data.csv: "},
      {"", "data.csv: "},
      {"hello\n", "data.csv"},
  };
  const ScratchFolder folder;
  for (const BadData& wrong : bad) {
    folder.write("data.csv", wrong.data);
    const Outcome outcome = run_lrcs({"fit", "data.csv", "-o", "fit.yaml", "-q"}, {folder.path()});
    EXPECT_EQ(outcome.status, 2) << wrong.data;
    EXPECT_EQ(outcome.err.rfind("lrcs: " + wrong.message, 0), 0U) << outcome.err << wrong.message;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(folder.has("fit.yaml") || folder.has("fit.json")) << wrong.data;
  }
}

struct BadWords {
  Words words;
  std::string message;
};

TEST(BadFitUsage, IsOneLineThatSaysWhatWasExpectedAndNothingIsWritten) {
  const ScratchFolder folder;
  folder.write("data.csv", made_data());
  folder.write("zero.csv", replaced(small_data(), "0,30,180,0.2", "0,30,180,0"));
  folder.write("dark.csv", std::string(columns) + "0,10,180,0\n0,20,180,0\n30,0,180,1\n30,10,180,1\n30,20,180,1\n");
  const std::vector<BadWords> bad{
      {{"data.csv", "--model", "five_paramter"},
       "--model: unknown model 'five_paramter', did you mean 'five_parameter'? (known: all, lambert, "},
      {{"data.csv", "--modle", "phong"}, "unknown flag '--modle', did you mean '--model'? (see lrcs fit --help)"},
      {{"none.csv"}, "none.csv: cannot be read: No such file or directory"},
      {{"data.csv", "-o", "none/fit.yaml"}, "--output: no such folder: 'none'"},
      {{"data.csv", "-o", "fit.json"}, "--output: expected a file that ends in .yaml, found 'fit.json'"},
      {{"data.csv", "-o", "fit"}, "--output: expected a file that ends in .yaml, found 'fit'"},
      {{"data.csv", "--wavelength", "1.55 um"}, "--wavelength: data.csv was measured at 1.06 um, not at 1.55 um"},
      {{"data.csv", "--wavelength", "1.55"}, "--wavelength: expected a positive length with its unit"},
      {{"data.csv", "--incidence", "20"}, "--incidence: no samples at 20 deg, measured were 0, "},
      {{"data.csv", "--incidence", "0,20"}, "--incidence: no samples at 20 deg, measured were 0, "},
      {{"dark.csv", "--incidence", "0", "--model", "lambert"}, "dark.csv: no f_r above 1e-150 in the 2 samples"},
      {{"data.csv", "--residual", "lg"}, "--residual: expected linear or log, found 'lg'"},
      {{"data.csv", "--value", "cosine"}, "--value: expected brdf or brdf_cosine, found 'cosine'"},
      {{"data.csv", "--azimuth-of-specular", "90"}, "--azimuth-of-specular: expected 180 or 0, found '90'"},
      {{"data.csv", "--azimuth-of-specular", "0"}, "data.csv:"},  // the file says 180
      {{"zero.csv", "--residual", "log"}, "zero.csv:3: expected f_r > 0 for logarithmic residuals, found 0"},
      {{"data.csv", "--population", "1"}, "--population: expected a whole number, 2 to 100000, found '1'"},
      {{"data.csv", "--starts", "1.5"}, "--starts: expected a whole number, 0 to 100000, found '1.5'"},
      {{"data.csv", "--cooling", "0"}, "--cooling: expected a number, 1e-6 to 1, found '0'"},
      {{"data.csv", "--cooling", "nan"}, "--cooling: expected a number, 1e-6 to 1, found 'nan'"},
      {{"data.csv", "--crossover", "nan"}, "--crossover: expected a number, 0 to 1, found 'nan'"},
      {{"data.csv", "--temperature", "inf"}, "--temperature: expected a number, 1e-6 to 1e6, found 'inf'"},
      {{"data.csv", "--seed", "-1"}, "--seed: expected a whole number below 2^64, found '-1'"},
      {{"data.csv", "--seed", "99999999999999999999"}, "--seed: expected a whole number below 2^64, found '9999"},
  };
  for (const BadWords& wrong : bad) {
    Words words{"fit"};
    if (std::find(wrong.words.begin(), wrong.words.end(), "-o") == wrong.words.end())
      words.insert(words.end(), {"-o", "fit.yaml"});
    const Outcome outcome = run_lrcs(with(words, with(wrong.words, {"-q"})), {folder.path()});
    EXPECT_EQ(outcome.status, 2) << wrong.message;
    EXPECT_EQ(outcome.err.rfind("lrcs: " + wrong.message, 0), 0U) << outcome.err << wrong.message;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "") << wrong.message;
    EXPECT_FALSE(folder.has("fit.yaml") || folder.has("fit.json") || folder.has("fit")) << wrong.message;
  }
}

TEST(BadFitUsage, DoesNotOverwriteTheData) {
  const ScratchFolder folder;
  for (const char* name : {"fit.yaml", "fit.json", "fit.png", "fit-shadowing.png"}) {
    folder.write(name, made_data());
    const Outcome outcome = run_lrcs({"fit", name, "-o", "fit.yaml", "-q"}, {folder.path()});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, fmt::format("lrcs: --output: would overwrite the data, '{}'\n", name));
    EXPECT_EQ(folder.read(name), made_data());
    std::filesystem::remove(folder.path() / name);
  }
}

TEST(Fit, SaysHowTheFileWasRead) {
  const ScratchFolder folder;
  folder.write("data.csv", made_data() + "10,90,0,0.1,1\n");
  const Outcome outcome = run_lrcs(with({"fit", "data.csv"}, quickly), {folder.path()});
  EXPECT_NE(outcome.err.find("lrcs: note: azimuth of specular: 180 deg"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("lrcs: note: 1 value at 90 deg from the normal"), std::string::npos) << outcome.err;
}

TEST(Fit, SaysWhyThereIsNoPictureOfDataOffThePlane) {
  const ScratchFolder folder;
  folder.write("data.csv", std::string(columns) + "10,10,90,0.3\n10,30,90,0.2\n30,10,90,0.25\n30,40,90,0.15\n");
  const Words words{"fit", "data.csv", "-m", "lambert", "-o", "fit.yaml"};
  const Outcome outcome = run_lrcs(words, {folder.path()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("lrcs: warning: no picture: no sample lies in the plane of incidence\n"),
            std::string::npos)
      << outcome.err;
  EXPECT_FALSE(folder.has("fit.png"));
  EXPECT_EQ(run_lrcs(with(words, {"-q"}), {folder.path()}).err, "");
}

TEST(Fit, DrawsLogarithmicResidualsOfASampleThatDoesNotCount) {
  const ScratchFolder folder;
  folder.write("data.csv",
               "theta_i_deg,theta_r_deg,phi_deg,f_r_per_sr,weight\n0,10,0,0.3,1\n0,30,0,0.2,1\n10,20,0,0,0\n");
  const Outcome outcome =
      run_lrcs({"fit", "data.csv", "-m", "lambert", "--residual", "log", "-o", "fit.yaml", "-q"}, {folder.path()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(folder.read("fit.png").substr(1, 3), "PNG");
}

TEST(Fit, DrawsSvgWhereAsked) {
  const ScratchFolder folder;
  folder.write("data.csv", made_data());
  const Words words{"fit", "data.csv", "-m", "lambert", "-o", "漆.yaml", "--pictures", "svg", "-q"};
  ASSERT_EQ(run_lrcs(words, {folder.path()}).status, 0);
  EXPECT_NE(folder.read("漆.svg").find("<svg"), std::string::npos);
  EXPECT_FALSE(folder.has("漆.png"));
  const Outcome wrong = run_lrcs({"fit", "data.csv", "--pictures", "pdf"}, {folder.path()});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(wrong.err, "lrcs: --pictures: expected png or svg, found 'pdf'\n");
}

TEST(Fit, WarnsOfOneAngleOfIncidenceUnlessQuiet) {
  const ScratchFolder folder;
  folder.write("data.csv", run_lrcs({"brdf", "metal-skin-5p", "--theta-i", "30", "-q"}).out);
  const Words words = with({"fit", "data.csv"}, quickly);
  const Outcome loud = run_lrcs(words, {folder.path()});
  EXPECT_EQ(loud.status, 0);
  EXPECT_NE(loud.err.find("lrcs: warning: only one angle of incidence, 30 deg"), std::string::npos) << loud.err;
  EXPECT_EQ(run_lrcs(with(words, {"-q"}), {folder.path()}).err, "");
}

TEST(Fit, WarnsWhereTheAnglesAskedForAreOne) {
  const ScratchFolder folder;
  folder.write("data.csv", made_data());
  const Outcome outcome = run_lrcs(with({"fit", "data.csv", "--incidence", "30"}, quickly), {folder.path()});
  EXPECT_NE(outcome.err.find("lrcs: warning: only one angle of incidence, 30 deg"), std::string::npos) << outcome.err;
}

TEST(Fit, WritesTheSameBytesForAnyNumberOfThreads) {
  const ScratchFolder folder;
  folder.write("data.csv", made_data("metal-skin-9p"));
  for (const char* threads : {"1", "2"}) {
    const Words words = with({"fit", "data.csv", "--model", "all", "-q", "-t", threads}, quickly);
    EXPECT_EQ(run_lrcs(with(words, {"-o", std::string("fit") + threads + ".yaml"}), {folder.path()}).status, 0);
  }
  EXPECT_NE(folder.read("fit1.yaml"), "");
  EXPECT_EQ(folder.read("fit1.yaml"), folder.read("fit2.yaml"));
  EXPECT_EQ(folder.read("fit1.json"), folder.read("fit2.json"));
}

TEST(Fit, TakesAFileNameThatIsNoUtf8) {
  const ScratchFolder folder;
  folder.write("t\xf6ne.csv", made_data());
  const Outcome outcome = run_lrcs(with({"fit", "t\xf6ne.csv", "-o", "fit.yaml", "-q"}, quickly), {folder.path()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(facts(folder)["model"], "five_parameter");
  EXPECT_EQ(run_lrcs({"brdf", "fit.yaml", "-q"}, {folder.path()}).status, 0);
}

}  // namespace
}  // namespace lrcs
