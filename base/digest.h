#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace lrcs {

// SHA-256 of the bytes, as 64 lower-case hexadecimal digits.
[[nodiscard]] std::string digest_of(std::string_view bytes);

// The same of a file's content. Throws InputError where the file cannot be read.
[[nodiscard]] std::string digest_of_file(const std::filesystem::path& file);

// The whole content of a file. Throws InputError where it cannot be read.
[[nodiscard]] std::string content_of_file(const std::filesystem::path& file);

}  // namespace lrcs
