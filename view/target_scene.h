#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "mesh/facet_mesh.h"
#include "view/colour.h"
#include "view/png.h"

class vtkRenderer;

namespace lrcs {

// A target in three dimensions, to be looked at from anywhere: its facets in given colours, creases and rims, arrows to
// where transmitter and receiver stand, the body's axes.
// frame: body. domain: mesh measured (measure_facets), not empty; it must outlive this.
class TargetScene {
 public:
  explicit TargetScene(const FacetMesh& mesh);
  ~TargetScene();

  // colours: one a facet, drawn as drawn_colour() says.
  void colour(const std::vector<Colour>& colours, bool are_names = false);
  // Unit vectors; equal: one arrow, to the sensor.
  void point_at(const Vec3& to_transmitter, const Vec3& to_receiver);
  // Is the arrow to the receiver drawn? Looked at from there it hides the target.
  void show_receiver(bool is_shown);
  // Outlines the facets of a part; none: none.
  void outline_part(std::optional<std::uint32_t> part);

  // Looks from such a direction, up as far as possible along z, at the whole target with its arrows.
  void look_from(const Vec3& toward_viewer);
  // The same from above and beside a direction, as pictures of facets are.
  void look_beside(const Vec3& direction);

  // Shows all of it, with its arrows, in a window so many times wider than high; the direction stays.
  void fit(double width_over_height);

  // The facet at a place of the renderer's window [pixel]; none: the ground.
  [[nodiscard]] std::optional<std::uint32_t> facet_at(double x, double y) const;

  // letters: their height [pixel].
  void set_letters(int letters);
  // For a window of ours: the target; and the axes, to be laid over its lower left corner, in a square.
  static constexpr double axes_share = 0.26;  // its side, of the target's width
  [[nodiscard]] vtkRenderer* renderer() const;
  [[nodiscard]] vtkRenderer* axes() const;
  // Drawn without a window. error: std::runtime_error, one line, where no 3-D picture can be drawn.
  [[nodiscard]] Picture picture(int width, int height, int letters);

 private:
  struct Hidden;
  std::unique_ptr<Hidden> hidden_;
};

}  // namespace lrcs
