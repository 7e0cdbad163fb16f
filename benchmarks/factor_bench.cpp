// SPDX-License-Identifier: Apache-2.0
// Factorisations of real Hessians, ours and others', beside what it costs to form them.
// Usage: factor_bench TASK.toml ... > times.json
#include <Eigen/SparseCholesky>
#include <cstdio>
#include <exception>
#include <memory>

#include "benchmarks/timing.hpp"
#include "mjcf/read/read_robot.hpp"
#include "optimizer/factor/hessian_factor.hpp"
#include "optimizer/solve/newton.hpp"
#include "tests/optimizer/factor/random_sparse.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

using bench::Contestant;
using Eigen::MatrixXd;
using Eigen::SparseMatrix;
using Eigen::VectorXd;
using Json = nlohmann::ordered_json;

constexpr int many_columns = 20;

/// A matrix, the shift that makes it positive definite, and what else shall be timed beside it.
struct Case {
  SparseMatrix<double> hessian;
  VectorXd shift;
  std::vector<Contestant> others;
};

struct Solver {
  std::string name;
  std::unique_ptr<HessianFactor> factor;
  VectorXd x;
  MatrixXd many;
};

struct EigenSolver {
  SparseMatrix<double> shifted;
  Eigen::SimplicialLDLT<SparseMatrix<double>> factor;
  VectorXd x;
};

void require(bool success) {
  if (!success) throw std::runtime_error("a factorisation or solution failed");
}

std::vector<Solver> all_solvers() {
  std::vector<Solver> solvers;
  for (const CpuPath path : available_cpu_paths())
    solvers.push_back({std::string(to_string(path)),
                       std::make_unique<HessianFactor>(FactorMethod::supernodal, path),
                       {},
                       {}});
  solvers.push_back(
      {"cholmod_simplicial", std::make_unique<HessianFactor>(FactorMethod::simplicial), {}, {}});
  return solvers;
}

Json measure(const Case& given) {
  const VectorXd b = VectorXd::LinSpaced(given.hessian.rows(), -1.0, 1.0);
  const MatrixXd many = b.replicate(1, many_columns);
  std::vector<Solver> solvers = all_solvers();
  EigenSolver eigen;
  eigen.shifted = given.hessian;
  for (int i = 0; i < b.size(); ++i) eigen.shifted.coeffRef(i, i) += given.shift[i];
  eigen.factor.analyzePattern(eigen.shifted);

  std::vector<Contestant> contestants = given.others;
  for (Solver& solver : solvers) {
    contestants.push_back({solver.name + " factor",
                           [&] { require(solver.factor->factor(given.hessian, given.shift)); }});
    contestants.push_back(
        {solver.name + " solve", [&] { require(solver.factor->solve(b, solver.x)); }});
    contestants.push_back({solver.name + " solve " + std::to_string(many_columns),
                           [&] { require(solver.factor->solve(many, solver.many)); }});
  }
  contestants.push_back({"eigen_simplicial factor", [&] {
                           eigen.factor.factorize(eigen.shifted);
                           require(eigen.factor.info() == Eigen::Success);
                         }});
  contestants.push_back({"eigen_simplicial solve", [&] { eigen.x = eigen.factor.solve(b); }});

  Json result;
  result["unknowns"] = given.hessian.rows();
  result["entries_lower"] = given.hessian.nonZeros();
  result["times"] = to_json(bench::interleave(contestants));
  return result;
}

/// ∂G/∂m at m with the least shift of a ladder that makes it positive definite.
Json measure_at(const Objective& objective, const VectorXd& s, const VectorXd& m) {
  Case given;
  given.hessian = objective.evaluate(s, m, Order::hessian).hessian_mm;
  const VectorXd stiffness = objective.motion_units().cwiseAbs2().cwiseInverse();
  HessianFactor factor(FactorMethod::simplicial);
  double shift = 0.0;
  while (!factor.factor(given.hessian, shift * stiffness)) shift = shift > 0.0 ? 4 * shift : 1e-3;
  given.shift = shift * stiffness;

  ObjectiveCost cost(objective);
  Evaluation evaluation;
  given.others = {
      {"F + gradient", [&] { cost.evaluate(s, m, Order::gradient, evaluation); }},
      {"F + gradient + Hessian", [&] { cost.evaluate(s, m, Order::hessian, evaluation); }}};
  Json result = measure(given);
  result["shift"] = shift;
  return result;
}

Json measure_task(const std::string& path) {
  const TaskFile file = read_task_file(path);
  const RobotModel robot = read_robot(file.robot);
  const Objective objective(robot.morphology, robot.space, make_task(file, robot));
  const VectorXd s = robot.space.initial();
  VectorXd m = initial_guess(objective, s);
  Json result;
  result["start"] = measure_at(objective, s, m);
  (void)newton(objective, s, m, {.max_iterations = 8});
  result["after 8 iterations"] = measure_at(objective, s, m);
  (void)newton(objective, s, m, {.max_iterations = 400});
  result["end"] = measure_at(objective, s, m);
  return result;
}

/// A closed chain of knots as wide as a robot of six legs with three joints each, blocks full: more
/// work than such a robot would be.
Json measure_six_legs() {
  Case given;
  given.hessian = test::random_values(test::cyclic_pattern(24, 63), 1u);
  given.shift = VectorXd::Zero(given.hessian.rows());
  return measure(given);
}

int run(int count, char** arguments) {
  Json result;
  result["machine"] = bench::machine();
  result["eigen"] = std::to_string(EIGEN_WORLD_VERSION) + "." +
                    std::to_string(EIGEN_MAJOR_VERSION) + "." + std::to_string(EIGEN_MINOR_VERSION);
  for (int k = 1; k < count; ++k) result["cases"][arguments[k]] = measure_task(arguments[k]);
  result["cases"]["24 full blocks of 63"] = measure_six_legs();
  std::puts(result.dump(2).c_str());
  return 0;
}

}  // namespace
}  // namespace legwright

int main(int count, char** arguments) {
  try {
    return legwright::run(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "factor_bench: %s\n", error.what());
    return 1;
  }
}
