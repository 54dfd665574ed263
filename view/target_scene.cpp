#include "view/target_scene.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellPicker.h>
#include <vtkCleanPolyData.h>
#include <vtkFeatureEdges.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "view/arrow_names.h"
#include "view/facet_colours.h"
#include "view/offscreen.h"
#include "view/parallel_view.h"

namespace lrcs {
namespace {

constexpr double sharp = 30.0;  // where facets turn by more, a line is drawn [deg]
// Of arrows: from the target, and their own; and room beyond them, for their names; of the target's radius.
constexpr double gap = 0.05, arrow_length = 0.24, name_room = 0.09;
constexpr double tip_radius = 0.11;   // of the arrow's length
constexpr double beyond_axes = 0.34;  // their names, of their length

vtkSmartPointer<vtkPolyData> shown_triangles(const FacetMesh& mesh, std::optional<std::uint32_t> part = std::nullopt) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& p : mesh.positions) points->InsertNextPoint(p.data());
  vtkNew<vtkCellArray> triangles;
  for (std::size_t k = 0; k < mesh.size(); ++k)
    if (const auto& f = mesh.facets[k]; !part || mesh.part.of[k] == *part)
      triangles->InsertNextCell({f[0], f[1], f[2]});
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

// Creases and rims.
void set_lines(vtkActor* actor, vtkPolyData* triangles, const Colour& colour, double width) {
  vtkNew<vtkCleanPolyData> welded;
  welded->SetInputData(triangles);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(welded->GetOutputPort());
  edges->SetFeatureAngle(sharp);
  edges->NonManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(edges->GetOutput());
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-1.0, -2.0);
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(colour.red, colour.green, colour.blue);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
}

struct Arrow {
  vtkNew<vtkActor> body;
  vtkNew<vtkActor> ghost;  // before all that hides the body
  vtkNew<vtkBillboardTextActor3D> name;
  vtkNew<vtkProperty> translucent;
  Vec3 tail = Vec3::Zero(), tip = Vec3::Zero();

  explicit Arrow(const Colour& colour) {
    vtkNew<vtkArrowSource> source;
    source->SetTipResolution(24);
    source->SetShaftResolution(24);
    source->SetShaftRadius(0.035);
    source->SetTipRadius(tip_radius);
    source->SetTipLength(0.32);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    body->SetMapper(mapper);
    body->SetUserMatrix(vtkNew<vtkMatrix4x4>());
    body->PickableOff();
    body->GetProperty()->SetColor(colour.red, colour.green, colour.blue);
    body->GetProperty()->SetAmbient(0.6);
    body->GetProperty()->SetDiffuse(0.4);
    ghost->SetMapper(mapper);
    ghost->SetProperty(translucent);
    ghost->PickableOff();
    ghost->VisibilityOff();
    translucent->DeepCopy(body->GetProperty());
    translucent->SetOpacity(0.3);
    name->PickableOff();
    name->GetTextProperty()->SetColor(colour.red, colour.green, colour.blue);
    name->GetTextProperty()->BoldOn();
    name->GetTextProperty()->SetBackgroundColor(1.0, 1.0, 1.0);
    name->GetTextProperty()->SetBackgroundOpacity(0.7);
    name->GetTextProperty()->SetJustificationToCentered();
    name->GetTextProperty()->SetVerticalJustificationToCentered();
  }
  // The name comes near its place, for VTK not to take it for out of sight; the view puts it there.
  void set(const Vec3& from, const Vec3& direction, double length, const char* text) {
    const Vec3 d = direction.normalized();
    tail = from;
    tip = from + length * d;
    const Vec3 across = (std::abs(d.z()) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)).cross(d).normalized();
    const Vec3 third = d.cross(across);
    vtkNew<vtkMatrix4x4> place;
    for (int k = 0; k < 3; ++k) {
      place->SetElement(k, 0, length * d[k]);
      place->SetElement(k, 1, length * across[k]);
      place->SetElement(k, 2, length * third[k]);
      place->SetElement(k, 3, from[k]);
    }
    body->SetUserMatrix(place);
    name->SetPosition(tip.x(), tip.y(), tip.z());
    name->SetInput(text);
  }
  // In a parallel projection all stays where it is as it comes nearer.
  void bring_forward(const Vec3& of_body, const Vec3& of_name) const {
    const Vec3 at = tip + of_name;
    name->SetPosition(at.x(), at.y(), at.z());
    vtkNew<vtkMatrix4x4> place;
    place->DeepCopy(body->GetUserMatrix());
    for (int k = 0; k < 3; ++k) place->SetElement(k, 3, place->GetElement(k, 3) + of_body[k]);
    ghost->SetUserMatrix(place);
  }
  void add_to(vtkRenderer* renderer) const {
    renderer->AddActor(body);
    renderer->AddActor(ghost);
    renderer->AddActor(name);
  }
  void show(bool is_shown) const {
    body->SetVisibility(is_shown);
    ghost->SetVisibility(is_shown);
    name->SetVisibility(is_shown);
  }
};

}  // namespace

struct TargetScene::Hidden {
  explicit Hidden(const FacetMesh& m) : mesh(m), triangles(shown_triangles(m)) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const auto& facet : mesh.facets)
      for (const std::uint32_t v : facet)
        low = low.cwiseMin(mesh.positions[v]), high = high.cwiseMax(mesh.positions[v]);
    centre = 0.5 * (low + high);
    radius = std::max(0.5 * (high - low).norm(), std::numeric_limits<double>::min());
    rgb->SetNumberOfComponents(3);
    rgb->SetNumberOfTuples(static_cast<vtkIdType>(mesh.size()));
    triangles->GetCellData()->SetScalars(rgb);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(triangles);
    facets->SetMapper(mapper);
    facets->GetProperty()->LightingOff();
    set_lines(creases, triangles, ink, 1.0);
    creases->PickableOff();
    part->PickableOff();
    part->VisibilityOff();
    renderer->SetBackground(1.0, 1.0, 1.0);
    renderer->AddActor(facets);
    renderer->AddActor(creases);
    renderer->AddActor(part);
    sensor.add_to(renderer);
    sensor.show(true);
    transmitter.add_to(renderer);
    renderer->GetActiveCamera()->ParallelProjectionOn();
    set_axes();
    follow->SetClientData(this);
    follow->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
      static_cast<Hidden*>(self)->shade();
      static_cast<Hidden*>(self)->turn_axes();
      static_cast<Hidden*>(self)->place_names();
    });
    renderer->AddObserver(vtkCommand::StartEvent, follow);
  }

  void set_axes() {
    const std::array<const char*, 3> names{"x", "y", "z"};
    for (std::size_t k = 0; k < 3; ++k) {
      axis_arrows[k].set(Vec3::Zero(), Vec3::Unit(static_cast<Eigen::Index>(k)), 1.0, names[k]);
      axis_arrows[k].add_to(axes);
    }
    axes->SetLayer(2);
    axes->InteractiveOff();
    axes->GetActiveCamera()->ParallelProjectionOn();
  }

  // Colours as they are drawn from where the target is seen now.
  void shade() {
    const Vec3 away(renderer->GetActiveCamera()->GetDirectionOfProjection());
    if (away == shaded_from) return;
    shaded_from = away;
    for (std::size_t k = 0; k < colours.size(); ++k)
      rgb->SetTypedTuple(static_cast<vtkIdType>(k),
                         drawn_colour(colours[k], colours_are_names, mesh.normals[k].dot(away)).data());
    rgb->Modified();
  }

  // The axes are seen from where the target is.
  void turn_axes() {
    vtkCamera* from = renderer->GetActiveCamera();
    vtkCamera* camera = axes->GetActiveCamera();
    std::array<double, 3> direction{}, up{};
    from->GetDirectionOfProjection(direction.data());
    from->GetViewUp(up.data());
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(-10.0 * direction[0], -10.0 * direction[1], -10.0 * direction[2]);
    camera->SetViewUp(up.data());
    camera->SetParallelScale(1.6);
    camera->SetClippingRange(5.0, 15.0);
    part_names_of_axes(Vec3(direction.data()).cross(Vec3(up.data())), Vec3(up.data()));
  }

  // Names of axes that fall on one another go to either side.
  void part_names_of_axes(const Vec3& right, const Vec3& up) {
    const int letters = axis_arrows[0].name->GetTextProperty()->GetFontSize();
    const double pixels_a_unit = 0.5 * axes->GetSize()[1] / axes->GetActiveCamera()->GetParallelScale();
    // Before the arrows, which reach 1 toward the viewer.
    const Vec3 forward = 2.0 * right.cross(up).normalized();
    std::array<Point, 3> at;
    std::array<int, 3> aside{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 name = (1.0 + beyond_axes) * Vec3::Unit(static_cast<Eigen::Index>(k)) + forward;
      axis_arrows[k].name->SetPosition(name.x(), name.y(), name.z());
      at[k] = {pixels_a_unit * name.dot(right), pixels_a_unit * name.dot(up)};
    }
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t other = 0; other < 3; ++other)
        if (other != k && std::hypot(at[k].x - at[other].x, at[k].y - at[other].y) < letters)
          aside[k] = at[k].x < at[other].x || (at[k].x == at[other].x && k < other) ? -letters / 2 : letters / 2;
    for (std::size_t k = 0; k < 3; ++k) axis_arrows[k].name->SetDisplayOffset(aside[k], 0);
  }

  void place_names() {
    vtkCamera* camera = renderer->GetActiveCamera();
    const Vec3 above(camera->GetViewUp()), focus(camera->GetFocalPoint());
    const Vec3 right = Vec3(camera->GetDirectionOfProjection()).cross(above);
    const double pixels_a_metre = 0.5 * renderer->GetSize()[1] / camera->GetParallelScale();
    const Point middle{0.5 * renderer->GetSize()[0], 0.5 * renderer->GetSize()[1]};
    const auto on_screen = [&](const Vec3& p) -> Point {
      return {middle.x + pixels_a_metre * (p - focus).dot(right), middle.y + pixels_a_metre * (p - focus).dot(above)};
    };
    const auto named = [&](const Arrow& arrow) -> NamedArrow {
      const int letters = arrow.name->GetTextProperty()->GetFontSize();
      return {on_screen(arrow.tail), on_screen(arrow.tip),
              0.5 * text_size(arrow.name->GetInput(), {letters, true}).width + 0.1 * letters, 0.6 * letters,
              pixels_a_metre * tip_radius * (arrow.tip - arrow.tail).norm() + 0.2 * letters};
    };
    const auto is_shown = [](const Arrow& arrow) { return arrow.name->GetVisibility() != 0; };
    // One that is not shown is in nobody's way.
    const Arrow& first = is_shown(sensor) ? sensor : transmitter;
    const Arrow& second = is_shown(transmitter) ? transmitter : sensor;
    const std::array<NamedArrow, 2> arrows{named(first), named(second)};
    const double side = axes_share * 2.0 * middle.x;
    const auto places =
        places_of_names(arrows, {{0.0, 0.0}, {2.0 * middle.x, 2.0 * middle.y}}, {{0.0, 0.0}, {side, side}});
    // Before all of the target, and names before arrows.
    const Vec3 away(camera->GetDirectionOfProjection());
    const auto put = [&](const Arrow& arrow, const Point& tip, const Point& place) {
      const double behind = std::max(away.dot(arrow.tip - centre), away.dot(arrow.tail - centre));
      const double forward = std::max(0.0, radius + behind);
      arrow.bring_forward(-forward * away, -(forward + arrow_length * radius) * away);
      arrow.name->SetDisplayOffset(static_cast<int>(std::lround(place.x - tip.x)),
                                   static_cast<int>(std::lround(place.y - tip.y)));
    };
    if (&first != &second) put(second, arrows[1].tip, places[1]);
    put(first, arrows[0].tip, places[0]);
  }

  // How far the target reaches from its middle.
  [[nodiscard]] double reach(const Vec3& direction) const {
    double most = 0.0;
    for (const auto& facet : mesh.facets)
      for (const std::uint32_t v : facet) most = std::max(most, direction.dot(mesh.positions[v] - centre));
    return most;
  }

  const FacetMesh& mesh;
  Vec3 centre;
  double radius;
  double width_over_height = 1.0;
  std::vector<Colour> colours;
  bool colours_are_names = false;
  Vec3 shaded_from = Vec3::Zero();  // zero: not yet
  vtkSmartPointer<vtkPolyData> triangles;
  vtkNew<vtkUnsignedCharArray> rgb;
  vtkNew<vtkActor> facets, creases, part;
  Arrow sensor{ink}, transmitter{curve_colour(1)};
  std::array<Arrow, 3> axis_arrows{Arrow(curve_colour(1)), Arrow(curve_colour(2)), Arrow(curve_colour(0))};
  vtkNew<vtkRenderer> renderer, axes;
  vtkNew<vtkCallbackCommand> follow;
};

TargetScene::TargetScene(const FacetMesh& mesh) : hidden_(std::make_unique<Hidden>(mesh)) {}
TargetScene::~TargetScene() = default;

void TargetScene::colour(const std::vector<Colour>& colours, bool are_names) {
  hidden_->colours = colours;
  hidden_->colours_are_names = are_names;
  hidden_->shaded_from = Vec3::Zero();
}

void TargetScene::point_at(const Vec3& to_transmitter, const Vec3& to_receiver) {
  constexpr double same = 1e-6;  // [rad]
  const bool is_monostatic = (to_transmitter - to_receiver).norm() < same;
  const double r = hidden_->radius;
  const auto set = [&](Arrow& arrow, const Vec3& direction, const char* name) {
    arrow.set(hidden_->centre + (hidden_->reach(direction) + gap * r) * direction, direction, arrow_length * r, name);
  };
  set(hidden_->sensor, to_receiver, is_monostatic ? "sensor" : "receiver");
  set(hidden_->transmitter, to_transmitter, "transmitter");
  hidden_->transmitter.show(!is_monostatic);
}

void TargetScene::show_receiver(bool is_shown) {
  hidden_->sensor.show(is_shown);
}

void TargetScene::outline_part(std::optional<std::uint32_t> part) {
  hidden_->part->SetVisibility(part.has_value());
  if (part) set_lines(hidden_->part, shown_triangles(hidden_->mesh, part), {0.84, 0.1, 0.1}, 3.0);
}

void TargetScene::look_from(const Vec3& toward_viewer) {
  const Vec3 d = toward_viewer.normalized();
  const Vec3 up = std::abs(d.z()) < 0.999 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
  const Vec3 position = hidden_->centre + 10.0 * hidden_->radius * d;
  vtkCamera* camera = hidden_->renderer->GetActiveCamera();
  camera->SetFocalPoint(hidden_->centre.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(up.data());
  camera->OrthogonalizeViewUp();
  fit(hidden_->width_over_height);
}

void TargetScene::fit(double width_over_height) {
  hidden_->width_over_height = width_over_height;
  vtkCamera* camera = hidden_->renderer->GetActiveCamera();
  const Vec3 d = -Vec3(camera->GetDirectionOfProjection()), above(camera->GetViewUp());
  const Vec3 right = above.cross(d).normalized();
  // An arrow stands off a point p of the target along d by p.d: of that (p.d)(d.right) is seen across, which is at most
  // half of p.right + |p|, whatever d is.
  const double with_arrow = (gap + arrow_length + name_room) * hidden_->radius;
  const double across = 0.5 * (std::max(hidden_->reach(right), hidden_->reach(-right)) + hidden_->radius) + with_arrow;
  const double upward = 0.5 * (std::max(hidden_->reach(above), hidden_->reach(-above)) + hidden_->radius) + with_arrow;
  constexpr double of_names = 0.93;  // half of a name lies beyond its middle
  camera->SetParallelScale(std::max(upward, across / width_over_height) / of_names);
  camera->SetClippingRange(hidden_->radius, 20.0 * hidden_->radius);
}

void TargetScene::look_beside(const Vec3& direction) {
  constexpr double raise = 25.0 * degree, aside = 30.0 * degree;
  look_from(oblique(direction, Vec3::UnitZ(), raise, aside));
}

std::optional<std::uint32_t> TargetScene::facet_at(double x, double y) const {
  vtkNew<vtkCellPicker> picker;
  picker->SetTolerance(0.0);
  picker->PickFromListOn();
  picker->AddPickList(hidden_->facets);
  if (picker->Pick(x, y, 0.0, hidden_->renderer) == 0 || picker->GetCellId() < 0) return std::nullopt;
  return static_cast<std::uint32_t>(picker->GetCellId());
}

void TargetScene::set_letters(int letters) {
  for (const Arrow* arrow : {&hidden_->sensor, &hidden_->transmitter, &hidden_->axis_arrows[0],
                             &hidden_->axis_arrows[1], &hidden_->axis_arrows[2]})
    arrow->name->GetTextProperty()->SetFontSize(letters);
}

vtkRenderer* TargetScene::renderer() const {
  return hidden_->renderer;
}

vtkRenderer* TargetScene::axes() const {
  return hidden_->axes;
}

Picture TargetScene::picture(int width, int height, int letters) {
  const int fine = offscreen_fineness(width, height);
  set_letters(fine * letters);
  hidden_->creases->GetProperty()->SetLineWidth(static_cast<float>(1.6 * fine));
  hidden_->part->GetProperty()->SetLineWidth(static_cast<float>(3.0 * fine));
  hidden_->axes->SetViewport(0.0, 0.0, axes_share, axes_share * width / height);
  hidden_->axes->SetLayer(1);
  return shrunk(drawn_offscreen({hidden_->renderer, hidden_->axes}, fine * width, fine * height), fine);
}

}  // namespace lrcs
