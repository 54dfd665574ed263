#pragma once
#include "brdf/simplex_mesh.h"

namespace lrcs {

// A point written by the vertices of one simplex: Sum over k of weights[k] points[cells[cell][k]].
template <int D>
struct SimplexPlace {
  std::uint32_t cell = SimplexMesh<D>::none;
  std::array<double, D + 1> weights{};  // [1] >= 0, their sum is 1 up to rounding

  [[nodiscard]] bool exists() const { return cell != SimplexMesh<D>::none; }
};

// Finds the simplex that a point lies in: from one near it, by a tree of their centres, step by step toward it.
// laws: the answer depends on nothing but mesh and point; safe from many threads at once. Of simplices that meet at the
//   point it is one, always the same.
// Compiled for D = 1, 2, 3.
template <int D>
class SimplexSearch {
 public:
  // Keeps a reference. domain: a mesh of at least one cell.
  explicit SimplexSearch(const SimplexMesh<D>& mesh);

  // None outside the hull; on it, by rounding, perhaps none.
  [[nodiscard]] SimplexPlace<D> find(const Point<D>& point) const;

 private:
  using Index = std::uint32_t;
  struct Node {
    double split = 0.0;
    Index axis = D;  // D: a leaf
    Index next = 0;  // the node of larger coordinates (of smaller: the next one); of a leaf a cell nearby
  };

  void add_node(const std::vector<Point<D>>& centres, std::vector<Index>& cells, std::size_t first, std::size_t last);
  [[nodiscard]] Index start(const Point<D>& point) const;
  [[nodiscard]] SimplexPlace<D> find_anywhere(const Point<D>& point) const;

  const SimplexMesh<D>& mesh_;
  std::vector<Node> nodes_;
};

}  // namespace lrcs
