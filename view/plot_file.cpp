#include "view/plot_file.h"

#include "base/input_error.h"
#include "base/whole_file.h"

namespace lrcs {
namespace {

bool is_svg(const std::filesystem::path& file) {
  if (file.extension() == ".svg") return true;
  if (file.extension() == ".png") return false;
  throw InputError(Place{file.string()}, "expected a file for a plot, that ends in .png or .svg");
}

}  // namespace

Canvas plot_canvas(const std::filesystem::path& file, int width, int height, double magnification) {
  return {width, height, is_svg(file) ? Recording::shapes : Recording::none, magnification};
}

void write_plot(const std::filesystem::path& file, const Canvas& canvas) {
  if (is_svg(file))
    write_whole_file(file, canvas.svg());
  else
    write_png(file, canvas.picture());
}

}  // namespace lrcs
