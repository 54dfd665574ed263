#pragma once
#include "brdf/retro_form.h"
#include "lrcs/facet_block.h"
#include "lrcs/return_error.h"

namespace lrcs {

// Adds what the facets of a block return to a transmitter and receiver in the direction d, from their fronts, none of
// them hidden. One version for each instruction set, chosen when the program starts.
// laws: the same bytes from every version: no operation is contracted or reordered; the same whether all_lit is said or
//   not. domain: all_lit only where block.least(d) >= smallest_retro_cosine.
// error: a facet whose cosine is not above doubtful_cosine in size returns between nothing and its share of
//   smallest_retro_cosine x slope; of others the cosine counts as it is.
void add_retro(const FacetBlock& block, const Vec3& d, bool all_lit, const WuRetro& form, LaneSums& sums);
void add_retro(const FacetBlock& block, const Vec3& d, bool all_lit, const LambertRetro& form, LaneSums& sums);
void add_retro(const FacetBlock& block, const Vec3& d, bool all_lit, const BlackRetro& form, LaneSums& sums);

}  // namespace lrcs
