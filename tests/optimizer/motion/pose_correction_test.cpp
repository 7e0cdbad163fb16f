// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/pose_correction.hpp"

#include <gtest/gtest.h>

#include "optimizer/objective/objective.hpp"
#include "tests/support/puppy.hpp"
#include "tests/support/standing.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

/// A standing puppy and a step of everything, the body too: feet, COM and joints each go their way.
class PoseCorrected : public testing::Test {
 protected:
  PoseCorrected()
      : puppy_(test::make_puppy(true)),
        objective_(puppy_.morphology, puppy_.space, test::make_sideways_task(false, 8)),
        s_(puppy_.space.initial()),
        poses_(objective_.morphology(), objective_.layout(), objective_.motion_units()) {
    s_[6] = 0.5;  // hips turned outwards: feet can go sideways
    s_[12] = 0.5;
    m_ = test::standing_motion(objective_, s_);
    const VectorXd units = objective_.motion_units(), scale = puppy_.space.scale();
    motion_step_.resize(m_.size());
    for (int k = 0; k < m_.size(); ++k) motion_step_[k] = 0.1 * units[k] * (k * 37 % 19 - 9) / 9.0;
    design_step_.resize(s_.size());
    for (int k = 0; k < s_.size(); ++k) design_step_[k] = 0.1 * scale[k] * (k * 29 % 13 - 6) / 6.0;
  }
  /// F's share of eq (12) in leg lengths: how far it misses, all knots, feet and the COM.
  VectorXd misses(const VectorXd& s, const VectorXd& m) const {
    const GeometryAtDesign geometry(objective_.morphology(), s);
    const Layout& layout = objective_.layout();
    const int n = layout.design_size(), feet = layout.foot_count();
    VectorXd out((layout.knot_count() + 1) * 3 * (1 + feet));
    PoseKinematics pose;
    for (int i = 0, at = 0; i <= layout.knot_count(); ++i) {
      pose.compute(objective_.morphology(), geometry,
                   m.segment(layout.pose(i) - n, layout.pose_size()), PoseDetail::place);
      out.segment<3>(at) =
          pose.first_moment(0) / geometry.total_mass - m.segment<3>(layout.com(i) - n);
      at += 3;
      for (int j = 0; j < feet; ++j, at += 3)
        out.segment<3>(at) = foot_place(objective_.morphology(), geometry, pose, j) -
                             m.segment<3>(layout.foot(i, j) - n);
    }
    return out / objective_.morphology().leg_length;
  }
  /// What the linear model says of the misses after t of the step, by central differences.
  VectorXd predicted(double t) const {
    const double h = 1e-5;
    const VectorXd up = misses(s_ + h * design_step_, m_ + h * motion_step_),
                   down = misses(s_ - h * design_step_, m_ - h * motion_step_);
    return misses(s_, m_) + t * (up - down) / (2.0 * h);
  }
  VectorXd corrected(double t) {
    VectorXd m = m_ + t * motion_step_;
    poses_.correct(s_ + t * design_step_, m);
    return m;
  }

  test::Puppy puppy_;
  Objective objective_;
  VectorXd s_, m_, motion_step_, design_step_;
  PoseCorrection poses_;
};

TEST_F(PoseCorrected, MissesAreThoseOfTheLinearModel) {
  poses_.set_base(s_, m_);
  const VectorXd s = s_ + design_step_;
  const double straight = (misses(s, m_ + motion_step_) - predicted(1.0)).norm();
  EXPECT_GT(straight, 0.05) << "nothing to correct";
  EXPECT_LT((misses(s, corrected(1.0)) - predicted(1.0)).norm(), 0.05 * straight);
}

TEST_F(PoseCorrected, IsOfSecondOrderAndMovesPosesOnly) {
  poses_.set_base(s_, m_);
  const auto moved = [&](double t) { return VectorXd(corrected(t) - (m_ + t * motion_step_)); };
  const VectorXd whole = moved(0.5), half = moved(0.25);
  EXPECT_NEAR(whole.norm() / half.norm(), 4.0, 0.4);
  const Layout& layout = objective_.layout();
  VectorXd rest = whole;
  for (int i = 0; i <= layout.knot_count(); ++i)
    rest.segment(layout.pose(i) - layout.design_size(), layout.pose_size()).setZero();
  EXPECT_EQ(rest.norm(), 0.0);
}

TEST_F(PoseCorrected, DoesNothingWithoutAStepAndRemembersItsBase) {
  poses_.set_base(s_, m_);
  EXPECT_EQ(corrected(0.0), m_);
  const VectorXd first = corrected(1.0);
  (void)corrected(-0.3);
  EXPECT_EQ(corrected(1.0), first) << "same input, same bytes";
}

/// Steps so long that the Jacobian of their base leads astray.
TEST_F(PoseCorrected, NeverMissesByMore) {
  poses_.set_base(s_, m_);
  for (const double t : {5.0, 10.0, 30.0}) {
    design_step_.setZero();
    const VectorXd m = corrected(t), straight = m_ + t * motion_step_;
    EXPECT_TRUE(m.allFinite());
    EXPECT_NE(m, straight) << "nothing was tried";
    const double before = (misses(s_, straight) - predicted(t)).norm();
    EXPECT_LT((misses(s_, m) - predicted(t)).norm(), before) << t;
  }
}

}  // namespace
}  // namespace legwright
