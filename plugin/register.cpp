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
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "plugin/gait_view.hpp"
#include "plugin/pd_playback.hpp"
#include "plugin/playback_config.hpp"
#include "plugin/sensors.hpp"

namespace legwright {
namespace {

constexpr const char* kGait = "legwright.gait";
constexpr const char* kSensor = "legwright.sensor";

/// Which MuJoCo the file serves, for who reads it without loading it: `strings`, and
/// served_mujoco() of tools/simulate.
[[gnu::used]] constexpr char kServes[] = "legwright.gait for MuJoCo " LEGWRIGHT_SERVED_MUJOCO;
static_assert(mjVERSION_HEADER == LEGWRIGHT_SERVED_HEADER, "headers of another MuJoCo");

/// What an instance of legwright.gait keeps for one mjData.
struct Gait {
  Gait(const mjModel* m, int instance) : playback(m, instance) {}
  PdPlayback playback;
  std::unique_ptr<GaitView> view;  // made when something is first shown
  bool view_failed = false;
};

template <typename Kept>
Kept* kept(const mjData* d, int instance) noexcept {
  return std::bit_cast<Kept*>(d->plugin_data[instance]);
}

int gait_slot() noexcept {
  int slot = -1;
  mjp_getPlugin(kGait, &slot);
  return slot;
}

/// Whether the model came out of the compiler, which signs it last: there a refusal becomes an
/// error text, later it ends the host.
bool compiled(const mjModel* m) noexcept { return m->signature != 0; }

/// Whether the process has not been told of this configuration before. Randomised models come by
/// the thousand, each with another number in its reason.
bool first_time(const mjModel* m, int instance) noexcept {
  try {
    static std::mutex mutex;
    static std::set<std::size_t> told;
    constexpr std::size_t kMost = 1000;
    std::string text;
    for (const char* const key : {"trajectory", "kp", "kd", "kind", "gait"})
      text += std::string(attribute(m, instance, key)) + '\n';
    const std::lock_guard lock(mutex);
    return told.size() < kMost && told.insert(std::hash<std::string>()(text)).second;
  } catch (...) {
    return false;  // no memory to remember it by
  }
}

/// The compiler gets a refusal. A model that was edited after it is played without the plugin.
int refuse_instance(const mjModel* m, int instance, const char* plugin, bool ends_host,
                    const char* reason) noexcept {
  if (ends_host && !first_time(m, instance)) return 0;
  const char* name = mj_id2name(m, mjOBJ_PLUGIN, instance);
  for (int s = 0; s < m->nsensor && (name == nullptr || *name == '\0'); ++s)
    if (m->sensor_plugin[s] == instance) name = mj_id2name(m, mjOBJ_SENSOR, s);
  mju_warning("%s \"%.40s\": %.400s%s", plugin, name == nullptr ? "" : name, reason,
              ends_host
                  ? "; the model was changed after it was compiled: it is played without this "
                    "instance, which gives no force and measures nothing (said once)"
                  : "");
  return ends_host ? 0 : -1;
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

/// Makes what an instance keeps. Only the model and the configuration can be trusted here: the rest
/// of mjData is not initialised yet.
template <typename Make>
int init(const mjModel* m, mjData* d, int instance, const char* plugin, const Make& make) noexcept {
  d->plugin_data[instance] = 0;
  bool ends_host = false;
  try {
    check_version(mj_version());
    ends_host = compiled(m);
    d->plugin_data[instance] = reinterpret_cast<std::uintptr_t>(make());
    return 0;
  } catch (const std::exception& error) {
    return refuse_instance(m, instance, plugin, ends_host, error.what());
  } catch (...) {
    return refuse_instance(m, instance, plugin, ends_host, "unknown failure");
  }
}

template <typename Kept>
void destroy(mjData* d, int instance) noexcept {
  delete kept<Kept>(d, instance);
  d->plugin_data[instance] = 0;
}

/// Sensors of legwright.gait itself tell the tracking error.
void check_own_sensors(const mjModel* m, int instance) {
  for (int sensor = 0; sensor < m->nsensor; ++sensor) {
    if (m->sensor_plugin[sensor] == instance && m->sensor_objtype[sensor] != mjOBJ_UNKNOWN) {
      throw ConfigError("sensor " + name_of(m, mjOBJ_SENSOR, sensor) +
                        ": expected no objtype: it has a value for each actuator of the instance");
    }
  }
}

int init_gait(const mjModel* m, mjData* d, int instance) noexcept {
  return init(m, d, instance, kGait, [&] {
    auto gait = std::make_unique<Gait>(m, instance);
    check_own_sensors(m, instance);
    return gait.release();
  });
}

void compute_gait(const mjModel* m, mjData* d, int instance, int capability) noexcept {
  const Gait* const gait = kept<Gait>(d, instance);
  if (gait == nullptr) return;
  if (capability == mjPLUGIN_ACTUATOR) gait->playback.apply_torque(m, d);
  if (capability != mjPLUGIN_SENSOR) return;
  for (int sensor = 0; sensor < m->nsensor; ++sensor) {
    if (m->sensor_plugin[sensor] == instance)
      write_tracking_error(m, d, gait->playback, d->sensordata + m->sensor_adr[sensor]);
  }
}

bool anything_shown(const Gait& gait, const mjvOption* option) noexcept {
  return option->flags[mjVIS_COM] != 0 || option->flags[mjVIS_CONTACTPOINT] != 0 ||
         option->flags[mjVIS_CONTACTFORCE] != 0 ||
         option->geomgroup[gait.playback.ghost_group()] != 0;
}

void visualize(const mjModel* m, mjData* d, const mjvOption* option, mjvScene* scene,
               int instance) noexcept {
  Gait* const gait = kept<Gait>(d, instance);
  if (gait == nullptr || gait->view_failed || !anything_shown(*gait, option)) return;
  const int before = scene->ngeom;
  try {
    if (!gait->view) gait->view = std::make_unique<GaitView>(m, gait->playback);
    gait->view->draw(m, d, option, scene);
  } catch (...) {  // no memory: the robot is still to be seen
    scene->ngeom = before;
    gait->view_failed = true;
  }
}

int init_sensor(const mjModel* m, mjData* d, int instance) noexcept {
  return init(m, d, instance, kSensor,
              [&] { return std::make_unique<GaitSensor>(m, instance, gait_slot()).release(); });
}

void compute_sensor(const mjModel* m, mjData* d, int instance, int capability) noexcept {
  const GaitSensor* const sensor = kept<GaitSensor>(d, instance);
  if (sensor == nullptr || capability != mjPLUGIN_SENSOR) return;
  const Gait* const gait = kept<Gait>(d, sensor->gait());
  if (gait != nullptr) sensor->measure(m, d, gait->playback);
}

/// What both have: nothing is remembered between steps, so there is nothing to reset or to copy.
mjpPlugin stateless(const char* name, const char* const* attributes, int count) noexcept {
  mjpPlugin plugin;
  mjp_defaultPlugin(&plugin);
  plugin.name = name;
  plugin.attributes = attributes;
  plugin.nattribute = count;
  plugin.nstate = +[](const mjModel*, int) noexcept { return 0; };
  plugin.reset = +[](const mjModel*, mjtNum*, void*, int) noexcept {};  // required
  return plugin;
}

void register_plugins() noexcept {
  mjpPlugin gait = stateless(kGait, kAttributes, kAttributeCount);
  gait.capabilityflags = mjPLUGIN_ACTUATOR | mjPLUGIN_SENSOR;
  gait.needstage = mjSTAGE_POS;
  gait.nsensordata =
      +[](const mjModel* m, int instance, int) noexcept { return servo_count(m, instance); };
  gait.init = &init_gait;
  gait.destroy = &destroy<Gait>;
  gait.compute = &compute_gait;
  gait.visualize = &visualize;
  mjp_registerPlugin(&gait);

  mjpPlugin sensor = stateless(kSensor, kSensorAttributes, kSensorAttributeCount);
  sensor.capabilityflags = mjPLUGIN_SENSOR;
  sensor.needstage = mjSTAGE_ACC;  // forces are known
  sensor.nsensordata = +[](const mjModel* m, int instance, int) noexcept {
    return sensor_size(m, instance, gait_slot());
  };
  sensor.init = &init_sensor;
  sensor.destroy = &destroy<GaitSensor>;
  sensor.compute = &compute_sensor;
  mjp_registerPlugin(&sensor);
}

}  // namespace
}  // namespace legwright

mjPLUGIN_LIB_INIT(legwright_gait) { legwright::register_plugins(); }
