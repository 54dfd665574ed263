#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "view/aspect_view.h"

namespace lrcs {

// Shows a view in a window until it is closed.
// keys: see aspect_window_keys. Mouse: drag turns the target, with shift moves it, the wheel zooms; a click on a facet
//   or a part in the table shows its numbers; slider and curve go to an aspect.
// pictures: folder for what the key s saves. say: is told what was picked and saved, a line each.
// display_ends: called where the X server ends. It must end the process: X does, once it returns.
// error: std::runtime_error, one line, where no window can be opened.
void show_aspect_window(AspectView& view, const std::string& title, const std::filesystem::path& pictures,
                        const std::function<void(const std::string&)>& say, void (*display_ends)());

inline constexpr const char* aspect_window_keys =
    "left, right, PgUp, PgDn, Home, End: aspect   space: play   c: colours   d: dB   a: per area   f: range   l: from "
    "sensor   s: save   q: quit";

}  // namespace lrcs
