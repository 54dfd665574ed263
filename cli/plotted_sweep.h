#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/sweep_cuts.h"

namespace lrcs {

// A sweep that is to be plotted.
struct PlottedSweep {
  std::string input;   // as the user named it
  std::string label;   // the name of its folder; of a file of another name than sweep.csv, that name
  std::string target;  // the name of the target's file; "": not known
  std::vector<SweepRow> rows;

  [[nodiscard]] bool is_monostatic() const;
};

// From a folder that `lrcs sweep` wrote, or from its sweep.csv. error: InputError that names what was expected.
[[nodiscard]] PlottedSweep read_plotted_sweep(const std::string& input);

// Labels that are the same become the words that the user named the sweeps by.
void tell_apart(std::vector<PlottedSweep>& sweeps);

// Which cut of a sweep is meant: against azimuth at that elevation, or against elevation at that azimuth; neither: all
// that there are.
struct CutChoice {
  std::optional<double> azimuth_deg, elevation_deg;
};
// error: InputError where the sweep has no such cut; it lists those that it has.
[[nodiscard]] Cuts chosen_cuts(const PlottedSweep& sweep, const CutChoice& choice);

// error: InputError where there are several; it lists them.
void require_one_cut(const PlottedSweep& sweep, const Cuts& cuts);

}  // namespace lrcs
