// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "optimizer/design/inertia.hpp"
#include "optimizer/terms/factories.hpp"

namespace legwright {
namespace {

/// Not in the paper: a weak tether of the design to the initial one; without it legs shrink to
/// nothing. Residuals: (l − l₀)/l₀ for lengths and (p − p₀)/leg length for positions, once for
/// everything tied to them, and a(s) − a₀ for each joint axis.
class DesignTether final : public Term {
 public:
  explicit DesignTether(const TermContext& context) {
    const Eigen::VectorXd initial = context.space.initial();
    for (int k = 0; k < context.space.size(); ++k) {
      const DesignParameter& parameter = context.space.parameters[k];
      if (parameter.kind == ParameterKind::axis_angle) continue;
      const double unit =
          parameter.kind == ParameterKind::length ? parameter.initial : context.length;
      elements_.push_back({0, -1, 1, {context.layout.design(k)}});
      parts_.push_back(
          {std::sqrt(static_cast<double>(parameter.tied_count)) / unit, parameter.initial});
    }
    for (const Link& link : context.morphology.links) {
      const JointAxis& axis = link.joint.axis;
      if (axis.turns.empty()) continue;
      Element element{0, -1, 3, {}};
      JointAxis local = axis;  // its parameters numbered by local variable
      for (std::size_t k = 0; k < axis.turns.size(); ++k) {
        element.slots.push_back(context.layout.design(axis.turns[k].parameter));
        local.turns[k].parameter = static_cast<int>(k);
      }
      elements_.push_back(std::move(element));
      parts_.push_back({0.0, 0.0, std::move(local), axis.at(initial)});
    }
  }
  std::string_view name() const override { return "design_tether"; }

  void residual(int element, const Eigen::VectorXd& z, Eigen::VectorXd& r) const override {
    const Part& part = parts_[element];
    if (elements_[element].rows == 1)
      r[0] = part.scale * (z[0] - part.initial);
    else
      r = part.axis.at(z) - part.initial_axis;
  }
  void jacobian(int element, const Eigen::VectorXd& z, Eigen::MatrixXd& jacobian) const override {
    const Part& part = parts_[element];
    if (elements_[element].rows == 1) {
      jacobian(0, 0) = part.scale;
      return;
    }
    const AxisAtDesign at = axis_at(part.axis, z);
    for (std::size_t k = 0; k < at.first.size(); ++k)
      jacobian.col(static_cast<int>(k)) = at.first[k];
  }
  void add_curvature(int element, const Eigen::VectorXd& z, const Eigen::VectorXd& multiplier,
                     Eigen::MatrixXd& hessian) const override {
    if (elements_[element].rows == 1) return;
    const AxisAtDesign at = axis_at(parts_[element].axis, z);
    for (std::size_t k = 0; k < at.first.size(); ++k)
      for (std::size_t l = 0; l < at.first.size(); ++l)
        hessian(static_cast<int>(k), static_cast<int>(l)) +=
            multiplier.head<3>().dot(at.second[k][l]);
  }
  Eigen::VectorXd sample(int element, std::mt19937& random) const override {
    std::normal_distribution<double> normal;
    const Part& part = parts_[element];
    Eigen::VectorXd z(static_cast<int>(elements_[element].slots.size()));
    for (double& value : z)
      value = elements_[element].rows == 1 ? part.initial + 0.2 * normal(random) / part.scale
                                           : 0.5 * normal(random);
    return z;
  }

 private:
  struct Part {
    double scale = 0.0, initial = 0.0;
    JointAxis axis = {};
    Eigen::Vector3d initial_axis = Eigen::Vector3d::Zero();
  };
  std::vector<Part> parts_;
};

}  // namespace

std::unique_ptr<Term> make_design_tether(const TermContext& context) {
  return std::make_unique<DesignTether>(context);
}

}  // namespace legwright
