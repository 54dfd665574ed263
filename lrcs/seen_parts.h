#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "lrcs/facet_piece.h"
#include "lrcs/layer_count.h"

namespace lrcs {

// The outlines over a facet of a curved surface, in the facet's coordinates: as the flat facets have them, and moved to
// where the surfaces' are, along u and along v. Those moved along v, with u and v in each other's place.
class BentOutlines {
 public:
  // straight: of the flat facets, with v0 <= v1. error: of their positions; what lies along the side v = 0 as far as it
  // tells bends with it, what lies along u = 0 is not among them (lrcs/facet_cut.h).
  void bend(std::span<const LayerEdge> straight, double error);

  // None is moved: empty.
  [[nodiscard]] std::span<const LayerEdge> along_u() const { return along_u_; }
  [[nodiscard]] std::span<const LayerEdge> along_v() const { return along_v_; }
  // Area that they have passed over, all together: more than what they change where some cover what others lay bare.
  [[nodiscard]] double swept() const { return swept_; }

 private:
  void add_swapped(LayerEdge e, double error);

  double swept_ = 0.0;

  std::vector<LayerEdge> along_u_, along_v_;
};

// What is seen of the facets of a curved surface that are seen in part.
class SeenParts {
 public:
  struct Part {
    std::uint32_t facet = 0;         // of the mesh
    std::uint32_t first_corner = 0;  // the corner of the mesh's facet that lies at u = v = 0
    AreaMoments seen{};              // in (u, v), where the facet is the unit triangle
    double error = 0.0;              // of positions in (u, v)
    int layers_at_left = 0;
    std::size_t straight = 0, along_u = 0, along_v = 0, end = 0;  // where its outlines begin
  };

  void clear();
  // part: all but where its outlines lie.
  void add(Part part, std::span<const LayerEdge> straight, const BentOutlines& bent);

  [[nodiscard]] std::span<const Part> parts() const { return parts_; }
  // Of what is seen of a piece of the facet.
  [[nodiscard]] AreaMoments seen_within(const FacetPiece& piece, const Part& part);

 private:
  std::vector<Part> parts_;
  std::vector<LayerEdge> edges_, in_piece_;
  LayerCount count_;
};

}  // namespace lrcs
