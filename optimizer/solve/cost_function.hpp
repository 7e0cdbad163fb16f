// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string_view>
#include <vector>

#include "optimizer/motion/pose_correction.hpp"
#include "optimizer/objective/objective.hpp"

namespace legwright {

/// F(s, m) as the solvers see it: small, so that a test can put a function of three variables, or
/// one that turns to NaN at the k-th call, in the place of a robot.
class CostFunction {
 public:
  virtual ~CostFunction() = default;
  /// F and derivatives up to `order` into `out`; hessian_mm as lower triangle with a fixed pattern.
  virtual void evaluate(const Eigen::VectorXd& s, const Eigen::VectorXd& m, Order order,
                        Evaluation& out) = 0;
  /// Physical unit of each entry of m, all positive: Newton damps and measures in these.
  virtual const Eigen::VectorXd& motion_units() const = 0;
  /// The point that steps set out from, before correct_step().
  virtual void set_step_base(const Eigen::VectorXd& s, const Eigen::VectorXd& m);
  /// Second-order correction: bends the end m of a straight step in (s, m) so that it stays where
  /// the linear model of stiff terms has it. Of second order in the step; here none.
  virtual void correct_step(const Eigen::VectorXd& s, Eigen::VectorXd& m);
  /// Names of Evaluation::term_values; empty where F has no parts.
  virtual std::vector<std::string_view> term_names() const { return {}; }
};

/// The terms' values at a point, by name; empty where F has no parts.
std::vector<TermValue> named_terms(const CostFunction& cost, const Evaluation& at);

/// An Objective with a workspace of its own. Keeps a reference: the objective must live longer.
class ObjectiveCost final : public CostFunction {
 public:
  explicit ObjectiveCost(const Objective& objective);
  ~ObjectiveCost() override;
  void evaluate(const Eigen::VectorXd& s, const Eigen::VectorXd& m, Order order,
                Evaluation& out) override;
  const Eigen::VectorXd& motion_units() const override;
  /// Eq (12), by motion/pose_correction.
  void set_step_base(const Eigen::VectorXd& s, const Eigen::VectorXd& m) override;
  void correct_step(const Eigen::VectorXd& s, Eigen::VectorXd& m) override;
  std::vector<std::string_view> term_names() const override;

 private:
  const Objective& objective_;
  std::unique_ptr<Objective::Workspace> workspace_;
  PoseCorrection poses_;
};

}  // namespace legwright
