#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "mesh/facet_mesh.h"
#include "view/sweep_plot.h"

namespace lrcs {

// A cut, and the row of the sweep at each of its angles.
struct ViewedCut {
  Curve curve;
  std::vector<std::size_t> rows;
};

// A sweep to be looked at, row by row.
struct ViewedSweep {
  const FacetMesh* mesh = nullptr;
  std::string title;
  PlotText axis;  // its title is not used
  std::vector<ViewedCut> cuts;
  // Where each row stands: on a cut, at one of its angles.
  struct Place {
    std::size_t cut, point;
  };
  std::vector<Place> places;
  std::vector<double> sigma_m2, bound_m2;  // one a row, as the sweep found them
};

}  // namespace lrcs
