#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace lrcs {

// Colours that Wavefront material libraries (MTL) give to the materials of an OBJ file.
// value: "#rrggbb", 255 times the diffuse colour Kd, rounded. Spectra, XYZ and textures are not read.
// error: a library that cannot be read, or has a Kd that is none, is a warning at its place; none of its colours count.
class MtlColours {
 public:
  // folder: of the OBJ file, which the libraries are named from. warnings: may be null.
  MtlColours(std::filesystem::path folder, std::vector<std::string>* warnings)
      : folder_(std::move(folder)), warnings_(warnings) {}

  // What a mtllib statement names: one file, or several between blanks. Each is read once.
  void add_libraries(std::string_view names);

  // "" for a material without a colour.
  [[nodiscard]] std::string_view of(std::string_view material) const;

 private:
  void add(const std::string& name);

  std::filesystem::path folder_;
  std::vector<std::string>* warnings_;
  std::set<std::string> known_;
  std::map<std::string, std::string, std::less<>> colours_;
};

}  // namespace lrcs
