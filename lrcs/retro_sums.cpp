#include "lrcs/retro_sums.h"

#include "base/wide_loop.h"

namespace lrcs {
namespace {

#define LRCS_INSIDE __attribute__((always_inline)) inline

// Plain pointers that do not overlap: without them the compiler makes no vector code.
using In = const double* __restrict;
using Out = double* __restrict;

template <class Form>
LRCS_INSIDE void add_lit(In nx, In ny, In nz, In area, double dx, double dy, double dz, const Form form, Out returned,
                         Out seen, Out slope) {
  for (std::size_t k = 0; k < block_facets; ++k) {
    const double along = nx[k] * dx + ny[k] * dy + nz[k] * dz;
    const double cosine = along < 1.0 ? along : 1.0;
    const double returns = area[k] * form(cosine);
    returned[k] += returns * cosine;
    seen[k] += area[k] * cosine;
    slope[k] += returns;
  }
}

template <class Form>
LRCS_INSIDE void add_any(In nx, In ny, In nz, In area, double dx, double dy, double dz, const Form form, Out returned,
                         Out seen, Out slope) {
  for (std::size_t k = 0; k < block_facets; ++k) {
    const double along = nx[k] * dx + ny[k] * dy + nz[k] * dz;
    const double below = along < 1.0 ? along : 1.0;
    const double cosine = below > 0.0 ? below : 0.0;
    const double above = below > smallest_retro_cosine ? below : smallest_retro_cosine;
    const double all = area[k] * form(above);
    const double returns = along > -doubtful_cosine ? all : 0.0;
    returned[k] += returns * cosine;
    seen[k] += area[k] * cosine;
    slope[k] += returns;
  }
}

LRCS_WIDE void add_lit_wu(In nx, In ny, In nz, In area, double dx, double dy, double dz, const WuRetro& form,
                          Out returned, Out seen, Out slope) {
  add_lit(nx, ny, nz, area, dx, dy, dz, form, returned, seen, slope);
}
LRCS_WIDE void add_any_wu(In nx, In ny, In nz, In area, double dx, double dy, double dz, const WuRetro& form,
                          Out returned, Out seen, Out slope) {
  add_any(nx, ny, nz, area, dx, dy, dz, form, returned, seen, slope);
}
LRCS_WIDE void add_lit_lambert(In nx, In ny, In nz, In area, double dx, double dy, double dz, const LambertRetro& form,
                               Out returned, Out seen, Out slope) {
  add_lit(nx, ny, nz, area, dx, dy, dz, form, returned, seen, slope);
}
LRCS_WIDE void add_any_lambert(In nx, In ny, In nz, In area, double dx, double dy, double dz, const LambertRetro& form,
                               Out returned, Out seen, Out slope) {
  add_any(nx, ny, nz, area, dx, dy, dz, form, returned, seen, slope);
}

LRCS_WIDE void add_lit_black(In nx, In ny, In nz, In area, double dx, double dy, double dz, const BlackRetro& form,
                             Out returned, Out seen, Out slope) {
  add_lit(nx, ny, nz, area, dx, dy, dz, form, returned, seen, slope);
}
LRCS_WIDE void add_any_black(In nx, In ny, In nz, In area, double dx, double dy, double dz, const BlackRetro& form,
                             Out returned, Out seen, Out slope) {
  add_any(nx, ny, nz, area, dx, dy, dz, form, returned, seen, slope);
}

template <class Version, class Form>
void call(Version version, const FacetBlock& block, const Vec3& d, const Form& form, LaneSums& sums) {
  version(block.nx.data(), block.ny.data(), block.nz.data(), block.area.data(), d.x(), d.y(), d.z(), form,
          sums.returned.data(), sums.seen.data(), sums.slope.data());
}

}  // namespace

void add_retro(const FacetBlock& block, const Vec3& d, bool all_lit, const WuRetro& form, LaneSums& sums) {
  call(all_lit ? add_lit_wu : add_any_wu, block, d, form, sums);
}

void add_retro(const FacetBlock& block, const Vec3& d, bool all_lit, const LambertRetro& form, LaneSums& sums) {
  call(all_lit ? add_lit_lambert : add_any_lambert, block, d, form, sums);
}

void add_retro(const FacetBlock& block, const Vec3& d, bool all_lit, const BlackRetro& form, LaneSums& sums) {
  call(all_lit ? add_lit_black : add_any_black, block, d, form, sums);
}

}  // namespace lrcs
