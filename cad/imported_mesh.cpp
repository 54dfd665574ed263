#include "cad/imported_mesh.h"

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace lrcs {
namespace {

void append_count(std::string& bytes, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
}

std::string_view take(std::string_view& bytes, std::size_t count) {
  if (count > bytes.size()) throw std::runtime_error("a mesh ends too early");
  const std::string_view taken = bytes.substr(0, count);
  bytes.remove_prefix(count);
  return taken;
}

std::size_t take_count(std::string_view& bytes) {
  std::size_t count = 0;
  std::memcpy(&count, take(bytes, sizeof count).data(), sizeof count);
  return count;
}

// Of plain numbers and arrays of them.
template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
  append_count(bytes, values.size());
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

template <class T>
void take(std::string_view& bytes, std::vector<T>& values) {
  const std::size_t count = take_count(bytes);
  if (count > bytes.size() / sizeof(T)) throw std::runtime_error("a mesh ends too early");
  values.resize(count);
  if (count > 0)
    std::memcpy(static_cast<void*>(values.data()), take(bytes, count * sizeof(T)).data(), count * sizeof(T));
}

void append_words(std::string& bytes, const std::vector<std::string>& words) {
  append_count(bytes, words.size());
  for (const std::string& word : words) {
    append_count(bytes, word.size());
    bytes += word;
  }
}

std::vector<std::string> take_words(std::string_view& bytes) {
  std::vector<std::string> words;
  for (std::size_t count = take_count(bytes); count > 0; --count) words.emplace_back(take(bytes, take_count(bytes)));
  return words;
}

// Of a reader that a damaged file misled but did not kill.
void check(const FacetMesh& mesh) {
  const auto require = [](bool good) {
    if (!good) throw std::runtime_error("a mesh that contradicts itself");
  };
  for (const auto& facet : mesh.facets)
    for (const std::uint32_t corner : facet) require(corner < mesh.positions.size());
  const auto require_names = [&](const FacetNames& told, bool may_be_empty) {
    require(told.of.size() == mesh.size() || (may_be_empty && told.of.empty()));
    for (const std::uint32_t name : told.of) require(name < told.names.size());
  };
  require(mesh.source_facet.size() == mesh.size());
  require_names(mesh.part, false);
  require_names(mesh.file_material, false);
  require_names(mesh.colour, true);
  require_names(mesh.layer, true);
  for (const FacetProperty& property : mesh.properties) require_names(property.values, false);
  require(mesh.curved.of.empty() || mesh.curved.of.size() == mesh.size());
  for (const std::uint32_t patch : mesh.curved.of)
    require(patch == CurvedFacets::flat || patch < mesh.curved.patches.size());
}

}  // namespace

std::string bytes_of(const ImportedMesh& imported) {
  const FacetMesh& mesh = imported.mesh;
  std::string bytes;
  append(bytes, mesh.positions);
  append(bytes, mesh.facets);
  append(bytes, mesh.source_facet);
  for (const FacetNames* told : {&mesh.part, &mesh.file_material, &mesh.colour, &mesh.layer}) {
    append(bytes, told->of);
    append_words(bytes, told->names);
  }
  append(bytes, mesh.curved.of);
  append(bytes, mesh.curved.patches);
  append_count(bytes, mesh.properties.size());
  for (const FacetProperty& property : mesh.properties) {
    append_words(bytes, {property.name});
    append(bytes, property.values.of);
    append_words(bytes, property.values.names);
  }
  append(bytes, std::vector{mesh.metres_per_unit});
  append_words(bytes, {imported.unit});
  append_words(bytes, imported.warnings);
  return bytes;
}

ImportedMesh imported_of(std::string_view bytes) {
  ImportedMesh imported;
  FacetMesh& mesh = imported.mesh;
  take(bytes, mesh.positions);
  take(bytes, mesh.facets);
  take(bytes, mesh.source_facet);
  for (FacetNames* told : {&mesh.part, &mesh.file_material, &mesh.colour, &mesh.layer}) {
    take(bytes, told->of);
    told->names = take_words(bytes);
  }
  take(bytes, mesh.curved.of);
  take(bytes, mesh.curved.patches);
  for (std::size_t count = take_count(bytes); count > 0; --count) {
    FacetProperty& property = mesh.properties.emplace_back();
    property.name = take_words(bytes).at(0);
    take(bytes, property.values.of);
    property.values.names = take_words(bytes);
  }
  std::vector<double> unit;
  take(bytes, unit);
  mesh.metres_per_unit = unit.at(0);
  imported.unit = take_words(bytes).at(0);
  imported.warnings = take_words(bytes);
  check(mesh);
  measure_facets(mesh);
  return imported;
}

}  // namespace lrcs
