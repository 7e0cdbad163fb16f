// SPDX-License-Identifier: Apache-2.0
// A dog to be printed, and how far its servos and parts are from each other: MuJoCo's own
// distances, of the robot as it is written for a design.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/assembly/boxy_dog.hpp"

namespace legwright::test {

/// Of short shanks, so that half of a proposed range is too near.
inline Assembly short_dog() {
  Assembly out = hulled_dog();
  out.limbs[0].foot_offset = {0.0, 0.0, -0.055};
  return out;
}

inline Assembly printed_dog(const Eigen::Vector2d& bed = PrintLimits{}.bed, double margin = 0.0) {
  Assembly out = short_dog();
  out.print = PrintLimits{bed, 0.0, margin};
  out.link_radius = 0.006;
  out.link_wall = 0.003;
  return out;
}

inline const DesignParameter& parameter(const BuiltRobot& built, const std::string& name) {
  const int k = built.found.model.space.find(name);
  if (k < 0) throw std::out_of_range(name);
  return built.found.model.space.parameters[static_cast<std::size_t>(k)];
}

/// The robot with one parameter at a value.
inline ModelPointer model_at(const BuiltRobot& built, const std::string& name, double value) {
  Eigen::VectorXd s = built.found.model.space.initial();
  s[built.found.model.space.find(name)] = value;
  return compile_mjcf(rewrite_robot(built.found.model, s), "dog.xml", MeshDetail::triangles);
}

/// The geoms of a body's shapes, or of one; none where there is no such thing.
inline std::vector<int> geoms_of(const mjModel& model, const char* name) {
  const int body = mj_name2id(&model, mjOBJ_BODY, name),
            geom = mj_name2id(&model, mjOBJ_GEOM, name);
  std::vector<int> out;
  if (geom >= 0) out.push_back(geom);
  for (int k = 0; body >= 0 && k < model.body_geomnum[body]; ++k)
    out.push_back(model.body_geomadr[body] + k);
  return out;
}

using Names = std::vector<const char*>;

/// Distances of what a joint moves, over its range, from what carries it [m].
inline std::vector<double> distances(const mjModel& model, const char* hinge, const Names& moved,
                                     const Names& still) {
  const int joint = mj_name2id(&model, mjOBJ_JOINT, hinge);
  const double* range = model.jnt_range + std::ptrdiff_t{2} * joint;
  std::vector<double> qpos(model.qpos0, model.qpos0 + model.nq), out;
  for (int k = 0; k <= 60; ++k) {
    qpos[static_cast<std::size_t>(model.jnt_qposadr[joint])] =
        range[0] + (range[1] - range[0]) * k / 60.0;
    const DataPointer data = kinematics_at(model, qpos.data(), "dog.xml");
    for (const char* far : moved)
      for (const char* near : still)
        for (const int a : geoms_of(model, far))
          for (const int b : geoms_of(model, near))
            out.push_back(mj_geomDistance(&model, data.get(), a, b, 1.0, nullptr));
  }
  return out;
}

inline Eigen::Isometry3d pose_at(const mjtNum* positions, const mjtNum* turns, int k) {
  const mjtNum *p = positions + std::ptrdiff_t{3} * k, *q = turns + std::ptrdiff_t{4} * k;
  return Eigen::Translation3d(p[0], p[1], p[2]) * Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
}

/// Those of the shank from the knee and what carries it, and of that from hip and trunk.
inline std::vector<double> distances(const mjModel& model, bool with_hip) {
  const Names hip_link{"FL_knee_servo", "FL_hip_link_arm", "FL_hip_link_boss"};
  std::vector<double> out =
      distances(model, "FL_knee", {"FL", "FL_knee_link_arm", "FL_knee_link_boss"}, hip_link);
  if (!with_hip) return out;
  const std::vector<double> more = distances(model, "FL_hip", hip_link, {"FL_hip_servo", "trunk"});
  out.insert(out.end(), more.begin(), more.end());
  return out;
}

/// The least of those that are 1 mm as drawn [m].
inline double least_distance(const mjModel& drawn, const mjModel& model, bool with_hip = false) {
  const std::vector<double> before = distances(drawn, with_hip), now = distances(model, with_hip);
  EXPECT_EQ(before.size(), now.size());
  EXPECT_GT(now.size(), 61U * 3U);
  double least = 1.0;
  for (std::size_t k = 0; k < now.size(); ++k)
    if (before[k] >= 1e-3) least = std::min(least, now[k]);
  return least;
}

/// Of legs as they are used: not folded up to the trunk.
inline Assembly ranged_dog() {
  Assembly out = printed_dog();
  out.limbs[0].joints[0].range = {-0.8, 1.6};
  out.limbs[0].joints[1].range = {-2.2, 0.4};
  out.print->turn = 1.0;
  return out;
}

}  // namespace legwright::test
