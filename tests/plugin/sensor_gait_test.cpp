// SPDX-License-Identifier: Apache-2.0
// Which gait a sensor looks at where robots share a scene, and the sensor belongs to none of them.

#include "tests/plugin/attached.hpp"
#include "tests/plugin/walker.hpp"

namespace legwright {
namespace {

class SensorGaitTest : public EngineTest {
 protected:
  /// Two walkers a_ and b_ that start a quarter of a cycle apart, and a sensor of the world.
  Loaded world(const std::string& key, const std::string& sensor_prefix,
               const std::string& outer = "") {
    const auto robot = [](const char* phase) {
      WalkerOptions options;
      options.config = std::string(R"(<config key="phase" value=")") + phase + "\"/>";
      return walker(options);
    };
    const std::string watch =
        R"(<mujoco><extension><plugin plugin="legwright.sensor"/></extension><sensor>)" +
        gait_sensor("phase", key) + "</sensor></mujoco>";
    Loaded loaded = attach(
        {{robot("0.25"), "a_", ""}, {robot("0.5"), "b_", ""}, {watch, sensor_prefix, ""}}, outer);
    for (const std::string& warning : take_warnings())
      EXPECT_TRUE(warning.find("empty prefix") != std::string::npos ||
                  warning.find("Attach conflict") != std::string::npos)
          << warning;
    return loaded;
  }
  static double first_value(const mjModel* m) {
    const DataPointer d(mj_makeData(m));
    mj_forward(m, d.get());
    return d->sensordata[0];
  }
};

constexpr const char* kOfA = R"(<config key="gait" value="a_gait"/>)";
constexpr const char* kOfB = R"(<config key="gait" value="b_gait"/>)";

TEST_F(SensorGaitTest, WorldNamesTheGaitAsItIsCalledThere) {
  for (const char* const outer : {"", "n_"}) {
    for (const char* const prefix : {"", "a_", "b_", "c_"}) {
      SCOPED_TRACE(std::string(outer) + prefix);
      const Loaded a = world(kOfA, prefix, outer), b = world(kOfB, prefix, outer);
      ASSERT_TRUE(a.model) << a.error;
      ASSERT_TRUE(b.model) << b.error;
      EXPECT_EQ(first_value(a.model.get()), 0.25);
      EXPECT_EQ(first_value(b.model.get()), 0.5);
    }
  }
}

/// What stands before a gait's name counts only as far as it stands before its joints' names, too.
TEST_F(SensorGaitTest, NamesThatMerelyBeginAlikeDoNotMisleadIt) {
  WalkerOptions own, other;
  own.config = R"(<config key="phase" value="0.25"/>)";
  own.sensors = gait_sensor("phase", R"(<config key="gait" value="gait"/>)");
  other.config = R"(<config key="phase" value="0.5"/>)";
  const std::string first = replace_all(walker(own), "name=\"phase\"", "name=\"r_b_phase\"");
  std::string second =
      replace_all(walker(other), "instance name=\"gait\"", "instance name=\"b_gait\"");
  second = replace_all(second, "instance=\"gait\"", "instance=\"b_gait\"");
  const Loaded loaded = attach({{first, "", ""}, {second, "r_", ""}});
  take_warnings();  // of the empty prefix
  ASSERT_TRUE(loaded.model) << loaded.error;
  EXPECT_EQ(first_value(loaded.model.get()), 0.25);
}

TEST_F(SensorGaitTest, OfSeveralGaitsNoneIsGuessed) {
  const Loaded mute = world("", "c_");
  EXPECT_FALSE(mute.model);
  EXPECT_NE(mute.error.find("gait is missing; the model has several"), std::string::npos)
      << mute.error;
  const Loaded vague = world(R"(<config key="gait" value="gait"/>)", "c_");
  EXPECT_FALSE(vague.model);
  EXPECT_NE(vague.error.find("no instance of legwright.gait is named \"gait\""), std::string::npos)
      << vague.error;
  const Loaded a = world("", "a_");
  ASSERT_TRUE(a.model) << a.error;
  EXPECT_EQ(first_value(a.model.get()), 0.25);
}

}  // namespace
}  // namespace legwright
