// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <string_view>
#include <vector>

#include "optimizer/design/design.hpp"
#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/layout.hpp"
#include "optimizer/motion/path.hpp"
#include "optimizer/motion/task.hpp"

namespace legwright {

/// A term's share of F.
struct TermValue {
  std::string_view name;
  double value;
};

/// How much of the derivatives is wanted.
enum class Order {
  value,      // F
  gradient,   // + ∂F/∂m
  gradients,  // + ∂F/∂m and ∂F/∂s, no second derivatives: for an outer objective
  hessian,    // + ∂F/∂m and ∂G/∂m, for Newton
  design,     // everything: + ∂F/∂s, ∂G/∂s, ∂²F/∂s², for the adjoint
};

/// Each term's share of the first derivatives, weighted. Rows: terms in registry order; they sum
/// to ∂F/∂s and G. Terms of weight zero have rows of zeros.
struct TermShares {
  std::vector<std::string_view> names;
  Eigen::MatrixXd partial_s;     // terms × design_size
  Eigen::MatrixXd stationarity;  // terms × motion_size; empty unless asked for
};

/// Everything that is known about F at one point (s, m), up to the order that was asked for.
struct Evaluation {
  double value = 0.0;
  std::vector<double> term_values;         // registry order, weighted
  Eigen::VectorXd stationarity;            // G = ∂F/∂m
  Eigen::SparseMatrix<double> hessian_mm;  // ∂G/∂m, lower triangle, fixed pattern
  Eigen::VectorXd partial_s;               // ∂F/∂s at fixed m
  Eigen::MatrixXd hessian_ms;              // ∂G/∂s, motion_size × design_size
  Eigen::MatrixXd hessian_ss;              // ∂²F/∂s²
  std::shared_ptr<const void> pattern;     // whose pattern hessian_mm has
};

/// F(s, m) = Σ weight·term for one robot and one task, with exact derivatives. Immutable after
/// construction: any number of threads may evaluate it, each with its own Evaluation and Workspace.
class Objective {
 public:
  /// Scratch memory of one thread; reused between evaluations.
  class Workspace {
   public:
    Workspace();
    ~Workspace();

   private:
    friend class Objective;
    struct Parts;
    std::unique_ptr<Parts> parts_;
  };

  /// Throws std::invalid_argument where task and robot do not fit (feet, weights by unknown name).
  Objective(Morphology morphology, DesignSpace space, Task task);
  ~Objective();
  Objective(Objective&&) noexcept;

  const Morphology& morphology() const;
  const DesignSpace& space() const;
  const Task& task() const;
  const Layout& layout() const;
  const WantedPath& path() const;
  /// Physical unit of each entry of m.
  const Eigen::VectorXd& motion_units() const;
  std::vector<std::string_view> term_names() const;

  std::unique_ptr<Workspace> make_workspace() const;
  /// F and derivatives at (s, m). @param s design_size, @param m motion_size.
  void evaluate(const Eigen::VectorXd& s, const Eigen::VectorXd& m, Order order,
                Workspace& workspace, Evaluation& out) const;
  /// The same with a workspace of its own; for callers that evaluate once.
  Evaluation evaluate(const Eigen::VectorXd& s, const Eigen::VectorXd& m, Order order) const;
  std::vector<TermValue> terms(const Eigen::VectorXd& s, const Eigen::VectorXd& m) const;
  /// Each term's share of ∂F/∂s and, on request, of G: why a design changes.
  TermShares shares(const Eigen::VectorXd& s, const Eigen::VectorXd& m,
                    bool with_stationarity = false) const;

 private:
  friend class ViolationFinder;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// m₀ of a robot and its task (optimizer/motion/initial_guess.hpp).
Eigen::VectorXd initial_guess(const Objective& objective, const Eigen::VectorXd& s);

}  // namespace legwright
