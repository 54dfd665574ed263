#pragma once
#include <cstddef>
#include <vector>

namespace lrcs {

// Asks the system to back memory by large pages: memory that is new costs by the page, and a vector of megabytes has
// many. A hint: where the system has none, or for less than a few megabytes, nothing is done.
void prefer_large_pages(void* begin, std::size_t bytes);

// vector::reserve() and that, before the memory is touched.
template <class T>
void reserve_large(std::vector<T>& values, std::size_t count) {
  values.reserve(count);
  prefer_large_pages(values.data(), values.capacity() * sizeof(T));
}

// A vector of so many values in such memory.
template <class T>
[[nodiscard]] std::vector<T> large_vector(std::size_t count) {
  std::vector<T> values;
  reserve_large(values, count);
  values.resize(count);
  return values;
}

}  // namespace lrcs
