#include "base/digest.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "base/input_error.h"
#include "base/large_pages.h"

namespace lrcs {

namespace {

// SHA-256 of bytes that come in pieces.
class Digest {
 public:
  Digest() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
  }
  void add(std::string_view bytes) { check(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size())); }
  [[nodiscard]] std::string finish() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> sum{};
    unsigned int size = 0;
    check(EVP_DigestFinal_ex(context_.get(), sum.data(), &size));
    std::string hex;
    for (unsigned int k = 0; k < size; ++k) hex += fmt::format("{:02x}", sum[k]);
    return hex;
  }

 private:
  static void check(int is_done) {
    if (is_done != 1) throw std::runtime_error("SHA-256 is not available");
  }

  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context_;
};

std::ifstream opened(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) throw InputError(Place{file.string()}, "is a folder, expected a file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(Place{file.string()}, fmt::format("cannot be read: {}", std::strerror(errno)));
  return in;
}

}  // namespace

std::string digest_of(std::string_view bytes) {
  Digest digest;
  digest.add(bytes);
  return digest.finish();
}

std::string content_of_file(const std::filesystem::path& file) {
  std::ifstream in = opened(file);
  // What has no size (a pipe, /proc) grows as it is read.
  std::error_code none;
  const auto size = std::filesystem::file_size(file, none);
  std::string content;
  content.reserve(none ? 0 : static_cast<std::size_t>(size));
  prefer_large_pages(content.data(), content.capacity());
  content.resize(none ? 0 : static_cast<std::size_t>(size));
  in.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(in.gcount()));
  in.clear();
  content.append(std::istreambuf_iterator<char>(in), {});
  return content;
}

std::string digest_of_file(const std::filesystem::path& file) {
  std::ifstream in = opened(file);
  Digest digest;
  std::string piece(1U << 16U, '\0');
  do {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    digest.add({piece.data(), static_cast<std::size_t>(in.gcount())});
  } while (in);
  return digest.finish();
}

}  // namespace lrcs
