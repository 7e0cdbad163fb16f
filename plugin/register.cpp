// SPDX-License-Identifier: Apache-2.0
// Registers `legwright.gait` and `legwright.sensor` when the library is loaded. The callbacks hand
// over to PdPlayback, GaitView and GaitSensor and keep every failure inside: no exception, no
// mju_error, no exit leaves this file.
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "plugin/gait_view.hpp"
#include "plugin/pd_playback.hpp"
#include "plugin/playback_config.hpp"
#include "plugin/sensors.hpp"
#include "plugin/told.hpp"

namespace legwright {
namespace {

constexpr const char* kGait = "legwright.gait";
constexpr const char* kSensor = "legwright.sensor";

/// Which MuJoCo the file serves, for who reads it without loading it: `strings`, and
/// served_mujoco() of tools/simulate.
[[gnu::used]] constexpr char kServes[] = "legwright.gait for MuJoCo " LEGWRIGHT_SERVED_MUJOCO;
static_assert(mjVERSION_HEADER == LEGWRIGHT_SERVED_HEADER, "headers of another MuJoCo");

/// Sensors of legwright.gait itself tell the tracking error.
void check_own_sensors(const mjModel* m, int instance) {
  for (int sensor = 0; sensor < m->nsensor; ++sensor) {
    if (m->sensor_plugin[sensor] == instance && m->sensor_objtype[sensor] != mjOBJ_UNKNOWN) {
      throw ConfigError("sensor " + name_of(m, mjOBJ_SENSOR, sensor) +
                        ": expected no objtype: it has a value for each actuator of the instance");
    }
  }
}

int gait_slot() noexcept {
  int slot = -1;
  mjp_getPlugin(kGait, &slot);
  return slot;
}

/// What an instance of legwright.gait keeps for one mjData.
struct Gait {
  static constexpr const char* kPlugin = kGait;
  std::optional<PdPlayback> playback;  // none: the instance is inert
  std::unique_ptr<GaitView> view;      // made when something is first shown; refers to playback
  bool view_failed = false;

  void bind(const mjModel* m, int instance) {
    view.reset();
    view_failed = false;
    playback.reset();
    PdPlayback bound(m, instance);
    check_own_sensors(m, instance);
    playback.emplace(std::move(bound));
  }
};

/// What an instance of legwright.sensor keeps for one mjData.
struct Sensor {
  static constexpr const char* kPlugin = kSensor;
  std::optional<GaitSensor> measuring;  // none: the instance is inert

  void bind(const mjModel* m, int instance) {
    measuring.reset();
    measuring.emplace(m, instance, gait_slot());
  }
};

template <typename Kept>
Kept* kept(const mjData* d, int instance) noexcept {
  return std::bit_cast<Kept*>(d->plugin_data[instance]);
}

/// Whether the model came out of the compiler, which signs it last: there a refusal becomes an
/// error text, later it ends the host.
bool compiled(const mjModel* m) noexcept { return m->signature != 0; }

/// The configuration of an instance, by which the same robot is known in another model.
std::string configuration(const mjModel* m, int instance) {
  std::string text;
  for (const char* const key : {"trajectory", "kp", "kd", "kind", "gait"})
    text += std::string(attribute(m, instance, key)) + '\n';
  return text;
}

/// Says why an instance is refused or, in a model that was edited after it was compiled, inert.
void warn(const mjModel* m, int instance, const char* plugin, const char* reason) noexcept {
  try {
    if (compiled(m) && !first_told(configuration(m, instance), reason)) return;
  } catch (...) {
    return;  // no memory
  }
  const char* name = mj_id2name(m, mjOBJ_PLUGIN, instance);
  for (int s = 0; s < m->nsensor && (name == nullptr || *name == '\0'); ++s)
    if (m->sensor_plugin[s] == instance) name = mj_id2name(m, mjOBJ_SENSOR, s);
  mju_warning("%s \"%.40s\": %.400s%s", plugin, name == nullptr ? "" : name, reason,
              compiled(m) ? "; the model was changed after it was compiled: this instance gives no "
                            "force and measures nothing until data is made or reset after the "
                            "change is taken back (said once)"
                          : "");
}

std::string version_text(int version) {
  return fmt::format("{}.{}.{}", version / 1'000'000, version / 1000 % 1000, version % 1000);
}

/// The loader checks the version by the library's name; this is the second line of defence.
void check_version(int running) {
  if (running == mjVERSION_HEADER) return;
  throw ConfigError(
      fmt::format("built for MuJoCo {}, but this is {}; load the plugin for it, or "
                  "rebuild Legwright with it",
                  version_text(mjVERSION_HEADER), version_text(running)));
}

/// Calls what may throw. Returns whether it did not; a reason is told.
template <typename Try>
bool attempt(const mjModel* m, int instance, const char* plugin, const Try& call) noexcept {
  try {
    call();
    return true;
  } catch (const std::exception& error) {
    warn(m, instance, plugin, error.what());
  } catch (...) {
    warn(m, instance, plugin, "unknown failure");
  }
  return false;
}

/// Makes what an instance keeps. Only the model and the configuration can be trusted here: the rest
/// of mjData is not initialised yet. The compiler gets a refusal; a model that was edited after it
/// is played without the instance.
template <typename Kept>
int init(const mjModel* m, mjData* d, int instance) noexcept {
  d->plugin_data[instance] = 0;
  if (!attempt(m, instance, Kept::kPlugin, [] { check_version(mj_version()); })) return -1;
  std::unique_ptr<Kept> made;
  const bool bound = attempt(m, instance, Kept::kPlugin, [&] {
    made = std::make_unique<Kept>();
    made->bind(m, instance);
  });
  if (!bound && !compiled(m)) return -1;
  d->plugin_data[instance] = reinterpret_cast<std::uintptr_t>(made.release());
  return 0;
}

/// Binds to the model as it is now: what was edited since the last time counts from here on, as if
/// the data were new.
template <typename Kept>
void reset(const mjModel* m, mjtNum*, void* data, int instance) noexcept {
  Kept* const kept = static_cast<Kept*>(data);
  if (kept != nullptr) attempt(m, instance, Kept::kPlugin, [&] { kept->bind(m, instance); });
}

template <typename Kept>
void destroy(mjData* d, int instance) noexcept {
  delete kept<Kept>(d, instance);
  d->plugin_data[instance] = 0;
}

void compute_gait(const mjModel* m, mjData* d, int instance, int capability) noexcept {
  const Gait* const gait = kept<Gait>(d, instance);
  if (gait == nullptr || !gait->playback) return;
  if (capability == mjPLUGIN_ACTUATOR) gait->playback->apply_torque(m, d);
  if (capability != mjPLUGIN_SENSOR) return;
  for (int sensor = 0; sensor < m->nsensor; ++sensor) {
    if (m->sensor_plugin[sensor] == instance)
      write_tracking_error(m, d, *gait->playback, d->sensordata + m->sensor_adr[sensor]);
  }
}

bool anything_shown(const PdPlayback& playback, const mjvOption* option) noexcept {
  return option->flags[mjVIS_COM] != 0 || option->flags[mjVIS_CONTACTPOINT] != 0 ||
         option->flags[mjVIS_CONTACTFORCE] != 0 || option->geomgroup[playback.ghost_group()] != 0;
}

void visualize(const mjModel* m, mjData* d, const mjvOption* option, mjvScene* scene,
               int instance) noexcept {
  Gait* const gait = kept<Gait>(d, instance);
  if (gait == nullptr || !gait->playback || gait->view_failed ||
      !anything_shown(*gait->playback, option))
    return;
  const int before = scene->ngeom;
  try {
    if (!gait->view) gait->view = std::make_unique<GaitView>(m, *gait->playback);
    gait->view->draw(m, d, option, scene);
  } catch (...) {  // no memory: the robot is still to be seen
    scene->ngeom = before;
    gait->view_failed = true;
  }
}

void compute_sensor(const mjModel* m, mjData* d, int instance, int capability) noexcept {
  const Sensor* const sensor = kept<Sensor>(d, instance);
  if (sensor == nullptr || !sensor->measuring || capability != mjPLUGIN_SENSOR) return;
  const Gait* const gait = kept<Gait>(d, sensor->measuring->gait());
  if (gait != nullptr && gait->playback) sensor->measuring->measure(m, d, *gait->playback);
}

/// What both have: nothing is remembered between steps, so there is nothing to copy.
template <typename Kept>
mjpPlugin stateless(const char* const* attributes, int count) noexcept {
  mjpPlugin plugin;
  mjp_defaultPlugin(&plugin);
  plugin.name = Kept::kPlugin;
  plugin.attributes = attributes;
  plugin.nattribute = count;
  plugin.nstate = +[](const mjModel*, int) noexcept { return 0; };
  plugin.init = &init<Kept>;
  plugin.reset = &reset<Kept>;
  plugin.destroy = &destroy<Kept>;
  return plugin;
}

void register_plugins() noexcept {
  mjpPlugin gait = stateless<Gait>(kAttributes, kAttributeCount);
  gait.capabilityflags = mjPLUGIN_ACTUATOR | mjPLUGIN_SENSOR;
  gait.needstage = mjSTAGE_POS;
  gait.nsensordata =
      +[](const mjModel* m, int instance, int) noexcept { return servo_count(m, instance); };
  gait.compute = &compute_gait;
  gait.visualize = &visualize;
  mjp_registerPlugin(&gait);

  mjpPlugin sensor = stateless<Sensor>(kSensorAttributes, kSensorAttributeCount);
  sensor.capabilityflags = mjPLUGIN_SENSOR;
  sensor.needstage = mjSTAGE_ACC;  // forces are known
  sensor.nsensordata = +[](const mjModel* m, int instance, int) noexcept {
    return sensor_size(m, instance, gait_slot());
  };
  sensor.compute = &compute_sensor;
  mjp_registerPlugin(&sensor);
}

}  // namespace
}  // namespace legwright

mjPLUGIN_LIB_INIT(legwright_gait) { legwright::register_plugins(); }
