// SPDX-License-Identifier: Apache-2.0
// Sensors of legwright.sensor: what they tell, against the plan and the engine's own numbers.
#include <algorithm>
#include <cmath>

#include "plugin/planned_motion.hpp"
#include "tests/plugin/allocation_count.hpp"
#include "tests/plugin/engine.hpp"
#include "tests/plugin/walker.hpp"

namespace legwright {
namespace {

const char* const kKinds[] = {"phase",          "planned_contact", "measured_contact",
                              "tracking_error", "base_error",      "torque_share"};

WalkerOptions with_all_sensors() {
  WalkerOptions options;
  for (const char* const kind : kKinds) options.sensors += gait_sensor(kind);
  return options;
}

class SensorsTest : public EngineTest {
 protected:
  void make(const WalkerOptions& options) {
    Loaded loaded = load(walker(options));
    ASSERT_TRUE(loaded.model) << loaded.error;
    model_ = std::move(loaded.model);
    data_.reset(mj_makeData(model_.get()));
  }
  std::vector<double> values(const char* sensor) const {
    const int id = mj_name2id(model_.get(), mjOBJ_SENSOR, sensor);
    if (id < 0) return {};
    const mjtNum* const first = data_->sensordata + model_->sensor_adr[id];
    return {first, first + model_->sensor_dim[id]};
  }
  /// What the plan says about the root at `time`, in qpos.
  void put_on_plan(const Trajectory& trajectory, double time) {
    const Pose root = PlannedMotion(trajectory).root(phase_at(trajectory, time));
    std::copy(root.position.begin(), root.position.end(), data_->qpos);
    std::copy(root.quaternion.begin(), root.quaternion.end(), data_->qpos + 3);
    data_->time = time;
  }
  ModelPointer model_;
  DataPointer data_;
};

TEST_F(SensorsTest, HaveTheSizeOfTheirKind) {
  make(with_all_sensors());
  const std::size_t sizes[] = {1, 2, 2, 2, 6, 2};
  for (std::size_t i = 0; i < std::size(kKinds); ++i)
    EXPECT_EQ(values(kKinds[i]).size(), sizes[i]) << kKinds[i];
}

TEST_F(SensorsTest, PhaseRunsFromNoughtToOneWithStartAndSpeed) {
  WalkerOptions options = with_all_sensors();
  options.config = R"(<config key="phase" value="0.25"/><config key="speed" value="0.5"/>)";
  make(options);
  for (const double time : {-7.3, -0.1, 0.0, 0.3, 1.19, 1.21, 500.0}) {
    data_->time = time;
    mj_forward(model_.get(), data_.get());
    const double cycles = 0.25 + 0.5 * time / 0.8;
    EXPECT_NEAR(values("phase")[0], cycles - std::floor(cycles), 1e-9) << time;
  }
}

TEST_F(SensorsTest, PlannedContactIsThatOfTheNearestKnot) {
  make(with_all_sensors());
  const Trajectory t = walker_trajectory();
  for (int i = 0; i < 40; ++i) {
    data_->time = 0.0437 * i;
    mj_forward(model_.get(), data_.get());
    const int knot = static_cast<int>(std::lround(data_->time / 0.1)) % 8;
    EXPECT_EQ(values("planned_contact")[0], t.at(knot, t.contact_column(0)));
    EXPECT_EQ(values("planned_contact")[1], t.at(knot, t.contact_column(1)));
  }
}

TEST_F(SensorsTest, MeasuredContactIsOfFeetAndNotOfTheRobotItself) {
  WalkerOptions options = with_all_sensors();
  options.world =
      R"(<body name="ball" pos="1 0 0.5"><freejoint/><geom size="0.05" mass="0.1"/></body>)";
  make(options);
  const auto contact = [&](double height, double a, double b) {
    const int trunk =
        model_->jnt_qposadr[model_->body_jntadr[mj_name2id(model_.get(), mjOBJ_BODY, "trunk")]];
    data_->qpos[trunk + 2] = height;
    data_->qpos[trunk + 7] = a;
    data_->qpos[trunk + 8] = b;
    mj_forward(model_.get(), data_.get());
    return values("measured_contact");
  };
  using V = std::vector<double>;
  EXPECT_EQ(contact(0.219, 0.0, 0.0), (V{1, 1}));
  EXPECT_EQ(contact(0.3, 0.0, 0.0), (V{0, 0}));
  EXPECT_EQ(contact(0.219, 0.6, 0.0), (V{0, 1}));
  EXPECT_EQ(contact(0.219, 0.0, 0.6), (V{1, 0}));
  // Far from the floor, foot against foot: a contact, but with the robot.
  EXPECT_EQ(contact(0.9, 0.42, -0.42), (V{0, 0}));
  EXPECT_GT(data_->ncon, 0);  // the pose is such
  const int ball =
      model_->jnt_qposadr[model_->body_jntadr[mj_name2id(model_.get(), mjOBJ_BODY, "ball")]];
  data_->qpos[ball] = 0.08;  // under foot A
  data_->qpos[ball + 2] = 0.9 - 0.2 - 0.065;
  EXPECT_EQ(contact(0.9, 0.0, 0.0), (V{1, 0}));
}

TEST_F(SensorsTest, TrackingErrorIsTargetLessAngle) {
  make(with_all_sensors());
  const Trajectory t = walker_trajectory();
  data_->time = 0.33;
  data_->qpos[7] = 0.4;
  data_->qpos[8] = -0.2;
  data_->ctrl[0] = 0.5;  // is no part of it
  mj_forward(model_.get(), data_.get());
  TrajectorySample plan;
  sample(t, 0.33, plan);
  EXPECT_NEAR(values("tracking_error")[0], plan.target[0] - 0.4, 1e-13);
  EXPECT_NEAR(values("tracking_error")[1], plan.target[1] + 0.2, 1e-13);
}

TEST_F(SensorsTest, BaseErrorIsNoughtOnThePlanCycleAfterCycleAndWhatIsMissingOffIt) {
  make(with_all_sensors());
  const Trajectory t = walker_trajectory();
  for (const double time : {0.0, 0.5, 3.7, -2.2, 41.3}) {
    put_on_plan(t, time);
    mj_forward(model_.get(), data_.get());
    for (const double value : values("base_error")) EXPECT_NEAR(value, 0.0, 1e-9) << time;
    // Moved and turned in world axes by a known amount: the way back is what the sensor tells.
    const mjtNum axis[3] = {0.6, 0.0, 0.8};
    mjtNum turn[4], rotated[4];
    mju_axisAngle2Quat(turn, axis, -0.2);
    mju_mulQuat(rotated, turn, data_->qpos + 3);
    std::copy_n(rotated, 4, data_->qpos + 3);
    data_->qpos[1] -= 0.05;
    mj_forward(model_.get(), data_.get());
    const double expected[6] = {0.0, 0.05, 0.0, 0.12, 0.0, 0.16};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(values("base_error")[i], expected[i], 1e-9);
  }
}

TEST_F(SensorsTest, TorqueShareIsThatOfTheNarrowerLimit) {
  WalkerOptions options = with_all_sensors();
  options.actuator_a = "forcerange=\"-0.5 2\"";
  make(options);
  const auto share = [&](double offset) {
    data_->ctrl[0] = offset;
    mj_forward(model_.get(), data_.get());
    return values("torque_share")[0];
  };
  EXPECT_EQ(share(10.0), 1.0);
  EXPECT_EQ(share(-10.0), 1.0);
  const double positive = share(0.3), force = data_->actuator_force[0];
  ASSERT_GT(force, 0.0);
  EXPECT_NEAR(positive, force / 2.0, 1e-12);
  ASSERT_LT(force, 2.0);
  EXPECT_NEAR(share(0.3 - (force + 0.2) / 4.0), 0.2 / 0.5, 1e-12);  // kp = 4
  EXPECT_EQ(values("torque_share")[1], 0.0);                        // unlimited
}

TEST_F(SensorsTest, AMotorHasLessLeftTheFasterItRuns) {
  WalkerOptions options = with_all_sensors();
  options.config += R"(<config key="stall_torque" value="2 0"/>)"
                    R"(<config key="no_load_speed" value="8 0"/>)";
  make(options);
  const int dof = model_->jnt_dofadr[mj_name2id(model_.get(), mjOBJ_JOINT, "a")];
  const auto force_at = [&](double velocity, double offset) {
    data_->qvel[dof] = velocity;
    data_->ctrl[0] = data_->ctrl[1] = offset;
    mj_forward(model_.get(), data_.get());
    return data_->actuator_force[0];
  };
  EXPECT_NEAR(force_at(0.0, 10.0), 2.0, 1e-12);
  EXPECT_GT(data_->actuator_force[1], 10.0);  // of a motor that nobody knows
  EXPECT_NEAR(force_at(6.0, 10.0), 0.5, 1e-12);
  EXPECT_EQ(values("torque_share")[0], 1.0);
  EXPECT_NEAR(force_at(-6.0, -10.0), -0.5, 1e-12);
  EXPECT_NEAR(force_at(-6.0, 10.0), 3.5, 1e-12);   // it brakes with more
  EXPECT_NEAR(force_at(10.0, 10.0), -0.5, 1e-12);  // faster than it runs by itself
  const double less = force_at(1.0, 0.3);
  ASSERT_GT(less, 0.0);
  ASSERT_LT(less, 1.75);
  EXPECT_NEAR(values("torque_share")[0], less / 1.75, 1e-12);
}

TEST_F(SensorsTest, StepAllocatesNothing) {
  make(with_all_sensors());
  mj_step(model_.get(), data_.get());
  const long before = allocation_count();
  for (int i = 0; i < 100; ++i) mj_step(model_.get(), data_.get());
  EXPECT_EQ(allocation_count(), before);
}

TEST_F(SensorsTest, FootMayBeASiteOrABody) {
  WalkerOptions options = with_all_sensors();
  options.foot_a = R"(<geom name="sole" size="0.02" pos="0 0 -0.2"/><site name="A"/>)";
  make(options);
  data_->qpos[2] = 0.219;
  mj_forward(model_.get(), data_.get());
  EXPECT_EQ(values("measured_contact"), (std::vector<double>{1, 1}));
  options.foot_a = R"(<body name="A"><geom size="0.02" pos="0 0 -0.2"/></body>)";
  make(options);
  data_->qpos[2] = 0.219;
  mj_forward(model_.get(), data_.get());
  EXPECT_EQ(values("measured_contact"), (std::vector<double>{1, 1}));
}

struct BadSensor {
  const char* what;
  void (*spoil)(WalkerOptions&);
  const char* message;
};

const BadSensor kBadSensors[] = {
    {"unknown kind", [](WalkerOptions& o) { o.sensors = gait_sensor("speed"); },
     "legwright.sensor \"speed\": kind: got \"speed\", expected one of phase, planned_contact"},
    {"no kind",
     [](WalkerOptions& o) { o.sensors = R"(<plugin name="s" plugin="legwright.sensor"/>)"; },
     "kind is missing"},
    {"no such gait",
     [](WalkerOptions& o) {
       o.sensors = gait_sensor("phase", R"(<config key="gait" value="trot"/>)");
     },
     "gait: no instance of legwright.gait is named \"trot\""},
    {"foot that is not there",
     [](WalkerOptions& o) {
       o.sensors = gait_sensor("measured_contact");
       o.foot_a = "<geom size=\"0.02\" pos=\"0 0 -0.2\"/>";
     },
     "foot \"A\" of the trajectory: the model has no geom, site or body of this name"},
    {"foot in two places",
     [](WalkerOptions& o) {
       o.sensors = gait_sensor("measured_contact");
       o.foot_a = "<geom size=\"0.02\" pos=\"0 0 -0.2\"/>";
       o.world = "<site name=\"A\"/><body name=\"A\"><geom size=\"0.01\"/></body>";
     },
     "foot \"A\": the site and the body of this name are on different bodies"},
    {"a foot's geom, and others called so",
     [](WalkerOptions& o) {
       o.sensors = gait_sensor("measured_contact");
       o.world = "<site name=\"A\"/><body name=\"A\"><geom size=\"0.01\"/></body>";
     },
     ""},  // names are per kind: the geom is meant
    {"foot that cannot touch",
     [](WalkerOptions& o) {
       o.sensors = gait_sensor("measured_contact");
       o.foot_a = "<body name=\"A\"><geom size=\"0.02\" contype=\"0\" conaffinity=\"0\"/></body>";
     },
     "has no geom that collides"},
    {"feet with one geom",
     [](WalkerOptions& o) {
       o.sensors = gait_sensor("measured_contact");
       o.foot_a = "";
       o.world = R"(<body name="A"><geom name="x" size="0.01"/></body>)";
     },
     ""},  // negative control: far away, but a foot
    {"fixed base",
     [](WalkerOptions& o) {
       o.sensors = gait_sensor("base_error");
       o.trunk_joint = "";
     },
     "the robot has no free joint"},
};

TEST_F(SensorsTest, AreRefusedWithTheReason) {
  for (const BadSensor& bad : kBadSensors) {
    WalkerOptions options;
    bad.spoil(options);
    const Loaded loaded = load(walker(options));
    EXPECT_EQ(loaded.model == nullptr, *bad.message != '\0') << bad.what << loaded.error;
    EXPECT_NE(loaded.error.find(bad.message), std::string::npos)
        << bad.what << ": " << loaded.error;
    EXPECT_LE(take_warnings().size(), 1u) << bad.what;
  }
}

TEST_F(SensorsTest, NeedTheModelOnlyWhereTheyReadIt) {
  WalkerOptions options;
  options.foot_a = "";  // no foot A in the model
  options.sensors = gait_sensor("phase") + gait_sensor("planned_contact") +
                    gait_sensor("torque_share") + gait_sensor("base_error");
  EXPECT_TRUE(load(walker(options)).model);
}

TEST_F(SensorsTest, FaultOfTheGaitIsReportedByTheGait) {
  for (const char* const kind : kKinds) {
    WalkerOptions options;
    options.sensors = gait_sensor(kind);
    options.config = R"(<config key="period" value="0.7"/>)";
    const Loaded loaded = load(walker(options));
    EXPECT_FALSE(loaded.model);
    EXPECT_NE(loaded.error.find("legwright.gait \"gait\": trajectory: row"), std::string::npos)
        << kind << ": " << loaded.error;
    EXPECT_LE(take_warnings().size(), 1u) << kind;
  }
}

}  // namespace
}  // namespace legwright
