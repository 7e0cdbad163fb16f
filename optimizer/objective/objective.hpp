// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string_view>
#include <vector>

#include "optimizer/design/design.hpp"
#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/layout.hpp"
#include "optimizer/motion/path.hpp"
#include "optimizer/motion/task.hpp"
#include "optimizer/objective/evaluation.hpp"
#include "optimizer/terms/term.hpp"

namespace legwright {

struct EvaluationScratch;
struct ObjectiveParts;

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
    std::unique_ptr<EvaluationScratch> parts_;
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
  /// What a residual of one of a term stands for, that of its first element.
  ResidualUnit unit_of(std::string_view term) const;

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
  std::unique_ptr<ObjectiveParts> impl_;
};

/// m₀ of a robot and its task (optimizer/motion/initial_guess.hpp).
Eigen::VectorXd initial_guess(const Objective& objective, const Eigen::VectorXd& s);

}  // namespace legwright
