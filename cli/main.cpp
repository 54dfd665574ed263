#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "base/input_error.h"
#include "base/nearest_name.h"
#include "base/version.h"
#include "cli/commands.h"
#include "cli/font_warning.h"

namespace lrcs {
namespace {

// Why the word is no number of threads; "" if it is one.
std::string thread_complaint(const std::string& word) {
  unsigned threads = 0;
  const auto [end, wrong] = std::from_chars(word.data(), word.data() + word.size(), threads);
  const bool good = wrong == std::errc{} && end == word.data() + word.size() && threads >= 1 && threads <= 4096;
  return good ? "" : fmt::format("expected a number of threads, 1 to 4096, found '{}'", word);
}

}  // namespace

void add_common_flags(CLI::App& verb, Common& common) {
  verb.add_option("-t,--threads", common.threads, "Number of threads (default: all)")
      ->check(CLI::Validator(thread_complaint, "1..4096"));
  verb.add_flag("-v,--verbose", common.verbose, "Say more");
  verb.add_flag("-q,--quiet", common.quiet, "Say nothing but errors");
}

namespace {

constexpr int done = 0, could_not_finish = 1, wrong_input = 2;

std::vector<std::string> verb_names(const CLI::App& app) {
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
  return verbs;
}

// CLI11's own message for a mistyped verb does not name the nearest one.
void check_verb(const CLI::App& app, const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().starts_with('-')) return;
  const auto verbs = verb_names(app);
  if (std::find(verbs.begin(), verbs.end(), arguments.front()) != verbs.end()) return;
  throw InputError(fmt::format("unknown verb '{}'{} (verbs: {})", arguments.front(),
                               did_you_mean(arguments.front(), verbs), fmt::join(verbs, ", ")));
}

std::string value_complaint(const CLI::App& verb, const CLI::ParseError& wrong) {
  std::string message = wrong.what();
  if (wrong.get_name() != "ArgumentMismatch") return message;
  for (const CLI::Option* option : verb.get_options())
    if (option->count() > 1 && option->get_expected_max() == 1)
      return fmt::format("{}: expected once, found {} times", option->get_name(), option->count());
  return fmt::format("{}: its value is missing", message.substr(0, message.find(':')));
}

// CLI11's own message does not name the nearest flag, and a missing value hides an unknown flag.
std::string flag_complaint(const CLI::App& app, const CLI::ParseError& wrong) {
  const auto used = app.get_subcommands();
  const CLI::App& verb = used.empty() ? app : *used.front();
  const std::string help = used.empty() ? "lrcs --help" : fmt::format("lrcs {} --help", verb.get_name());
  std::vector<std::string> flags;
  for (const CLI::Option* option : verb.get_options())
    for (const auto& name : option->get_lnames()) flags.push_back("--" + name);
  const auto left_over = app.remaining(true);
  const auto flag = std::find_if(left_over.begin(), left_over.end(), [](const auto& w) { return w.starts_with('-'); });
  if (flag != left_over.end()) {
    const std::string name = flag->substr(0, flag->find('='));
    return fmt::format("unknown flag '{}'{} (see {})", name, did_you_mean(name, flags), help);
  }
  if (!left_over.empty()) return fmt::format("unexpected argument '{}' (see {})", left_over.front(), help);
  if (used.empty())
    return fmt::format("a verb is missing: expected one of {} (see {})", fmt::join(verb_names(app), ", "), help);
  return fmt::format("{} (see {})", value_complaint(verb, wrong), help);
}

// One line, whatever a file's name or the user's words hold.
int complain(int status, std::string message) {
  std::replace_if(
      message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  fmt::print(stderr, "lrcs: {}\n", message);
  return status;
}

// What was printed may still wait in a buffer; a full disk shows only now.
int finish_output() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return done;
  return complain(could_not_finish, fmt::format("standard output: cannot be written: {}", std::strerror(errno)));
}

int run(int argc, char** argv) {
  Common common;
  common.command.assign(argv, argv + argc);
  CLI::App app("Laser radar cross section of CAD targets", "lrcs");
  app.set_version_flag("--version", fmt::format("lrcs {}", version));
  app.require_subcommand(1);
  add_sweep_command(app, common);
  add_check_command(app, common);
  add_info_command(app, common);
  add_view_command(app, common);
  add_plot_command(app, common);
  add_report_command(app, common);
  add_repair_command(app, common);
  add_fit_command(app, common);
  add_brdf_commands(app, common);
  try {
    check_verb(app, {common.command.begin() + std::min(argc, 1), common.command.end()});
    app.parse(argc, argv);
    warn_of_letters_without_font(common);
    return finish_output();
  } catch (const CLI::Success& help) {
    app.exit(help);
    return finish_output();
  } catch (const CLI::ParseError& wrong) {
    return complain(wrong_input, flag_complaint(app, wrong));
  } catch (const InputError& wrong) {
    return complain(wrong_input, wrong.what());
  } catch (const std::bad_alloc&) {
    return complain(could_not_finish, "not enough memory");
  } catch (const std::exception& failed) {
    return complain(could_not_finish, failed.what());
  }
}

}  // namespace
}  // namespace lrcs

int main(int argc, char** argv) try {
  std::signal(SIGXFSZ, SIG_IGN);  // a file larger than the user's limit is an error to report, not the end
  return lrcs::run(argc, argv);
} catch (...) {  // run() catches what its work throws; this is memory that ran out before or after
  std::fputs("lrcs: could not finish\n", stderr);
  return 1;
}
