// SPDX-License-Identifier: Apache-2.0
// The plugin in MuJoCo: the servo law, against the engine's own, and what it depends on.
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>

#include "plugin/spline.hpp"
#include "tests/plugin/allocation_count.hpp"
#include "tests/plugin/engine.hpp"
#include "tests/support/paths.hpp"

namespace legwright {
namespace {

ModelPointer compile(const std::string& xml) {
  Loaded loaded = load(xml);
  if (!loaded.model) throw std::runtime_error(loaded.error);
  return std::move(loaded.model);
}

DataPointer make_data(const ModelPointer& m) { return DataPointer(mj_makeData(m.get())); }

/// What the host of native servos does at each step: targets of the trajectory as controls.
void drive_native_by_trajectory(const mjModel* m, mjData* d, const Trajectory& trajectory,
                                double t0, double offset) {
  const SplinePhase phase = phase_at(trajectory, d->time + t0);
  for (int actuator = 0; actuator < m->nactuator; ++actuator) {
    const int joint = m->jnt_qposadr[m->actuator_trnid[2 * actuator]];  // a, b, c are qpos 0, 1, 2
    const SplinePoint target = spline_point(trajectory, phase, trajectory.target_column(joint));
    double* const control = d->ctrl + m->actuator_ctrladr[actuator];
    control[0] = target.value + offset;
    control[1] = target.rate;
    control[2] = linear_value(trajectory, phase, trajectory.torque_column(joint));
  }
}

/// Largest difference of qpos between the plugin and native servos over `steps` steps.
double difference_to_native(const ChainOptions& options, int steps, bool with_bias,
                            double t0 = 0.0) {
  const Trajectory trajectory = chain_trajectory();
  const ModelPointer plugin = compile(plugin_chain(options)),
                     native = compile(native_chain(options));
  const DataPointer d_plugin = make_data(plugin), d_native = make_data(native);
  if (!with_bias) {  // after init has seen the right one: what a model without biasprm would do
    for (int a = 0; a < plugin->nactuator; ++a) plugin->actuator_biastype[a] = mjBIAS_NONE;
  }
  constexpr double kOffset = 0.05;
  for (int a = 0; a < plugin->nactuator; ++a) d_plugin->ctrl[plugin->actuator_ctrladr[a]] = kOffset;
  double largest = 0.0;
  for (int i = 0; i < steps; ++i) {
    drive_native_by_trajectory(native.get(), d_native.get(), trajectory, t0, kOffset);
    mj_step(native.get(), d_native.get());
    mj_step(plugin.get(), d_plugin.get());
    for (int j = 0; j < plugin->nq; ++j) {
      largest = std::max(largest, std::abs(d_plugin->qpos[j] - d_native->qpos[j]));
    }
  }
  return largest;
}

class PlaybackTest : public EngineTest {};

class NativeServo : public EngineTest, public testing::WithParamInterface<std::string> {};

TEST_P(NativeServo, IsEqualledToTheLastBits) {
  ChainOptions options = valid_options();
  options.integrator = GetParam();
  const double difference = difference_to_native(options, 3000, true);
  std::printf("largest difference in qpos to <pid>, %s, 3000 steps: %.3g rad\n", GetParam().c_str(),
              difference);
  EXPECT_LT(difference, 1e-10);
}

TEST_P(NativeServo, IsMissedWithoutBiasprm) {
  ChainOptions options = valid_options();
  options.integrator = GetParam();
  EXPECT_GT(difference_to_native(options, 1000, false), 1e-4);
}

TEST_P(NativeServo, IsEqualledWithStartTimeAndTwoMilliseconds) {
  ChainOptions options = valid_options();
  options.integrator = GetParam();
  options.timestep = "0.002";
  options.more_config = R"(<config key="t0" value="-0.17"/>)";
  EXPECT_LT(difference_to_native(options, 1000, true, -0.17), 1e-10);
  EXPECT_GT(difference_to_native(options, 200, true, 0.0), 1e-3);  // t0 matters
}

INSTANTIATE_TEST_SUITE_P(Integrators, NativeServo, testing::Values("implicitfast", "implicit"),
                         [](const auto& name) { return name.param; });

TEST_F(PlaybackTest, ForceIsTheLawForEachJointWithItsOwnGains) {
  ChainOptions options = valid_options();
  options.kp = "1 2 3";  // of drive_b, drive_a, drive_c
  options.kd = "0.1 0.2 0.3";
  std::string xml = plugin_chain(options);
  // One default class per pair of gains, as the README asks.
  std::string classes;
  for (int i = 1; i <= 3; ++i) {
    const std::string n = std::to_string(i);
    classes += "<default class=\"pd" + n + "\"><general biastype=\"affine\" biasprm=\"0 -" + n +
               " -0." + n + "\"/></default>";
    xml.replace(xml.find("class=\"pd\" plugin"), 10, "class=\"pd" + n + "\"");
  }
  xml.insert(xml.find("<default class=\"pd\">"), classes);
  const ModelPointer m = compile(xml);
  const DataPointer d = make_data(m);
  const Trajectory trajectory = chain_trajectory();
  TrajectorySample plan;
  for (int i = 0; i < 40; ++i) {
    d->time = 0.037 * i;
    for (int j = 0; j < 3; ++j) {
      d->qpos[j] = 0.1 * (j + 1) - 0.01 * i;
      d->qvel[j] = -0.2 * j + 0.03 * i;
      d->ctrl[j] = 0.07 * j;
    }
    mj_forward(m.get(), d.get());
    sample(trajectory, d->time, plan);
    const int joint_of[] = {1, 0, 2};
    for (int a = 0; a < 3; ++a) {
      const int j = joint_of[a];
      const auto p = static_cast<std::size_t>(j);
      const double expected = (a + 1) * (plan.target[p] + d->ctrl[a] - d->qpos[j]) +
                              0.1 * (a + 1) * (plan.velocity[p] - d->qvel[j]) + plan.torque[p];
      EXPECT_NEAR(d->actuator_force[a], expected, 1e-12);
      EXPECT_NEAR(d->sensordata[a], plan.target[p] - d->qpos[j], 1e-13);
    }
  }
}

TEST_F(PlaybackTest, SensorHasOneValuePerActuator) {
  const ModelPointer m = compile(plugin_chain(valid_options()));
  ASSERT_EQ(m->nsensor, 1);
  EXPECT_EQ(m->sensor_dim[0], 3);
  EXPECT_EQ(m->nsensordata, 3);
}

TEST_F(PlaybackTest, ControlMovesTheTargetBy1RadPerUnit) {
  const ModelPointer m = compile(plugin_chain(valid_options()));
  const DataPointer d = make_data(m);
  mj_forward(m.get(), d.get());
  const std::vector<double> before(d->actuator_force, d->actuator_force + 3);
  const std::vector<double> error(d->sensordata, d->sensordata + 3);
  d->ctrl[1] = 0.25;
  mj_forward(m.get(), d.get());
  EXPECT_EQ(d->actuator_force[0], before[0]);
  EXPECT_NEAR(d->actuator_force[1] - before[1], 4 * 0.25, 1e-12);
  EXPECT_EQ(d->sensordata[1], error[1]);  // against the plan, not against the plan plus offset
}

TEST_F(PlaybackTest, DisabledGroupGivesNoForce) {
  ChainOptions options = valid_options();
  options.actuator = "group=\"2\"";
  const ModelPointer m = compile(plugin_chain(options));
  const DataPointer d = make_data(m);
  mj_forward(m.get(), d.get());
  for (int a = 0; a < 3; ++a) EXPECT_NE(d->actuator_force[a], 0.0);
  m->opt.disableactuator = 1 << 2;
  mj_forward(m.get(), d.get());
  for (int a = 0; a < 3; ++a) EXPECT_EQ(d->actuator_force[a], 0.0);
  for (int j = 0; j < m->nv; ++j) EXPECT_EQ(d->qfrc_actuator[j], 0.0);
  m->opt.disableactuator = 1 << 3;  // another group
  mj_forward(m.get(), d.get());
  for (int a = 0; a < 3; ++a) EXPECT_NE(d->actuator_force[a], 0.0);
}

TEST_F(PlaybackTest, ForcerangeIsHonoured) {
  ChainOptions options = valid_options();
  options.actuator = "forcerange=\"-0.1 0.1\"";
  const ModelPointer m = compile(plugin_chain(options));
  const DataPointer d = make_data(m);
  d->ctrl[0] = 100.0;
  mj_forward(m.get(), d.get());
  EXPECT_EQ(d->actuator_force[0], 0.1);
}

TEST_F(PlaybackTest, FourThreadsGiveTheSameBits) {
  const ModelPointer m = compile(plugin_chain(valid_options()));
  const DataPointer d = make_data(m);
  const std::vector<double> expected = roll_out(m.get(), d.get(), 1000);
  std::vector<std::vector<double>> results(4);
  std::vector<std::thread> threads;
  for (std::vector<double>& result : results) {
    threads.emplace_back([&m, &result] {
      const DataPointer own = make_data(m);
      result = roll_out(m.get(), own.get(), 1000);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<double>& result : results) EXPECT_EQ(result, expected);
}

TEST_F(PlaybackTest, FourThreadsMayLoadAtOnce) {
  const std::string xml = plugin_chain(valid_options());
  std::vector<std::vector<double>> results(4);
  std::vector<std::thread> threads;
  for (std::vector<double>& result : results) {
    threads.emplace_back([&xml, &result] {
      const ModelPointer m = compile(xml);
      const DataPointer d = make_data(m);
      result = roll_out(m.get(), d.get(), 200);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<double>& result : results) EXPECT_EQ(result, results[0]);
}

TEST_F(PlaybackTest, ResetCopyAndReloadGiveTheSameBits) {
  const std::string xml = plugin_chain(valid_options());
  const ModelPointer m = compile(xml);
  const DataPointer d = make_data(m);
  const std::vector<double> expected = roll_out(m.get(), d.get(), 400);
  mj_resetData(m.get(), d.get());
  EXPECT_EQ(roll_out(m.get(), d.get(), 400), expected);

  const DataPointer fresh(mj_copyData(nullptr, m.get(), d.get()));
  const DataPointer existing = make_data(m);
  mj_copyData(existing.get(), m.get(), d.get());
  const std::vector<double> onward = roll_out(m.get(), d.get(), 300);
  EXPECT_EQ(roll_out(m.get(), fresh.get(), 300), onward);
  EXPECT_EQ(roll_out(m.get(), existing.get(), 300), onward);
  EXPECT_NE(onward, std::vector<double>(expected.begin(), expected.begin() + 1800));

  const ModelPointer again = compile(xml);
  const DataPointer d_again = make_data(again);
  EXPECT_EQ(roll_out(again.get(), d_again.get(), 400), expected);
}

TEST_F(PlaybackTest, TimeMayJump) {
  const ModelPointer m = compile(plugin_chain(valid_options()));
  const DataPointer walked = make_data(m), jumped = make_data(m);
  for (const double time : {0.31, -5.0, 1e4, 0.0, 0.31, 123.456}) {
    roll_out(m.get(), walked.get(), 50);  // history that must not matter
    mj_resetData(m.get(), walked.get());
    walked->time = jumped->time = time;
    mj_forward(m.get(), walked.get());
    mj_forward(m.get(), jumped.get());
    EXPECT_EQ(std::memcmp(walked->actuator_force, jumped->actuator_force, 3 * sizeof(mjtNum)), 0)
        << time;
  }
  mj_resetData(m.get(), walked.get());
  mj_forward(m.get(), walked.get());
  const double at_start = walked->actuator_force[0];
  walked->time = 0.2;
  mj_forward(m.get(), walked.get());
  EXPECT_NE(walked->actuator_force[0], at_start);  // time does matter
}

TEST_F(PlaybackTest, SavedModelPlaysOn) {
  ChainOptions options = valid_options();
  options.kp = options.bias_kp =
      "4.123456789";  // saved with six digits in biasprm, whole in the plugin
  const std::string xml = plugin_chain(options);
  char error[1024] = "";
  const SpecPointer spec(mj_parseXMLString(xml.c_str(), nullptr, error, sizeof error));
  ASSERT_TRUE(spec) << error;
  const ModelPointer m(mj_compile(spec.get(), nullptr));
  ASSERT_TRUE(m) << mjs_getError(spec.get());
  std::vector<char> saved(1 << 20);
  ASSERT_EQ(mj_saveXMLString(spec.get(), saved.data(), static_cast<int>(saved.size()), error,
                             sizeof error),
            0)
      << error;
  const ModelPointer m_saved = compile(saved.data());
  const DataPointer d = make_data(m), d_saved = make_data(m_saved);
  mj_forward(m.get(), d.get());
  mj_forward(m_saved.get(), d_saved.get());
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(d_saved->actuator_force[a], d->actuator_force[a], 1e-12);
}

TEST_F(PlaybackTest, SteppingAllocatesNothing) {
  const ModelPointer m = compile(plugin_chain(valid_options()));
  const long at_first = allocation_count();
  const DataPointer d = make_data(m);
  EXPECT_GT(allocation_count(), at_first);  // the counter sees the plugin's init
  const long before = allocation_count();
  for (int i = 0; i < 200; ++i) mj_step(m.get(), d.get());
  EXPECT_EQ(allocation_count(), before);
}

TEST_F(PlaybackTest, LoadingTheLibraryTwiceIsHarmless) {
  mj_loadPluginLibrary(LEGWRIGHT_PLUGIN_FILE);
  EXPECT_TRUE(load(plugin_chain(valid_options())).model);
}

TEST_F(PlaybackTest, ReadmesSmallestModelSwings) {
  std::ifstream file(test::source_dir() + "/plugin/README.md");
  std::stringstream stream;
  stream << file.rdbuf();
  const std::string readme = stream.str(), opening = "```xml\n";
  const std::size_t begin = readme.find(opening) + opening.size();
  const ModelPointer m = compile(readme.substr(begin, readme.find("```", begin) - begin));
  const DataPointer d = make_data(m);
  double largest = 0.0, error = 0.0;
  for (int i = 0; i < 3000; ++i) {
    mj_step(m.get(), d.get());
    largest = std::max(largest, d->qpos[0]);
    error = std::max(error, std::abs(d->sensordata[0]));
  }
  EXPECT_NEAR(largest, 1.0 / 3.0, 0.01);  // (0 + 4·0.5 + 0)/6
  EXPECT_LT(error, 0.02);
}

}  // namespace
}  // namespace legwright
