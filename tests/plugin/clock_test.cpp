// SPDX-License-Identifier: Apache-2.0
// Start, speed, way in from rest, feed-forward gain and kinds of joints: against the engine's own
// servo, and what they may not depend on.
#include <fmt/format.h>

#include <cmath>
#include <thread>

#include "plugin/clock.hpp"
#include "plugin/spline.hpp"
#include "tests/plugin/engine.hpp"

namespace legwright {
namespace {

/// The attributes under test, and what they mean.
struct Attributes {
  double ff = 1.0, phase = 0.0, speed = 1.0, blend_in = 0.0;
  bool home = false;  // the rest pose is a keyframe, not qpos0
  std::array<double, 3> rest() const {
    return home ? std::array{0.2, -0.3, 0.1} : std::array{0.0, 0.0, 0.0};
  }
};

std::string key(const char* name, double value) {
  return fmt::format(R"(<config key="{}" value="{}"/>)", name, value);
}

ChainOptions options_of(const Attributes& a, const char* integrator = "implicitfast") {
  ChainOptions o = valid_options();
  o.integrator = integrator;
  o.more_config =
      key("ff", a.ff) + key("phase", a.phase) + key("speed", a.speed) + key("blend_in", a.blend_in);
  return o;
}

std::string with_home(std::string xml, const Attributes& a) {
  const std::string keys =
      R"(<keyframe><key name="other" qpos="1 1 1"/><key name="home" qpos="0.2 -0.3 0.1"/></keyframe>)";
  return a.home ? xml.insert(xml.rfind("</mujoco>"), keys) : xml;
}

/// What the host of native servos does at each step: the law of the README, written once more.
void drive_native_by_law(const mjModel* m, mjData* d, const Trajectory& t, const Attributes& a) {
  const double s = a.phase * t.period + a.speed * d->time;
  const double x = a.blend_in > 0 ? std::min(1.0, d->time / a.blend_in) : 1.0;
  const double w = 10 * x * x * x - 15 * x * x * x * x + 6 * x * x * x * x * x;
  const double rate = a.blend_in > 0 && x < 1
                          ? (30 * x * x - 60 * x * x * x + 30 * x * x * x * x) / a.blend_in
                          : 0.0;
  const SplinePhase phase = phase_at(t, s);
  for (int actuator = 0; actuator < m->nactuator; ++actuator) {
    const int joint = m->jnt_qposadr[m->actuator_trnid[2 * actuator]];
    const SplinePoint gait = spline_point(t, phase, t.target_column(joint));
    const double rest = a.rest()[static_cast<std::size_t>(joint)];
    double* const control = d->ctrl + m->actuator_ctrladr[actuator];
    control[0] = rest + w * (gait.value - rest);
    control[1] = w * a.speed * gait.rate + rate * (gait.value - rest);
    control[2] = a.ff * w * linear_value(t, phase, t.torque_column(joint));
  }
}

/// Largest difference of qpos between the plugin with `set` and native servos driven as `meant`.
double difference(const ChainOptions& options, const Attributes& set, const Attributes& meant,
                  int steps) {
  const Loaded plugin = load(with_home(plugin_chain(options), set)),
               native = load(native_chain(options));
  if (!plugin.model || !native.model) throw std::runtime_error(plugin.error + native.error);
  const DataPointer d(mj_makeData(plugin.model.get())), twin(mj_makeData(native.model.get()));
  const Trajectory t = chain_trajectory();
  double largest = 0.0;
  for (int i = 0; i < steps; ++i) {
    drive_native_by_law(native.model.get(), twin.get(), t, meant);
    mj_step(native.model.get(), twin.get());
    mj_step(plugin.model.get(), d.get());
    for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(d->qpos[j] - twin->qpos[j]));
  }
  return largest;
}

class ClockTest : public EngineTest, public testing::WithParamInterface<const char*> {};

TEST_P(ClockTest, NativeServoIsEqualledWithEveryAttribute) {
  const Attributes sets[] = {{0.3, 0.0, 1.0, 0.0},         {1.0, 0.4, 1.0, 0.0, true},
                             {1.0, 0.0, 0.7, 0.0},         {1.0, 0.0, -1.2, 0.0},
                             {1.0, 0.0, 1.0, 0.5},         {1.0, 0.0, 1.0, 0.5, true},
                             {-0.5, 0.9, 1.6, 0.35, true}, {0.0, 0.3, 0.0, 2.0}};
  for (const Attributes& set : sets) {
    const ChainOptions options = options_of(set, GetParam());
    EXPECT_LT(difference(options, set, set, 1200), 1e-10) << options.more_config;
    EXPECT_GT(difference(options, set, Attributes{}, 400), 1e-3)  // what is set matters
        << options.more_config;
  }
}

INSTANTIATE_TEST_SUITE_P(Integrators, ClockTest, testing::Values("implicitfast", "implicit"),
                         [](const auto& name) { return std::string(name.param); });

TEST_F(ClockTest, RestMayBeAnyKeyframe) {
  Attributes set;
  set.home = true;
  set.blend_in = 1.0;
  ChainOptions options = options_of(set);
  options.more_config += R"(<config key="rest" value="other"/>)";
  const Loaded loaded = load(with_home(plugin_chain(options), set));
  ASSERT_TRUE(loaded.model) << loaded.error;
  const DataPointer d(mj_makeData(loaded.model.get()));
  for (const double time : {-1.0, 0.0}) {  // nothing but the servo at rest
    d->time = time;
    mj_forward(loaded.model.get(), d.get());
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(d->actuator_force[a], 4.0 * 1.0, 1e-12);
  }
}

TEST_F(ClockTest, StartMayBeSaidTwiceIfItIsTheSame) {
  ChainOptions options = options_of({});
  const auto loads = [&](const std::string& config) {
    options.more_config = config;
    const Loaded loaded = load(plugin_chain(options));
    return loaded.model ? std::string("yes") : loaded.error;
  };
  EXPECT_EQ(loads(key("t0", 0.15) + key("phase", 0.25)), "yes");   // of 0.6 s
  EXPECT_EQ(loads(key("t0", -0.45) + key("phase", 0.25)), "yes");  // a cycle before
  EXPECT_NE(loads(key("t0", 0.15) + key("phase", 0.5))
                .find("t0 = 0.15 s is a phase of 0.25, but phase = 0.5; remove one of the two"),
            std::string::npos);
  take_warnings();
}

TEST_F(ClockTest, BadAttributesAreRefused) {
  const std::pair<std::string, const char*> bad[] = {
      {key("speed", 101), "speed: got 101, expected"},
      {key("speed", -1e9), "speed: got -1000000000"},
      {R"(<config key="speed" value="fast"/>)", "speed: got \"fast\""},
      {key("blend_in", -0.1), "blend_in: got -0.1 s"},
      {key("blend_in", 1e-300), "blend_in: got 1e-300 s"},
      {R"(<config key="blend_in" value="1 2"/>)", "blend_in: got 2 numbers"},
      {R"(<config key="ff" value="nan"/>)", "ff: got \"nan\""},
      {R"(<config key="phase" value="half"/>)", "phase: got \"half\""},
      {R"(<config key="rest" value="stand"/>)", "rest: the model has no keyframe named \"stand\""},
      {key("ghost_group", 6), "ghost_group: got 6, expected 0 to 5"},
      {key("ghost_group", 1.5), "ghost_group: got 1.5"}};
  for (const auto& [config, message] : bad) {
    ChainOptions options = options_of({});
    options.more_config = config;
    const Loaded loaded = load(plugin_chain(options));
    EXPECT_FALSE(loaded.model) << config;
    EXPECT_NE(loaded.error.find(message), std::string::npos) << loaded.error;
    EXPECT_LE(take_warnings().size(), 1u);
  }
}

TEST_F(ClockTest, ThreadsResetStateAndJumpsGiveTheSameBits) {
  const Attributes set{0.7, 0.2, 1.3, 0.4};
  const Loaded loaded = load(plugin_chain(options_of(set)));
  ASSERT_TRUE(loaded.model) << loaded.error;
  const mjModel* const m = loaded.model.get();
  const DataPointer d(mj_makeData(m));
  std::vector<mjtNum> state(static_cast<std::size_t>(mj_stateSize(m, mjSTATE_INTEGRATION)));
  roll_out(m, d.get(), 100);  // in the middle of the way in from rest
  mj_getState(m, d.get(), state.data(), mjSTATE_INTEGRATION);
  const std::vector<double> expected = roll_out(m, d.get(), 1000);

  std::vector<std::vector<double>> results(4);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < results.size(); ++i) {
    threads.emplace_back([&, i] {
      const DataPointer own(mj_makeData(m));
      own->time = 77.0 * static_cast<double>(i);  // jumps there and back
      roll_out(m, own.get(), 10);
      mj_setState(m, own.get(), state.data(), mjSTATE_INTEGRATION);
      results[i] = roll_out(m, own.get(), 1000);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<double>& result : results) EXPECT_EQ(result, expected);
  mj_resetData(m, d.get());
  roll_out(m, d.get(), 100);
  EXPECT_EQ(roll_out(m, d.get(), 1000), expected);
  mj_setState(m, d.get(), state.data(), mjSTATE_INTEGRATION);
  d->time += 1e-3;  // negative control: another time is another motion
  EXPECT_NE(roll_out(m, d.get(), 1000), expected);
}

TEST_F(ClockTest, SlideAndJointInParentArePlayedToo) {
  ChainOptions options = options_of({0.8, 0.1, 1.1, 0.3});
  options.joint_type = "slide";
  options.trajectory = replace_all(options.trajectory, "q:a_rad", "q:a_m");
  options.trajectory = replace_all(options.trajectory, "tau:a_Nm", "tau:a_N");
  const Loaded slide = load(plugin_chain(options)), native = load(native_chain(options));
  ASSERT_TRUE(slide.model) << slide.error;
  ASSERT_TRUE(native.model) << native.error;
  EXPECT_LT(difference(options, {}, {0.8, 0.1, 1.1, 0.3}, 1000), 1e-10);

  const ChainOptions hinge = options_of({});
  const Loaded one = load(plugin_chain(hinge)),
               other = load(replace_all(plugin_chain(hinge), "joint=\"b\"", "jointinparent=\"b\""));
  ASSERT_TRUE(other.model) << other.error;
  const DataPointer a(mj_makeData(one.model.get())), b(mj_makeData(other.model.get()));
  EXPECT_EQ(roll_out(one.model.get(), a.get(), 300), roll_out(other.model.get(), b.get(), 300));
}

}  // namespace
}  // namespace legwright
