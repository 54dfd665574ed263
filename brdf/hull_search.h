#pragma once
#include "brdf/simplex_search.h"

namespace lrcs {

// Finds the place on the hull of a mesh nearest to a point outside, through a tree of boxes about the hull's faces.
// laws: as SimplexSearch; the place moves continuously with the point, as projections to convex bodies do.
// Compiled for D = 1, 2, 3.
template <int D>
class HullSearch {
 public:
  // Keeps a reference. domain: a mesh of at least one cell.
  explicit HullSearch(const SimplexMesh<D>& mesh);

  // None where nothing of the hull is nearer than `most`.
  [[nodiscard]] SimplexPlace<D> nearest(const Point<D>& point, double most) const;

 private:
  using Index = std::uint32_t;
  struct Face {
    Index cell = 0;
    std::array<Index, D> corners{};  // which of the cell's vertices
  };
  struct Node {
    Point<D> low, high;
    Index next = 0;   // the second child (the first: the next node); of a leaf the first face
    Index faces = 0;  // of a leaf
  };

  struct Nearest {
    SimplexPlace<D> place;
    double distance2 = 0.0;
  };

  void add_node(std::size_t first, std::size_t last);
  [[nodiscard]] const Point<D>& corner(const Face& face, std::size_t k) const;
  void try_face(const Face& face, const Point<D>& point, Nearest& best) const;
  void search(Index node, const Point<D>& point, Nearest& best) const;

  const SimplexMesh<D>& mesh_;
  std::vector<Face> faces_;
  std::vector<Node> nodes_;
};

}  // namespace lrcs
