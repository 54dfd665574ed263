#pragma once
#include <filesystem>
#include <string_view>

namespace lrcs {

// A file that appears whole or not at all: it is written under a temporary name in the same folder, then renamed.
// Not committed, or the program killed: the final name is untouched. Throws std::runtime_error where writing fails.
class WholeFile {
 public:
  explicit WholeFile(std::filesystem::path final_name);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  // The name to write to: in the folder of the final name, hidden, with the same extension.
  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }
  // Brings the temporary file to disk and gives it its final name.
  void commit();

 private:
  std::filesystem::path final_;
  std::filesystem::path temporary_;
};

void write_whole_file(const std::filesystem::path& file, std::string_view content);

}  // namespace lrcs
