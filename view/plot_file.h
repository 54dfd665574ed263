#pragma once
#include <filesystem>

#include "view/canvas.h"

namespace lrcs {

// A white canvas for a plot that will be written to this file.
// error: InputError unless the file's name ends in .png or .svg.
[[nodiscard]] Canvas plot_canvas(const std::filesystem::path& file, int width, int height, double magnification = 1.0);

// Writes the plot as the file's name says: .png pixels, .svg shapes. The file appears whole or not at all; the same
// plot gives the same bytes. error: InputError at any other ending; std::runtime_error where writing fails.
// domain: .svg: a canvas that records its shapes, as plot_canvas() makes it; else std::logic_error.
void write_plot(const std::filesystem::path& file, const Canvas& canvas);

}  // namespace lrcs
