// SPDX-License-Identifier: Apache-2.0
// Robots that are attached to a scene under a prefix or suffix, and several in one: each plays its
// own gait, to the bit as it does alone.
#include <algorithm>
#include <array>

#include "tests/plugin/attached.hpp"
#include "tests/plugin/walker.hpp"

namespace legwright {
namespace {

class RobotNamesTest : public EngineTest {
 protected:
  /// Attaching without a prefix makes MuJoCo warn of saving the scene, which no test does.
  Loaded attach_quietly(const std::vector<Attached>& robots, const std::string& outer = "") {
    Loaded loaded = attach(robots, outer);
    for (const std::string& warning : take_warnings())
      EXPECT_NE(warning.find("empty prefix"), std::string::npos) << warning;
    return loaded;
  }
};

const char* const kKindsOfSensors[] = {"phase",          "planned_contact", "measured_contact",
                                       "tracking_error", "base_error",      "torque_share"};

/// A walker with everything that is looked up by name: joints, feet, keyframe, gait of the sensors.
/// It touches the floor, but no other robot.
std::string named_walker(double speed = 1.0, bool name_gait = false) {
  WalkerOptions options;
  options.config += R"(<config key="blend_in" value="0.3"/><config key="rest" value="stand"/>
                       <config key="speed" value=")" +
                    std::to_string(speed) + "\"/>";
  for (const char* const kind : kKindsOfSensors)
    options.sensors += gait_sensor(kind, name_gait ? R"(<config key="gait" value="gait"/>)" : "");
  std::string xml = walker(options);
  xml.insert(xml.find("<sensor>"),
             R"(<keyframe><key name="stand" qpos="0 0 0.22 1 0 0 0 0.3 -0.2"/></keyframe>)");
  xml = replace_all(xml, "<default><default",
                    R"(<default><geom contype="2" conaffinity="1"/><default)");
  return replace_all(xml, R"("floor" type="plane")",
                     R"("floor" type="plane" contype="1" conaffinity="0")");
}

std::string without_floor(std::string xml) {
  const std::size_t begin = xml.find("<geom name=\"floor\"");
  return xml.erase(begin, xml.find("/>", begin) + 2 - begin);
}

std::vector<double> played(const mjModel* m) {
  const DataPointer d(mj_makeData(m));
  return roll_out(m, d.get(), 400);
}

/// The values that all sensors of names prefix + KIND + suffix have after some steps.
std::vector<double> sensed(const mjModel* m, mjData* d, const std::string& prefix,
                           const std::string& suffix = "") {
  std::vector<double> values;
  for (const char* const kind : kKindsOfSensors) {
    const int sensor = mj_name2id(m, mjOBJ_SENSOR, (prefix + kind + suffix).c_str());
    if (sensor < 0) return {};
    const mjtNum* const first = d->sensordata + m->sensor_adr[sensor];
    values.insert(values.end(), first, first + m->sensor_dim[sensor]);
  }
  return values;
}

/// What the plugin draws of feet and forces, which stand where the feet are.
std::vector<float> drawn(const mjModel* m) {
  const DataPointer d(mj_makeData(m));
  for (int step = 0; step < 100; ++step) mj_step(m, d.get());
  mj_forward(m, d.get());
  mjvScene scene;
  mjv_defaultScene(&scene);
  mjv_makeScene(m, &scene, 2000);
  mjvOption option;
  mjv_defaultOption(&option);
  option.geomgroup[5] = option.flags[mjVIS_CONTACTFORCE] = option.flags[mjVIS_CONTACTPOINT] = 1;
  mjvCamera camera;
  mjv_defaultFreeCamera(m, &camera);
  mjv_updateScene(m, d.get(), &option, nullptr, &camera, mjCAT_ALL, &scene);
  std::vector<float> places;
  for (int g = 0; g < scene.ngeom; ++g)
    places.insert(places.end(), scene.geoms[g].pos, scene.geoms[g].pos + 3);
  mjv_freeScene(&scene);
  return places;
}

TEST_F(RobotNamesTest, AttachedRobotPlaysToTheBitAsItDoesAlone) {
  const ModelPointer alone = load(named_walker()).model;
  ASSERT_TRUE(alone);
  const std::vector<double> expected = played(alone.get());
  const std::vector<float> seen = drawn(alone.get());
  struct {
    const char *prefix, *suffix, *outer;
  } const cases[] = {{"", "", ""},   {"a_", "", ""},   {"", "_z", ""},
                     {"a", "z", ""}, {"a_", "", "n/"}, {"gait", "", "gait"}};
  for (const auto& c : cases) {
    SCOPED_TRACE(std::string(c.outer) + c.prefix + "NAME" + c.suffix);
    for (const bool name_gait : {false, true}) {
      const Loaded loaded =
          attach_quietly({{named_walker(1.0, name_gait), c.prefix, c.suffix}}, c.outer);
      ASSERT_TRUE(loaded.model) << loaded.error;
      EXPECT_EQ(played(loaded.model.get()), expected);
      EXPECT_EQ(drawn(loaded.model.get()), seen);
    }
  }
}

TEST_F(RobotNamesTest, RobotsOfOneSceneAreNotTakenForEachOther) {
  const std::array<double, 2> speeds = {1.0, 0.6};
  std::array<std::vector<double>, 2> expected;
  for (std::size_t robot = 0; robot < 2; ++robot) {
    const ModelPointer alone = load(named_walker(speeds[robot])).model;
    const DataPointer d(mj_makeData(alone.get()));
    for (int step = 0; step < 400; ++step) mj_step(alone.get(), d.get());
    expected[robot] = sensed(alone.get(), d.get(), "");
  }
  ASSERT_NE(expected[0], expected[1]);
  const std::array<std::array<const char*, 2>, 5> prefixes = {
      {{"a_", "b_"}, {"", "b_"}, {"b_", ""}, {"a_", "a_b_"}, {"a_a_", "a_"}}};
  for (const auto& prefix : prefixes) {
    for (const char* const outer : {"", "n_"}) {
      for (const bool name_gait : {false, true}) {
        SCOPED_TRACE(std::string(outer) + " " + prefix[0] + " " + prefix[1]);
        const Loaded loaded =
            attach_quietly({{named_walker(speeds[0], name_gait), prefix[0], ""},
                            {without_floor(named_walker(speeds[1], name_gait)), prefix[1], ""}},
                           outer);
        ASSERT_TRUE(loaded.model) << loaded.error;
        mjModel* const m = loaded.model.get();
        const DataPointer d(mj_makeData(m));
        for (int step = 0; step < 400; ++step) mj_step(m, d.get());
        for (std::size_t robot = 0; robot < 2; ++robot) {
          const std::vector<double> found = sensed(m, d.get(), std::string(outer) + prefix[robot]);
          ASSERT_EQ(found.size(), expected[robot].size());
          for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_NEAR(found[i], expected[robot][i], 1e-6) << robot << " value " << i;
        }
      }
    }
  }
}

TEST_F(RobotNamesTest, WhatDoesNotFitIsStillRefused) {
  const std::string good = named_walker();
  const struct {
    const char* what;
    std::string xml;
    const char *prefix, *message;
  } cases[] = {
      {"a column is of no joint",
       replace_all(replace_all(good, "q:b_rad", "q:c_rad"), "tau:b_", "tau:c_"), "n_",
       "legwright.gait \"n_gait\": actuator \"n_drive_b\": the trajectory has no column for joint "
       "\"n_b\" (the robot is attached with prefix \"n_\" and suffix \"\")"},
      {"another robot's trajectory",
       replace_all(
           replace_all(replace_all(replace_all(good, "q:a_rad", "q:x_rad"), "q:b_rad", "q:y_rad"),
                       "tau:a_", "tau:x_"),
           "tau:b_", "tau:y_"),
       "n_", "the trajectory has no column for joint \"n_a\""},
      {"joints alone have a prefix",
       replace_all(replace_all(good, "joint name=\"", "joint name=\"n_"), "joint=\"", "joint=\"n_"),
       "", "the trajectory has no column for joint \"n_a\""},
      {"foot that is not there", replace_all(good, "name=\"B\"", "name=\"C\""), "n_",
       "foot \"n_B\" of the trajectory: the model has no geom, site or body of this name"},
      {"keyframe that is not there",
       replace_all(good, "\"rest\" value=\"stand\"", "\"rest\" value=\"sit\""), "n_",
       "rest: the model has no keyframe named \"n_sit\""},
      {"gait that is not there",
       replace_all(named_walker(1.0, true), "\"gait\" value=\"gait\"", "\"gait\" value=\"trot\""),
       "n_", "gait: no instance of legwright.gait is named \"trot\""},
  };
  for (const auto& bad : cases) {
    const Loaded loaded = attach({{bad.xml, bad.prefix, ""}});
    EXPECT_FALSE(loaded.model) << bad.what;
    EXPECT_NE(loaded.error.find(bad.message), std::string::npos)
        << bad.what << ": " << loaded.error;
    EXPECT_LE(take_warnings().size(), 1u) << bad.what;
  }
}

}  // namespace
}  // namespace legwright
