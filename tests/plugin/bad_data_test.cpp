// SPDX-License-Identifier: Apache-2.0
// Bad data: refused at compile with one reason, and the host lives.
#include <fmt/format.h>

#include "tests/plugin/engine.hpp"

namespace legwright {
namespace {

class BadDataTest : public EngineTest {};

struct BadModel {
  const char* what;
  void (*spoil)(ChainOptions&);
  const char* message;
};

std::string config(const char* key, const char* value) {
  return fmt::format(R"(<config key="{}" value="{}"/>)", key, value);
}

const BadModel kBadModels[] = {
    {"no trajectory", [](ChainOptions& o) { o.trajectory.clear(); }, "trajectory is missing"},
    {"truncated", [](ChainOptions& o) { o.trajectory.resize(o.trajectory.size() - 60); },
     "values, expected"},
    {"garbage", [](ChainOptions& o) { o.trajectory = "hello"; }, "expected \"time_s\""},
    {"NaN", [](ChainOptions& o) { o.trajectory.replace(o.trajectory.rfind(' '), 99, " nan"); },
     "got \"nan\""},
    {"kp not a number", [](ChainOptions& o) { o.kp = "4x"; }, "kp: got \"4x\""},
    {"kp missing", [](ChainOptions& o) { o.kp = ""; }, "kp is missing"},
    {"kd missing", [](ChainOptions& o) { o.kd = " "; }, "kd is missing"},
    {"kp negative", [](ChainOptions& o) { o.kp = "-4"; }, "kp: got -4"},
    {"kd infinite", [](ChainOptions& o) { o.kd = "inf"; }, "kd: got \"inf\""},
    {"two gains", [](ChainOptions& o) { o.kp = "4 4"; }, "kp: got 2 numbers, expected 1, or 3"},
    {"kp differs", [](ChainOptions& o) { o.kp = "4.001"; },
     "biasprm \"0 -4 -0.1\", but kp = 4.001"},
    {"kd differs", [](ChainOptions& o) { o.bias_kd = "0.2"; }, "biasprm \"0 -4 -0.2\""},
    {"one of three differs", [](ChainOptions& o) { o.kp = "4 4 5"; },
     "actuator \"drive_c\": biasprm"},
    {"zero bias", [](ChainOptions& o) { o.bias_kp = o.bias_kd = "0"; }, "biasprm=\"0 -4 -0.1\"/>"},
    {"torque without speed", [](ChainOptions& o) { o.more_config = config("stall_torque", "1.5"); },
     "no_load_speed is missing"},
    {"speed of no torque",
     [](ChainOptions& o) {
       o.more_config = config("stall_torque", "1.5 0 1.5") + config("no_load_speed", "6");
     },
     "stall_torque 0 and no_load_speed 6 of actuator 1 of the instance: expected both positive"},
    {"negative speed",
     [](ChainOptions& o) {
       o.more_config = config("stall_torque", "1.5") + config("no_load_speed", "-6");
     },
     "no_load_speed: got -6, expected a speed of 0 or more"},
    {"t0", [](ChainOptions& o) { o.more_config = config("t0", "1 2"); }, "t0: got 2 numbers"},
    {"t0 text", [](ChainOptions& o) { o.more_config = config("t0", "soon"); }, "t0: got \"soon\""},
    {"period", [](ChainOptions& o) { o.more_config = config("period", "0.7"); },
     "column 1 (time_s)"},
    {"period zero", [](ChainOptions& o) { o.more_config = config("period", "0"); }, "period = 0 s"},
    {"travel", [](ChainOptions& o) { o.more_config = config("travel", "1 2"); },
     "travel: got 2 numbers"},
    {"turn", [](ChainOptions& o) { o.more_config = config("turn", "1,5"); }, "turn: got \"1,5\""},
    {"unknown key", [](ChainOptions& o) { o.more_config = config("kpp", "1"); },
     "unrecognized attribute"},
    {"duplicate key", [](ChainOptions& o) { o.more_config = config("kp", "1"); }, "duplicate"},
    {"gear", [](ChainOptions& o) { o.actuator = "gear=\"2\""; }, "gear = 2, expected 1"},
    {"activation", [](ChainOptions& o) { o.actuator = "dyntype=\"integrator\""; }, "activation"},
    {"slide joint", [](ChainOptions& o) { o.joint_type = "slide"; },
     "joint \"a\" is a slide, but its column is q:a_rad; expected q:a_m and tau:a_N"},
    {"joint driven twice",
     [](ChainOptions& o) {
       o.more_actuators =
           R"(<plugin name="again" class="pd" plugin="legwright.gait" instance="gait"
                                    joint="a"/>)";
     },
     "joint \"a\" is driven by actuator \"drive_a\" already"},
    {"joint without a column",
     [](ChainOptions& o) {
       Trajectory t = blank_trajectory({"a", "b"}, {}, 4, 1.0);
       o.trajectory = write_trajectory(t);
     },
     "actuator \"drive_c\": the trajectory has no column for joint \"c\""},
    {"column without an actuator",
     [](ChainOptions& o) {
       o.trajectory = write_trajectory(blank_trajectory({"a", "b", "c", "knee"}, {}, 4, 1.0));
     },
     "the trajectory moves joint \"knee\""},
    {"sensor of an object",
     [](ChainOptions& o) {
       o.sensor =
           R"(<plugin name="s" plugin="legwright.gait" instance="gait"
                            objtype="body" objname="upper"/>)";
     },
     "sensor \"s\": expected no objtype"},
};

TEST_F(BadDataTest, IsRefusedAtCompileWithTheReason) {
  ASSERT_TRUE(load(plugin_chain(valid_options())).model);  // negative control
  for (const BadModel& bad : kBadModels) {
    ChainOptions options = valid_options();
    bad.spoil(options);
    const Loaded loaded = load(plugin_chain(options));
    EXPECT_FALSE(loaded.model) << bad.what;
    EXPECT_NE(loaded.error.find(bad.message), std::string::npos)
        << bad.what << ": " << loaded.error;
    const std::vector<std::string> warnings = take_warnings();
    EXPECT_LE(warnings.size(), 1u) << bad.what;
    for (const std::string& warning : warnings) {
      EXPECT_NE(warning.find("legwright.gait"), std::string::npos) << warning;
    }
  }
}

TEST_F(BadDataTest, MissingBiasIsRefusedWithTheLineToAdd) {
  std::string xml = plugin_chain(valid_options());
  for (std::size_t at; (at = xml.find(" class=\"pd\" plugin")) != std::string::npos;)
    xml.erase(at, 11);
  const Loaded loaded = load(xml);
  EXPECT_FALSE(loaded.model);
  EXPECT_NE(loaded.error.find("<general biastype=\"affine\" biasprm=\"0 -4 -0.1\"/>"),
            std::string::npos)
      << loaded.error;
}

TEST_F(BadDataTest, InstanceWithoutActuatorsIsRefused) {
  std::string xml = plugin_chain(valid_options());
  const std::size_t begin = xml.find("<actuator>"), end = xml.find("</actuator>");
  xml.erase(begin, end - begin + 11);
  const Loaded loaded = load(xml);
  EXPECT_FALSE(loaded.model);
  EXPECT_NE(loaded.error.find("no actuator refers to this instance"), std::string::npos)
      << loaded.error;
}

TEST_F(BadDataTest,
       LogHandlerOfTheTestsSeesErrorsAndWarnings) {  // else these tests would prove nothing
  EXPECT_THROW(mju_error("control"), std::runtime_error);
  mju_warning("control");
  EXPECT_EQ(take_warnings(), std::vector<std::string>{"control"});
}

}  // namespace
}  // namespace legwright
