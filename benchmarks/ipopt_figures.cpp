// SPDX-License-Identifier: Apache-2.0
// The same motion by IPOPT + MUMPS: same F, start, tolerance and exact callbacks.
#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "benchmarks/figures.hpp"
#include "benchmarks/timing.hpp"

namespace legwright::bench {
namespace {

using Eigen::Map;
using Eigen::VectorXd;
using Ipopt::Index;
using Ipopt::Number;

/// min F(s, ·) without constraints in the variables m/unit, so that IPOPT's tolerance means what
/// ours does: max |G·unit|. F is evaluated once per point, to the highest order asked for.
class MotionProblem final : public Ipopt::TNLP {
 public:
  MotionProblem(CostFunction& cost, const VectorXd& s, const VectorXd& start)
      : cost_(cost), s_(s), start_(start), units_(cost.motion_units()) {
    cost_.evaluate(s_, start_, Order::hessian, at_);
  }

  bool get_nlp_info(Index& n, Index& m, Index& jacobian, Index& hessian,
                    IndexStyleEnum& style) override {
    n = static_cast<Index>(start_.size());
    m = jacobian = 0;
    hessian = static_cast<Index>(at_.hessian_mm.nonZeros());
    style = C_STYLE;
    return true;
  }
  bool get_bounds_info(Index n, Number* lower, Number* upper, Index, Number*, Number*) override {
    std::fill(lower, lower + n, -1e20);
    std::fill(upper, upper + n, 1e20);
    return true;
  }
  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool,
                          Number*) override {
    Map<VectorXd>(x, n) = start_.cwiseQuotient(units_);
    return true;
  }
  bool eval_f(Index, const Number* x, bool fresh, Number& value) override {
    at(x, fresh, Order::value);
    value = at_.value;
    return std::isfinite(value);
  }
  bool eval_grad_f(Index n, const Number* x, bool fresh, Number* gradient) override {
    at(x, fresh, Order::gradient);
    Map<VectorXd>(gradient, n) = at_.stationarity.cwiseProduct(units_);
    return at_.stationarity.allFinite();
  }
  bool eval_g(Index, const Number*, bool, Index, Number*) override { return true; }
  bool eval_jac_g(Index, const Number*, bool, Index, Index, Index*, Index*, Number*) override {
    return true;
  }
  bool eval_h(Index, const Number* x, bool fresh, Number factor, Index, const Number*, bool, Index,
              Index* rows, Index* columns, Number* values) override {
    if (values) at(x, fresh, Order::hessian);
    Index k = 0;
    for (Index j = 0; j < at_.hessian_mm.outerSize(); ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator it(at_.hessian_mm, j); it; ++it, ++k) {
        if (values) {
          values[k] = factor * it.value() * units_[it.row()] * units_[j];
        } else {
          rows[k] = static_cast<Index>(it.row());
          columns[k] = j;
        }
      }
    return true;
  }
  void finalize_solution(Ipopt::SolverReturn, Index, const Number*, const Number*, const Number*,
                         Index, const Number*, const Number*, Number value, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    final_value_ = value;
  }
  double final_value() const { return final_value_; }

 private:
  void at(const Number* x, bool fresh, Order order) {
    if (!fresh && known_ && order <= order_) return;
    m_ = Map<const VectorXd>(x, start_.size()).cwiseProduct(units_);
    cost_.evaluate(s_, m_, order, at_);
    order_ = order;
    known_ = true;
  }

  CostFunction& cost_;
  const VectorXd& s_;
  const VectorXd start_;
  const VectorXd& units_;
  VectorXd m_;
  Evaluation at_;
  Order order_ = Order::value;
  bool known_ = false;
  double final_value_ = NAN;
};

struct Contest {
  SolveReport ours;
  double theirs = NAN;  // F
  int iterations = 0;
  bool solved = false;
  std::vector<Times> times;
};

Contest compete(const Objective& objective, const VectorXd& s, const VectorXd& start) {
  ObjectiveCost cost(objective);
  NewtonWorkspace workspace;
  Contest contest;
  Ipopt::SmartPtr<Ipopt::IpoptApplication> ipopt = new Ipopt::IpoptApplication(false);
  ipopt->Options()->SetStringValue("sb", "yes");
  ipopt->Options()->SetIntegerValue("print_level", 0);
  ipopt->Options()->SetStringValue("linear_solver", "mumps");
  ipopt->Options()->SetStringValue("hessian_approximation", "exact");
  ipopt->Options()->SetStringValue("nlp_scaling_method", "none");
  ipopt->Options()->SetNumericValue("tol", NewtonOptions{}.tolerance);
  ipopt->Options()->SetIntegerValue("max_iter", 1000);
  if (ipopt->Initialize() != Ipopt::Solve_Succeeded)
    throw std::runtime_error("IPOPT does not start");
  const auto theirs = [&] {
    Ipopt::SmartPtr<MotionProblem> problem = new MotionProblem(cost, s, start);
    contest.solved = ipopt->OptimizeTNLP(problem) == Ipopt::Solve_Succeeded;
    contest.theirs = problem->final_value();
    contest.iterations = ipopt->Statistics()->IterationCount();
  };
  const auto ours = [&] {
    VectorXd m = start;
    contest.ours = newton(cost, s, m, {}, workspace);
  };
  contest.times = interleave({{"IPOPT + MUMPS", theirs}, {"newton", ours}}, 5, 0.5);
  return contest;
}

}  // namespace

Group ipopt_figures(const SolvedCase& solved) {
  Group group;
  for (int k = 0; k < solved.problem.task_count(); ++k) {
    const Objective& objective = *solved.problem.objectives[k];
    const Contest contest = compete(objective, solved.s, initial_guess(objective, solved.s));
    const std::string& name = solved.problem.task(k).name;
    const double ratio = contest.times[0].median() / contest.times[1].median();
    const double apart =
        std::abs(contest.theirs - contest.ours.value) / std::abs(contest.ours.value);
    group.details[name] = {{"times", to_json(contest.times)},
                           {"ratio", ratio},
                           {"ipopt_version", IPOPT_VERSION},
                           {"ipopt_iterations", contest.iterations},
                           {"ipopt_solved", contest.solved},
                           {"ipopt_F", contest.theirs},
                           {"newton_iterations", contest.ours.iterations},
                           {"newton_status", std::string(to_string(contest.ours.status))},
                           {"newton_F", contest.ours.value},
                           {"F_apart", apart}};
    const std::string where = solved.of.label + ": " + name;
    if (contest.solved && apart <= 1e-6)
      group.figures.push_back({"IPOPT + MUMPS over our inner solve, same F, start, tolerance", 10,
                               ratio, true, "×", where});
    else
      group.notes.push_back(where + ": IPOPT and we ended at different F (" +
                            std::to_string(contest.theirs) + ", " +
                            std::to_string(contest.ours.value) + "): no comparison");
  }
  return group;
}

}  // namespace legwright::bench
