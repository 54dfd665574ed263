#include "lrcs/mirror_planes.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/expansion.h"
#include "mesh/weld.h"

namespace lrcs {
namespace {

using Point = std::array<double, 3>;

// A facet by its corners, from the lowest on in the order of its winding, and the materials of front and back.
using FacetKey = std::array<std::uint32_t, 5>;
using KeyedFacet = std::pair<FacetKey, std::uint32_t>;

FacetKey key_of(std::array<std::uint32_t, 3> corners, std::uint32_t front, std::uint32_t back) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return {corners[0], corners[1], corners[2], front, back};
}

// Mirrors coordinates of one axis, exactly or not at all.
class Mirror {
 public:
  // Half way between two coordinates, whether that is a double or not.
  Mirror(double low, double high) : sum_(sum_of(low, high)) {}

  [[nodiscard]] std::optional<double> image(double x) const {
    const double y = (sum_.value - x) + sum_.error + 0.0;
    const Unrounded own = sum_of(x, y);
    if (own.value != sum_.value || own.error != sum_.error) return std::nullopt;
    return y;
  }

 private:
  Unrounded sum_;
};

// Have the corners of one facet their images among the positions? Of most targets that are not symmetric they have not,
// and no more need be looked at.
bool may_be_mirrored(const FacetMesh& mesh, Eigen::Index axis) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const std::array<std::uint32_t, 3>* one = nullptr;
  for (std::size_t f = 0; f < mesh.size(); ++f) {
    if (mesh.areas[f] == 0.0) continue;
    one = &mesh.facets[f];
    for (const std::uint32_t v : *one) {
      low = std::min(low, mesh.positions[v][axis]);
      high = std::max(high, mesh.positions[v][axis]);
    }
  }
  const Mirror mirror(low, high);
  const auto has_image = [&](std::uint32_t v) {
    Vec3 p = mesh.positions[v];
    const auto image = mirror.image(p[axis]);
    if (!image) return false;
    p[axis] = *image;
    return std::find(mesh.positions.begin(), mesh.positions.end(), p) != mesh.positions.end();
  };
  return one != nullptr && std::all_of(one->begin(), one->end(), has_image);
}

class MirrorSearch {
 public:
  MirrorSearch(const Target& target, const std::vector<CoincidentFacets>& coincident)
      : target_(target), coincident_(coincident) {
    for (std::uint32_t f = 0; f < target.mesh.size(); ++f)
      if (target.mesh.areas[f] > 0.0) facets_.push_back(f);
    number_places();
    for (const std::uint32_t f : facets_)
      keyed_.emplace_back(key_of(corners_[f], target.material[f], target.back_material()[f]), f);
    std::sort(keyed_.begin(), keyed_.end());
  }

  [[nodiscard]] bool is_mirrored(std::size_t axis) const {
    const auto image = images_of_places(axis);
    if (!image) return false;
    std::vector<KeyedFacet> images;
    images.reserve(keyed_.size());
    for (const auto& [key, facet] : keyed_) {
      const auto& [a, b, c, front, back] = key;
      images.emplace_back(key_of({(*image)[a], (*image)[c], (*image)[b]}, front, back), facet);
    }
    std::sort(images.begin(), images.end());
    const auto same = [](const KeyedFacet& a, const KeyedFacet& b) { return a.first == b.first; };
    return std::equal(keyed_.begin(), keyed_.end(), images.begin(), same) && keeps_order(images);
  }

 private:
  // Different positions of corners, in lexicographic order.
  void number_places() {
    const auto first = first_equal(target_.mesh.positions);
    std::vector<std::uint32_t> used;
    for (const std::uint32_t f : facets_)
      for (const std::uint32_t v : target_.mesh.facets[f]) used.push_back(first[v]);
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::sort(used.begin(), used.end(), [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    std::vector<std::uint32_t> number(target_.mesh.positions.size());
    for (std::uint32_t k = 0; k < used.size(); ++k) {
      places_.push_back(place(used[k]));
      number[used[k]] = k;
    }
    corners_.resize(target_.mesh.size());
    for (const std::uint32_t f : facets_)
      for (std::size_t k = 0; k < 3; ++k) corners_[f][k] = number[first[target_.mesh.facets[f][k]]];
  }
  [[nodiscard]] Point place(std::uint32_t vertex) const {
    const Vec3& p = target_.mesh.positions[vertex];
    return {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};  // zero has one sign
  }
  [[nodiscard]] std::optional<std::uint32_t> number_of(const Point& p) const {
    const auto found = std::lower_bound(places_.begin(), places_.end(), p);
    if (found == places_.end() || *found != p) return std::nullopt;
    return static_cast<std::uint32_t>(found - places_.begin());
  }

  // The number of each place's image; nothing where one has none.
  [[nodiscard]] std::optional<std::vector<std::uint32_t>> images_of_places(std::size_t axis) const {
    const auto [low, high] = std::minmax_element(places_.begin(), places_.end(),
                                                 [=](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    const Mirror mirror((*low)[axis], (*high)[axis]);
    std::vector<std::uint32_t> image;
    image.reserve(places_.size());
    for (const Point& p : places_) {
      const auto mirrored = mirror.image(p[axis]);
      if (!mirrored) return std::nullopt;
      Point q = p;
      q[axis] = *mirrored;
      const auto number = number_of(q);
      if (!number) return std::nullopt;
      image.push_back(*number);
    }
    return image;
  }

  // images[k] is of the facet whose image is keyed_[k].
  [[nodiscard]] bool keeps_order(const std::vector<KeyedFacet>& images) const {
    if (coincident_.empty()) return true;
    std::vector<std::uint32_t> image(target_.mesh.size());
    for (std::size_t k = 0; k < images.size(); ++k) image[images[k].second] = keyed_[k].second;
    return std::all_of(coincident_.begin(), coincident_.end(), [&](const CoincidentFacets& pair) {
      const auto [a, b] = pair;
      return are_alike(a, b) || (a < b) == (image[a] < image[b]);
    });
  }
  // Of opposite facets the one counts whose front is seen, whatever the order.
  [[nodiscard]] bool are_alike(std::uint32_t a, std::uint32_t b) const {
    return target_.material[a] == target_.material[b] && target_.back_material()[a] == target_.back_material()[b];
  }

  const Target& target_;
  const std::vector<CoincidentFacets>& coincident_;
  std::vector<std::uint32_t> facets_;  // of an area
  std::vector<Point> places_;
  std::vector<std::array<std::uint32_t, 3>> corners_;  // numbers of places; one a facet of the mesh
  std::vector<KeyedFacet> keyed_;                      // sorted
};

}  // namespace

MirrorPlanes mirror_planes(const Target& target, const MirrorPlanes& sought,
                           const std::vector<CoincidentFacets>& coincident) {
  MirrorPlanes likely{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    likely[axis] = sought[axis] && may_be_mirrored(target.mesh, static_cast<Eigen::Index>(axis));
  if (likely == MirrorPlanes{}) return likely;
  const MirrorSearch search(target, coincident);
  for (std::size_t axis = 0; axis < 3; ++axis) likely[axis] = likely[axis] && search.is_mirrored(axis);
  return likely;
}

}  // namespace lrcs
