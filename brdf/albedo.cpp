#include "brdf/albedo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace lrcs {
namespace {

constexpr std::size_t max_cells = 4000;  // 0.9 million evaluations

// The Gauss-Kronrod pair of 7 and 15 points on [-1, 1]; gauss: 0 where the 7-point rule has no point.
// source: QUADPACK, R. Piessens et al., Springer 1983, qk15.
struct Node {
  double x, kronrod, gauss;
};
constexpr std::array<Node, 15> nodes{
    {{-0.991455371120812639206854697526329, 0.022935322010529224963732008058970, 0.0},
     {-0.949107912342758524526189684047851, 0.063092092629978553290700663189204, 0.129484966168869693270611432679082},
     {-0.864864423359769072789712788640926, 0.104790010322250183839876322541518, 0.0},
     {-0.741531185599394439863864773280788, 0.140653259715525918745189590510238, 0.279705391489276667901467771423780},
     {-0.586087235467691130294144691693013, 0.169004726639267902826583426598550, 0.0},
     {-0.405845151377397166906606412076961, 0.190350578064785409913256402421014, 0.381830050505118944950369775488975},
     {-0.207784955007898467600689403773245, 0.204432940075298892414161999234649, 0.0},
     {0.0, 0.209482141084727828012999174891714, 0.417959183673469387755102040816327},
     {0.207784955007898467600689403773245, 0.204432940075298892414161999234649, 0.0},
     {0.405845151377397166906606412076961, 0.190350578064785409913256402421014, 0.381830050505118944950369775488975},
     {0.586087235467691130294144691693013, 0.169004726639267902826583426598550, 0.0},
     {0.741531185599394439863864773280788, 0.140653259715525918745189590510238, 0.279705391489276667901467771423780},
     {0.864864423359769072789712788640926, 0.104790010322250183839876322541518, 0.0},
     {0.949107912342758524526189684047851, 0.063092092629978553290700663189204, 0.129484966168869693270611432679082},
     {0.991455371120812639206854697526329, 0.022935322010529224963732008058970, 0.0}}};

// A rectangle of theta_r and phi with its share of the integral.
struct Cell {
  double theta_from, theta_to, phi_from, phi_to;
  Estimate share;
  bool operator<(const Cell& other) const { return share.bound < other.share.bound; }
};

template <class Integrand>
Cell cell(double theta_from, double theta_to, double phi_from, double phi_to, const Integrand& integrand) {
  const double theta_half = 0.5 * (theta_to - theta_from);
  const double phi_half = 0.5 * (phi_to - phi_from);
  double kronrod = 0.0;
  double gauss_in_theta = 0.0;
  double gauss_in_phi = 0.0;
  for (const Node& t : nodes)
    for (const Node& p : nodes) {
      const double value = integrand(theta_from + theta_half * (1.0 + t.x), phi_from + phi_half * (1.0 + p.x));
      kronrod += t.kronrod * p.kronrod * value;
      gauss_in_theta += t.gauss * p.kronrod * value;
      gauss_in_phi += t.kronrod * p.gauss * value;
    }
  // One difference a direction: errors of the two may cancel in a common one.
  const double error = std::abs(kronrod - gauss_in_theta) + std::abs(kronrod - gauss_in_phi);
  const double area = theta_half * phi_half;
  return {theta_from, theta_to, phi_from, phi_to, {area * kronrod, area * error}};
}

Estimate sum(const std::vector<Cell>& cells) {
  Estimate total;
  for (const Cell& c : cells) {
    total.value += c.share.value;
    total.bound += c.share.bound;
  }
  total.bound += static_cast<double>(cells.size() + nodes.size() * nodes.size()) *
                 std::numeric_limits<double>::epsilon() * std::abs(total.value);
  return total;
}

// Halves the worst cell both ways until the bound is met. The first cells meet at the retro and the specular direction.
template <class Integrand>
Estimate cubature(double theta_i, double relative, const Integrand& integrand) {
  std::vector<Cell> cells;
  const double right = std::numbers::pi / 2.0;
  if (theta_i > 0.0) cells.push_back(cell(0.0, theta_i, 0.0, std::numbers::pi, integrand));
  cells.push_back(cell(theta_i, right, 0.0, std::numbers::pi, integrand));
  std::make_heap(cells.begin(), cells.end());
  Estimate total = sum(cells);
  while (total.bound > relative * total.value && cells.size() < max_cells) {
    std::pop_heap(cells.begin(), cells.end());
    const Cell c = cells.back();
    cells.pop_back();
    const double theta = 0.5 * (c.theta_from + c.theta_to);
    const double phi = 0.5 * (c.phi_from + c.phi_to);
    const std::array<Cell, 4> quarters{
        cell(c.theta_from, theta, c.phi_from, phi, integrand), cell(c.theta_from, theta, phi, c.phi_to, integrand),
        cell(theta, c.theta_to, c.phi_from, phi, integrand), cell(theta, c.theta_to, phi, c.phi_to, integrand)};
    for (const Cell& quarter : quarters) {
      cells.push_back(quarter);
      std::push_heap(cells.begin(), cells.end());
    }
    total = sum(cells);
  }
  return total;
}

}  // namespace

Estimate albedo(const Brdf& brdf, double theta_i, double relative) {
  if (!(theta_i >= 0.0 && theta_i < std::numbers::pi / 2.0) || !(relative > 0.0))
    throw std::domain_error("albedo: expected theta_i in [0, pi/2) and relative > 0");
  const Vec3 wi(std::sin(theta_i), 0.0, std::cos(theta_i));
  return std::visit(
      [&](const auto& model) {
        return cubature(theta_i, relative, [&](double theta_r, double phi) {
          const double sine = std::sin(theta_r);
          const Vec3 wr(sine * std::cos(phi), sine * std::sin(phi), std::cos(theta_r));
          const Vec3 n = Vec3::UnitZ();
          return 2.0 * sine * model.f_cos_cos(wi, wr, n) / wi.z();  // 2: the hemisphere is symmetric in phi
        });
      },
      brdf);
}

}  // namespace lrcs
