// The command line itself: every verb, and every way to use it wrongly.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/cli/made_scene.h"
#include "tests/cli/program.h"

namespace lrcs {
namespace {

const Words by_flags{"sweep", "box.stl", "--unit", "m", "--material", "lambert:0.8", "--azimuth", "0:20:10"};

struct Wrong {
  Words words;
  std::string message;
};

const std::string see_sweep = " (see lrcs sweep --help)";
const std::string library = "metal-skin-5p, metal-skin-9p, painted-steel-5p, painted-steel-9p";
const std::string units = "nm, um, mm, cm, dm, m, km, inch, in, ft, mil";

std::vector<Wrong> wrong_words() {
  return {
      {{"--verison"}, "unknown flag '--verison', did you mean '--version'? (see lrcs --help)"},
      {{"sweep"}, "input is required" + see_sweep},
      {{"info"}, "target is required (see lrcs info --help)"},
      {{"plot"}, "inputs is required (see lrcs plot --help)"},
      {{"check"}, "scene is required (see lrcs check --help)"},
      {{"brdf"}, "material is required (see lrcs brdf --help)"},
      {{"sweep", "box.stl", "--unti", "mm"}, "unknown flag '--unti', did you mean '--unit'?" + see_sweep},
      {{"sweep", "box.stl", "--unti=mm"}, "unknown flag '--unti', did you mean '--unit'?" + see_sweep},
      {{"sweep", "--azimut", "0"}, "unknown flag '--azimut', did you mean '--azimuth'?" + see_sweep},
      {{"check", "scene.yaml", "--threds", "2"},
       "unknown flag '--threds', did you mean '--threads'? (see lrcs check --help)"},
      {{"sweep", "scene.yaml", "-x"}, "unknown flag '-x'" + see_sweep},
      {{"sweep", "scene.yaml", "extra"}, "unexpected argument 'extra'" + see_sweep},
      {{"sweep", "scene.yaml", "check"}, "unexpected argument 'check'" + see_sweep},
      {{"materials", "x"}, "unexpected argument 'x' (see lrcs materials --help)"},
      {{"sweep", "box.stl", "--unit"}, "--unit: its value is missing" + see_sweep},
      {with(by_flags, {"--unit", "mm"}), "--unit: expected once, found 2 times" + see_sweep},
      {{"sweep", "scene.yaml", "--elevation", "0"},
       "--elevation: expected no such flag beside the scene file scene.yaml"},
      {{"sweep", "none.stl"}, "none.stl: no such file (a scene file ends in .yaml)"},
      {{"sweep", "box.stl"}, "--unit is missing: box.stl has no unit of its own; expected one of " + units},
      {{"sweep", "box.stl", "--unit", "m"},
       "--material is missing: expected lambert:REFLECTANCE, a library name or a file"},
      {{"sweep", "box.stl", "--unit", "m", "--material", "lambert:0.8"},
       "--azimuth is missing: expected A, A,B,C or FROM:TO:STEP in deg"},
      {{"sweep", "box.stl", "--unit", "m", "--material", "lambert:1.8", "--azimuth", "0"},
       "material 'lambert:1.8': expected reflectance in [0, 1], found 1.8"},
      {{"sweep", "box.stl", "--unit", "m", "--material", "steel.yaml", "--azimuth", "0"},
       "material: no such file: 'steel.yaml'"},
      {{"sweep", "box.stl", "--unit", "m", "--material", "metl-skin-5p", "--azimuth", "0"},
       "unknown material 'metl-skin-5p', did you mean 'metal-skin-5p'? (expected lambert:REFLECTANCE, a YAML file, or "
       "one of " +
           library + ")"},
      {{"sweep", "box.stl", "--unit", "em", "--material", "lambert:0.8", "--azimuth", "0"},
       "--unit: unknown length unit 'em', did you mean 'nm'? (known: " + units + ")"},
      {{"sweep", "box.stl", "--unit", "m", "--material", "lambert:0.8", "--azimuth", "0:10"},
       "--azimuth: expected A, A,B,C or FROM:TO:STEP in deg, found '0:10'"},
      {{"sweep", "box.stl", "--unit", "m", "--material", "lambert:0.8", "--azimuth", "0,,1"},
       "--azimuth: expected a number, found ''"},
      {{"sweep", "box.stl", "--unit", "m", "--material", "lambert:0.8", "--azimuth", "0:10:0"},
       "--azimuth: expected a step other than 0 deg, found '0:10:0'"},
      {{"sweep", "box.stl", "--unit", "m", "--material", "lambert:0.8", "--azimuth", "0:10:-1"},
       "--azimuth: the sweep is empty: from 0 in steps of -1 never comes to 10"},
      {{"sweep", "box.stl", "--unit", "m", "--material", "lambert:0.8", "--azimuth", "nan"},
       "--azimuth: expected a number, found 'nan'"},
      {with(by_flags, {"--elevation", "95"}), "--elevation: expected an elevation of -90..90 deg, found 95"},
      {with(by_flags, {"--elevation", "low"}), "--elevation: expected a number, found 'low'"},
      {with(by_flags, {"--receiver", "north"}),
       "--receiver: expected monostatic or AZIMUTH,ELEVATION in deg, found 'north'"},
      {with(by_flags, {"--receiver", "1,2,3"}), "--receiver: expected AZIMUTH,ELEVATION in deg, found '1,2,3'"},
      {with(by_flags, {"--bistatic-angle", "200"}), "--bistatic-angle: expected -180..180 deg, found 200"},
      {with(by_flags, {"--bistatic-angle", "20", "--receiver", "0,0"}),
       "--receiver: expected either --receiver or --bistatic-angle, found both"},
      {with(by_flags, {"--plane", "elevation"}), "--plane: belongs to --bistatic-angle, which is missing"},
      {with(by_flags, {"--wavelength", "1.06"}),
       "--wavelength: expected a positive length with its unit, such as '1.06 um', found '1.06'"},
      {with(by_flags, {"--up", "x"}), "--up: expected another axis than --forward +x, found x"},
      {with(by_flags, {"--sides", "fornt"}),
       "--sides: expected both or front, found 'fornt', did you mean 'front'?" + see_sweep},
      {with(by_flags, {"--repair", "yes"}), "--repair: expected auto or none, found 'yes'" + see_sweep},
      {with(by_flags, {"--curved", "normals"}),
       "--curved: expected auto, none, file_normals or crease:ANGLE with 1..89 deg, found 'normals'"},
      {with(by_flags, {"--curved", "file_normals"}),
       "box.stl: has no normals at its vertices, expected them for curved: file_normals"},
      {with(by_flags, {"--facets", "some"}), "--facets: expected none, all or AZ,EL;AZ,EL... in deg, found 'some'"},
      {with(by_flags, {"--facets", "5,0"}),
       "--facets: azimuth 5, elevation 0 is no direction of the sweep; the nearest is azimuth 0, elevation 0"},
      {with(by_flags, {"-t", "0"}), "--threads: expected a number of threads, 1 to 4096, found '0'" + see_sweep},
      {with(by_flags, {"-t", "4097"}), "--threads: expected a number of threads, 1 to 4096, found '4097'" + see_sweep},
      {with(by_flags, {"-t", "-1"}), "--threads: expected a number of threads, 1 to 4096, found '-1'" + see_sweep},
      {with(by_flags, {"-t", "two"}), "--threads: expected a number of threads, 1 to 4096, found 'two'" + see_sweep},
      {{"info", "none.stl"}, "none.stl: cannot be read: No such file or directory"},
      {{"info", "box.stl", "--chord-angle", "100"}, "--chord-angle: expected 0.1..90 deg from edge to edge, found 100"},
      {{"info", "box.stl", "--chord-angle", "fine"}, "--chord-angle: expected a number, found 'fine'"},
      {{"info", "box.stl", "--facet-properties", "none.csv"}, "none.csv: cannot be read: No such file or directory"},
      {{"info", "box.stl", "--unit", "q"}, "--unit: unknown length unit 'q' (known: " + units + ")"},
      {{"brdf", "lambert:0.5", "--theta-i", "95"},
       "--theta-i: expected an angle of incidence of 0 to below 90 deg, found 95"},
      {{"brdf", "lambert:0.5", "--theta-i", ""}, "--theta-i: expected A, A,B,C or FROM:TO:STEP in deg, found ''"},
      {{"brdf", "lambert:0.5", "--step", "0"}, "--step: expected 0.01 to 80 deg, found 0"},
      {{"brdf", "lambert:0.5", "--step", "x"}, "--step: expected a number, found 'x'"},
      {{"brdf", "lambert:0.5", "--step", "0.01", "--theta-i", "0:80:1"},
       "--step: expected a step > 0 deg that gives at most 100000 rows"},
      {{"brdf", "lambert:0.5", "-o", "f.png", "--surface", "f.txt"},
       "--surface: expected a file that ends in .png, found 'f.txt'"},
      {{"brdf", "lambert:0.5", "-o", "f.png", "--surface", "none/f.png"}, "--surface: no such folder: 'none'"},
      {{"brdf", "lambert:0.5", "-o", "x.txt"}, "--output: expected a file that ends in .png, found 'x.txt'"},
      {{"brdf", "lambert:0.5", "--shadowing", "g.png"},
       "--shadowing: expected a material with a shadowing function, found 'lambert:0.5', model lambert "
       "reflectance=0.5"},
      {{"brdf", "metal-skin-5p", "--with", "lambert:0.5", "-o", "f.png", "--shadowing", "g.png"},
       "--shadowing: expected a material with a shadowing function, found 'lambert:0.5', model lambert "
       "reflectance=0.5"},
      {{"brdf", "lambert:0.5", "--surface-shadowing", "g.png"},
       "--surface-shadowing: expected a material with a shadowing function, found 'lambert:0.5', model lambert "
       "reflectance=0.5"},
      {{"brdf", "metal-skin-5p", "-o", "f.png", "--surface", "./f.png"},
       "--surface: would overwrite the picture of --output, './f.png'"},
      {{"brdf", "lambert:0.5", "--with", "metal-skin-5p"}, "--with: expected beside --output or --shadowing"},
      {{"brdf", "lambert:0.5", "--with"}, "--with: its value is missing (see lrcs brdf --help)"},
      {{"brdf", "lambert:0.5", "--with", "steel.yaml", "-o", "f.png"}, "material: no such file: 'steel.yaml'"},
      {{"brdf", "lambert:0", "-o", "f.png", "--with", "lambert:0.1", "--with", "lambert:0.2", "--with", "lambert:0.3",
        "--with", "lambert:0.4", "--with", "lambert:0.5", "--with", "lambert:0.6"},
       "--with: expected at most 5 materials, found 6"},
      {{"brdf", "lambert:0.5", "--with", "lambert:0.1", "--with", "lambert:0.2", "--surface", "a.png", "--surface",
        "b.png"},
       "--surface: expected once, found 2 times (see lrcs brdf --help)"},
  };
}

TEST(WrongUsage, IsOneLineThatSaysWhatWasExpected) {
  const ScratchFolder folder;
  folder.write("box.stl", two_boxes());
  folder.write("scene.yaml", good_scene);
  for (const Wrong& wrong : wrong_words()) {
    const Outcome outcome = run_lrcs(wrong.words, {folder.path()});
    EXPECT_EQ(outcome.status, 2) << wrong.message;
    EXPECT_EQ(outcome.err, "lrcs: " + wrong.message + "\n");
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_FALSE(folder.has("box-lrcs"));
  for (const char* picture : {"f.png", "g.png", "x.txt"}) EXPECT_FALSE(folder.has(picture)) << picture;
}

TEST(WrongUsage, OfVerbsNamesThemAll) {
  const Outcome none = run_lrcs({});
  EXPECT_EQ(none.status, 2);
  EXPECT_EQ(none.err.rfind("lrcs: a verb is missing: expected one of sweep, check, info, ", 0), 0U) << none.err;
  const Outcome mistyped = run_lrcs({"swep"});
  EXPECT_EQ(mistyped.status, 2);
  EXPECT_EQ(mistyped.err.rfind("lrcs: unknown verb 'swep', did you mean 'sweep'? (verbs: sweep, check, ", 0), 0U);
  for (const Outcome& outcome : {none, mistyped})
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
}

TEST(WrongUsage, IsOneLineEvenIfAFileNameHasTwo) {
  const Outcome outcome = run_lrcs({"sweep", "a\nb.stl"});
  EXPECT_EQ(outcome.err, "lrcs: a b.stl: no such file (a scene file ends in .yaml)\n");
}

TEST(Help, IsThereForEveryVerb) {
  for (const Words& words : {Words{"--help"},
                             {"sweep", "--help"},
                             {"check", "--help"},
                             {"info", "--help"},
                             {"plot", "--help"},
                             {"brdf", "--help"},
                             {"materials", "--help"},
                             {"sweep", "-h"}}) {
    const Outcome outcome = run_lrcs(words);
    EXPECT_EQ(outcome.status, 0) << words[0];
    EXPECT_NE(outcome.out.find("Usage: lrcs"), std::string::npos) << words[0];
    EXPECT_EQ(outcome.err, "");
  }
  const Outcome version = run_lrcs({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out.rfind("lrcs ", 0), 0U);
}

TEST(Info, PrintsTextAndJson) {
  const ScratchFolder folder;
  folder.write("box.stl", two_boxes());
  const Outcome text = run_lrcs({"info", "box.stl", "--unit", "m"}, {folder.path()});
  EXPECT_EQ(text.status, 0);
  EXPECT_EQ(text.err, "");
  EXPECT_NE(text.out.find("panel1"), std::string::npos);
  const Outcome json = run_lrcs({"info", "box.stl", "--unit", "mm", "--json"}, {folder.path()});
  EXPECT_EQ(json.status, 0);
  const auto info = nlohmann::json::parse(json.out);
  EXPECT_EQ(info["facets"], 24);
  EXPECT_EQ(info["unit"], "mm");
  EXPECT_EQ(info["parts"].size(), 2U);
  EXPECT_NEAR(info["area_m2"].get<double>(), (10.0 + 1.84) * 1e-6, 1e-18);  // 2x1x1 and 0.4x1.4x0.2
}

TEST(Info, TakesTheFinenessOfCadSurfaces) {
  const auto facets = [](const Words& more) {
    const Outcome outcome = run_lrcs(with({"info", LRCS_EXAMPLES "/as1/as1-oc-214.stp", "--json"}, more));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out)["facets"].get<std::size_t>();
  };
  EXPECT_LT(facets({"--chord-angle", "30", "--chord-tolerance", "0.1"}), facets({"--chord-tolerance", "0.1"}));
}

TEST(Info, CountsTheValuesOfATableOfFacetProperties) {
  const ScratchFolder folder;
  folder.write("box.stl", two_boxes());
  folder.write("zones.csv", "facet,zone\n0,hot\n7,cold\n");
  const Outcome json = run_lrcs({"info", "box.stl", "--facet-properties", "zones.csv", "--json"}, {folder.path()});
  EXPECT_EQ(json.status, 0) << json.err;
  EXPECT_EQ(nlohmann::json::parse(json.out)["properties"], nlohmann::json({"zone (3 values)"}));
}

TEST(Check, SaysWhichMaterialLibraryIsMissing) {
  const ScratchFolder folder;
  folder.write("a.obj", "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
  folder.write("scene.yaml",
               "lrcs: 1\ntarget: {file: a.obj, unit: m}\nmaterials: {w: {model: lambert, reflectance: 1}}\n"
               "assign: [{default: w}]\nsweep: {azimuth: 0}\n");
  const Outcome outcome = run_lrcs({"check", "scene.yaml"}, {folder.path()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err,
            "lrcs: warning: none.mtl: cannot be read: No such file or directory; its materials have no colours\n");
}

TEST(Check, CountsAndComputesNothing) {
  const ScratchFolder folder;
  folder.write("box.stl", two_boxes());
  folder.write("scene.yaml", good_scene);
  const Outcome outcome = run_lrcs({"check", "scene.yaml"}, {folder.path()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out,
            "scene.yaml: ok\ntarget      box.stl: 24 facets in 2 parts\nmaterial    skin: 12 facets\n"
            "material    white: 12 facets\ndirections  5\n");
  EXPECT_EQ(outcome.err, "");
  EXPECT_FALSE(folder.has("scene-lrcs"));
}

TEST(Brdf, PrintsATableAndDrawsItsCurves) {
  const ScratchFolder folder;
  const Outcome outcome = run_lrcs({"brdf", "lambert:0.5", "--theta-i", "0,45", "-o", "f.png"}, {folder.path()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("theta_i_deg,theta_r_deg,phi_deg,f_r_per_sr,G\n0,-80,0,0.15915494309189535,1\n"),
            std::string::npos)
      << outcome.out;
  EXPECT_EQ(folder.read("f.png").substr(1, 3), "PNG");
}

TEST(Brdf, DrawsEveryPictureAskedForAndTheSameTable) {
  const ScratchFolder folder;
  const Words plain{"brdf", "metal-skin-9p", "--theta-i", "30,60", "-q"};
  const Outcome outcome =
      run_lrcs(with(plain, {"-o", "f.png", "--shadowing", "g.png", "--with", "painted-steel-5p", "--with",
                            "painted-steel-9p", "--surface", "fs.png", "--surface-shadowing", "gs.png"}),
               {folder.path()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, run_lrcs(plain).out);
  for (const char* png : {"f.png", "g.png", "fs.png", "gs.png"}) EXPECT_EQ(folder.read(png).substr(1, 3), "PNG") << png;
}

TEST(Brdf, TakesAMaterialFile) {
  const ScratchFolder folder;
  folder.write("half.yaml", "{model: lambert, reflectance: 0.5}\n");
  const Outcome outcome = run_lrcs({"brdf", "half.yaml", "--theta-i", "0"}, {folder.path()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("# material: half: lambert reflectance=0.5\n"), std::string::npos);
}

TEST(Brdf, WarnsOfAnAlbedoAboveOneUnlessQuiet) {
  EXPECT_NE(run_lrcs({"brdf", "metal-skin-5p"}).err.find("lrcs: warning: the albedo passes 1"), std::string::npos);
  EXPECT_EQ(run_lrcs({"brdf", "metal-skin-5p", "-q"}).err, "");
}

TEST(Materials, ListsTheLibrary) {
  const Outcome outcome = run_lrcs({"materials"});
  EXPECT_EQ(outcome.status, 0);
  for (const char* name : {"metal-skin-5p", "metal-skin-9p", "painted-steel-5p", "painted-steel-9p"})
    EXPECT_NE(outcome.out.find(name), std::string::npos);
}

TEST(Output, ThatCannotBeWrittenIsExitOne) {
  for (const Words& words : {Words{"materials"}, {"--help"}, {"brdf", "lambert:0.5"}}) {
    const Outcome outcome = run_lrcs(words, {.out_file = "/dev/full"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "lrcs: standard output: cannot be written: No space left on device\n");
  }
}

}  // namespace
}  // namespace lrcs
