#include "brdf/tabulated.h"

#include <gtest/gtest.h>

#include "lrcs/sweep.h"
#include "tests/brdf/made_measurement.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

std::vector<Aspect> some_aspects() {
  std::vector<Aspect> aspects;
  for (const double azimuth : {0.0, 17.0, 40.0})
    for (const double bistatic : {0.0, 30.0}) {
      Receiver receiver;
      receiver.kind = bistatic == 0.0 ? Receiver::Kind::monostatic : Receiver::Kind::bistatic;
      receiver.bistatic_angle_deg = bistatic;
      aspects.push_back(aspect_of({azimuth, 10.0}, receiver));
    }
  return aspects;
}

TEST(TabulatedLambert, HasTheCrossSectionOfLambert) {
  const Brdf table = Tabulated(measured_on_grid(Lambert(0.8), 10.0, 80.0), Outside::nearest);
  for (const FacetMesh& mesh : {box({-1.0, -1.0, 0.0}, {1.0, 1.0, 0.5}), sphere(1.0, 12)}) {
    const Target of_table = target_of(mesh, table), of_lambert = target_of(mesh, Lambert(0.8));
    const auto found = run_sweep(of_table, some_aspects(), 2), wanted = run_sweep(of_lambert, some_aspects(), 2);
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_NEAR(found[k].sigma.value, wanted[k].sigma.value, 1e-12 * wanted[k].sigma.value);
      EXPECT_LE(found[k].sigma.bound, 1e-9 * found[k].sigma.value);
    }
  }
}

}  // namespace
}  // namespace lrcs
