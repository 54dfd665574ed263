#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"

namespace lrcs {

// A piece of an outline in a facet's own coordinates (u, v): the facet is the triangle u >= 0, v >= 0, u + v <= 1.
struct LayerEdge {
  double u0 = 0.0, v0 = 0.0, u1 = 0.0, v1 = 0.0;  // ends, in any order
  int step = 0;                                   // layers gained where the edge is crossed toward larger u
  double bend0 = 0.0, bend1 = 0.0;  // how far beside the ends the outline of a curved surface lies: in u, or
  bool bends_in_v = false;          // in v, of edges that run along u rather
  double swept = 0.0;               // area over the facet between the edge and where it bends to
};

// Integrals of 1, of u and v, and of their products over a region of the (u, v) plane.
struct AreaMoments {
  double area = 0.0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();

  AreaMoments& operator+=(const AreaMoments& more) {
    area += more.area, first += more.first, second += more.second;
    return *this;
  }
  AreaMoments& operator-=(const AreaMoments& less) {
    area -= less.area, first -= less.first, second -= less.second;
    return *this;
  }
  // With u and v in each other's place.
  [[nodiscard]] AreaMoments swapped() const { return {area, first.reverse(), second.reverse()}; }
};

// Counts the layers that lie over a facet, from their outlines alone, and measures where there are none.
// The layers are the polygons whose outlines sum up to the edges; edges that two layers share with opposite steps may
// be left out. Horizontal slabs between the ends of the edges hold lines from bottom to top; the count is walked from
// left to right at the bottom, and two neighbours change places where they cross on the way up. error: positions closer
// than `tolerance` (the rounding error of the coordinates) are taken as one, so the area is off by at most 2 tolerance
// per edge. cost: edges per slab and crossings, each times a logarithm. source: Appel, "The notion of quantitative
// invisibility", Proc. 22nd ACM National Conf., 387-393, 1967.
class LayerCount {
 public:
  // Area of the part of the unit triangle that no layer covers, 0..1/2. `layers_at_left`: the number of layers at u =
  // -infinity.
  [[nodiscard]] double uncovered_area(std::span<const LayerEdge> edges, double tolerance, int layers_at_left = 0);
  // The same, with its moments.
  [[nodiscard]] AreaMoments uncovered(std::span<const LayerEdge> edges, double tolerance, int layers_at_left = 0);
  // Of the last area asked for: did the count go below zero on more than rounding's area?
  [[nodiscard]] bool went_negative() const {
    return negative_area_ > 4.0 * tolerance_ * static_cast<double>(edges_.size());
  }

 private:
  struct Edge : LayerEdge {  // v0 < v1
    double slope = 0.0;      // du / dv
    [[nodiscard]] double u_at(double v) const { return v == v0 ? u0 : v == v1 ? u1 : u0 + slope * (v - v0); }
  };
  struct Line {  // an edge within one slab
    double bottom, top;
    int step;
    std::uint32_t rank;  // makes the order of coincident lines definite
  };
  struct Gap {  // between a line and its right neighbour
    int layers;
    double since;  // share of the slab's height from which these two are neighbours
  };
  struct Crossing {
    double height;              // share of the slab's height
    std::uint32_t left, right;  // ranks of the lines
    bool operator>(const Crossing& other) const;
  };

  [[nodiscard]] double count(std::span<const LayerEdge> edges, double tolerance, int layers_at_left);
  void take_edges(std::span<const LayerEdge> edges);
  // Lets edges come and go. False: all of the slab is covered, wherever its lines are.
  [[nodiscard]] bool pass_to_slab(double low);
  void order_lines(double low, double high);
  // False: all of the slab is covered, whatever the order of its lines.
  [[nodiscard]] bool collect_lines(double low, double high);
  [[nodiscard]] double slab_area();
  void add_moments(const Line& left, const Line& right, double from, double to);
  void find_crossings();
  // The same between lines first and last, which may cross, with `layers` at their left.
  [[nodiscard]] double area_with_crossings(std::size_t first, std::size_t last, int layers);
  void snap(double Line::*end);
  void expect_crossing(std::size_t left);
  // The gap's area [in units of the slab's height] from its beginning to `height`, if nothing covers it.
  [[nodiscard]] double gap_area(std::size_t left, double height);

  std::vector<Edge> edges_;
  std::vector<Line> active_;  // edges in the slab at hand, in their order half way up
  std::size_t next_ = 0;      // edge that has not been active yet
  int surely_ = 0;            // layers in the slab at hand if all lines that take away had done so
  std::vector<double> heights_;
  std::vector<Line> lines_;           // of the slab at hand that pass over the facet, in that order
  std::vector<double> least_bottom_;  // of a line and those right of it
  std::vector<double> least_top_;
  std::vector<std::uint8_t> crosses_;  // a line: some other
  std::vector<Line> run_;              // lines that may cross each other, from left to right
  std::vector<Gap> gaps_;              // gaps_[k]: right of run_[k]
  std::vector<Crossing> crossings_;    // a heap, the lowest first
  std::vector<std::uint32_t> place_;   // of a line by its rank
  AreaMoments moments_;
  bool with_moments_ = false;
  double tolerance_ = 0.0;
  double negative_area_ = 0.0;
  double slab_low_ = 0.0, slab_height_ = 0.0;
  int layers_at_left_ = 0;
};

}  // namespace lrcs
