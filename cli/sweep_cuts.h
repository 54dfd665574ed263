#pragma once
#include <string>
#include <vector>

#include "lrcs/sweep.h"
#include "view/viewed_sweep.h"

namespace lrcs {

// A sweep as cuts to draw: sigma against azimuth, one cut an elevation; against elevation where the azimuth is always
// the same; against the row's number for a list of loose directions.
struct Cuts {
  std::vector<ViewedCut> cuts;
  std::string axis;  // "azimuth [deg]", ...
  CutAngle angle = CutAngle::azimuth;

  // The first ones. left_out: how many are not among them.
  [[nodiscard]] std::vector<Curve> curves(std::size_t most, std::size_t* left_out = nullptr) const;
};
[[nodiscard]] Cuts cuts_of(const std::vector<SweepRow>& rows);

// The same with every row on a cut: against the row's number where directions repeat, or most have a cut of their own.
[[nodiscard]] Cuts cuts_of_all(const std::vector<SweepRow>& rows);

// All cuts against azimuth, one an elevation; against elevation, one an azimuth. Some may have one direction only.
// Azimuths that reach across the nose rise there: see azimuth_before_nose.
[[nodiscard]] Cuts azimuth_cuts(const std::vector<SweepRow>& rows);
[[nodiscard]] Cuts elevation_cuts(const std::vector<SweepRow>& rows);

// Azimuths that reach across the nose, 340, 350, 0, 10, are drawn as -20, -10, 0, 10: nothing is drawn across
// directions that nobody computed. value: from which azimuth on they are less by a turn [deg]; infinity: none is.
[[nodiscard]] double azimuth_before_nose(const std::vector<double>& rising);

// More are not told apart in one plot.
inline constexpr std::size_t most_curves = 7;

// The sweep to be looked at on a target; both are to outlive it.
[[nodiscard]] ViewedSweep viewed_sweep(const std::vector<SweepRow>& rows, const FacetMesh& mesh, std::string title);

}  // namespace lrcs
