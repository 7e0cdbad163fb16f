// SPDX-License-Identifier: Apache-2.0
// Linear actuators: the plugin on a tendon over one hinge, against the engine's own lengths and
// servo.
#include <cmath>

#include "plugin/spline.hpp"
#include "tests/plugin/engine.hpp"

namespace legwright {
namespace {

std::string with(std::string text, const std::string& old_part, const std::string& new_part) {
  const std::size_t at = text.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  return at == std::string::npos ? text : text.replace(at, old_part.size(), new_part);
}

/// The toy chain with a piston over hinge b in place of its servo. Its upper site rides on a fixed
/// body.
std::string with_piston(std::string xml, const std::string& lower_body = "middle") {
  xml = with(xml, "<body name=\"middle\"",
             "<body pos=\"0.01 0.002 -0.01\" euler=\"0.3 0.2 -0.4\"><site name=\"top\" "
             "pos=\"0.01 0.003 0\"/></body><body name=\"middle\"");
  xml = with(xml,
             "<body name=\"" + lower_body + "\" pos=\"0 0 -0.0" +
                 (lower_body == "middle" ? "6" : "8") + "\">",
             "<body name=\"" + lower_body + "\" pos=\"0 0 -0.0" +
                 (lower_body == "middle" ? "6\" euler=\"0.1 -0.2 0.3" : "8") +
                 "\"><site name=\"end\" pos=\"0.015 -0.004 -0.03\"/>");
  xml = with(xml, "<actuator>",
             "<tendon><spatial name=\"piston\"><site site=\"end\"/><site site=\"top\"/>"
             "</spatial></tendon><actuator>");
  return with(xml, "joint=\"b\" ", "tendon=\"piston\" ");
}

ChainOptions options() {
  ChainOptions options = valid_options();
  options.kp = options.bias_kp = "3000";
  options.kd = options.bias_kd = "30";
  options.timestep = "0.0005";
  return options;
}

/// Length of the piston and its derivative by the angle of b in the plan, as MuJoCo has them.
struct Planned {
  double length, arm, rate, torque;
};

class TendonTest : public EngineTest {
 protected:
  static Planned planned(const mjModel* m, mjData* d, const Trajectory& trajectory, double time) {
    const SplinePhase phase = phase_at(trajectory, time);
    const SplinePoint target = spline_point(trajectory, phase, trajectory.target_column(1));
    d->qpos[1] = target.value;
    mj_fwdPosition(m, d);
    double arm = 0.0;
    for (int k = 0; k < m->ten_J_rownnz[0]; ++k)
      if (m->ten_J_colind[m->ten_J_rowadr[0] + k] == 1) arm = d->ten_J[m->ten_J_rowadr[0] + k];
    return {d->ten_length[0], arm, target.rate,
            linear_value(trajectory, phase, trajectory.torque_column(1))};
  }
};

/// The pose of the file need not be at angle 0: `ref` says at which angle it is.
class TendonReference : public TendonTest, public testing::WithParamInterface<const char*> {};

INSTANTIATE_TEST_SUITE_P(Of, TendonReference, testing::Values("", " ref=\"0.7\"", " ref=\"-2\""),
                         [](const auto& test) { return std::to_string(test.index); });

TEST_P(TendonReference, ForceIsTheLawAlongTheTendon) {
  const Loaded loaded = load(with(with_piston(plugin_chain(options())), "<joint name=\"b\"",
                                  std::string("<joint name=\"b\"") + GetParam()));
  ASSERT_TRUE(loaded.model) << loaded.error;
  const mjModel* m = loaded.model.get();
  const DataPointer d(mj_makeData(m)), plan(mj_makeData(m));
  const Trajectory trajectory = chain_trajectory();
  for (int i = 0; i < 30; ++i) {
    d->time = 0.031 * i;
    for (int j = 0; j < 3; ++j) {
      d->qpos[j] = 0.2 * j - 0.02 * i;
      d->qvel[j] = 0.3 - 0.05 * i * j;
    }
    d->ctrl[0] = 0.001 * i;
    mj_forward(m, d.get());
    const Planned at = planned(m, plan.get(), trajectory, d->time);
    const double expected = 3000 * (at.length + d->ctrl[0] - d->ten_length[0]) +
                            30 * (at.arm * at.rate - d->ten_velocity[0]) + at.torque / at.arm;
    EXPECT_NEAR(d->actuator_force[0], expected, 1e-8 * (1.0 + std::abs(expected)));
    EXPECT_GT(std::abs(at.torque / at.arm), 1e-6);
  }
}

/// Twin: MuJoCo's own servo on the same tendon, told the same targets.
TEST_F(TendonTest, NativeServoOnTheTendonIsEqualled) {
  const ChainOptions o = options();
  const Loaded plugin = load(with_piston(plugin_chain(o))),
               native = load(with_piston(native_chain(o)));
  ASSERT_TRUE(plugin.model) << plugin.error;
  ASSERT_TRUE(native.model) << native.error;
  const mjModel* m = native.model.get();
  const DataPointer d(mj_makeData(plugin.model.get())), twin(mj_makeData(m)), plan(mj_makeData(m));
  const Trajectory trajectory = chain_trajectory();
  double largest = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const SplinePhase phase = phase_at(trajectory, twin->time);
    const Planned at = planned(m, plan.get(), trajectory, twin->time);
    const int joint_of[] = {1, 0, 2};
    for (int a = 0; a < 3; ++a) {
      const int j = joint_of[a];
      const SplinePoint target = spline_point(trajectory, phase, trajectory.target_column(j));
      double* control = twin->ctrl + m->actuator_ctrladr[a];
      control[0] = a == 0 ? at.length : target.value;
      control[1] = a == 0 ? at.arm * at.rate : target.rate;
      control[2] = linear_value(trajectory, phase, trajectory.torque_column(j));
      if (a == 0) control[2] /= at.arm;
    }
    mj_step(m, twin.get());
    mj_step(plugin.model.get(), d.get());
    for (int q = 0; q < 3; ++q) largest = std::max(largest, std::abs(d->qpos[q] - twin->qpos[q]));
  }
  EXPECT_LT(largest, 1e-9);
  EXPECT_GT(std::abs(d->qpos[1]), 0.0);
}

TEST_F(TendonTest, TendonOverTwoHingesIsRefused) {
  const Loaded loaded = load(with_piston(plugin_chain(options()), "lower"));
  EXPECT_FALSE(loaded.model);
  EXPECT_NE(loaded.error.find("does not span exactly one hinge"), std::string::npos)
      << loaded.error;
  take_warnings();
}

}  // namespace
}  // namespace legwright
