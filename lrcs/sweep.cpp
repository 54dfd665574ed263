#include "lrcs/sweep.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <span>

#include "lrcs/convex_body.h"
#include "lrcs/convexity.h"
#include "lrcs/facet_sections.h"
#include "lrcs/mirror_planes.h"
#include "lrcs/return_error.h"
#include "lrcs/sampled_sections.h"
#include "lrcs/sweep_plan.h"

namespace lrcs {
namespace {

class Sweep {
 public:
  Sweep(const Target& target, const std::vector<Aspect>& aspects, const SweepWatch& watch,
        std::optional<double> relative)
      : target_(target), aspects_(aspects), watch_(watch), relative_(relative), rows_(aspects.size()) {
    for (std::size_t row = 0; row < aspects.size(); ++row)
      wanted_.push_back(watch.wants_facets && watch.wants_facets(row));
  }

  // To be called where the threads allowed are.
  std::vector<SweepRow> run() {
    if (aspects_.empty()) return {};
    convex_ = is_convex_body(target_.mesh);
    if (!convex_ && relative_ && target_.curved.empty() && SampledSections::may_pay(target_, *relative_)) {
      sampled_.emplace(target_, *relative_, has_pairs());
      if (!sampled_->may_pay()) sampled_.reset();
    }
    if (!convex_ && !sampled_) visibility_.emplace(target_.mesh);
    plan();
    if (convex_) compute_convex();
    if (sampled_) sample();
    if (visibility_) leave_out_facets();
    sections_.emplace(target_, visibility_ ? &*visibility_ : nullptr);
    methods_.exact = alone_.size() + batched_.size();
    tbb::parallel_for(std::size_t{0}, alone_.size(), [this](std::size_t k) { compute(alone_[k]); });
    copy_alike();
    return std::move(rows_);
  }

  [[nodiscard]] const SkipCounts& skipped() const { return skipped_; }
  [[nodiscard]] const MethodCounts& methods() const { return methods_; }

 private:
  [[nodiscard]] bool is_copied(std::size_t row) const { return alike_[row] != row && !wanted_[row]; }

  // Parts the rows into those computed each by itself, those of a convex body in batches, and copies.
  void plan() {
    find_alike();
    for (std::size_t row = 0; row < aspects_.size(); ++row) {
      if (is_copied(row)) continue;
      (convex_ && !wanted_[row] && target_.curved.empty() ? batched_ : alone_).push_back(row);
      const Aspect& aspect = aspects_[row];
      ++(aspect.to_transmitter == aspect.to_receiver ? skipped_.monostatic_directions
                                                     : skipped_.fixed_gamma_directions);
    }
    for (std::size_t f = 0; f < target_.mesh.size(); ++f)
      if (is_black(target_.material[f]) && (target_.sides == Sides::front || is_black(target_.back_material()[f])))
        ++skipped_.facets_without_return;
  }

  [[nodiscard]] bool is_black(std::uint32_t material) const { return returns_nothing(target_.materials[material]); }

  // Symmetry is not sought for a convex target: that takes longer than what it could save.
  void find_alike() {
    alike_ = first_alike(aspects_, {});
    for (std::size_t row = 0; row < alike_.size(); ++row)
      if (is_copied(row)) ++skipped_.repeated_directions;
    // Curved facets may differ where flat ones do not.
    if (convex_ || !target_.curved.empty()) return;
    // Which facets lie on each other matters only where their materials differ, and is not known without visibility.
    if (!visibility_ && !target_.has_one_material()) return;
    const auto coincident = visibility_ ? visibility_->coincident_facets() : std::vector<CoincidentFacets>{};
    const MirrorPlanes planes = mirror_planes(target_, planes_of_use(aspects_), coincident);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (planes[axis]) skipped_.mirror_planes += "xyz"[axis];
    alike_ = first_alike(aspects_, planes);
    for (std::size_t row = 0; row < alike_.size(); ++row)
      if (is_copied(row)) ++skipped_.mirrored_directions;
    skipped_.mirrored_directions -= skipped_.repeated_directions;
  }

  [[nodiscard]] bool has_pairs() const {
    return std::ranges::any_of(aspects_, [](const Aspect& a) { return a.to_transmitter != a.to_receiver; });
  }

  // Leaves the rows alone for which it is not the way; only if there are any is the costly visibility built.
  void sample() {
    std::vector<std::uint8_t> is_done(aspects_.size(), 0);
    tbb::parallel_for(std::size_t{0}, alone_.size(), [&](std::size_t k) { is_done[alone_[k]] = sample(alone_[k]); });
    methods_.sampled = std::erase_if(alone_, [&](std::size_t row) { return is_done[row] != 0; });
    sampled_.reset();
    if (!alone_.empty()) visibility_.emplace(target_.mesh);
  }

  std::uint8_t sample(std::size_t row) {
    if (wanted_[row]) return 0;
    const auto section = sampled_->section(aspects_[row].to_transmitter, aspects_[row].to_receiver);
    if (!section) return 0;
    const std::scoped_lock lock(watching_);
    rows_[row] = {aspects_[row], section->sigma, section->seen_area};
    tell_done();
    return 1;
  }

  void leave_out_facets() {
    if (alone_.empty()) return;
    skipped_.hull_facets = visibility_->hull_facets();
    std::vector<Vec3> viewers;
    for (const std::size_t row : alone_) {
      viewers.push_back(aspects_[row].to_receiver);
      if (aspects_[row].to_transmitter != aspects_[row].to_receiver) viewers.push_back(aspects_[row].to_transmitter);
    }
    skipped_.facets_never_faced = visibility_->look_only_from(viewers);
  }

  void compute(std::size_t row) {
    VisibilityCost cost;
    const CrossSection& section = sections_->at(aspects_[row], &cost);
    const std::scoped_lock lock(watching_);
    rows_[row] = {aspects_[row], section.sigma, section.seen_area};
    skipped_.free_convex_parts += cost.free_convex_parts;
    skipped_.parts_apart += cost.other_free_parts;
    if (wanted_[row]) watch_.facets(row, rows_[row], section);
    tell_done();
  }

  void compute_convex() {
    skipped_.convex_facets = target_.mesh.size();
    if (batched_.empty()) return;
    const ConvexBody body(target_);
    std::vector<std::uint8_t> faced(body.blocks(), 0);
    // Directions that pass together over a block while it is in the cache.
    constexpr std::size_t most = 16;
    const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    const std::size_t batch = std::min(most, (batched_.size() + threads - 1) / threads);
    const std::size_t batches = (batched_.size() + batch - 1) / batch;
    tbb::parallel_for(std::size_t{0}, batches, [&](std::size_t k) {
      const auto rows = std::span(batched_).subspan(k * batch, std::min(batch, batched_.size() - k * batch));
      compute_batch(body, rows, faced);
    });
    for (std::size_t b = 0; b < body.blocks(); ++b)
      if (faced[b] == 0) skipped_.facets_never_faced += body.facets_of(b);
  }

  void compute_batch(const ConvexBody& body, std::span<const std::size_t> rows, std::vector<std::uint8_t>& faced) {
    std::vector<Aspect> aspects;
    for (const std::size_t row : rows) aspects.push_back(aspects_[row]);
    std::vector<std::uint8_t> faced_now(body.blocks(), 0);
    const auto sections = body.sections(aspects, faced_now);
    const std::scoped_lock lock(watching_);
    for (std::size_t b = 0; b < faced.size(); ++b) faced[b] |= faced_now[b];
    for (std::size_t k = 0; k < rows.size(); ++k) {
      rows_[rows[k]] = {aspects[k], sections[k].sigma, sections[k].seen_area};
      tell_done();
    }
  }

  void copy_alike() {
    for (std::size_t row = 0; row < aspects_.size(); ++row) {
      if (!is_copied(row)) continue;
      const SweepRow& first = rows_[alike_[row]];
      rows_[row] = {aspects_[row], first.sigma, first.seen_area};
      tell_done();
    }
  }

  // In turn: with the lock, or when no other thread is left.
  void tell_done() {
    ++done_;
    if (watch_.progress) watch_.progress(done_);
  }

  const Target& target_;
  const std::vector<Aspect>& aspects_;
  const SweepWatch& watch_;
  std::vector<bool> wanted_;  // rows whose facets are
  std::optional<double> relative_;
  bool convex_ = false;
  std::optional<SampledSections> sampled_;
  std::optional<Visibility> visibility_;
  std::optional<FacetSections> sections_;
  std::vector<std::size_t> alike_, alone_, batched_;
  std::vector<SweepRow> rows_;
  SkipCounts skipped_;
  MethodCounts methods_;
  std::mutex watching_;
  std::size_t done_ = 0;
};

}  // namespace

std::vector<SweepRow> run_sweep(const Target& target, const std::vector<Aspect>& aspects, std::size_t threads,
                                const SweepWatch& watch, SkipCounts* skipped, std::optional<double> relative,
                                MethodCounts* methods) {
  Sweep sweep(target, aspects, watch, relative);
  std::vector<SweepRow> rows;
  // By itself TBB starts no more threads than there are cores.
  std::optional<tbb::global_control> allowed;
  if (threads != 0) allowed.emplace(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads));
  arena.execute([&] { rows = sweep.run(); });
  if (skipped != nullptr) *skipped = sweep.skipped();
  if (methods != nullptr) *methods = sweep.methods();
  return rows;
}

}  // namespace lrcs
