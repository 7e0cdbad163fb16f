// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/outer_function.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace legwright {
namespace {

using Eigen::VectorXd;

/// J of a function of the arrays, on one thread. Keeps references.
class FunctionCost final : public CostFunction {
 public:
  FunctionCost(const OuterObjective& outer, const Objective& objective,
               const MotionQuantity& function)
      : outer_(outer), objective_(objective), function_(function), entries_(objective) {}

  /// @param order up to Order::gradients
  void evaluate(const VectorXd& s, const VectorXd& m, Order order, Evaluation& out) override {
    if (!s.allFinite() || !m.allFinite()) {  // a search that has come to nothing
      out.value = std::numeric_limits<double>::quiet_NaN();
      out.stationarity.setConstant(m.size(), out.value);
      out.partial_s.setConstant(s.size(), out.value);
      return;
    }
    const bool with_gradient = order != Order::value;
    const MotionArrays at = entries_.arrays(s, m, with_gradient, workspace_);
    MotionArrays by_entry(objective_.layout());
    out.value = outer_.cost(function_(at, with_gradient ? &by_entry : nullptr));
    if (!with_gradient) return;
    entries_.pull_back(by_entry, workspace_, out);
    out.stationarity *= outer_.cost(1.0);
    out.partial_s *= outer_.cost(1.0);
  }
  const VectorXd& motion_units() const override { return objective_.motion_units(); }

 private:
  const OuterObjective& outer_;
  const Objective& objective_;
  const MotionQuantity& function_;
  MotionEntries entries_;
  MotionEntries::Workspace workspace_;
};

}  // namespace

OuterFunction::OuterFunction(const Objective& objective, MotionQuantity function, std::string unit,
                             double weight, std::optional<double> reference)
    : OuterObjective(std::move(unit), weight),
      objective_(objective),
      function_(std::move(function)) {
  const VectorXd s = objective_.space().initial();
  const double first = amount_at(s, initial_guess(objective_, s));  // asked for in any case
  const double found = reference.value_or(first);
  if (!(found > 0.0) || !std::isfinite(found))
    throw std::invalid_argument("its reference must be positive, is " + std::to_string(found));
  set_reference(found);
}

double OuterFunction::amount_at(const VectorXd& s, const VectorXd& m) const {
  MotionEntries::Workspace workspace;
  return function_(MotionEntries(objective_).arrays(s, m, false, workspace), nullptr);
}

std::unique_ptr<CostFunction> OuterFunction::make_cost() const {
  return std::make_unique<FunctionCost>(*this, objective_, function_);
}

}  // namespace legwright
