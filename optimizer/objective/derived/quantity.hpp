// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "optimizer/design/inertia.hpp"
#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/momentum.hpp"
#include "optimizer/design/motion_curvature.hpp"
#include "optimizer/motion/layout.hpp"
#include "optimizer/motion/task.hpp"
#include "optimizer/objective/derived/dependence.hpp"

namespace legwright {

/// What a derived quantity may know when it is built. It keeps none of these references.
struct DerivedSetting {
  const Morphology& morphology;
  const Layout& layout;
  const Task& task;
  const Ancestry& ancestry;
};

/// The robot at one point (s, m), from which all derived quantities are read off.
struct RobotAtPoint {
  Eigen::VectorXd s;
  GeometryAtDesign geometry;
  std::vector<PoseKinematics> poses;  // knots 0 … T, then knot T − 1 moved back by one cycle
  std::vector<PairMoments> moments;   // knot i to i + 1; at T the wrapping pair
};

/// What derived quantities ask of second derivatives in the motion, summed up by pose and by pair
/// of poses, as RobotAtPoint numbers them.
struct MotionLoads {
  std::vector<PoseLoads> poses;
  std::vector<PairLoads> pairs;
};

/// Arguments of a quantity's functions.
struct DerivedInput {
  const Morphology& morphology;
  const Ancestry& ancestry;
  const RobotAtPoint& robot;
  const Eigen::VectorXd& extended;  // [s; m; y]

  bool with_design() const { return robot.poses[0].with_design(); }
};

/// One derived quantity y of Layout at one place (a knot, a foot, a joint): a function of some
/// slots of p = [s; m] with exact derivatives. Each kind is a class in a file of this folder with a
/// row in quantities.cpp. Immutable; what a thread computes stands in a State of its own.
class DerivedQuantity {
 public:
  /// Derivatives of one quantity, kept between evaluations so that memory is reused.
  class State {
   public:
    virtual ~State() = default;
  };

  virtual ~DerivedQuantity() = default;

  /// First slot of y in the extended vector, and how many there are.
  int slot() const { return slot_; }
  int size() const { return size_; }
  /// Column → slot of p; motion columns first, both kinds rising.
  const std::vector<int>& slots() const { return slots_; }
  int motion_columns() const { return motion_columns_; }
  std::size_t pose_count() const { return pose_slots_.size(); }

  virtual std::unique_ptr<State> make_state() const = 0;
  /// Whether RobotAtPoint::moments and the pose moved back by one cycle are used.
  virtual bool needs_moments() const { return false; }
  /// Called once for each design, before value(): the place for what depends on s alone.
  virtual void prepare_design(const Morphology&, const Eigen::VectorXd& /*s*/, State&) const {}
  /// y, `size` entries.
  virtual void value(const DerivedInput& input, State& state,
                     Eigen::Ref<Eigen::VectorXd> y) const = 0;
  /// ∂y (columns × size; arrives as zeros of all columns, or of the motion's alone), at the point
  /// of value().
  virtual void jacobian(const DerivedInput& input, State& state,
                        Eigen::MatrixXd& jacobian) const = 0;
  /// Adds Σ_k multiplier_k ∂y_k/∂m to `gradient` (as [s; m; y]) without a Jacobian, to the bits of
  /// jacobian() times multiplier, and returns true; false: only jacobian() knows.
  virtual bool add_motion_gradient(const DerivedInput&, const double* /*multiplier*/,
                                   double* /*gradient*/) const {
    return false;
  }
  /// Adds Σ_k multiplier_k ∂²y_k/∂m² to `loads`, after jacobian(), which was asked for the motion's
  /// alone; false: curvature() has the rest, which may be all of it.
  virtual bool add_loads(const DerivedInput&, const State&, const double* /*multiplier*/,
                         MotionLoads& /*loads*/) const {
    return false;
  }
  /// Σ multiplier_k ∂²y_k, into the lower triangle of `hessian`, which arrives as zeros; after
  /// jacobian().
  virtual void curvature(const Ancestry& ancestry, const State& state, const double* multiplier,
                         Eigen::MatrixXd& hessian) const = 0;

 protected:
  /// @param knots of the poses it depends on: none, one, two or three
  /// @param forces first slot of each force that it depends on
  DerivedQuantity(const DerivedSetting& setting, int slot, int size, const std::vector<int>& knots,
                  const Dependence& on, const std::vector<int>& forces = {});
  /// Column of each coordinate of [q; s] of its k-th pose.
  const Columns& columns(std::size_t k) const { return columns_[k]; }
  /// First slot of its k-th pose.
  int pose_slot(std::size_t k) const { return pose_slots_[k]; }
  int column_of(int slot) const;

 private:
  int slot_, size_;
  std::vector<int> slots_;
  int motion_columns_ = 0;
  std::vector<Columns> columns_;  // by pose
  std::vector<int> pose_slots_;   // by pose
};

using DerivedBlocks = std::vector<std::unique_ptr<const DerivedQuantity>>;

/// The quantities of a robot and task that something needs; filled by the
/// functions of quantities.cpp.
class DerivedList {
 public:
  /// @param wanted by slot of the extended vector: only quantities that hold a wanted slot are
  /// added
  DerivedList(const DerivedSetting& setting, const std::vector<char>& wanted)
      : setting_(setting), wanted_(wanted) {}

  const DerivedSetting& setting() const { return setting_; }
  /// Adds Quantity(setting, slot, arguments …) where one of `size` slots from `slot` on is wanted.
  template <class Quantity, class... Arguments>
  void add(int slot, int size, Arguments&&... arguments) {
    for (int at = slot; at < slot + size; ++at) {
      if (wanted_[static_cast<std::size_t>(at)] == 0) continue;
      list_.push_back(
          std::make_unique<Quantity>(setting_, slot, std::forward<Arguments>(arguments)...));
      return;
    }
  }
  DerivedBlocks take() { return std::move(list_); }

 private:
  const DerivedSetting& setting_;
  const std::vector<char>& wanted_;
  DerivedBlocks list_;
};

}  // namespace legwright
