#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/input_error.h"
#include "brdf/material.h"
#include "cad/tessellation.h"
#include "lrcs/aspect.h"
#include "lrcs/cross_section.h"

namespace lrcs {

// Which facets a material goes to. First match wins.
struct AssignRule {
  enum class By { part, file_material, colour, layer, property, everything };
  By by = By::everything;
  std::string pattern;     // of what the file tells of a facet: *, ? and [...] as in a shell
  std::string material;    // a name of Scene::materials
  Place place;             // of the pattern, for messages
  std::string property{};  // its name, of By::property
  std::string back{};      // what the side behind the winding has instead; "": both sides have `material`
};

// What a rule goes by, as the scene file says it: part, file_material, colour, layer, property, default.
[[nodiscard]] const std::string& key_of(AssignRule::By by);

// The target's file and how it is to be read.
struct TargetFile {
  std::filesystem::path file;
  Place place;                            // of the file name, for messages
  std::string unit;                       // "": the file's own
  Tessellation tessellation;              // of CAD surfaces
  std::string forward = "+x", up = "+z";  // axes of the file: the user's, else the format's
  bool repair = true;
  Sides sides = Sides::both;
  std::filesystem::path facet_properties{};  // a table of them (mesh/facet_properties_csv.h); "": none
  Place properties_place{};                  // of its name
};

// For which directions of the sweep the facets are to be written.
struct FacetOutput {
  bool all = false;
  std::vector<AspectAngles> directions;
  std::vector<Place> places;
};

// What is to be computed, as the user said it, every word checked.
struct Scene {
  std::string name;         // the scene file, or "command line"
  std::string digest;       // SHA-256 of the scene's text
  double wavelength = 0.0;  // [m]; 0: not stated
  TargetFile target;
  std::vector<Material> materials;
  std::vector<AssignRule> assign;
  Place assign_place;
  std::vector<AspectAngles> directions;  // of the transmitter, in the order of the sweep
  Receiver receiver;
  std::optional<double> relative_accuracy;  // none: exact
  FacetOutput facets;
};

// Reads a scene file (docs/scene.md). The target's path is taken relative to it.
// error: InputError at file:line:column for anything that is not as it should be.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file);

// A unit of length, for every way to make a scene. Throws InputError at `place` for a name that is none.
[[nodiscard]] std::string checked_unit(const std::string& unit, const Place& place);

// The same of a chord tolerance: "1e-3" is relative, "0.1 mm" a length. Which of the two was said is set.
void set_chord_tolerance(Tessellation& tessellation, const std::string& words, const Place& place);

void set_chord_angle(Tessellation& tessellation, double angle_deg, const Place& place);

// For each direction of scene.facets its row of the sweep: the one of the same angles, else the first that points the
// same way. error: InputError at its place for a direction outside the sweep; it names the nearest.
[[nodiscard]] std::vector<std::size_t> facet_rows(const Scene& scene);

// Materials made for another wavelength than the scene's; one line each.
[[nodiscard]] std::vector<std::string> wavelength_warnings(const Scene& scene);

// These, and what the measurements of tabulated materials warn of; one line each.
[[nodiscard]] std::vector<std::string> material_warnings(const Scene& scene);

}  // namespace lrcs
