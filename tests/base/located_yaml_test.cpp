#include "base/located_yaml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

namespace lrcs {
namespace {

LocatedYaml yaml(const std::string& text) {
  return LocatedYaml::of_text(text, "scene.yaml");
}

std::string complaint(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}
std::string complaint_on_reading(const std::string& text) {
  return complaint([&] { yaml(text); });
}

TEST(LocatedYaml, GivesValuesInFileOrderWithTheirPlaces) {
  const LocatedYaml root = yaml("b: 1.5\na:\n  - x\n  - [2, -3e-2]\nc: {d: text with words}\n");
  const auto entries = root.entries();
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(entries[0].first, "b");
  EXPECT_EQ(entries[0].second.number(), 1.5);
  EXPECT_EQ(root.at("a").items()[1].items()[1].number(), -3e-2);
  EXPECT_EQ(root.at("a").items()[1].items()[1].place().text(), "scene.yaml:4:9");
  EXPECT_EQ(root.at("c").at("d").text(), "text with words");
  EXPECT_EQ(root.key_place("c").place().text(), "scene.yaml:5:1");
  EXPECT_TRUE(root.has("a"));
  EXPECT_FALSE(root.has("d"));
  EXPECT_TRUE(root.is_map());
  EXPECT_TRUE(root.at("a").is_sequence());
  EXPECT_TRUE(root.at("b").is_scalar());
}

TEST(LocatedYaml, LookingForAKeyDoesNotCreateIt) {
  const LocatedYaml root = yaml("a: 1");
  EXPECT_FALSE(root.has("b"));
  EXPECT_EQ(complaint([&] { static_cast<void>(root.at("b")); }), "scene.yaml:1:1: key 'b' is missing");
  EXPECT_EQ(root.entries().size(), 1U);
}

TEST(LocatedYaml, NamesTheNearestKnownKey) {
  const LocatedYaml root = yaml("lrcs: 1\n\n  \nwavelenght: 1.06 um\n");
  EXPECT_EQ(complaint([&] {
              root.allow_keys({"lrcs", "wavelength"});
            }),
            "scene.yaml:4:1: unknown key 'wavelenght', did you mean 'wavelength'? (known: lrcs, wavelength)");
  EXPECT_EQ(complaint([&] { root.allow_keys({"lrcs", "wavelenght"}); }), "accepted");
}

TEST(LocatedYaml, FindsDuplicateKeysAtAnyDepth) {
  EXPECT_EQ(complaint_on_reading("a:\n  skin: 1\n  skin: 2\n"),
            "scene.yaml:3:3: duplicate key 'skin' (first on line 2)");
  EXPECT_EQ(complaint_on_reading("- {k: 1, \"k\": 2}"), "scene.yaml:1:10: duplicate key 'k' (first on line 1)");
  EXPECT_EQ(complaint_on_reading("a: {k: 1}\nb: {k: 1}"), "accepted");
}

TEST(LocatedYaml, TakesOnlyFiniteNumbersForNumbers) {
  for (const char* good : {"1", "+1.5", "-2.5e-3", ".5", "5.", "1E3", "007"}) {
    EXPECT_TRUE(yaml(good).is_number()) << good;
    EXPECT_EQ(yaml(good).number(), std::stod(good));
  }
  for (const char* infinite : {".nan", ".inf", "-.inf", "+.Inf", "1e999", "1e-999"}) {
    EXPECT_FALSE(yaml(infinite).is_number());
    EXPECT_EQ(complaint([&] { static_cast<void>(yaml(infinite).number()); }),
              "scene.yaml:1:1: expected a finite number, found '" + std::string(infinite) + "'");
  }
  for (const char* word : {"abc", "1 m", "1,5", "0x10", "nan", "inf", "infinity", "--1", "+-1", "1e", "1.2.3"})
    EXPECT_EQ(complaint([&] { static_cast<void>(yaml(word).number()); }),
              "scene.yaml:1:1: expected a number, found '" + std::string(word) + "'");
  EXPECT_EQ(complaint([] { static_cast<void>(yaml("'1'").number()); }),
            "scene.yaml:1:1: expected a number, found the text '1'");
}

TEST(LocatedYaml, SaysWhatItFoundInsteadOfWhatWasAskedFor) {
  const LocatedYaml root = yaml("a: [1]\nb: {c: 1}\nd:\ne: word");
  EXPECT_EQ(complaint([&] { static_cast<void>(root.at("a").number()); }),
            "scene.yaml:1:4: expected a number, found a list");
  EXPECT_EQ(complaint([&] { static_cast<void>(root.at("b").text()); }),
            "scene.yaml:2:4: expected text, found a mapping");
  EXPECT_THAT(complaint([&] { static_cast<void>(root.at("d").text()); }), testing::HasSubstr("found nothing"));
  EXPECT_EQ(complaint([&] { static_cast<void>(root.at("e").items()); }),
            "scene.yaml:4:4: expected a list, found 'word'");
  EXPECT_EQ(complaint([&] { static_cast<void>(root.at("e").at("f")); }),
            "scene.yaml:4:4: expected a mapping, found 'word'");
}

TEST(LocatedYaml, TakesOneOfAFewWordsAndNamesTheNearestFirst) {
  EXPECT_EQ(yaml("both").one_of({"front", "both"}), "both");
  EXPECT_EQ(complaint([] {
              static_cast<void>(yaml("boht").one_of({"front", "both"}));
            }),
            "scene.yaml:1:1: expected both or front, found 'boht'");
  EXPECT_EQ(complaint([] {
              static_cast<void>(yaml("[]").one_of({"front", "both"}));
            }),
            "scene.yaml:1:1: expected front or both, found a list");
}

TEST(LocatedYaml, ComplainsInItsOwnWordsAtItsPlace) {
  EXPECT_EQ(complaint([] { yaml("a: 3").at("a").fail("expected less"); }), "scene.yaml:1:4: expected less");
}

TEST(LocatedYaml, FollowsAliasesButNotInACircle) {
  const LocatedYaml root = yaml("a: &x {k: 1}\nb: *x\n");
  EXPECT_EQ(root.at("b").at("k").number(), 1.0);
  EXPECT_THAT(complaint_on_reading("a: &x [1, *x]"), testing::HasSubstr("an alias stands inside the value it names"));
  EXPECT_THAT(complaint_on_reading("a: *nowhere"), testing::StartsWith("scene.yaml:1:4: "));
}

TEST(LocatedYaml, StopsBeforeNestingGetsDeep) {
  const std::string open(90, '[');
  const std::string close(90, ']');
  EXPECT_EQ(complaint_on_reading(open + close), "accepted");
  for (const char* bracket : {"[", "{a: ", "- ", "? "}) {
    std::string deep;
    for (int k = 0; k < 100000; ++k) deep += bracket;
    EXPECT_THAT(complaint_on_reading(deep), testing::StartsWith("scene.yaml:1:")) << bracket;
  }
  std::string chain = "a0: &a0 [1]\n";
  for (int k = 1; k < 1000; ++k) {
    const std::string name = "a" + std::to_string(k);
    chain.append(name).append(": &").append(name).append(" [*a").append(std::to_string(k - 1)).append("]\n");
  }
  EXPECT_THAT(complaint_on_reading(chain), testing::HasSubstr("nested more than 100 levels deep"));
}

TEST(LocatedYaml, ReadsExponentiallyManyAliasesInLinearTime) {
  std::string laughs = "a0: &a0 [x, x]\n";
  for (int k = 1; k < 60; ++k) {
    const std::string last = "*a" + std::to_string(k - 1);
    laughs += "a" + std::to_string(k) + ": &a" + std::to_string(k) + " [" + last + ", " + last + "]\n";
  }
  EXPECT_EQ(yaml(laughs).at("a59").items().size(), 2U);
}

TEST(LocatedYaml, RefusesWhatIsNotOneDocumentOfText) {
  EXPECT_EQ(complaint_on_reading(""), "scene.yaml: is empty, expected YAML");
  EXPECT_EQ(complaint_on_reading("# nothing\n\n"), "scene.yaml: is empty, expected YAML");
  EXPECT_EQ(complaint_on_reading("a: 1\n---\nb: 2\n"), "scene.yaml:2:1: a second document starts here, expected one");
  EXPECT_EQ(complaint_on_reading(std::string("a: 1\nb: \0 2\n", 12)),
            "scene.yaml:2:4: byte 0x00 found, expected text in UTF-8");
  EXPECT_EQ(complaint_on_reading("a: \x04 2\n"), "scene.yaml:1:4: byte 0x04 found, expected text in UTF-8");
  EXPECT_EQ(complaint_on_reading("a: \xff\xfe"), "scene.yaml:1:4: byte 0xff found, expected text in UTF-8");
  EXPECT_EQ(complaint_on_reading("a: \xc3"), "scene.yaml:1:4: byte 0xc3 found, expected text in UTF-8");
  EXPECT_THAT(complaint_on_reading("a: [1, 2\nb: 3"), testing::StartsWith("scene.yaml:"));
  EXPECT_THAT(complaint_on_reading("{[1]: 2}"), testing::HasSubstr("expected a key that is a word"));
  EXPECT_THAT(complaint_on_reading(std::string(17 << 20, ' ')), testing::HasSubstr("larger than 16 MiB"));
}

TEST(LocatedYaml, SkipsAByteOrderMarkAndKeepsColumns) {
  EXPECT_EQ(yaml("\xef\xbb\xbf"
                 "a: 1")
                .at("a")
                .place()
                .text(),
            "scene.yaml:1:4");
}

TEST(LocatedYaml, ReadsFilesAndNamesThem) {
  const auto file = std::filesystem::path(testing::TempDir()) / "located_yaml_test.yaml";
  std::ofstream(file) << "a: x\n";
  const LocatedYaml root = LocatedYaml::of_file(file);
  EXPECT_EQ(complaint([&] { static_cast<void>(root.at("a").number()); }),
            file.string() + ":1:4: expected a number, found 'x'");
  std::filesystem::remove(file);
  EXPECT_THAT(complaint([&] { LocatedYaml::of_file(file); }), testing::StartsWith(file.string() + ": cannot be read"));
}

TEST(LocatedYaml, NeverEndsOtherwiseThanInAnInputErrorOnDamagedText) {
  const std::string scene =
      "lrcs: 1\ntarget: {file: a.stl, unit: mm}\nmaterials:\n  s: &s {model: lambert, x: [1, 'q', \"e\\n\"]}\n  t: *s\n"
      "k: |\n  block\n  text\n? q\n: !tag v\n";
  unsigned state = 12345;
  const auto random = [&](std::size_t below) {
    state = state * 1664525U + 1013904223U;
    return (state >> 8U) % below;
  };
  const std::string letters = "{}[]:,-?&*!|>'\"%@`# \n\tab0~.\xc3\xa9\\";
  for (int k = 0; k < 20000; ++k) {
    std::string damaged = scene;
    for (std::size_t j = 0; j <= random(6); ++j) damaged[random(damaged.size())] = letters[random(letters.size())];
    if (k % 3 == 0) damaged.resize(random(damaged.size()));
    EXPECT_NO_FATAL_FAILURE(static_cast<void>(complaint_on_reading(damaged)));
  }
}

}  // namespace
}  // namespace lrcs
