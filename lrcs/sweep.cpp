#include "lrcs/sweep.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <mutex>
#include <optional>

namespace lrcs {

std::vector<SweepRow> run_sweep(const Target& target, const std::vector<Aspect>& aspects, std::size_t threads,
                                const SweepWatch& watch) {
  std::vector<SweepRow> rows(aspects.size());
  std::mutex watching;
  std::size_t done = 0;
  const auto one = [&](const Visibility& visibility, std::size_t k) {
    const CrossSection section = cross_section(target, visibility, aspects[k].to_transmitter, aspects[k].to_receiver);
    rows[k] = {aspects[k], section.sigma, section.seen_area};
    const std::scoped_lock lock(watching);
    if (watch.wants_facets && watch.wants_facets(k)) watch.facets(k, rows[k], section);
    ++done;
    if (watch.progress) watch.progress(done);
  };
  // By itself TBB starts no more threads than there are cores.
  std::optional<tbb::global_control> allowed;
  if (threads != 0) allowed.emplace(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads));
  arena.execute([&] {
    const Visibility visibility(target.mesh);
    tbb::parallel_for(std::size_t{0}, aspects.size(), [&](std::size_t k) { one(visibility, k); });
  });
  return rows;
}

}  // namespace lrcs
