#include "fit/fit_problem.h"

#include <ceres/jet.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "base/compensated_sum.h"
#include "brdf/direction_at.h"

namespace lrcs {
namespace {

const Vec3 normal(0.0, 0.0, 1.0);

FitRow row_of(const BrdfSample& s) {
  FitRow row;
  row.wi = direction_at(s.theta_i, 0.0);
  row.wr = direction_at(s.theta_r, s.phi);
  row.cos_i = row.wi.z();
  row.cos_r = row.wr.z();
  row.f_r = s.f_r;
  row.root_weight = std::sqrt(s.weight);
  return row;
}

// Makes the squares of the residuals add up to what FitProblem says.
void scale(std::vector<FitRow>& rows, Residual residual) {
  CompensatedSum all;
  for (const FitRow& row : rows) {
    const double size = residual == Residual::linear ? row.f_r * row.cos_r : 1.0;
    all.add(row.root_weight * size * row.root_weight * size);
  }
  if (!(all.value() > 0.0)) throw std::domain_error("expected samples with f_r > 0 and weight > 0");
  for (FitRow& row : rows) row.root_weight /= std::sqrt(all.value());
}

// Least squares of a and b, of two columns or of one (b empty of content then), against a target: their inner products.
struct Products {
  double aa = 0.0, ab = 0.0, bb = 0.0, at = 0.0, bt = 0.0, tt = 0.0;

  void add(double a, double b, double t) {
    aa += a * a, ab += a * b, bb += b * b, at += a * t, bt += b * t, tt += t * t;
  }
  [[nodiscard]] double squares(double x, double y) const {
    return tt - 2.0 * (x * at + y * bt) + x * x * aa + 2.0 * x * y * ab + y * y * bb;
  }
};

double between(double low, double x, double high) {
  return std::isfinite(x) ? std::clamp(x, low, high) : low;
}

// Sine squared of the angle between columns: below, rounding decides which of them counts.
constexpr double parallel = 1e-14;

// Non-negative least squares in two unknowns: the free solution, or the better of the two with one unknown at 0.
std::array<double, 2> non_negative_scales(const Products& p, double most_x, double most_y) {
  const double determinant = p.aa * p.bb - p.ab * p.ab;
  if (determinant > parallel * p.aa * p.bb) {
    const double x = (p.at * p.bb - p.bt * p.ab) / determinant;
    const double y = (p.bt * p.aa - p.at * p.ab) / determinant;
    if (x >= 0.0 && y >= 0.0 && x <= most_x && y <= most_y) return {x, y};
  }
  const double x = between(0.0, p.at / p.aa, most_x);
  const double y = between(0.0, p.bt / p.bb, most_y);
  if (p.squares(x, 0.0) <= p.squares(0.0, y)) return {x, 0.0};
  return {0.0, y};
}

template <class Form>
class FormProblem final : public FitProblem {
 public:
  static constexpr std::size_t size = Form::parameters.size();
  // A multiple of four, of which the compiler makes straight code: half the time of nine.
  using Jet = ceres::Jet<double, static_cast<int>((size + 3) / 4 * 4)>;

  FormProblem(int azimuth_of_specular, const std::vector<BrdfSample>& samples, Residual residual)
      : azimuth_of_specular_(azimuth_of_specular), residual_(residual) {
    for (const BrdfSample& s : samples) rows_.push_back(row_of(s));
    scale(rows_, residual);
    for (std::size_t k = 0; k < size; ++k)
      if (Form::parameters[k].is_linear) linear_.push_back(k);
    assert(linear_.size() == 1 || linear_.size() == 2);
  }

  [[nodiscard]] std::span<const FormParameter> parameters() const override { return Form::parameters; }
  [[nodiscard]] std::size_t rows() const override { return rows_.size(); }

  void residuals(std::span<const double> parameters, Eigen::VectorXd& residual,
                 Eigen::MatrixXd* jacobian) const override {
    residual.resize(static_cast<Eigen::Index>(rows_.size()));
    if (jacobian == nullptr) {
      const auto model = make<double>(parameters);
      for (std::size_t k = 0; k < rows_.size(); ++k) residual[index(k)] = difference(model, rows_[k]);
      return;
    }
    jacobian->resize(residual.size(), static_cast<Eigen::Index>(size));
    const auto model = make<Jet>(parameters);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const Jet r = difference(model, rows_[k]);
      residual[index(k)] = r.a;
      jacobian->row(index(k)) = r.v.template head<static_cast<int>(size)>().transpose();
    }
  }

  [[nodiscard]] Eigen::MatrixXd variance_basis(std::span<const double> parameters) const override {
    const auto model = make<double>(parameters);
    Eigen::MatrixXd basis(static_cast<Eigen::Index>(rows_.size()), 4);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const FitRow& row = rows_[k];
      const double value = f_cos(model, row);
      const double slope = residual_ == Residual::linear ? 1.0 : 1.0 / value;  // of what is weighed, by f_r cos_r
      const double by_weight = slope * slope;
      const double constant = row.root_weight * row.root_weight * by_weight;
      basis.row(index(k)) << constant, constant * value, constant * value * value, by_weight;
    }
    return basis;
  }

  [[nodiscard]] double solve_linear(std::span<double> parameters) const override {
    const Products p = products(parameters);
    const std::size_t a = linear_.front(), b = linear_.back();
    if (a == b) {
      parameters[a] = between(0.0, p.at / p.aa, Form::parameters[a].most);
      return squares(p, parameters, parameters[a], 0.0);
    }
    const auto [x, y] = non_negative_scales(p, Form::parameters[a].most, Form::parameters[b].most);
    parameters[a] = x;
    parameters[b] = y;
    return squares(p, parameters, x, y);
  }

 private:
  [[nodiscard]] static Eigen::Index index(std::size_t k) { return static_cast<Eigen::Index>(k); }

  template <class T>
  [[nodiscard]] auto make(std::span<const double> parameters) const {
    forms::Values<T, size> values{};
    for (std::size_t k = 0; k < size; ++k) {
      if constexpr (std::is_same_v<T, double>)
        values[k] = parameters[k];
      else
        values[k] = T(parameters[k], static_cast<int>(k));
    }
    return Form::template make<T>(values, azimuth_of_specular_);
  }

  // f_r cos_r of a model.
  template <class Model>
  [[nodiscard]] static auto f_cos(const Model& model, const FitRow& row) {
    return model.f_cos_cos(row.wi, row.wr, normal) / row.cos_i;
  }

  template <class Model>
  [[nodiscard]] auto difference(const Model& model, const FitRow& row) const {
    using std::log;
    const auto f = f_cos(model, row);
    if (residual_ == Residual::linear) return decltype(f * 1.0)((f - row.f_r * row.cos_r) * row.root_weight);
    return decltype(f * 1.0)(log(f / (row.f_r * row.cos_r)) * row.root_weight);
  }

  // With the linear parameters 1 and 0, 0 and 1.
  [[nodiscard]] Products products(std::span<const double> parameters) const {
    const auto first = make_unit(parameters, linear_.front());
    const auto second = make_unit(parameters, linear_.back());
    const bool both = linear_.size() == 2;
    Products p;
    for (const FitRow& row : rows_) {
      const double measured = row.f_r * row.cos_r;
      const double weight = residual_ == Residual::linear ? row.root_weight : row.root_weight / measured;
      p.add(weight * f_cos(first, row), both ? weight * f_cos(second, row) : 0.0, weight * measured);
    }
    return p;
  }

  [[nodiscard]] auto make_unit(std::span<const double> parameters, std::size_t active) const {
    std::array<double, size> values{};
    for (std::size_t k = 0; k < size; ++k) values[k] = parameters[k];
    for (const std::size_t k : linear_) values[k] = k == active ? 1.0 : 0.0;
    return make<double>(values);
  }

  [[nodiscard]] double squares(const Products& p, std::span<const double> parameters, double x, double y) const {
    if (residual_ == Residual::linear) return std::max(p.squares(x, y), 0.0);
    Eigen::VectorXd residual;
    residuals(parameters, residual, nullptr);
    return residual.squaredNorm();
  }

  int azimuth_of_specular_;
  Residual residual_;
  std::vector<FitRow> rows_;
  std::vector<std::size_t> linear_;
};

template <class... Forms>
std::unique_ptr<FitProblem> find(const std::tuple<Forms...>* /*list*/, std::string_view form, int azimuth_of_specular,
                                 const std::vector<BrdfSample>& samples, Residual residual) {
  std::unique_ptr<FitProblem> problem;
  const auto try_form = [&]<class Form>(Form) {
    if (Form::name == form) problem = std::make_unique<FormProblem<Form>>(azimuth_of_specular, samples, residual);
  };
  (try_form(Forms{}), ...);
  if (!problem) throw std::invalid_argument("no such form: " + std::string(form));
  return problem;
}

}  // namespace

std::unique_ptr<FitProblem> fit_problem(std::string_view form, int azimuth_of_specular,
                                        const std::vector<BrdfSample>& samples, Residual residual) {
  return find(static_cast<const FormList*>(nullptr), form, azimuth_of_specular, samples, residual);
}

}  // namespace lrcs
