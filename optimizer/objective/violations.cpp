// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/violations.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "optimizer/objective/parts.hpp"

namespace legwright {

/// Walks over the elements of an objective's constraints; a friend of it.
class ViolationFinder {
 public:
  ViolationFinder(const Objective& objective, const Eigen::VectorXd& s, const Eigen::VectorXd& m)
      : impl_(*objective.impl_) {
    impl_.prepare(s, m, Order::value, workspace_);
  }

  std::vector<Violation> find() {
    std::vector<Violation> found;
    for (const WeightedTerm& entry : impl_.terms)
      if (entry.entry->role == TermRole::constraint && !entry.plans.empty())
        found.push_back(worst_of(entry));
    std::stable_sort(found.begin(), found.end(), [](const Violation& a, const Violation& b) {
      const auto size = [](const Violation& v) {  // what is not a number is the worst there is
        return std::isnan(v.relative) ? std::numeric_limits<double>::infinity() : v.relative;
      };
      return size(a) > size(b);
    });
    return found;
  }

  std::vector<Violation> broken(double least) {
    std::vector<Violation> found;
    for (const WeightedTerm& entry : impl_.terms) {
      if (entry.entry->role != TermRole::constraint) continue;
      const auto first = found.size();
      for (int e = 0; e < static_cast<int>(entry.plans.size()); ++e) {
        Violation worst;
        worst.relative = -std::numeric_limits<double>::infinity();
        look_at(entry, e, worst);
        if (!(worst.relative <= least)) found.push_back(std::move(worst));
      }
      std::stable_sort(found.begin() + static_cast<std::ptrdiff_t>(first), found.end(),
                       [](const Violation& a, const Violation& b) { return a.knot < b.knot; });
    }
    return found;
  }

 private:
  Violation worst_of(const WeightedTerm& entry) {
    Violation worst;
    worst.relative = -std::numeric_limits<double>::infinity();
    for (int e = 0; e < static_cast<int>(entry.plans.size()); ++e)
      if (!look_at(entry, e, worst)) return worst;
    return worst;
  }

  /// Takes what is worse. @return false once something is not a number, which is the worst there is
  bool look_at(const WeightedTerm& entry, int e, Violation& worst) {
    const bool inequality = is_inequality(entry.term->penalty());
    impl_.residual(entry, e, workspace_);
    const Eigen::VectorXd& r = workspace_.element.residual;
    for (int row = 0; row < r.size(); ++row) {
      const double relative = inequality ? -r[row] : norm_of_unit(*entry.term, e, row, r);
      if (!(relative <= worst.relative)) take(entry, e, row, relative, worst);
      if (std::isnan(relative)) return false;
    }
    return true;
  }

  /// Over the rows that share the unit of `row`.
  static double norm_of_unit(const Term& term, int element, int row, const Eigen::VectorXd& r) {
    const ResidualUnit own = term.unit(element, row);
    double sum = 0.0;
    for (int k = 0; k < r.size(); ++k) {
      const ResidualUnit other = term.unit(element, k);
      if (other.symbol == own.symbol && other.size == own.size) sum += r[k] * r[k];
    }
    return std::sqrt(sum);
  }

  void take(const WeightedTerm& entry, int e, int row, double relative, Violation& worst) const {
    const Element& element = entry.term->elements()[e];
    const ResidualUnit unit = entry.term->unit(e, row);
    worst.term = entry.entry->name;
    worst.equation = entry.entry->equation;
    worst.knot = element.knot;
    worst.where =
        element.foot >= 0 ? impl_.morphology.feet[element.foot].name : entry.term->subject(e, row);
    worst.amount = relative * unit.size;
    worst.unit = unit.symbol;
    worst.relative = relative;
  }

  const ObjectiveParts& impl_;
  EvaluationScratch workspace_;
};

std::vector<Violation> worst_violations(const Objective& objective, const Eigen::VectorXd& s,
                                        const Eigen::VectorXd& m) {
  return ViolationFinder(objective, s, m).find();
}

std::vector<Violation> broken_elements(const Objective& objective, const Eigen::VectorXd& s,
                                       const Eigen::VectorXd& m, double least) {
  return ViolationFinder(objective, s, m).broken(least);
}

}  // namespace legwright
