#pragma once
#include <string>

namespace lrcs {

// The processor, how many of them, what else they do now, and the compiler: a line.
[[nodiscard]] std::string machine_facts();

}  // namespace lrcs
