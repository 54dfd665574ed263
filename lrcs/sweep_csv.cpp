#include "lrcs/sweep_csv.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "base/length.h"
#include "base/text_scanner.h"
#include "base/version.h"
#include "brdf/material_yaml.h"
#include "mesh/file_content.h"

namespace lrcs {
namespace {

constexpr std::array<const char*, 8> columns{"transmitter_azimuth_deg",
                                             "transmitter_elevation_deg",
                                             "receiver_azimuth_deg",
                                             "receiver_elevation_deg",
                                             "sigma_m2",
                                             "sigma_dbsm",
                                             "bound_m2",
                                             "seen_area_m2"};
constexpr std::size_t dbsm_column = 5;

// A mapping of one key a line, on one line.
std::string on_one_line(const std::string& mapping) {
  std::string line;
  for (const char c : mapping) line += c == '\n' ? std::string(", ") : std::string(1, c);
  while (line.ends_with(", ")) line.resize(line.size() - 2);
  return line;
}

std::string comments(const Scene& scene, const std::string& target_digest) {
  std::string text = fmt::format("# lrcs {}: laser radar cross section\n", version);
  text += fmt::format("# scene sha256: {}\n# target sha256: {}\n", scene.digest, target_digest);
  text +=
      fmt::format("# wavelength: {}\n", scene.wavelength > 0.0 ? text_of_length(scene.wavelength, "um") : "not stated");
  for (const Material& m : scene.materials)
    text += fmt::format("# material {}: {}\n", m.name, on_one_line(material_to_yaml(m)));
  text +=
      "# azimuth from +x (forward) toward +y (left), elevation from the xy-plane toward +z (up), in the body frame\n";
  text += "# sigma = 4 pi Integral f_r cos_i cos_r dA over what is lit and seen; dBsm = 10 log10(sigma / 1 m^2)\n";
  text += "# |sigma - true sigma of the facets| <= bound; seen area: lit and seen, projected toward the receiver\n";
  return text;
}

bool has_cells(TextScanner scanner) {
  return !scanner.word().empty();
}

void read_header(TextScanner& scanner) {
  for (const char* column : columns)
    if (const auto name = scanner.cell(); name.value_or("") != column)
      scanner.fail(fmt::format("expected the column {} of a sweep.csv, found '{}'", column, shown(name.value_or(""))));
  if (scanner.cell()) scanner.fail(fmt::format("expected {} columns, found more", columns.size()));
}

double cell_at(TextScanner& scanner, std::size_t column) {
  const auto cell = scanner.cell();
  if (!cell) scanner.fail_expected(columns[column], "");
  if (column == dbsm_column) return 0.0;  // follows from sigma; minus infinity where that is 0
  const double value = scanner.number_in(*cell);
  if (column > dbsm_column - 2 && value < 0.0)
    scanner.fail(fmt::format("expected {} of 0 or more, found {}", columns[column], shown(*cell)));
  return value;
}

SweepRow read_row(TextScanner& scanner) {
  std::array<double, columns.size()> v{};
  for (std::size_t k = 0; k < v.size(); ++k) v[k] = cell_at(scanner, k);
  if (scanner.cell()) scanner.fail(fmt::format("expected {} cells, found more", columns.size()));
  return {aspect_between({v[0], v[1]}, {v[2], v[3]}), {v[4], v[6]}, v[7]};
}

}  // namespace

double dbsm(double sigma_m2) {
  return 10.0 * std::log10(sigma_m2);
}

std::string sweep_csv(const Scene& scene, const std::string& target_digest, const std::vector<SweepRow>& rows) {
  std::string text = comments(scene, target_digest);
  text += fmt::format("{}\n", fmt::join(columns, ","));
  for (const SweepRow& row : rows) {
    const auto& [transmitter, receiver, di, dr] = row.aspect;
    text += fmt::format("{},{},{},{},{},{},{},{}\n", transmitter.azimuth_deg, transmitter.elevation_deg,
                        receiver.azimuth_deg, receiver.elevation_deg, row.sigma.value, dbsm(row.sigma.value),
                        row.sigma.bound, row.seen_area);
  }
  return text;
}

std::vector<SweepRow> read_sweep_csv(const std::filesystem::path& file) {
  const std::string content = plain_content(file);
  TextScanner scanner(content, file.string());
  while (!has_cells(scanner))
    if (!scanner.next_line()) scanner.fail_expected("the columns of a sweep.csv", "");
  read_header(scanner);
  std::vector<SweepRow> rows;
  while (scanner.next_line())
    if (has_cells(scanner)) rows.push_back(read_row(scanner));
  if (rows.empty()) scanner.fail_expected("a row of numbers", "");
  return rows;
}

}  // namespace lrcs
