// Numbers from other programs: exact sigma and seen area of shipped targets, f_r in 30 digits (tests/data).
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "base/direction.h"
#include "mesh/read_mesh.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

// The rows of a table, its comments and header left out, each as words.
std::vector<std::vector<std::string>> rows_of(const std::string& name) {
  std::ifstream in(std::string(LRCS_TEST_DATA) + "/" + name);
  std::vector<std::vector<std::string>> rows;
  bool header = true;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    std::vector<std::string> row;
    for (std::string word; std::getline(words, word, ',');) row.push_back(word);
    if (!header) rows.push_back(row);
    header = false;
  }
  return rows;
}

void expect_relative(double value, double truth, double relative, const std::string& what) {
  EXPECT_NEAR(value, truth, relative * std::abs(truth)) << what;
}

class SeenSigma : public testing::TestWithParam<const char*> {};

TEST_P(SeenSigma, IsThatOfBruteForceClipping) {
  const std::string file = GetParam(), name = std::filesystem::path(file).stem();
  const FacetMesh mesh = read_mesh(std::string(LRCS_EXAMPLES) + "/" + name + "/" + file);
  const Visibility visibility(mesh);
  int checked = 0;
  for (const auto& row : rows_of("seen_sigma.csv")) {
    if (row[0] != name) continue;
    const auto number = [&](std::size_t column) { return std::stod(row[column]); };
    const Vec3 di = direction_of({number(1), number(2)}), dr = direction_of({number(3), number(4)});
    const Brdf brdfs[] = {lambert(1.0), library("metal-skin-5p"), library("painted-steel-9p")};
    for (std::size_t k = 0; k < 3; ++k) {
      const CrossSection section = cross_section(target_of(mesh, brdfs[k]), visibility, di, dr);
      expect_relative(section.sigma.value, number(6 + k), 1e-10, row[1] + "," + row[2]);
      expect_relative(section.seen_area, number(5), 1e-10, row[1] + "," + row[2]);
    }
    ++checked;
  }
  EXPECT_EQ(checked, 8);
}

INSTANTIATE_TEST_SUITE_P(Shipped, SeenSigma, testing::Values("tess.obj", "turbine.off", "propeller.stl"),
                         [](const auto& file) { return std::filesystem::path(file.param).stem().string(); });

TEST(PublishedBrdf, HasItsThirtyDigitValues) {
  const auto rows = rows_of("brdf_values.csv");
  EXPECT_EQ(rows.size(), 160U);
  for (const auto& row : rows) {
    const auto angle = [&](std::size_t column) { return std::stod(row[column]) * degree; };
    expect_relative(f_r_angles(library(row[0].c_str()), angle(1), angle(2), angle(3)), std::stod(row[4]), 1e-12,
                    row[0]);
  }
}

}  // namespace
}  // namespace lrcs
