#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

namespace lrcs {

// Makes wrong files of good ones: the same file from the same random numbers, on every machine.
class Mutations {
 public:
  explicit Mutations(std::uint64_t seed) : random_(seed) {}

  // A good file with one to three things done to it, mostly one, one time in six with its end cut off. other: a file to
  // take a stretch of bytes from.
  std::string of(std::string bytes, const std::string& other) {
    for (std::size_t left = 1 + below(2) * below(3); left > 0 && !bytes.empty(); --left) change(bytes, other);
    if (below(6) == 0) bytes.resize(below(bytes.size() + 1));
    return bytes;
  }

 private:
  std::size_t below(std::size_t end) { return end == 0 ? 0 : random_() % end; }

  struct Stretch {
    std::size_t begin, size;
  };
  Stretch stretch_of(const std::string& bytes) {
    const std::size_t begin = below(bytes.size());
    return {begin, std::min(bytes.size() - begin, 1 + below(below(2) == 0 ? 16 : bytes.size()))};
  }

  void change(std::string& bytes, const std::string& other) {
    switch (below(8)) {
      case 0:
        return flip(bytes, [this] { return static_cast<char>(random_()); });
      case 1:
        return flip(bytes, [this] { return static_cast<char>(32 + below(95)); });
      case 2:
        return remove(bytes);
      case 3:
        return repeat(bytes);
      case 4:
        return replace_number(bytes);
      case 5:
        return swap_lines(bytes);
      case 6:
        return splice(bytes, other);
      default:
        return overwrite_word(bytes);
    }
  }

  template <class Byte>
  void flip(std::string& bytes, const Byte& byte) {
    for (std::size_t left = 1 + below(6); left > 0; --left) bytes[below(bytes.size())] = byte();
  }
  void remove(std::string& bytes) {
    const Stretch s = stretch_of(bytes);
    bytes.erase(s.begin, s.size);
  }
  void repeat(std::string& bytes) {
    const Stretch s = stretch_of(bytes);
    const std::string piece = bytes.substr(s.begin, s.size);
    for (std::size_t left = 1 + below(20); left > 0; --left) bytes.insert(s.begin, piece);
  }
  // The digits at some place, or after it, become a number that nobody expects.
  void replace_number(std::string& bytes) {
    constexpr std::array<const char*, 14> numbers{"0",           "-1",   "1e308", "-1e308",
                                                  "1e-320",      "nan",  "inf",   "4294967295",
                                                  "1.5",         "1e99", "",      "99999999999999999999",
                                                  "-2147483648", "#0"};
    const std::size_t begin = bytes.find_first_of("0123456789", below(bytes.size()));
    if (begin == std::string::npos) return;
    const std::size_t end = std::min(bytes.find_first_not_of("0123456789.+-eE", begin), bytes.size());
    bytes.replace(begin, end - begin, numbers.at(below(numbers.size())));
  }
  void swap_lines(std::string& bytes) {
    const std::string_view all = bytes;
    const auto line_at = [&](std::size_t place) {
      const std::size_t before = all.rfind('\n', place);
      const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
      return Stretch{begin, std::min(all.find('\n', begin), all.size()) - begin};
    };
    Stretch a = line_at(below(all.size())), b = line_at(below(all.size()));
    if (b.begin < a.begin) std::swap(a, b);
    if (a.begin + a.size > b.begin) return;
    const std::string lower(all.substr(b.begin, b.size)), upper(all.substr(a.begin, a.size));
    bytes.replace(b.begin, b.size, upper);
    bytes.replace(a.begin, a.size, lower);
  }
  void splice(std::string& bytes, const std::string& other) {
    if (other.empty()) return;
    const Stretch from = stretch_of(other), to = stretch_of(bytes);
    bytes.replace(to.begin, to.size, other, from.begin, from.size);
  }
  // Four bytes become a count, an index or a float that nobody expects.
  void overwrite_word(std::string& bytes) {
    constexpr std::array<std::uint32_t, 8> words{0,          1,          0xffffffff, 0x7fffffff,
                                                 0x80000000, 0x7fc00000, 0x7f7fffff, 0x00ffffff};
    std::uint32_t word = words.at(below(words.size()));
    const std::size_t begin = below(bytes.size());
    for (std::size_t k = begin; k < std::min(begin + 4, bytes.size()); ++k, word >>= 8U)
      bytes[k] = static_cast<char>(word & 0xffU);
  }

  std::mt19937_64 random_;
};

}  // namespace lrcs
