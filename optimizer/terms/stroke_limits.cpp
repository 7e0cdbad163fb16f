// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "optimizer/design/actuator_length.hpp"
#include "optimizer/terms/factories.hpp"

namespace legwright {
namespace {

/// Not in the paper: linear actuators stay inside their stroke, shortest ≤ L(q, s) ≤ longest with
/// L² = A + B cos q + C sin q (design/actuator_length). Residuals (L − shortest)/half and
/// (longest − L)/half ≥ 0, kept by the barrier, half the stroke. Actuators without a range have
/// none.
class StrokeLimits final : public Term {
 public:
  explicit StrokeLimits(const TermContext& context) : length_(context.length) {
    const Layout& layout = context.layout;
    const auto& actuators = context.morphology.linear_actuators;
    for (int i = 0; i < layout.knot_count(); ++i)
      for (std::size_t k = 0; k < actuators.size(); ++k) {
        const LinearActuator& actuator = actuators[k];
        if (!std::isfinite(actuator.longest)) continue;
        const int shape = layout.actuator_shape(static_cast<int>(k));
        elements_.push_back(
            {i, -1, 2, {shape, shape + 1, shape + 2, layout.pose(i) + 6 + actuator.joint}});
        const double shortest = actuator.shortest / context.length,
                     longest = actuator.longest / context.length;
        strokes_.push_back({shortest, longest, 2.0 / (longest - shortest), actuator.name});
      }
  }
  std::string_view name() const override { return "stroke_limits"; }
  Penalty penalty() const override { return Penalty::barrier; }

  void residual(int element, const Eigen::VectorXd& z, Eigen::VectorXd& r) const override {
    const Stroke& stroke = strokes_[element];
    const double length = actuator_length(z.head<3>(), z[3]);
    r[0] = stroke.scale * (length - stroke.shortest);
    r[1] = stroke.scale * (stroke.longest - length);
  }
  void jacobian(int element, const Eigen::VectorXd& z, Eigen::MatrixXd& jacobian) const override {
    const double scale = strokes_[element].scale / (2.0 * actuator_length(z.head<3>(), z[3]));
    jacobian.row(0) = scale * squared_gradient(z).transpose();
    jacobian.row(1) = -jacobian.row(0);
  }
  void add_curvature(int element, const Eigen::VectorXd& z, const Eigen::VectorXd& multiplier,
                     Eigen::MatrixXd& hessian) const override {
    // L = √S: ∂²L = ∂²S/(2L) − ∂S ∂Sᵀ/(4L³).
    const double length = actuator_length(z.head<3>(), z[3]), c = std::cos(z[3]),
                 s = std::sin(z[3]);
    const Eigen::Vector4d gradient = squared_gradient(z);
    Eigen::Matrix4d second = Eigen::Matrix4d::Zero();
    second(1, 3) = second(3, 1) = -s;
    second(2, 3) = second(3, 2) = c;
    second(3, 3) = -z[1] * c - z[2] * s;
    hessian += strokes_[element].scale * (multiplier[0] - multiplier[1]) / (2.0 * length) *
               (second - gradient * gradient.transpose() / (2.0 * length * length));
  }
  ResidualUnit unit(int element, int) const override {
    return {length_ / strokes_[element].scale, "m"};
  }
  std::string subject(int element, int) const override { return strokes_[element].name; }
  Eigen::VectorXd sample(int element, std::mt19937& random) const override {
    std::uniform_real_distribution<double> share(-0.2, 1.2), angle(-2.0, 2.0), part(-0.3, 0.3);
    const Stroke& stroke = strokes_[element];
    const double length = stroke.shortest + share(random) * (stroke.longest - stroke.shortest);
    const double squared = std::pow(std::max(length, 0.1 * stroke.longest), 2);
    Eigen::Vector4d z(0.0, part(random) * squared, part(random) * squared, angle(random));
    z[0] = squared - z[1] * std::cos(z[3]) - z[2] * std::sin(z[3]);
    return z;
  }

 private:
  struct Stroke {
    double shortest, longest, scale;  // [leg length]
    std::string name;
  };
  /// ∂L²/∂(A, B, C, q).
  static Eigen::Vector4d squared_gradient(const Eigen::VectorXd& z) {
    const double c = std::cos(z[3]), s = std::sin(z[3]);
    return {1.0, c, s, z[2] * c - z[1] * s};
  }

  std::vector<Stroke> strokes_;  // by element
  double length_;                // of the leg [m]
};

}  // namespace

std::unique_ptr<Term> make_stroke_limits(const TermContext& context) {
  return std::make_unique<StrokeLimits>(context);
}

}  // namespace legwright
