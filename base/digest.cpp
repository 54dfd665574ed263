#include "base/digest.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "base/input_error.h"

namespace lrcs {

std::string digest_of(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> sum{};
  unsigned int size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), sum.data(), &size, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("SHA-256 is not available");
  std::string hex;
  for (unsigned int k = 0; k < size; ++k) hex += fmt::format("{:02x}", sum[k]);
  return hex;
}

std::string content_of_file(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) throw InputError(Place{file.string()}, "is a folder, expected a file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(Place{file.string()}, fmt::format("cannot be read: {}", std::strerror(errno)));
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string digest_of_file(const std::filesystem::path& file) {
  return digest_of(content_of_file(file));
}

}  // namespace lrcs
