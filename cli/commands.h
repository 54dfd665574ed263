#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace lrcs {

// What every verb is told.
struct Common {
  std::vector<std::string> command;  // the program's arguments
  unsigned threads = 0;              // 0: all
  bool verbose = false, quiet = false;
};

// Each adds its verb to the program; the verb's work runs when the verb is parsed (CLI11 callbacks).
// Work throws InputError for wrong input, std::runtime_error for what could not be finished.
void add_sweep_command(CLI::App& app, Common& common);
void add_view_command(CLI::App& app, Common& common);
void add_report_command(CLI::App& app, Common& common);
void add_plot_command(CLI::App& app, Common& common);
void add_check_command(CLI::App& app, Common& common);
void add_info_command(CLI::App& app, Common& common);
void add_repair_command(CLI::App& app, Common& common);
void add_brdf_commands(CLI::App& app, Common& common);
void add_fit_command(CLI::App& app, Common& common);

// -t, -v, -q, that every verb takes.
void add_common_flags(CLI::App& verb, Common& common);

}  // namespace lrcs
