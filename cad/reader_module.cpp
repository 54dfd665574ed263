#include "cad/reader_module.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "cad/contained.h"

namespace lrcs {
namespace {

std::filesystem::path folder_of_program() {
  std::error_code none;
  return std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
}

}  // namespace

ReadFunction* load_reader(const std::string& reader) {
  const std::filesystem::path here = folder_of_program();
  const std::string name = fmt::format("liblrcs-{}.so", reader);
  const std::vector<std::filesystem::path> places{here / name, here.parent_path() / LRCS_LIBRARY_FOLDER / "lrcs" / name,
                                                  std::filesystem::path(LRCS_INSTALLED_LIBRARIES) / "lrcs" / name,
                                                  name};
  std::string complaints;
  for (const auto& place : places) {
    std::error_code none;
    const bool is_there = place.has_parent_path() && std::filesystem::exists(place, none);
    if (place.has_parent_path() && !is_there) continue;
    if (void* library = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL))
      if (void* function = dlsym(library, "lrcs_read")) return reinterpret_cast<ReadFunction*>(function);
    complaints += fmt::format("{}{}", complaints.empty() ? "" : "; ", dlerror());
    if (is_there) break;
  }
  throw ReaderNotLoaded(fmt::format("a part of lrcs cannot be loaded: {}", complaints));
}

}  // namespace lrcs
