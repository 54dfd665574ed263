#pragma once
#include "cli/commands.h"

namespace lrcs {

// Says once that pictures hold letters that no installed font has, and what to install.
void warn_of_letters_without_font(const Common& common);

}  // namespace lrcs
