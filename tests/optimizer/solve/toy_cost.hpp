// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "optimizer/design/design.hpp"
#include "optimizer/solve/cost_function.hpp"

namespace legwright::toy {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Lower triangle with every entry stored, also zeros: a fixed pattern.
inline Eigen::SparseMatrix<double> lower_triangle(const MatrixXd& full) {
  Eigen::SparseMatrix<double> lower(full.rows(), full.cols());
  for (int j = 0; j < full.cols(); ++j)
    for (int i = j; i < full.rows(); ++i) lower.insert(i, j) = full(i, j);
  lower.makeCompressed();
  return lower;
}

/// Sizes of m and s of most toys.
inline constexpr int kMotionSize = 8, kDesignSize = 4;

/// Angles a, b, … around −0.3, −0.1, …, each free to move by `half`; their natural unit is one.
inline DesignSpace box(double half, int size = kDesignSize) {
  DesignSpace space;
  for (int k = 0; k < size; ++k) {
    DesignParameter parameter;
    parameter.name = std::string(1, static_cast<char>('a' + k));
    parameter.kind = ParameterKind::axis_angle;
    parameter.initial = 0.2 * k - 0.3;
    parameter.lower = parameter.initial - half;
    parameter.upper = parameter.initial + half;
    space.parameters.push_back(parameter);
  }
  return space;
}

/// A function of m alone, given by value, gradient, and full Hessian.
class MotionFunction final : public CostFunction {
 public:
  struct Derivatives {
    double value;
    VectorXd gradient;
    MatrixXd hessian;
  };
  using Function = std::function<Derivatives(const VectorXd&)>;

  MotionFunction(Function function, VectorXd units)
      : function_(std::move(function)), units_(std::move(units)) {}

  void evaluate(const VectorXd&, const VectorXd& m, Order order, Evaluation& out) override {
    ++calls;
    const Derivatives d = function_(m);
    out.value = d.value;
    if (order >= Order::gradient) out.stationarity = d.gradient;
    if (order >= Order::hessian) {
      out.hessian_mm = lower_triangle(d.hessian);
      ++hessians;
    }
  }
  const VectorXd& motion_units() const override { return units_; }

  int calls = 0, hessians = 0;

 private:
  Function function_;
  VectorXd units_;
};

/// F(s, m) = Σ ¼m⁴ weak + ½ mᵀAm − mᵀ(Bs + ½ C(s∘s)) + ½ sᵀDs − dᵀs: m*(s) is unique, bends with s,
/// and has no closed form, so that nothing can be right by accident.
class CoupledCost final : public CostFunction {
 public:
  CoupledCost(int motion_size, int design_size, unsigned seed = 7) {
    std::mt19937 random(seed);
    const auto fill = [&](int rows, int columns) {
      MatrixXd x(rows, columns);
      for (int j = 0; j < columns; ++j)
        for (int i = 0; i < rows; ++i) x(i, j) = static_cast<double>(random()) / 2147483648.0 - 1.0;
      return x;
    };
    const MatrixXd root = fill(motion_size, motion_size);
    a_ = root * root.transpose() + MatrixXd::Identity(motion_size, motion_size);
    b_ = fill(motion_size, design_size);
    c_ = fill(motion_size, design_size);
    d_ = fill(design_size, 1);
    units_ = VectorXd::LinSpaced(motion_size, 0.5, 2.0);
  }

  void evaluate(const VectorXd& s, const VectorXd& m, Order order, Evaluation& out) override {
    ++calls;
    const VectorXd load = b_ * s + 0.5 * c_ * s.cwiseAbs2();
    out.value = 0.25 * quartic_ * m.array().pow(4).sum() + 0.5 * m.dot(a_ * m) - m.dot(load) +
                0.5 * stiffness_ * s.squaredNorm() - d_.dot(s);
    out.term_values = {out.value};
    if (order >= Order::gradient)
      out.stationarity = quartic_ * m.array().cube().matrix() + a_ * m - load;
    if (order >= Order::hessian) {
      MatrixXd h = a_;
      h.diagonal() += 3.0 * quartic_ * m.cwiseAbs2();
      out.hessian_mm = lower_triangle(h);
    }
    if (order >= Order::design) {
      out.hessian_ms = -(b_ + c_ * s.asDiagonal());
      out.partial_s = out.hessian_ms.transpose() * m + stiffness_ * s - d_;
      out.hessian_ss =
          VectorXd(stiffness_ * VectorXd::Ones(s.size()) - c_.transpose() * m).asDiagonal();
    }
    if (calls == poisoned_call) out.value = std::numeric_limits<double>::quiet_NaN();
  }
  const VectorXd& motion_units() const override { return units_; }
  std::vector<std::string_view> term_names() const override { return {"all"}; }

  int calls = 0;
  int poisoned_call = -1;  // this call returns NaN

 private:
  double quartic_ = 0.3, stiffness_ = 6.0;
  MatrixXd a_, b_, c_;
  VectorXd d_, units_;
};

}  // namespace legwright::toy
