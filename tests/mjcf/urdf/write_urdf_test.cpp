// SPDX-License-Identifier: Apache-2.0
// What MuJoCo makes of the URDF of a robot is the robot: same masses, inertias, axes, ranges, and
// feet where the plan has them, in random poses.
#include "mjcf/urdf/write_urdf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "mjcf/propose/standing_pose.hpp"
#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "optimizer/design/kinematics.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/support/source_tree.hpp"
#include "tests/tools/files/temporary_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A robot, its model without what URDF cannot say, and the model that MuJoCo makes of its URDF.
struct Twins {
  RobotModel robot;
  UrdfRobot urdf;
  ModelPointer mjcf, read_back;
  DataPointer ours, theirs;
};

ModelPointer read_back(const UrdfRobot& urdf, const std::string& trunk) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.path() / "meshes");
  for (const UrdfMesh& mesh : urdf.meshes)
    std::ofstream(folder.path() / "meshes" / mesh.file) << mesh.obj;
  const fs::path file = folder.path() / "robot.urdf";
  std::ofstream(file) << urdf.text;
  char error[500] = "";
  const SpecPointer spec(mj_parseXML(file.c_str(), nullptr, error, sizeof error));
  EXPECT_TRUE(spec) << error;
  if (!spec) return {};
  mjs_addFreeJoint(mjs_findBody(spec.get(), trunk.c_str()));
  ModelPointer model(mj_compile(spec.get(), nullptr));
  EXPECT_TRUE(model) << mjs_getError(spec.get());
  return model;
}

Twins twins(RobotModel robot) {
  Twins out{std::move(robot), {}, {}, {}, {}, {}};
  out.mjcf = compile_mjcf(out.robot.xml, out.robot.file);
  out.urdf = urdf_of(out.robot, *out.mjcf, "meshes/");
  out.read_back = read_back(out.urdf, out.robot.root_body);
  if (!out.read_back) return out;
  std::fill_n(out.mjcf->dof_armature, out.mjcf->nv, 0.0);
  out.ours.reset(mj_makeData(out.mjcf.get()));
  out.theirs.reset(mj_makeData(out.read_back.get()));
  return out;
}

/// Id of a joint in the other model; unnamed ones are called by their number.
int joint_in(const mjModel& model, const mjModel& from, int joint) {
  std::string name = name_of(from, mjOBJ_JOINT, joint);
  if (name.empty()) name = "joint_" + std::to_string(joint);
  return mj_name2id(&model, mjOBJ_JOINT, name.c_str());
}

/// A pose of the robot, the same in both models, and as the plan has it.
VectorXd pose_both(Twins& pair, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  VectorXd pose(pair.robot.morphology.pose_size());
  pose.tail(pair.robot.morphology.joint_count()) = pair.robot.morphology.nominal_joints();
  for (int k = 0; k < 6; ++k) pose[k] = uniform(random);
  const Eigen::Vector3d turn = pose.segment<3>(3);
  const Eigen::Quaterniond q(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
  const Eigen::Matrix<double, 7, 1> root{pose[0], pose[1], pose[2], q.w(), q.x(), q.y(), q.z()};
  int free_joint = 0;
  while (pair.mjcf->jnt_type[free_joint] != mjJNT_FREE) ++free_joint;
  int other_free = 0;
  while (pair.read_back->jnt_type[other_free] != mjJNT_FREE) ++other_free;
  for (int k = 0; k < 7; ++k) {
    pair.ours->qpos[pair.mjcf->jnt_qposadr[free_joint] + k] = root[k];
    pair.theirs->qpos[pair.read_back->jnt_qposadr[other_free] + k] = root[k];
  }
  for (int joint = 0; joint < pair.mjcf->njnt; ++joint) {
    if (joint == free_joint) continue;
    const int other = joint_in(*pair.read_back, *pair.mjcf, joint);
    const double at = uniform(random);
    pair.ours->qpos[pair.mjcf->jnt_qposadr[joint]] = at;
    pair.theirs->qpos[pair.read_back->jnt_qposadr[other]] = at;
    const std::string name = name_of(*pair.mjcf, mjOBJ_JOINT, joint);
    for (std::size_t i = 1; i < pair.robot.morphology.links.size(); ++i)
      if (pair.robot.morphology.links[i].joint.name == name)
        pose[6 + static_cast<Eigen::Index>(i) - 1] = at;
  }
  for (auto [model, data] : {std::pair(pair.mjcf.get(), pair.ours.get()),
                             std::pair(pair.read_back.get(), pair.theirs.get())}) {
    mj_kinematics(model, data);
    mj_comPos(model, data);
  }
  return pose;
}

MatrixXd world_inertia(const mjModel& model, const mjData& data, int body) {
  const Eigen::Matrix3d axes = matrix_at(data.ximat, body);
  return axes * vector_at(model.body_inertia, body).asDiagonal() * axes.transpose();
}

void expect_same_joints(const Twins& pair) {
  const mjModel &a = *pair.mjcf, &b = *pair.read_back;
  ASSERT_EQ(a.njnt, b.njnt);
  for (int joint = 0; joint < a.njnt; ++joint) {
    if (a.jnt_type[joint] == mjJNT_FREE) continue;
    const std::string name = name_of(a, mjOBJ_JOINT, joint);
    const int other = joint_in(b, a, joint);
    ASSERT_GE(other, 0) << name;
    EXPECT_EQ(a.jnt_type[joint], b.jnt_type[other]) << name;
    EXPECT_EQ(a.jnt_limited[joint] != 0, b.jnt_limited[other] != 0) << name;
    for (int k = 0; k < 2 && a.jnt_limited[joint] != 0; ++k)
      EXPECT_DOUBLE_EQ(a.jnt_range[2 * joint + k], b.jnt_range[2 * other + k]) << name;
    EXPECT_DOUBLE_EQ(a.dof_damping[a.jnt_dofadr[joint]], b.dof_damping[b.jnt_dofadr[other]]);
    EXPECT_DOUBLE_EQ(a.dof_frictionloss[a.jnt_dofadr[joint]],
                     b.dof_frictionloss[b.jnt_dofadr[other]]);
  }
  for (const Link& link : pair.robot.morphology.links) {
    const int joint = mj_name2id(&b, mjOBJ_JOINT, link.joint.name.c_str());
    if (&link == &pair.robot.morphology.links[0] || !std::isfinite(link.joint.torque_limit))
      continue;
    EXPECT_DOUBLE_EQ(b.jnt_actfrcrange[2 * joint + 1], link.joint.torque_limit);
  }
}

void expect_same_place(const Twins& pair, const VectorXd& pose, double length) {
  const mjModel &a = *pair.mjcf, &b = *pair.read_back;
  for (int body = 1; body < a.nbody; ++body) {
    const std::string name = name_of(a, mjOBJ_BODY, body);
    const int other = mj_name2id(&b, mjOBJ_BODY, name.c_str());
    if (name.empty()) continue;
    ASSERT_GE(other, 0) << name;
    EXPECT_NEAR(a.body_mass[body], b.body_mass[other], 1e-9 * a.body_mass[body]) << name;
    const MatrixXd ours = world_inertia(a, *pair.ours, body);
    EXPECT_LE((ours - world_inertia(b, *pair.theirs, other)).norm(), 1e-9 * ours.norm()) << name;
    const double apart =
        (vector_at(pair.ours->xipos, body) - vector_at(pair.theirs->xipos, other)).norm();
    EXPECT_LE(a.body_mass[body] > 0.0 ? apart : 0.0, 1e-9 * length) << name;
    EXPECT_LE((matrix_at(pair.ours->xmat, body) - matrix_at(pair.theirs->xmat, other)).norm(), 1e-9)
        << name;
  }
  for (int joint = 0; joint < a.njnt; ++joint) {
    if (a.jnt_type[joint] == mjJNT_FREE) continue;
    const int other = joint_in(b, a, joint);
    EXPECT_LE((vector_at(pair.ours->xaxis, joint) - vector_at(pair.theirs->xaxis, other)).norm(),
              1e-9);
    if (a.jnt_type[joint] == mjJNT_SLIDE) continue;  // has no anchor
    EXPECT_LE(
        (vector_at(pair.ours->xanchor, joint) - vector_at(pair.theirs->xanchor, other)).norm(),
        1e-9 * length);
  }
  const Morphology& robot = pair.robot.morphology;
  const GeometryAtDesign geometry(robot, pair.robot.space.initial());
  PoseKinematics planned;
  planned.compute(robot, geometry, pose, PoseDetail::place);
  for (int j = 0; j < robot.foot_count(); ++j) {
    const std::string name = robot.feet[static_cast<std::size_t>(j)].name + "_foot_centre";
    const int foot = mj_name2id(&b, mjOBJ_BODY, name.c_str());
    ASSERT_GE(foot, 0) << name;
    EXPECT_LE((vector_at(pair.theirs->xpos, foot) - foot_place(robot, geometry, planned, j)).norm(),
              1e-9 * length)
        << name;
  }
}

void expect_same_robot(Twins pair) {
  ASSERT_TRUE(pair.read_back);
  const double length = pair.robot.morphology.leg_length;
  expect_same_joints(pair);
  std::mt19937 random(7);
  for (int trial = 0; trial < 5; ++trial) expect_same_place(pair, pose_both(pair, random), length);
}

class UrdfOf : public testing::TestWithParam<fs::path> {};

/// A robot without a pose to stand in has first the one that `init` finds.
TEST_P(UrdfOf, IsTheSameRobotInMujoco) {
  const std::string xml = test::read_file(GetParam());
  if (const auto pose = find_standing_pose(xml, GetParam()))
    expect_same_robot(twins(parse_robot(with_keyframe(xml, GetParam(), *pose), GetParam())));
  else
    expect_same_robot(twins(read_robot(GetParam())));
}

/// The puppy with something on its trunk, and without its keyframe, which would be too short.
RobotModel puppy_with(const std::string& riding) {
  const std::string eyes = "<body name=\"eyes\"";
  std::string xml = test::with(test::read_file(test::puppy_file()), eyes, riding + eyes);
  const std::size_t from = xml.find("<keyframe>"), to = xml.find("</keyframe>");
  xml.erase(from, to + std::string("</keyframe>").size() - from);
  return parse_robot(xml, test::puppy_file());
}

TEST(Urdf, HasBodiesOfSeveralHingesAwayFromTheirOrigin) {
  for (const char* name : {"crooked", "crooked_piston", "crooked_printed"}) {
    Twins pair = twins(parse_robot(test::named_robot(name), "crooked.xml"));
    EXPECT_GT(pair.read_back->nbody, pair.mjcf->nbody + pair.robot.morphology.foot_count());
    const auto& lost = pair.urdf.lost;
    EXPECT_TRUE(std::any_of(lost.begin(), lost.end(), [](const std::string& sentence) {
      return sentence.find("1e-12 kg between the joints of one body") != std::string::npos;
    })) << name;
    expect_same_robot(std::move(pair));
  }
}

TEST(Urdf, KeepsAnglesWhereRefShiftsThem) {
  expect_same_robot(twins(puppy_with(
      "<body name=\"neck\" pos=\"0.1 0 0.05\" euler=\"0.2 1.5707963267948966 0.3\">"
      "<joint name=\"nod\" axis=\"0.6 0.8 0\" pos=\"0.01 0 0.02\" ref=\"0.4\" range=\"-1 1\"/>"
      "<joint type=\"slide\" axis=\"0 0.6 0.8\" ref=\"0.01\" range=\"-0.1 0.1\"/>"
      "<geom type=\"ellipsoid\" size=\"0.01 0.02 0.03\" mass=\"0.1\"/></body>")));
}

TEST(Urdf, MeshesAndEllipsoidsHaveTheirShape) {
  const std::string cube =
      "<asset><mesh name=\"a b\" vertex=\"0 0 0 .1 0 0 0 .1 0 0 0 .1 .1 .1 .1\"/></asset>";
  const fs::path file = test::puppy_file();
  const std::string eyes = "<body name=\"eyes\"";
  const std::string xml =
      test::with(test::with(test::read_file(file), "<worldbody>", cube + "<worldbody>"), eyes,
                 "<geom type=\"mesh\" mesh=\"a b\" pos=\"0.1 0.2 0.3\" euler=\"0.1 0.2 0.3\"/>"
                 "<geom type=\"ellipsoid\" size=\"0.1 0.2 0.3\"/>" +
                     eyes);
  Twins pair = twins(parse_robot(xml, file));
  ASSERT_TRUE(pair.read_back);
  ASSERT_EQ(pair.urdf.meshes.size(), 2u);
  EXPECT_EQ(pair.urdf.meshes[0].file, "a_b.obj");
  std::mt19937 random(3);
  (void)pose_both(pair, random);
  // Corners of the mesh in the world, as both have them.
  const auto corners = [](const mjModel& model, const mjData& data) {
    std::vector<Eigen::Vector3d> out;
    for (int geom = 0; geom < model.ngeom; ++geom) {
      if (model.geom_type[geom] != mjGEOM_MESH) continue;
      const int mesh = model.geom_dataid[geom];
      if (model.mesh_vertnum[mesh] != 5) continue;
      for (int k = 0; k < 5; ++k) {
        const float* const v = model.mesh_vert + 3 * (model.mesh_vertadr[mesh] + k);
        out.push_back(vector_at(data.geom_xpos, geom) +
                      matrix_at(data.geom_xmat, geom) * Eigen::Vector3f::Map(v).cast<double>());
      }
    }
    return out;
  };
  const auto ours = corners(*pair.mjcf, *pair.ours);
  const auto theirs = corners(*pair.read_back, *pair.theirs);
  ASSERT_EQ(ours.size(), 5u);
  ASSERT_GE(theirs.size(), 5u);
  for (const Eigen::Vector3d& corner : ours)
    EXPECT_TRUE(std::any_of(theirs.begin(), theirs.end(), [&](const Eigen::Vector3d& other) {
      return (corner - other).norm() < 1e-7;  // vertices are floats
    })) << corner.transpose();
}

TEST(Urdf, RefusesABall) {
  const RobotModel robot = puppy_with(
      "<body name=\"head\" pos=\"0 0 0.1\"><joint name=\"neck\" type=\"ball\" range=\"0 1\"/>"
      "<geom size=\"0.01\" mass=\"0.1\"/></body>");
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  try {
    (void)urdf_of(robot, *model, "");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    for (const char* part : {"robot.xml", "joint 'neck'", "no ball joint", "give the body hinges"})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

std::vector<fs::path> robots() {
  std::vector<fs::path> found = test::taken_robots();
  for (const auto& entry : fs::directory_iterator(test::kExamples))
    if (fs::exists(entry.path() / "robot.xml")) found.push_back(entry.path() / "robot.xml");
  std::sort(found.begin(), found.end());
  return found;
}

INSTANTIATE_TEST_SUITE_P(Robots, UrdfOf, testing::ValuesIn(robots()), [](const auto& instance) {
  return instance.param.parent_path().filename().string();
});

}  // namespace
}  // namespace legwright
