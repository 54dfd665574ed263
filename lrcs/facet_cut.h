#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "lrcs/facet_frame.h"
#include "lrcs/layer_count.h"
#include "lrcs/surface.h"
#include "lrcs/view_outline.h"

namespace lrcs {

// The outlines that run in front of one facet, in its own coordinates, and how the number of layers changes between
// places on it. What lies left of the facet is left out; instead, where an outline leaves it there (u = 0), a line runs
// up from that place, so that the number of layers at u = -infinity is the same at all v: the base, unknown here.
class FacetCut {
 public:
  // Begins with a facet that is not seen edge-on.
  void begin(const Surface& surface, const ViewOutline& view, std::uint32_t facet);
  // What of the edge lies over the facet and in front of it.
  void add_outline(const OutlineEdge& edge);
  // What passes through the facet or lies on it.
  void add_contacts();

  // Does nothing come near to the facet?
  [[nodiscard]] bool empty() const { return !near_ && edges_.empty(); }
  [[nodiscard]] const std::vector<LayerEdge>& edges() const { return edges_; }
  // Error of u and v.
  [[nodiscard]] double error() const { return error_; }
  [[nodiscard]] const FacetFrame& frame() const { return frame_; }

  // The port of side k (from corner k to corner k + 1): a place on it that both facets at the edge know. Is it clear of
  // all outlines?
  [[nodiscard]] bool port_is_clear(std::size_t side) const { return clear_[side]; }
  // Layers over a port, less the base.
  [[nodiscard]] int layers_at_port(std::size_t side) const { return layers_at(ports_[side][0], ports_[side][1]); }
  [[nodiscard]] int layers_at(double u, double v) const;
  // A place on the facet in the widest gap between outlines, on the line v = `height`. False: none is clear of them.
  [[nodiscard]] bool clear_place(double height, double& u, double& v);

 private:
  // Looks at the facet along its normal, for places in its plane: so they are where Contacts has them.
  const FacetFrame& flat();
  // Where the vertex is, if it lies in the plane.
  void settle(FacetPoint& point, std::uint32_t vertex);
  void add(const FacetPoint& a, int corner_a, const FacetPoint& b, int corner_b, int gain, double slack);
  void close_ports(const FacetPoint& a, const FacetPoint& b, double slack);
  void add_between(const OutlineEdge& edge, const FacetPoint& a, int corner_a, const FacetPoint& b, int corner_b,
                   double slack);
  void push(FacetPoint a, FacetPoint b, int gain);
  void bend(const OutlineEdge& edge, const FacetPoint& low, const FacetPoint& high, std::size_t first);
  [[nodiscard]] int corner(const Contacts::Place& place) const {
    return place.low == place.high ? frame_.corner(place.low) : -1;
  }
  [[nodiscard]] int gain_of(const Contacts::LyingEdge& edge, const std::int8_t* sides) const;

  const Surface* surface_ = nullptr;
  const ViewOutline* view_ = nullptr;
  std::uint32_t facet_ = 0;
  FacetFrame frame_, flat_;
  bool has_flat_ = false;
  double error_ = 0.0;
  bool near_ = false;
  std::array<std::array<double, 2>, 3> ports_{};
  std::array<bool, 3> clear_{};
  struct Segment {
    FacetPoint a, b;
    double slack;
  };
  std::vector<Segment> segments_;  // as they came
  std::vector<LayerEdge> edges_;
  std::vector<double> crossings_;
};

}  // namespace lrcs
