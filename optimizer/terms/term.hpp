// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "optimizer/design/design.hpp"
#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/layout.hpp"
#include "optimizer/motion/path.hpp"
#include "optimizer/motion/task.hpp"
#include "optimizer/terms/penalty.hpp"

namespace legwright {

/// What a term may know when it is built. Residuals are made dimensionless with these units, so
/// that one set of weights serves robots of any size: lengths by the leg, forces by the weight.
struct TermContext {
  const Layout& layout;
  const Morphology& morphology;
  const DesignSpace& space;
  const Task& task;
  WantedPath path;    // of the COM on the ground, and the shift from one cycle to the next
  double length;      // leg length [m]
  double mass;        // [kg]
  double weight;      // M g [N]
  double com_height;  // [m]
  /// foot − COM on the ground at heading zero, per foot, at the initial design [m]
  std::vector<Eigen::Vector2d> footprint;
  /// ∂footprint/∂s per foot, 2 × design size; empty where the design does not move it.
  std::vector<Eigen::Matrix2Xd> footprint_slopes = {};
};

/// One residual of a term: where and on which slots of [s; m; y] (see Layout) it depends.
struct Element {
  int knot = 0;
  int foot = -1;
  int rows = 0;            // size of the residual
  std::vector<int> slots;  // local variable → slot
};

/// What a residual of one stands for: r · size is in `symbol`.
struct ResidualUnit {
  double size = 1.0;
  std::string_view symbol;  // "m", "N", "rad", "N m", or nothing for shares
};

/// One summand of F: Σ over elements and rows of weight · penalty(r(z)). A term measures, it does
/// not weigh: the penalty belongs to penalty.hpp, the weight to the objective. It sees only its
/// local variables z, knows no global index, and its functions are const and thread-safe. Matrices
/// arrive sized and zeroed.
class Term {
 public:
  virtual ~Term() = default;
  virtual std::string_view name() const = 0;
  virtual Penalty penalty() const { return Penalty::quadratic; }
  const std::vector<Element>& elements() const { return elements_; }

  /// r(z), rows. `element` is an index into elements().
  virtual void residual(int element, const Eigen::VectorXd& z, Eigen::VectorXd& r) const = 0;
  /// ∂r/∂z, rows × local variables.
  virtual void jacobian(int element, const Eigen::VectorXd& z, Eigen::MatrixXd& jacobian) const = 0;
  /// Adds Σ_k multiplier_k ∂²r_k/∂z² (both triangles). Linear residuals have none.
  virtual void add_curvature(int, const Eigen::VectorXd&, const Eigen::VectorXd&,
                             Eigen::MatrixXd&) const {}
  /// False where add_curvature does nothing.
  virtual bool curved() const { return true; }
  /// ∂r/∂z where it is the same everywhere, or none: then F's Hessian has parts that are worked out
  /// once.
  virtual const Eigen::MatrixXd* constant_jacobian(int) const { return nullptr; }
  /// Appends the elements whose penalty may differ from zero at [s; m; y], rising, and returns
  /// true; false: all of them. A cheap bound that lets crowds of inequalities far from their walls
  /// cost nothing.
  virtual bool select_active(const Eigen::VectorXd&, std::vector<int>&) const { return false; }

  /// For people: the physical unit of a residual, and the joint or pair of limbs an element is
  /// about (feet are named by Element::foot).
  virtual ResidualUnit unit(int, int /*row*/) const { return {}; }
  virtual std::string subject(int, int /*row*/) const { return {}; }

  /// A point to check derivatives at: residuals not zero, inequalities on both sides of the
  /// barrier's edge.
  virtual Eigen::VectorXd sample(int element, std::mt19937& random) const = 0;

 protected:
  std::vector<Element> elements_;
};

}  // namespace legwright
