#include "mesh/facet_properties_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "base/text_scanner.h"
#include "mesh/file_content.h"
#include "mesh/polygon_words.h"

namespace lrcs {
namespace {

bool has_cells(TextScanner scanner) {
  return !scanner.word().empty();
}

class Table {
 public:
  Table(const FacetMesh& mesh, TextScanner scanner) : mesh_(mesh), scanner_(std::move(scanner)) {
    for (const std::uint32_t polygon : mesh.source_facet) polygons_ = std::max<std::size_t>(polygons_, polygon + 1U);
    line_of_.assign(polygons_, 0);
  }

  std::vector<FacetProperty> read() {
    while (!has_cells(scanner_))
      if (!scanner_.next_line()) scanner_.fail_expected("column names: facet,NAME[,NAME...]", "");
    read_names();
    while (scanner_.next_line())
      if (has_cells(scanner_)) read_row();
    std::vector<FacetProperty> properties;
    for (std::size_t k = 0; k < names_.size(); ++k) properties.push_back({names_[k], words_[k].of_facets(mesh_)});
    return properties;
  }

 private:
  void read_names() {
    const auto first = scanner_.cell().value_or("");
    if (first != "facet") scanner_.fail(fmt::format("expected the column facet first, found '{}'", shown(first)));
    while (const auto name = scanner_.cell()) {
      if (name->empty()) scanner_.fail("expected the name of a property");
      if (is_known(*name)) scanner_.fail(fmt::format("facets have a property '{}' already", shown(*name)));
      names_.emplace_back(*name);
    }
    if (names_.empty()) scanner_.fail_expected("the name of a property", "");
    words_.resize(names_.size());
  }

  [[nodiscard]] bool is_known(std::string_view name) const {
    return std::find(names_.begin(), names_.end(), name) != names_.end() ||
           std::any_of(mesh_.properties.begin(), mesh_.properties.end(),
                       [&](const FacetProperty& property) { return property.name == name; });
  }

  void read_row() {
    const std::size_t polygon = read_number();
    for (std::size_t k = 0; k < names_.size(); ++k) {
      const auto word = scanner_.cell();
      if (!word) scanner_.fail_expected("a word for " + names_[k], "");
      words_[k].set(polygon, *word);
    }
    if (scanner_.cell()) scanner_.fail(fmt::format("expected {} cells, found more", names_.size() + 1));
  }

  std::size_t read_number() {
    const std::string_view word = scanner_.cell().value_or("");
    std::size_t polygon = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), polygon);
    if (error != std::errc() || end != word.data() + word.size() || polygon >= polygons_)
      scanner_.fail(fmt::format("expected the number of a facet, 0 to {}, found '{}'", polygons_ - 1, shown(word)));
    if (line_of_[polygon] != 0)
      scanner_.fail(fmt::format("facet {} again (first on line {})", polygon, line_of_[polygon]));
    line_of_[polygon] = scanner_.line();
    return polygon;
  }

  const FacetMesh& mesh_;
  TextScanner scanner_;
  std::size_t polygons_ = 0;
  std::vector<int> line_of_;  // one a polygon; 0: none yet
  std::vector<std::string> names_;
  std::vector<PolygonWords> words_;  // one a name
};

}  // namespace

void add_facet_properties(FacetMesh& mesh, const std::filesystem::path& csv) {
  const std::string content = plain_content(csv);
  for (FacetProperty& property : Table(mesh, TextScanner(content, csv.string())).read())
    mesh.properties.push_back(std::move(property));
}

}  // namespace lrcs
