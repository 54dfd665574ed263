// lrcs_mutants: what `lrcs info` does, of a thousand files that are wrong. See about. scripts/sanitize.sh builds and
// runs it with sanitizers.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/input_error.h"
#include "cad/read_target.h"
#include "cad/reader_module.h"
#include "made_cad.h"
#include "made_gltf.h"
#include "mesh/diagnosis.h"
#include "mesh/info_text.h"
#include "tests/mesh/mesh_files.h"
#include "tests/mutations.h"
#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

constexpr auto about =
    "Reads and diagnoses files as `lrcs info` does, each in a process of its own: seeded mutations of good STL, OBJ,\n"
    "PLY, OFF, GLB and STEP files, and the FILES given. Each must end within 5 s and 1 GB in a diagnosis, or in exit\n"
    "status 2 with one line that names the file; and no sanitizer may say anything. Files that fail stay in --keep.\n"
    "Exit status: 0; 1: one of them did not; 2: wrong command.";

constexpr unsigned longest_s = 5;
constexpr long most_kilobytes = 1L << 20;

constexpr int is_diagnosed = 0, is_refused = 2;

struct GoodFile {
  std::string format, bytes;  // format: as extensions have it
};

// Two solids, one of them round. The date would make another file every second.
std::string step(const std::filesystem::path& folder) {
  MadeCad made;
  const TDF_Label ship = made.assembly("ship");
  made.place(ship, made.product(box_of(10.0, 20.0, 30.0), "bus"), moved_by(0.0, 0.0, 0.0));
  made.place(ship, made.product(BRepPrimAPI_MakeCylinder(2.0, 9.0).Shape(), "tank"), moved_by(0.0, 0.0, 40.0));
  made.write_step(folder / "good.step");
  std::string bytes = content_of(folder / "good.step");
  const std::size_t name = bytes.find("FILE_NAME");
  const std::size_t date = bytes.find(",'", name);
  return bytes.replace(date, bytes.find("',", date) - date, ",'2000-01-01T00:00:00");
}

std::vector<GoodFile> good_files(const std::filesystem::path& folder) {
  const FacetMesh box = unit_box();
  const std::string named = obj(box) + "o second\nusemtl gold\nf 1 2 4 3\nf -1 -2 -4\n";
  const std::string cad = step(folder),
                    nodes = glb_of(R"({"name": "ship", "children": [1]}, {"name": "mast", "mesh": 0})");
  return {{"stl", text_stl(box) + text_stl(box, "second")},
          {"obj", named},
          {"ply", ply(box, "ascii")},
          {"off", off(box)},
          {"glb", nodes},
          {"step", cad},
          {"stl", binary_stl(box)},
          {"obj", named},
          {"ply", ply(box, "binary_little_endian")},
          {"off", "C" + off(box)},
          {"glb", nodes},
          {"step", cad}};
}

// The work of `lrcs info`; its exit status, and what it complains of in the file beside.
int info_on(const std::filesystem::path& file, const std::filesystem::path& complaint) {
  const auto say = [&](const char* what) { std::ofstream(complaint) << what; };
  try {
    const TargetRead read = read_target(file);
    const FileFacts facts{file.string(), read.unit, read.tessellation, read.warnings};
    return info_text(diagnose(read.mesh), facts).empty() ? 1 : is_diagnosed;
  } catch (const InputError& wrong) {
    say(wrong.what());
    return is_refused;
  } catch (const std::exception& other) {
    say(other.what());
    return 1;
  }
}

// How one file ended.
struct Ending {
  std::string fault;  // "": as it should
  bool refused = false;
  double seconds = 0.0;  // of processor time
  long kilobytes = 0;
};

class Trials {
 public:
  explicit Trials(const std::filesystem::path& scratch)
      : complaint_(scratch / "complaint"), report_(scratch / "report") {}

  [[nodiscard]] Ending look_at(const std::filesystem::path& file) const {
    std::filesystem::remove(complaint_);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process for a file");
    if (child == 0) {
      alarm(longest_s);
      dup2(open(report_.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_APPEND, 0600), STDERR_FILENO);
      _exit(info_on(file, complaint_));
    }
    int status = 0;
    rusage used{};
    while (wait4(child, &status, 0, &used) < 0 && errno == EINTR) {}
    Ending ending;
    ending.seconds = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                     1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    ending.kilobytes = used.ru_maxrss;
    ending.refused = WIFEXITED(status) && WEXITSTATUS(status) == is_refused;
    ending.fault = fault_of(file, status, ending);
    return ending;
  }
  // What the last file was refused with.
  [[nodiscard]] std::string complaint() const { return content_of(complaint_); }

 private:
  [[nodiscard]] std::string fault_of(const std::filesystem::path& file, int status, const Ending& ending) const {
    const std::string complaint = this->complaint();
    const std::string report = this->report(ending.refused);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) return fmt::format("takes more than {} s", longest_s);
    if (WIFSIGNALED(status)) return fmt::format("ends by signal {}: {}", WTERMSIG(status), report);
    if (!report.empty()) return report;
    if (ending.kilobytes > most_kilobytes) return fmt::format("takes {} MB", ending.kilobytes >> 10);
    if (WEXITSTATUS(status) == is_diagnosed) return "";
    if (!ending.refused) return fmt::format("ends with status {}: {}", WEXITSTATUS(status), complaint);
    const bool is_one_line = complaint.starts_with(file.string()) && complaint.find('\n') == std::string::npos;
    return is_one_line ? "" : fmt::format("is refused by '{}', expected one line that names it", complaint);
  }

  // What sanitizers wrote, of the process that read and of readers of other people's making in processes of their own.
  // Of those, one that wants more memory than there is has no other way to say so under a sanitizer.
  [[nodiscard]] std::string report(bool by_other_process) const {
    const std::string text = content_of(report_);
    const auto has = [&](const char* words) { return text.find(words) != std::string::npos; };
    if (!has("ERROR: AddressSanitizer") && !has("runtime error:")) return "";
    const bool is_memory = has("allocation-size-too-big") || has("out-of-memory");
    return is_memory && by_other_process && !has("runtime error:") ? "" : text;
  }

  std::filesystem::path complaint_, report_;
};

struct Options {
  std::uint64_t first = 1, count = 1000;
  std::filesystem::path keep = "mutants", scratch;
  std::vector<std::filesystem::path> files;
};

struct Tally {
  int read = 0, refused = 0, wrong = 0;
  double seconds = 0.0;
  long kilobytes = 0;
};

class Run {
 public:
  explicit Run(const Options& options) : options_(options), trials_(options.scratch) {}

  void look_at_mutants() {
    const std::vector<GoodFile> good = good_files(options_.scratch);
    for (const GoodFile& one : good) {
      const auto file = mutant(one.format);
      std::ofstream(file, std::ios::binary) << one.bytes;
      const Ending ending = trials_.look_at(file);
      if (ending.refused || !ending.fault.empty())
        throw std::runtime_error(
            fmt::format("the good {} is wrong: {}{}", one.format, ending.fault, trials_.complaint()));
    }
    for (std::uint64_t seed = options_.first; seed < options_.first + options_.count; ++seed) {
      const GoodFile& one = good[seed % good.size()];
      const GoodFile& other = good[(seed / good.size()) % good.size()];
      const auto file = mutant(one.format);
      std::ofstream(file, std::ios::binary) << Mutations(seed).of(one.bytes, other.bytes);
      const Ending ending = trials_.look_at(file);
      note(one.format, ending);
      if (!ending.fault.empty()) keep(file, one.format, seed, ending);
    }
  }

  void look_at_files() {
    for (const auto& file : options_.files) {
      const Ending ending = trials_.look_at(file);
      note("files", ending);
      const std::string found = ending.refused ? trials_.complaint() : "is diagnosed";
      fmt::print("{}: {}\n", file.filename().string(), ending.fault.empty() ? found : "WRONG: " + ending.fault);
    }
  }

  // Prints the table; whether all ended as they should.
  [[nodiscard]] bool tell() const {
    bool all_right = true;
    fmt::print("{:8}{:>10}{:>10}{:>8}{:>20}{:>14}\n", "", "diagnosed", "refused", "wrong", "most processor s",
               "most MB");
    for (const auto& [format, t] : tallies_) {
      fmt::print("{:8}{:10}{:10}{:8}{:20.2f}{:14}\n", format, t.read, t.refused, t.wrong, t.seconds, t.kilobytes >> 10);
      all_right = all_right && t.wrong == 0;
    }
    return all_right;
  }

 private:
  [[nodiscard]] std::filesystem::path mutant(const std::string& format) const {
    return options_.scratch / ("mutant." + format);
  }

  void note(const std::string& format, const Ending& ending) {
    Tally& t = tallies_[format];
    ++(!ending.fault.empty() ? t.wrong : ending.refused ? t.refused : t.read);
    t.seconds = std::max(t.seconds, ending.seconds);
    t.kilobytes = std::max(t.kilobytes, ending.kilobytes);
  }

  void keep(const std::filesystem::path& file, const std::string& format, std::uint64_t seed, const Ending& ending) {
    std::filesystem::create_directories(options_.keep);
    const auto kept = options_.keep / fmt::format("{}.{}", seed, format);
    std::filesystem::copy_file(file, kept, std::filesystem::copy_options::overwrite_existing);
    fmt::print("seed {}, kept as {}: {}\n", seed, kept.string(), ending.fault);
    std::fflush(stdout);
  }

  const Options& options_;
  Trials trials_;
  std::map<std::string, Tally> tallies_;
};

int run(int argc, char** argv) {
  Options options;
  CLI::App app(about, "lrcs_mutants");
  app.add_option("--first-seed", options.first, "Of the mutations (default 1)");
  app.add_option("--count", options.count, "How many mutations (default 1000)");
  app.add_option("--keep", options.keep, "Folder for files that fail (default mutants)");
  app.add_option("--scratch", options.scratch, "Folder for files that come and go")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_option("FILES", options.files, "Files that are looked at besides");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return app.exit(stop) == 0 ? 0 : 2;
  }
  // Loaded once, here: every process has them then.
  for (const char* reader : {"occt", "assimp"}) (void)load_reader(reader);
  Run trials(options);
  if (options.count > 0) trials.look_at_mutants();
  trials.look_at_files();
  return trials.tell() ? 0 : 1;
}

}  // namespace
}  // namespace lrcs

int main(int argc, char** argv) try { return lrcs::run(argc, argv); } catch (const std::exception& failed) {
  std::fprintf(stderr, "lrcs_mutants: %s\n", failed.what());
  return 1;
}
