// SPDX-License-Identifier: Apache-2.0
// The home pose against a chain of transforms that is multiplied out here.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "optimizer/design/kinematics.hpp"
#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::Isometry3d;
using Eigen::VectorXd;

/// Frames of the links at their nominal angles, trunk ← link.
std::vector<Isometry3d> multiplied_out(const Morphology& morphology, const VectorXd& s) {
  std::vector<Isometry3d> frames(morphology.links.size(), Isometry3d::Identity());
  for (std::size_t i = 1; i < morphology.links.size(); ++i) {
    const Link& link = morphology.links[i];
    frames[i] = frames[static_cast<std::size_t>(link.parent)];
    frames[i].translate(link.origin.at(s));
    frames[i].rotate(link.orientation);
    frames[i].rotate(Eigen::AngleAxisd(link.joint.nominal, link.joint.axis.at(s)));
  }
  return frames;
}

/// The largest distance of a foot, and of an entry of a link's rotation, from what is multiplied
/// out.
double error(const Morphology& morphology, const PoseKinematics& home, const VectorXd& s) {
  const GeometryAtDesign geometry(morphology, s);
  const std::vector<Isometry3d> frames = multiplied_out(morphology, s);
  double worst = 0.0;
  for (std::size_t l = 0; l < frames.size(); ++l)
    worst = std::max(
        worst, (home.rotation(static_cast<int>(l)) - frames[l].linear()).lpNorm<Eigen::Infinity>());
  for (int j = 0; j < morphology.foot_count(); ++j) {
    const Foot& foot = morphology.feet[static_cast<std::size_t>(j)];
    worst = std::max(worst, (foot_place(morphology, geometry, home, j) -
                             frames[static_cast<std::size_t>(foot.link)] * foot.position.at(s))
                                .norm());
  }
  return worst;
}

TEST(HomePose, HasTheNominalAnglesUnderTheTrunksOwnFrame) {
  test::Puppy puppy = test::make_puppy(true);
  const VectorXd s = 0.5 * (puppy.space.initial() + puppy.space.upper());
  const PoseKinematics home = home_pose(puppy.morphology, GeometryAtDesign(puppy.morphology, s));
  EXPECT_EQ(home.origin(0).norm(), 0.0);
  EXPECT_LT(error(puppy.morphology, home, s), 1e-14);
  EXPECT_GT(error(puppy.morphology, home, puppy.space.initial()), 1e-3) << "another design";
  puppy.morphology.links[2].joint.nominal += 0.01;
  EXPECT_GT(error(puppy.morphology, home, s), 1e-3) << "another pose";
}

}  // namespace
}  // namespace legwright
