#pragma once
#include <tbb/enumerable_thread_specific.h>

#include <memory>
#include <optional>

#include "base/estimate.h"
#include "lrcs/cross_section.h"
#include "lrcs/row_grid.h"

namespace lrcs {

// A cross section by sampling. error: sigma.bound is a calibrated estimate, no proof (docs/methods.md, section 7, says
// what it was tried on); seen_area has none.
struct SampledSection {
  Estimate sigma;          // [m^2]
  double seen_area = 0.0;  // [m^2]
};

// Cross sections of a target to a relative accuracy, by grids of places, where that is cheaper than the exact way. What
// stands at the places is drawn (lrcs/row_drawing.h) or, of bistatic sections and where facets are many and places few,
// met by rays (lrcs/row_rays.h). A grid that is not fine enough tells how fine the next has to be.
// laws: whether to sample, and how, follows from counts and results alone, never from a clock: the same bytes on any
// thread count. On another machine Embree may use other instructions, and a ray that grazes an edge go by it.
class SampledSections {
 public:
  // Keeps a reference. bistatic: are there to be sections of two directions?
  SampledSections(const Target& target, double relative, bool bistatic);
  ~SampledSections();

  // Can sampling be cheaper than the exact way at all? Asked before anything is built.
  [[nodiscard]] static bool may_pay(const Target& target, double relative);

  // The same, of what the target showed from a few directions.
  [[nodiscard]] bool may_pay() const;

  // None where exact is the cheaper way, or nothing is returned. Safe to call from several threads.
  [[nodiscard]] std::optional<SampledSection> section(const Vec3& to_transmitter, const Vec3& to_receiver) const;

 private:
  struct Rays;    // what they need, for all threads
  struct Memory;  // of a thread
  struct Sample;  // by one grid, or several

  void try_out();
  [[nodiscard]] double doubt_of_rays() const;
  [[nodiscard]] double first_size() const;
  [[nodiscard]] bool draws(double size) const;
  [[nodiscard]] bool is_cheaper(double size, bool bistatic) const;
  [[nodiscard]] static Sample combined(const Sample& a, const Sample& b);
  [[nodiscard]] Sample sample(const Vec3& to_transmitter, const Vec3& to_receiver, double size) const;

  const Target& target_;
  double relative_;
  RowGrids grids_;
  double bound_of_one_place_ = 0.0;   // over sigma; the largest of some directions, so that one grid is mostly enough
  double depth_ = 1.0;                // exact_cost; the largest of them
  double variety_ = 0.0;              // rays_cost; the largest of them
  std::unique_ptr<const Rays> rays_;  // null: not needed
  bool trusts_rays_ = false;          // of monostatic rows: where facets touch, drawing may know better
  mutable tbb::enumerable_thread_specific<std::unique_ptr<Memory>> memory_;
};

}  // namespace lrcs
