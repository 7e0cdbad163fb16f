// SPDX-License-Identifier: Apache-2.0
// Joint torques of the optimizer's point masses against MuJoCo's inverse dynamics of the same
// robot.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/scene/surroundings.hpp"
#include "mjcf/text/compile.hpp"
#include "optimizer/objective/derived.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kStep = 1e-3;  // [s] between knots: differences stand for derivatives
constexpr int kKnots = 8, kKnot = 4;

/// A smooth motion of all coordinates of a pose, with its first two derivatives in time.
struct Wave {
  VectorXd middle, size, phase;
  VectorXd at(double time) const {
    VectorXd q = middle;
    for (int k = 0; k < q.size(); ++k) q[k] += size[k] * std::sin(6.0 * time + phase[k]);
    return q;
  }
};

class TorqueOfRobot {
 public:
  /// @param task whose payload and slope both sides have
  /// @param planned what the plan believes of them instead
  TorqueOfRobot(const std::string& xml, const Task& task, const Task& planned)
      : robot_(parse_robot(xml, "robot.xml")),
        model_(compile_mjcf(in_surroundings(robot_, xml, task), "robot.xml")),
        task_(planned) {
    robot_.morphology = as_in_task(robot_.morphology, planned);
    model_->opt.disableflags |= mjDSBL_CONSTRAINT | mjDSBL_ACTUATION;
    data_ = DataPointer(mj_makeData(model_.get()));
    const Morphology& m = robot_.morphology;
    std::vector<int> order;
    GaitPattern pattern{"stand", {}, 1.0};
    for (int j = 0; j < m.foot_count(); ++j) {
      order.push_back(j);
      pattern.touchdown.push_back(0.0);
    }
    task_.gait = Gait(pattern, kStep * kKnots, kKnots, order);
    layout_ = Layout(m, robot_.space.size(), task_.gait, 1);
  }

  TorqueOfRobot(const std::string& xml, const Task& task) : TorqueOfRobot(xml, task, task) {}
  explicit TorqueOfRobot(const std::string& xml) : TorqueOfRobot(xml, {}) {}

  /// Largest difference of any joint's torque over the largest torque. @param force_scale of the
  /// forces that only MuJoCo's side feels: 1 is right.
  double difference(unsigned seed, double force_scale = 1.0) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const Morphology& m = robot_.morphology;
    const int n = m.pose_size();
    Wave wave{VectorXd::Zero(n), VectorXd::Zero(n), VectorXd::Zero(n)};
    for (int k = 0; k < n; ++k) {
      wave.middle[k] = 0.4 * normal(random);
      wave.size[k] = 0.1 * normal(random);
      wave.phase[k] = 3.0 * normal(random);
    }
    VectorXd extended = VectorXd::Zero(layout_.extended_size());
    extended.head(robot_.space.size()) = robot_.space.initial();
    for (int i = 0; i <= kKnots; ++i)
      extended.segment(layout_.pose(i), n) = wave.at(kStep * (i - kKnot));
    for (int j = 0; j < m.foot_count(); ++j)
      for (int k = 0; k < 3; ++k) extended[layout_.force(kKnot, j) + k] = 5.0 * normal(random);
    const DerivedQuantities derived(m, layout_, task_, WantedPath({0, 0}, 0.0, kStep * kKnots),
                                    std::vector<char>(layout_.extended_size(), 1));
    DerivedQuantities::Workspace workspace;
    derived.evaluate(m, layout_, PoseDetail::place, extended, workspace);
    const VectorXd expected = engine_torques(wave, extended, force_scale);
    double worst = 0.0;
    for (int a = 0; a < m.joint_count(); ++a)
      worst = std::max(worst, std::abs(extended[layout_.joint_torque(kKnot, a)] - expected[a]));
    return worst / expected.cwiseAbs().maxCoeff();
  }

 private:
  VectorXd to_qpos(const VectorXd& q) const {
    VectorXd qpos(model_->nq);
    const Vector3d o = q.segment<3>(3);
    const Eigen::Quaterniond turn(
        Eigen::AngleAxisd(o.norm(), o.norm() > 0 ? Vector3d(o.normalized()) : Vector3d::UnitX()));
    qpos << q.head<3>(), turn.w(), turn.x(), turn.y(), turn.z(), q.tail(q.size() - 6);
    return qpos;
  }

  VectorXd engine_torques(const Wave& wave, const VectorXd& extended, double force_scale) {
    const VectorXd before = to_qpos(wave.at(-kStep)), at = to_qpos(wave.at(0.0)),
                   after = to_qpos(wave.at(kStep));
    VectorXd come(model_->nv), go(model_->nv);
    mj_differentiatePos(model_.get(), come.data(), kStep, before.data(), at.data());
    mj_differentiatePos(model_.get(), go.data(), kStep, at.data(), after.data());
    Eigen::Map<VectorXd>(data_->qpos, model_->nq) = at;
    Eigen::Map<VectorXd>(data_->qvel, model_->nv) = 0.5 * (come + go);
    Eigen::Map<VectorXd>(data_->qacc, model_->nv) = (go - come) / kStep;
    mj_inverse(model_.get(), data_.get());
    VectorXd force = Eigen::Map<VectorXd>(data_->qfrc_inverse, model_->nv);
    const Morphology& m = robot_.morphology;
    const VectorXd q = wave.at(0.0);
    PoseKinematics pose;
    const GeometryAtDesign geometry(m, robot_.space.initial());
    pose.compute(m, geometry, q, PoseDetail::place);
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> jacobian(3, model_->nv);
    for (int j = 0; j < m.foot_count(); ++j) {
      const Foot& foot = m.feet[j];
      const Vector3d contact = foot_place(m, geometry, pose, j) - foot.radius * Vector3d::UnitZ();
      const int joint =
          mj_name2id(model_.get(), mjOBJ_JOINT, m.links[foot.link].joint.name.c_str());
      mj_jac(model_.get(), data_.get(), jacobian.data(), nullptr, contact.data(),
             model_->jnt_bodyid[joint]);
      force -= force_scale * jacobian.transpose() * extended.segment<3>(layout_.force(kKnot, j));
    }
    VectorXd torques(m.joint_count());
    for (int a = 0; a < m.joint_count(); ++a) {
      const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, m.links[a + 1].joint.name.c_str());
      torques[a] = force[model_->jnt_dofadr[joint]];
    }
    return torques;
  }

  RobotModel robot_;
  ModelPointer model_;
  DataPointer data_;
  Task task_;
  Layout layout_;
};

Task laden_on_a_slope() {
  Task task;
  task.up = up_on_slope({1.0, 0.5}, 0.3, -0.2);
  task.payload = Payload{0.7, {0.02, -0.01, 0.05}, {0.06, 0.04, 0.1}};
  return task;
}

TEST(JointTorque, OfThePuppyIsThatOfMujocosInverseDynamics) {
  TorqueOfRobot puppy(test::read_file(test::puppy_file()));
  for (unsigned seed = 1; seed <= 10; ++seed) EXPECT_LT(puppy.difference(seed), 2e-5) << seed;
}

TEST(JointTorque, OfACrookedRobotIsThatOfMujocosInverseDynamics) {
  TorqueOfRobot robot(test::crooked_robot());
  for (unsigned seed = 1; seed <= 10; ++seed) EXPECT_LT(robot.difference(seed), 2e-5) << seed;
}

/// The puppy with dampers and springs in its joints.
std::string puppy_with(const std::string& joints) {
  std::string xml = test::read_file(test::puppy_file());
  const std::string tag = "<joint ";
  const std::size_t at = xml.find(tag);
  EXPECT_NE(at, std::string::npos);
  return xml.replace(at, tag.size(), tag + joints + " ");
}

TEST(JointTorque, WorksAgainstDampersAndSpringsAsInMujoco) {
  const std::string plain = test::read_file(test::puppy_file());
  for (const char* joints :
       {"damping=\"0.3\"", "stiffness=\"2\"", "stiffness=\"2\" springref=\"0.4\"",
        "damping=\"0.1\" stiffness=\"0.5\" springref=\"-0.3\" frictionloss=\"0.1\""}) {
    TorqueOfRobot robot(puppy_with(joints));
    for (unsigned seed = 1; seed <= 5; ++seed)
      EXPECT_LT(robot.difference(seed), 2e-5) << joints << seed;
  }
}

TEST(JointTorque, OnASlopeAndWithAPayloadIsThatOfMujocosInverseDynamics) {
  for (const char* name : {"puppy", "crooked"}) {
    TorqueOfRobot robot(test::named_robot(name), laden_on_a_slope());
    for (unsigned seed = 1; seed <= 5; ++seed)
      EXPECT_LT(robot.difference(seed), 2e-5) << name << seed;
  }
}

TEST(JointTorqueControl, ASlopeThatThePlanDoesNotKnowIsNoticed) {
  Task planned = laden_on_a_slope();
  planned.up = Vector3d::UnitZ();
  EXPECT_GT(TorqueOfRobot(test::named_robot("puppy"), laden_on_a_slope(), planned).difference(1),
            1e-3);
}

TEST(JointTorqueControl, AForceThatIsOffIsNoticed) {
  TorqueOfRobot puppy(test::read_file(test::puppy_file()));
  EXPECT_GT(puppy.difference(1, 1.01), 1e-4);
}

}  // namespace
}  // namespace legwright
