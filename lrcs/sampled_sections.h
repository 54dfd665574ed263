#pragma once
#include <tbb/enumerable_thread_specific.h>

#include <memory>
#include <optional>

#include "base/estimate.h"
#include "lrcs/cross_section.h"
#include "lrcs/row_grid.h"

namespace lrcs {

class EmbreeScene;
class RowSums;
class TouchingFacets;

// A cross section by sampling. error: sigma.bound is an estimate that held in all cases tried (lrcs/row_spread.h).
struct SampledSection {
  Estimate sigma;          // [m^2]
  double seen_area = 0.0;  // [m^2]
};

// Cross sections of a target to a relative accuracy, by grids of rays (Embree), where that is cheaper than the exact
// way. A grid that is not fine enough tells how fine the next has to be.
// laws: whether to sample, and how, follows from counts and results alone, never from a clock: the same bytes on any
// thread count. On another machine Embree may use other instructions, and a ray that grazes an edge go by it.
class SampledSections {
 public:
  // Keeps a reference.
  SampledSections(const Target& target, double relative);
  ~SampledSections();

  // Can sampling be cheaper than the exact way at all? Asked before anything is built.
  [[nodiscard]] static bool may_pay(const Target& target, double relative);

  // None where exact is the cheaper way, or nothing is returned. Safe to call from several threads.
  [[nodiscard]] std::optional<SampledSection> section(const Vec3& to_transmitter, const Vec3& to_receiver) const;

 private:
  [[nodiscard]] SampledSection cast(const Vec3& to_transmitter, const Vec3& to_receiver, double size) const;

  const Target& target_;
  double relative_;
  std::unique_ptr<const EmbreeScene> scene_;
  std::unique_ptr<const TouchingFacets> touching_;
  RowGrids grids_;
  mutable tbb::enumerable_thread_specific<std::unique_ptr<RowSums>> sums_;
};

}  // namespace lrcs
