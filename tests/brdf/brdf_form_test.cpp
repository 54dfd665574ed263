#include "brdf/brdf_form.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/brdf/sample_brdfs.h"

namespace lrcs {
namespace {

TEST(BrdfForms, GiveEveryBrdfBackFromItsWords) {
  RandomDirections random(31);
  for (const Brdf& brdf : sample_brdfs()) {
    const BrdfWords words = words_of(brdf);
    EXPECT_EQ(words.form == nullptr, std::holds_alternative<Tabulated>(brdf));
    if (words.form == nullptr) continue;
    EXPECT_EQ(words.values.size(), words.form->parameters.size());
    const Brdf again = words.form->make(words.values, words.azimuth_of_specular);
    for (int k = 0; k < 20; ++k) {
      const Vec3 n = random.on_sphere();
      const Vec3 wi = random.above(n, 1.5);
      const Vec3 wr = random.above(n, 1.5);
      EXPECT_EQ(f_cos_cos(again, wi, wr, n), f_cos_cos(brdf, wi, wr, n));
    }
  }
}

TEST(BrdfForms, AreFoundByName) {
  for (const BrdfForm& form : brdf_forms()) EXPECT_EQ(find_brdf_form(form.name), &form);
  EXPECT_EQ(find_brdf_form("ward"), nullptr);
}

TEST(BrdfForms, WriteTheShortestFormThatHolds) {
  EXPECT_EQ(words_of(find_in_library("metal-skin-5p")->brdf).form->name, "five_parameter");
  EXPECT_EQ(words_of(find_in_library("metal-skin-9p")->brdf).form->name, "nine_parameter");
}

TEST(Library, HoldsTheFourPublishedSetsAtOnePointOhSixMicrometres) {
  EXPECT_THAT(library_names(),
              testing::ElementsAre("metal-skin-5p", "metal-skin-9p", "painted-steel-5p", "painted-steel-9p"));
  for (const Material& material : material_library()) {
    EXPECT_EQ(material.wavelength, 1.06e-6);
    EXPECT_THAT(material.source, testing::HasSubstr("2014"));
    EXPECT_EQ(find_in_library(material.name), &material);
  }
  EXPECT_EQ(find_in_library("gold"), nullptr);
}

}  // namespace
}  // namespace lrcs
