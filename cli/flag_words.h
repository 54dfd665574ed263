#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/direction.h"
#include "brdf/material.h"

namespace lrcs {

// What a user writes after a flag, read and checked. error: InputError that names the flag and what was expected.

// A finite number.
[[nodiscard]] double number_from_words(std::string_view words, const std::string& flag);

// Which angles a flag takes [deg].
struct AngleDomain {
  bool (*holds)(double deg);
  const char* what;
};
extern const AngleDomain azimuth_domain, elevation_domain, incidence_domain;

// "17", "0,10,45" or "from:to:step" [deg].
[[nodiscard]] std::vector<double> angles_from_words(const std::string& words, const std::string& flag,
                                                    const AngleDomain& domain);

// "azimuth,elevation" [deg].
[[nodiscard]] AspectAngles angle_pair_from_words(const std::string& words, const std::string& flag);

// The file that a flag names can be written: it has one of these endings (the first is the one to name), and its folder
// is there.
void require_output_file(const std::string& file, const std::string& flag, const std::vector<std::string>& endings);

// The folder of the file that a flag names is there.
void require_folder_of(const std::filesystem::path& file, const std::string& flag);

// The words between the separators: one more than there are separators.
[[nodiscard]] std::vector<std::string> split(std::string_view words, char separator);

// lambert:REFLECTANCE, a name of the library, or a material file; what looks like a file and is none is told so.
[[nodiscard]] Material material_from_argument(const std::string& words);

// "1600x900" [pixel]. error: InputError that names the flag, for less than the least size or more than 8000 x 8000.
struct PictureSize {
  int width, height;
};
[[nodiscard]] PictureSize size_from_words(const std::string& words, const std::string& flag, const PictureSize& least);

}  // namespace lrcs
