#pragma once
#include "base/vec3.h"
#include "mesh/facet_mesh.h"
#include "view/canvas.h"

namespace lrcs {

// A parallel projection of the body frame onto a box of a canvas.
struct ParallelView {
  Vec3 right;     // unit vectors in the body frame: along the canvas' x,
  Vec3 up;        // along its y,
  Vec3 backward;  // and toward the viewer
  Vec3 centre;    // [m], shown at the middle of `box`
  double pixels_a_metre = 1.0;
  Box box;

  [[nodiscard]] Point at(const Vec3& p) const;
  // A direction, as a step on the canvas [pixel a metre].
  [[nodiscard]] Point step(const Vec3& direction) const;
};

// Looks at the whole mesh from `toward_viewer`, as large as the box allows.
// domain: mesh not empty; toward_viewer not zero. Where `up` runs along it, another is chosen.
[[nodiscard]] ParallelView view_of(const FacetMesh& mesh, const Vec3& toward_viewer, const Vec3& up, const Box& box);

// A direction turned toward `up` by `raise` and about it by `aside` [rad]: beside and above the given one.
[[nodiscard]] Vec3 oblique(const Vec3& direction, const Vec3& up, double raise, double aside);

}  // namespace lrcs
