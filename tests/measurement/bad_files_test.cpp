#include <gtest/gtest.h>

#include <random>

#include "made_formats.h"
#include "measured_files.h"

// One message for each way in which a file can be wrong, word by word; and that nothing but an InputError comes of
// noise.

namespace lrcs {
namespace {

const std::string readable =
    "expected measured BRDFs as CSV with the header theta_i_deg,theta_r_deg,phi_deg,f_r_per_sr[,weight], or as ALTA, "
    "Zemax BSDF, FRED, MERL or a table of named angles";

const std::string header = "theta_i_deg,theta_r_deg,phi_deg,f_r_per_sr[,weight]";

std::string complaint_about_row(const std::string& row) {
  return complaint_about(csv_header + row + "\n");
}

TEST(BadMeasurement, IsNoFileThatCanBeRead) {
  const ScratchFolder folder;
  const auto complaint = [](const std::filesystem::path& file) -> std::string {
    try {
      return read_brdf_measurements(file).front().name;
    } catch (const InputError& error) {
      return error.what();
    }
  };
  const std::string none = folder.path() / "none.csv";
  EXPECT_EQ(complaint(none), none + ": cannot be read: No such file or directory");
  EXPECT_EQ(complaint(folder.path()), folder.path().string() + ": is a folder, expected a file");
  EXPECT_EQ(complaint("/dev/zero"), "/dev/zero: is no regular file");
  folder.write("large.csv", "");
  std::filesystem::resize_file(folder.path() / "large.csv", (256U << 20U) + 1);
  EXPECT_EQ(complaint(folder.path() / "large.csv"),
            (folder.path() / "large.csv").string() + ": has 268435457 bytes, expected at most 268435456");
}

TEST(BadMeasurement, IsInNoFormatKnown) {
  EXPECT_EQ(complaint_about(""), "a.txt: is empty, " + readable);
  EXPECT_EQ(complaint_about("hello\n"), "a.txt: is in no format known here, " + readable);
  EXPECT_EQ(complaint_about("# only words\n"), "a.txt: is in no format known here, " + readable);
  EXPECT_EQ(complaint_about(std::string(300, '\0')), "a.txt: is binary, in no format known here, " + readable);
  EXPECT_EQ(complaint_about(std::string("\xff\xfe#\0", 4)), "a.txt: is UTF-16 text, expected UTF-8 or ASCII");
}

TEST(BadMeasurement, HoldsNoAngles) {
  EXPECT_EQ(complaint_about("1.118\n1.117\n"),
            "a.txt:1:1: too few numbers in a row to hold angles, and no header row names the columns, expected " +
                header + ", found '1.118'");
  EXPECT_EQ(complaint_about("350 0.98 0.005\n"),
            "a.txt:1:1: too few numbers in a row to hold angles, and no header row names the columns, expected " +
                header + ", found '350 0.98 0.005'");
}

TEST(BadMeasurement, HasNoHeaderRow) {
  EXPECT_EQ(complaint_about("# mine\n10,20,0,1\n"),
            "a.txt:2:1: no header row names the columns, expected " + header + ", found '10'");
}

TEST(BadMeasurement, HasAnotherHeader) {
  EXPECT_EQ(complaint_about("theta_i_deg,theta_r_rad,phi_deg,f_r_per_sr\n"),
            "a.txt:1:13: expected a column 'theta_r_deg', found 'theta_r_rad'");
  EXPECT_EQ(complaint_about("theta_i_deg,theta_r_deg,phi_deg,f_r_percent\n"),
            "a.txt:1:33: expected a column 'f_r_per_sr', found 'f_r_percent'");
  EXPECT_EQ(complaint_about("thetai_deg,theta_r_deg,phi_deg,f_r_per_sr\n"),
            "a.txt:1:1: expected a column 'theta_i_deg', found 'thetai_deg'");
  EXPECT_EQ(complaint_about("theta_i_deg,theta_r_deg,phi_deg,f_r_per_sr,weigth\n"),
            "a.txt:1:44: expected a column 'weight', found 'weigth'");
  EXPECT_EQ(complaint_about("theta_i_deg,theta_r_deg,f_r_per_sr\n"),
            "a.txt:1:35: no column 'phi_deg', expected " + header);
  EXPECT_EQ(complaint_about("theta_i_deg,theta_r_deg,phi_deg,phi_deg,f_r_per_sr\n"),
            "a.txt:1:33: a second column 'phi_deg', expected one");
  EXPECT_EQ(complaint_about("theta_i_deg;theta_r_deg;phi_deg;f_r_per_sr\n"),
            "a.txt:1:1: expected columns between commas, " + header + ", found 'theta_i_deg;theta_r_deg;...'");
}

TEST(BadMeasurement, HasACommentThatSaysSomethingElse) {
  const std::string rows = csv_header + std::string("10,20,0,1\n");
  EXPECT_EQ(complaint_about("# wavelength: 1.06\n" + rows).substr(0, 24), "a.txt:1:1: wavelength: e");
  EXPECT_EQ(complaint_about("# azimuth_of_specular: 90\n" + rows),
            "a.txt:1:1: expected azimuth_of_specular: 180 or 0, found '90'");
  EXPECT_EQ(complaint_about("# value: brdf_cosin\n" + rows),
            "a.txt:1:1: expected value: brdf or brdf_cosine, found 'brdf_cosin', did you mean 'brdf_cosine'?");
  EXPECT_EQ(complaint_about("# azimut_of_specular: 0\n" + rows),
            "a.txt:1:1: unknown key 'azimut_of_specular', did you mean 'azimuth_of_specular'?");
  EXPECT_EQ(complaint_about("# value: brdf\n# value: brdf_cosine\n" + rows),
            "a.txt:2:1: line 1 says another value, expected one");
}

TEST(BadMeasurement, HasARowThatIsWrong) {
  EXPECT_EQ(complaint_about_row("10,abc,0,1"), "a.txt:2:4: expected a finite number, found 'abc'");
  EXPECT_EQ(complaint_about_row("10,nan,0,1"), "a.txt:2:4: expected a finite number, found 'nan'");
  EXPECT_EQ(complaint_about_row("10,20,0,inf"), "a.txt:2:9: expected a finite number, found 'inf'");
  EXPECT_EQ(complaint_about_row("10,20,0,1e200"), "a.txt:2:9: expected a number of at most 1e100, found '1e200'");
  EXPECT_EQ(complaint_about_row("10,20,0,-0.1"), "a.txt:2:9: expected a value that is not negative, found -0.1");
  EXPECT_EQ(complaint_about_row("10,91,0,1"),
            "a.txt:2:4: expected an angle from the normal of at most 90 deg, found 91");
  EXPECT_EQ(complaint_about_row("-100,9,0,1"),
            "a.txt:2:1: expected an angle from the normal of at most 90 deg, found -100");
  EXPECT_EQ(complaint_about_row("10,20,1000,1"), "a.txt:2:7: expected an azimuth of at most 720 deg, found 1000");
  EXPECT_EQ(complaint_about_row("10,20,,1"), "a.txt:2:7: expected a number, found nothing");
  EXPECT_EQ(complaint_about_row("10,20,0"), "a.txt:2:8: expected 4 cells as in the header, found 3");
  EXPECT_EQ(complaint_about_row("10,20,0,0,5"), "a.txt:2:11: expected 4 cells as in the header, found more");
  EXPECT_EQ(complaint_about("weight," + std::string(csv_header) + "-1,10,20,0,1\n"),
            "a.txt:2:1: expected a weight that is not negative, found -1");
}

TEST(BadMeasurement, LeavesNothingToFit) {
  EXPECT_EQ(complaint_about(csv_header), "a.txt: holds no values, expected at least one");
  EXPECT_EQ(complaint_about_row("10,20,0,0\n20,20,0,0"), "a.txt: all 2 values of f_r are 0, nothing to fit");
  EXPECT_EQ(complaint_about("weight," + std::string(csv_header) + "0,10,20,0,1\n"),
            "a.txt: all 1 weights are 0, nothing to fit");
  EXPECT_EQ(complaint_about_row("90,20,0,1"),
            "a.txt: has no value left to fit: 1 at 90 deg from the normal, where the cosine is 0, left out");
}

TEST(BadMeasurement, ContradictsWhatWasAskedFor) {
  const std::string rows = csv_header + std::string("10,20,0,1\n");
  EXPECT_EQ(complaint_about("# azimuth_of_specular: 180\n" + rows, {0, {}}),
            "a.txt:1:1: the file says azimuth of specular: 180 deg, asked for was azimuth of specular: 0 deg");
  EXPECT_EQ(complaint_about("# value: brdf\n" + rows, {{}, true}),
            "a.txt:1:1: the file says value: f_r, asked for was value: f_r cos theta_r, divided by the cosine");
  EXPECT_EQ(complaint_about(rows, {90, {}}), "a.txt: azimuth of specular: expected 180 or 0 deg, asked for was 90");
  EXPECT_EQ(complaint_about("# azimuth_of_specular: 0\n# value: brdf\n" + rows, {0, false}), "");
  EXPECT_EQ(
      complaint_about(made_zemax, {180, {}}),
      "a.txt:1:1: the format counts angles from the specular ray, asked for was an azimuth of specular of 180 deg, "
      "expected none");
  EXPECT_EQ(complaint_about(made_fred, {180, {}}).substr(0, 40), "a.txt:1:6: the file says azimuth of spec");
  EXPECT_EQ(complaint_about(made_alta, {{}, false}).substr(0, 40), "a.txt:4:12: the file says value: f_r cos");
}

TEST(BadMeasurement, IsNeverMoreThanAnInputErrorWhateverBytesAreChanged) {
  std::mt19937_64 random(20);
  int refused = 0;
  for (const std::string& good : made_formats()) {
    for (int k = 0; k < 300; ++k) {
      std::string bytes = good.substr(0, k % 5 == 0 ? random() % good.size() : good.size());
      for (std::size_t flips = 1 + random() % 4; flips > 0 && !bytes.empty(); --flips)
        bytes[random() % bytes.size()] = static_cast<char>(k % 2 == 0 ? random() : 32 + random() % 95);
      const ScratchFolder folder;
      folder.write("a", bytes);
      try {
        for (const BrdfMeasurement& m : read_brdf_measurements(folder.path() / "a")) {
          EXPECT_FALSE(m.samples.empty());
          EXPECT_TRUE(std::isfinite(m.wavelength) && m.wavelength >= 0.0);
          for (const BrdfSample& s : m.samples) {
            EXPECT_TRUE(s.theta_i >= 0.0 && s.theta_i < 90 * degree && s.theta_r >= 0.0 && s.theta_r < 90 * degree);
            EXPECT_TRUE(s.phi > -180 * degree && s.phi <= 180 * degree);
            EXPECT_TRUE(std::isfinite(s.f_r) && s.f_r >= 0.0 && std::isfinite(s.weight) && s.weight >= 0.0);
          }
        }
      } catch (const InputError& error) {
        EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace lrcs
