// SPDX-License-Identifier: Apache-2.0
#include "tests/plugin/engine.hpp"

#include <fmt/format.h>

#include <mutex>
#include <stdexcept>
#include <utility>

#include "tests/plugin/toy_trajectory.hpp"

namespace legwright {
namespace {

std::mutex g_mutex;
std::vector<std::string> g_warnings;

void collect(const mjLogMessage* message) {
  if (message->level == mjLOG_ERROR) throw std::runtime_error(message->subject);
  if (message->level != mjLOG_WARNING) return;
  const std::lock_guard lock(g_mutex);
  g_warnings.emplace_back(message->subject);
}

/// The chain up to its actuators, which differ.
std::string chain(const ChainOptions& o, const std::string& extension, const std::string& actuators,
                  const std::string& sensors) {
  return fmt::format(R"(<mujoco>
  {}
  <compiler angle="radian" autolimits="true"/>
  <option integrator="{}" timestep="{}" {}/>
  <size memory="500K"/>
  <default><default class="pd">
    <general biastype="affine" biasprm="0 -{} -{}"/>
    <geom type="capsule" size="0.01" contype="0" conaffinity="0"/>
  </default></default>
  <worldbody>
    <body name="upper" pos="0 0 1">
      <joint name="a" type="{}" axis="0 1 0" armature="0.0005"/>
      <geom class="pd" fromto="0 0 0 0 0 -0.06" mass="0.05"/>
      <body name="middle" pos="0 0 -0.06">
        <joint name="b" axis="0 1 0" armature="0.0005"/>
        <geom class="pd" fromto="0 0 0 0 0 -0.08" mass="0.05"/>
        <body name="lower" pos="0 0 -0.08">
          <joint name="c" axis="1 0 0" armature="0.0005"/>
          <geom class="pd" fromto="0 0 0 0 0 -0.07" mass="0.03"/>
        </body>
      </body>
    </body>
  </worldbody>
  <actuator>{}</actuator>
  <sensor>{}</sensor>
</mujoco>)",
                     extension, o.integrator, o.timestep, o.option, o.bias_kp, o.bias_kd,
                     o.joint_type, actuators, sensors);
}

}  // namespace

Loaded load(const std::string& xml) {
  char error[1024] = "";
  const SpecPointer spec(mj_parseXMLString(xml.c_str(), nullptr, error, sizeof error));
  if (!spec) return {nullptr, error};
  ModelPointer model(mj_compile(spec.get(), nullptr));
  if (model) return {std::move(model), ""};
  return {nullptr, mjs_getError(spec.get())};
}

std::string replace_all(std::string text, const std::string& old_part, const std::string& part) {
  EXPECT_NE(text.find(old_part), std::string::npos) << old_part;
  for (std::size_t at = 0; (at = text.find(old_part, at)) != std::string::npos; at += part.size())
    text.replace(at, old_part.size(), part);
  return text;
}

std::vector<double> roll_out(const mjModel* m, mjData* d, int steps) {
  std::vector<double> history;
  for (int i = 0; i < steps; ++i) {
    mj_step(m, d);
    history.insert(history.end(), d->qpos, d->qpos + m->nq);
    history.insert(history.end(), d->sensordata, d->sensordata + m->nsensordata);
  }
  return history;
}

void EngineTest::SetUpTestSuite() {
  mju_setLogHandler(&collect);
  mj_loadPluginLibrary(LEGWRIGHT_PLUGIN_FILE);  // again and again is harmless
}

void EngineTest::SetUp() { take_warnings(); }

void EngineTest::TearDown() {
  for (const std::string& warning : take_warnings())
    ADD_FAILURE() << "unexpected MuJoCo warning: " << warning;
}

std::vector<std::string> EngineTest::take_warnings() {
  const std::lock_guard lock(g_mutex);
  return std::exchange(g_warnings, {});
}

std::string plugin_chain(const ChainOptions& o) {
  const std::string extension =
      fmt::format(R"(<extension><plugin plugin="legwright.gait"><instance name="gait">
      <config key="kp" value="{}"/><config key="kd" value="{}"/>
      <config key="trajectory" value="{}"/>{}
    </instance></plugin></extension>)",
                  o.kp, o.kd, o.trajectory, o.more_config);
  std::string actuators;
  for (const char* const joint : {"b", "a", "c"}) {  // not in the order of the trajectory's columns
    actuators += fmt::format(
        R"(<plugin name="drive_{0}" class="pd" plugin="legwright.gait" instance="gait"
                       joint="{0}" {1}/>)",
        joint, o.actuator);
  }
  return chain(o, extension, actuators + o.more_actuators, o.sensor);
}

std::string native_chain(const ChainOptions& o) {
  std::string actuators;
  for (const char* const joint : {"b", "a", "c"}) {
    actuators +=
        fmt::format(R"(<pid name="drive_{0}" joint="{0}" kp="{1}" kv="{2}" input="pos vel ff"/>)",
                    joint, o.kp, o.kd);
  }
  return chain(o, "", actuators, "");
}

Trajectory chain_trajectory() { return toy_trajectory(3, 1, 12, 0.6, 11, 0.4); }

ChainOptions valid_options() {
  ChainOptions options;
  options.trajectory = write_trajectory(chain_trajectory());
  return options;
}

}  // namespace legwright
