#include "lrcs/sweep.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

std::vector<Aspect> aspects_of(int count, const Receiver& receiver) {
  std::vector<Aspect> aspects;
  for (int k = 0; k < count; ++k) aspects.push_back(aspect_of({7.3 * k, 60.0 - 2.9 * k}, receiver));
  return aspects;
}

Target soup() {
  std::mt19937_64 random(4711);
  return target_of(random_soup(random, 100), library("painted-steel-9p"));
}

struct Seen {
  std::vector<SweepRow> rows;
  std::vector<std::vector<double>> facet_sigma, seen_fraction;
};

Seen run(const Target& target, const std::vector<Aspect>& aspects, std::size_t threads) {
  Seen seen;
  seen.facet_sigma.resize(aspects.size());
  seen.seen_fraction.resize(aspects.size());
  seen.rows = run_sweep(target, aspects, threads,
                        {{},
                         [](std::size_t) { return true; },
                         [&](std::size_t row, const SweepRow&, const CrossSection& section) {
                           seen.facet_sigma[row] = section.facet_sigma;
                           seen.seen_fraction[row] = section.seen_fraction;
                         }});
  return seen;
}

TEST(RunSweep, GivesTheSameBitsForAnyNumberOfThreads) {
  const Target target = soup();
  Receiver bistatic;
  bistatic.kind = Receiver::Kind::bistatic;
  bistatic.bistatic_angle_deg = 20.0;
  for (const Receiver& receiver : {Receiver{}, bistatic}) {
    const auto aspects = aspects_of(24, receiver);
    const Seen one = run(target, aspects, 1);
    for (const std::size_t threads : {2, 4, 0}) {
      const Seen many = run(target, aspects, threads);
      ASSERT_EQ(many.rows.size(), one.rows.size());
      for (std::size_t k = 0; k < one.rows.size(); ++k) {
        EXPECT_EQ(many.rows[k].sigma.value, one.rows[k].sigma.value);
        EXPECT_EQ(many.rows[k].sigma.bound, one.rows[k].sigma.bound);
        EXPECT_EQ(many.rows[k].seen_area, one.rows[k].seen_area);
        EXPECT_EQ(many.rows[k].aspect.transmitter, aspects[k].transmitter);
      }
      EXPECT_EQ(many.facet_sigma, one.facet_sigma);
      EXPECT_EQ(many.seen_fraction, one.seen_fraction);
    }
  }
}

TEST(RunSweep, GivesEveryRowTheCrossSectionOfItsAspect) {
  const Target target = soup();
  const auto aspects = aspects_of(10, {});
  const auto rows = run_sweep(target, aspects, 2);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const CrossSection section = section_of(target, aspects[k].to_transmitter, aspects[k].to_receiver);
    EXPECT_EQ(rows[k].sigma.value, section.sigma.value);
    EXPECT_EQ(rows[k].seen_area, section.seen_area);
  }
}

TEST(RunSweep, TellsItsProgressOnceARowAndAsksForTheRowsWanted) {
  const auto aspects = aspects_of(30, {});
  std::size_t last = 0, calls = 0;
  std::vector<int> facets(aspects.size(), 0);
  (void)run_sweep(soup(), aspects, 4,
                  {[&](std::size_t done) {
                     EXPECT_EQ(done, last + 1);
                     last = done;
                     ++calls;
                   },
                   [](std::size_t row) { return row % 7 == 3; },
                   [&](std::size_t row, const SweepRow&, const CrossSection&) { ++facets[row]; }});
  EXPECT_EQ(calls, aspects.size());
  for (std::size_t k = 0; k < facets.size(); ++k) EXPECT_EQ(facets[k], k % 7 == 3 ? 1 : 0) << k;
}

TEST(RunSweep, LetsOutWhatAWatcherThrows) {
  const auto aspects = aspects_of(50, {});
  const SweepWatch disk_full{
      {},
      [](std::size_t) { return true; },
      [](std::size_t, const SweepRow&, const CrossSection&) { throw std::runtime_error("disk full"); }};
  for (const std::size_t threads : {1, 2, 4}) {
    try {
      (void)run_sweep(soup(), aspects, threads, disk_full);
      FAIL() << "nothing came out";
    } catch (const std::runtime_error& failed) {
      EXPECT_STREQ(failed.what(), "disk full");
    }
  }
}

TEST(RunSweep, OfNoAspectsIsEmpty) {
  EXPECT_TRUE(run_sweep(soup(), {}, 2).empty());
}

}  // namespace
}  // namespace lrcs
