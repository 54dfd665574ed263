#include "brdf/material_yaml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/brdf/sample_brdfs.h"

namespace lrcs {
namespace {

Material read(const std::string& yaml) {
  return material_from_yaml(LocatedYaml::of_text(yaml, "scene.yaml"), "skin");
}

std::string complaint(const std::string& yaml) {
  try {
    return "accepted " + read(yaml).name;
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string complaint_about_words(const std::string& words) {
  try {
    return "accepted " + material_from_words(words).name;
  } catch (const InputError& error) {
    return error.what();
  }
}

constexpr const char* five = "{model: five_parameter, kb: 0.153, kr: 0.456, b: -26.998, a: 0.667, kd: 0.015";

TEST(MaterialYaml, ReadsTheExamplesOfTheManual) {
  const Material skin = read("{library: metal-skin-5p}");
  EXPECT_EQ(skin.name, "skin");
  EXPECT_EQ(skin.wavelength, 1.06e-6);
  EXPECT_THAT(skin.source, testing::StartsWith("metal-skin-5p"));

  const Material paint = read(std::string(five) + ", azimuth_of_specular: 180, wavelength: 1.06 um, source: lab}");
  const Material published = *find_in_library("painted-steel-5p");
  EXPECT_EQ(f_r_angles(paint.brdf, 0.5, 0.7, 1.0), f_r_angles(published.brdf, 0.5, 0.7, 1.0));
  EXPECT_EQ(paint.wavelength, published.wavelength);
  EXPECT_EQ(paint.source, "lab");

  const Material white = read("{model: lambert, reflectance: 0.8}");
  EXPECT_EQ(std::get<Lambert>(white.brdf).reflectance(), 0.8);
  EXPECT_EQ(white.wavelength, 0.0);
}

TEST(MaterialYaml, TakesTheOtherAzimuthConventionForALibraryMaterialToo) {
  const Material turned = read("{library: metal-skin-5p, azimuth_of_specular: 0}");
  EXPECT_EQ(std::get<Wu>(turned.brdf).parameters().azimuth_of_specular, 0);
  EXPECT_EQ(std::get<Wu>(read(std::string(five) + ", azimuth_of_specular: 0}").brdf).parameters().azimuth_of_specular,
            0);
}

TEST(MaterialYaml, ReadsBackWhatItWrites) {
  for (const Brdf& brdf : sample_brdfs()) {
    if (std::holds_alternative<Tabulated>(brdf)) continue;  // comes from a file: tabulated_yaml_test.cpp
    const Material material{"skin", brdf, 1.0645e-6, "a \"lab\": 3 # of 4\nsamples"};
    const Material again = read(material_to_yaml(material));
    EXPECT_EQ(words_of(again.brdf).values, words_of(brdf).values);
    EXPECT_EQ(words_of(again.brdf).form, words_of(brdf).form);
    EXPECT_EQ(words_of(again.brdf).azimuth_of_specular, words_of(brdf).azimuth_of_specular);
    EXPECT_EQ(again.wavelength, material.wavelength);
    EXPECT_EQ(again.source, material.source);
  }
}

TEST(MaterialYaml, WritesNoWavelengthAndNoSourceWhereNoneIsStated) {
  EXPECT_EQ(material_to_yaml({"white", Lambert(0.8), 0.0, ""}), "model: lambert\nreflectance: 0.8\n");
}

TEST(MaterialYaml, NamesTheNearestKeyModelAndLibraryMaterial) {
  EXPECT_EQ(complaint("model: lambert\nreflectence: 0.8"),
            "scene.yaml:2:1: unknown key 'reflectence', did you mean 'reflectance'? "
            "(known: model, reflectance, wavelength, source)");
  EXPECT_EQ(complaint("model: lambrt"),
            "scene.yaml:1:8: expected lambert or five_parameter or nine_parameter or steinvall or phong or "
            "cook_torrance_beckmann or cook_torrance_ggx or tabulated, found 'lambrt'");
  EXPECT_EQ(complaint("library: metal-skin-5q"),
            "scene.yaml:1:10: unknown library material 'metal-skin-5q', did you mean 'metal-skin-5p'? "
            "(known: metal-skin-5p, metal-skin-9p, painted-steel-5p, painted-steel-9p)");
}

TEST(MaterialYaml, SaysWhichFormAKeyBelongsTo) {
  EXPECT_THAT(
      complaint(std::string(five) + ", sigma_p: 0.1}"),
      testing::AllOf(testing::StartsWith("scene.yaml:1:"),
                     testing::HasSubstr("unknown key 'sigma_p' of five_parameter: it belongs to nine_parameter")));
  EXPECT_THAT(complaint("{model: lambert, kb: 0.1}"), testing::HasSubstr("it belongs to five_parameter"));
}

TEST(MaterialYaml, PutsEveryMistakeAtItsPlace) {
  EXPECT_EQ(complaint("{model: lambert}"), "scene.yaml:1:1: key 'reflectance' is missing");
  EXPECT_EQ(complaint("{reflectance: 1}"), "scene.yaml:1:1: key 'model' or 'library' is missing");
  EXPECT_EQ(complaint("model: lambert\nreflectance: 1.5"),
            "scene.yaml:2:14: expected reflectance in [0, 1], found 1.5");
  EXPECT_EQ(complaint("model: lambert\nreflectance: .nan"), "scene.yaml:2:14: expected a finite number, found '.nan'");
  EXPECT_EQ(complaint("model: lambert\nreflectance: 1\nwavelength: 1.06"),
            "scene.yaml:3:13: expected a positive length with its unit, such as '1.06 um', found '1.06'");
  EXPECT_THAT(complaint(std::string(five) + ", azimuth_of_specular: 90}"),
              testing::HasSubstr("expected azimuth_of_specular 180 or 0, found '90'"));
  EXPECT_THAT(complaint("{model: five_parameter, kb: -1, kr: 1, b: 0, a: 1, kd: 0}"),
              testing::StartsWith("scene.yaml:1:29: expected kb >= 0"));
  EXPECT_THAT(complaint("- 3"), testing::HasSubstr("expected a mapping, found a list"));
  EXPECT_THAT(complaint("{library: metal-skin-5p, kb: 3}"), testing::HasSubstr("unknown key 'kb'"));
}

TEST(MaterialWords, TakeALambertAReflectanceALibraryNameOrAFile) {
  EXPECT_EQ(std::get<Lambert>(material_from_words("lambert:0.8").brdf).reflectance(), 0.8);
  EXPECT_EQ(material_from_words("metal-skin-9p").name, "metal-skin-9p");
  const auto file = std::filesystem::path(testing::TempDir()) / "fitted.yaml";
  std::ofstream(file) << material_to_yaml(*find_in_library("painted-steel-9p"));
  const Material material = material_from_words(file.string());
  EXPECT_EQ(material.name, "fitted");
  EXPECT_EQ(words_of(material.brdf).values, words_of(find_in_library("painted-steel-9p")->brdf).values);
  std::filesystem::remove(file);
}

TEST(MaterialWords, SayWhatWasExpected) {
  EXPECT_EQ(
      complaint_about_words("metal-skn-5p"),
      "unknown material 'metal-skn-5p', did you mean 'metal-skin-5p'? (expected lambert:REFLECTANCE, a YAML file, "
      "or one of metal-skin-5p, metal-skin-9p, painted-steel-5p, painted-steel-9p)");
  EXPECT_EQ(complaint_about_words("lambert:2"), "material 'lambert:2': expected reflectance in [0, 1], found 2");
  EXPECT_THAT(complaint_about_words("lambert:x"), testing::HasSubstr("expected a reflectance in [0, 1]"));
  EXPECT_THAT(complaint_about_words("lambert:nan"), testing::HasSubstr("expected reflectance in [0, 1]"));
  EXPECT_THAT(complaint_about_words("/"), testing::HasSubstr("is a folder"));
  EXPECT_THAT(complaint_about_words(""), testing::HasSubstr("unknown material ''"));
}

}  // namespace
}  // namespace lrcs
