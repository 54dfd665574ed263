#include "base/gunzip.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "base/input_error.h"

namespace lrcs {
namespace {

constexpr std::size_t always_allowed = std::size_t{64} << 20U;  // [bytes]
constexpr std::size_t most_ratio = 100;

// zlib's inflate on a gzip stream.
class Inflater {
 public:
  explicit Inflater(std::string_view packed) {
    // zlib does not change what it reads.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    left_ = packed.size();
    constexpr int with_gzip_header = 15 + 16;
    if (inflateInit2(&stream_, with_gzip_header) != Z_OK) throw std::runtime_error("zlib cannot be started");
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  // Appends what comes next; false at the end of all members. Throws std::runtime_error with zlib's reason.
  bool next(std::string& out) {
    constexpr std::size_t step = std::size_t{1} << 20U;
    const std::size_t before = out.size();
    out.resize(before + step);
    stream_.next_out = reinterpret_cast<Bytef*>(out.data() + before);
    stream_.avail_out = step;
    const uInt given = static_cast<uInt>(std::min<std::size_t>(left_, std::size_t{1} << 30U));
    stream_.avail_in = given;
    const int code = inflate(&stream_, Z_NO_FLUSH);
    left_ -= given - stream_.avail_in;
    out.resize(out.size() - stream_.avail_out);
    if (code == Z_STREAM_END) {
      if (left_ == 0) return false;
      if (inflateReset(&stream_) != Z_OK) throw std::runtime_error("zlib cannot go on");
      return true;
    }
    if (code != Z_OK && code != Z_BUF_ERROR) throw std::runtime_error(stream_.msg != nullptr ? stream_.msg : "damaged");
    if (left_ == 0 && out.size() == before) throw std::runtime_error("cut off");
    return true;
  }

 private:
  z_stream stream_{};
  std::size_t left_ = 0;
};

}  // namespace

std::string gunzip(std::string_view packed, const std::string& file) {
  const std::size_t most = std::max(always_allowed, most_ratio * packed.size());
  try {
    std::string content;
    Inflater inflater(packed);
    while (inflater.next(content))
      if (content.size() > most)
        throw std::runtime_error(fmt::format("unpacks to more than {} MB, expected at most that", most >> 20U));
    return content;
  } catch (const std::runtime_error& damaged) {
    throw InputError(Place{file}, fmt::format("is compressed by gzip and cannot be unpacked: {}", damaged.what()));
  }
}

}  // namespace lrcs
