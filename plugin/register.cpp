// SPDX-License-Identifier: Apache-2.0
// Registers `legwright.gait` when the library is loaded. The callbacks hand over to PdPlayback and
// keep every failure inside: no exception, no mju_error, no exit leaves this file.
#include <mujoco/mujoco.h>

#include <cstdint>
#include <exception>

#include "plugin/pd_playback.hpp"
#include "plugin/playback_config.hpp"

namespace legwright {
namespace {

PdPlayback* playback_of(const mjData* d, int instance) noexcept {
  return reinterpret_cast<PdPlayback*>(d->plugin_data[instance]);
}

int refuse(const mjModel* m, int instance, const char* reason) noexcept {
  const char* const name = mj_id2name(m, mjOBJ_PLUGIN, instance);
  mju_warning("legwright.gait \"%.40s\": %.400s", name == nullptr ? "" : name, reason);
  return -1;
}

/// Only the model and the configuration can be trusted here: the rest of mjData is not initialised
/// yet.
int init(const mjModel* m, mjData* d, int instance) noexcept {
  d->plugin_data[instance] = 0;
  if (mj_version() != mjVERSION_HEADER) {
    return refuse(m, instance,
                  "built for another version of MuJoCo; rebuild Legwright with this one");
  }
  try {
    d->plugin_data[instance] = reinterpret_cast<std::uintptr_t>(new PdPlayback(m, instance));
    return 0;
  } catch (const std::exception& error) {
    return refuse(m, instance, error.what());
  } catch (...) {
    return refuse(m, instance, "unknown failure");
  }
}

void destroy(mjData* d, int instance) noexcept {
  delete playback_of(d, instance);
  d->plugin_data[instance] = 0;
}

void compute(const mjModel* m, mjData* d, int instance, int capability) noexcept {
  const PdPlayback* const playback = playback_of(d, instance);
  if (playback == nullptr) return;
  if (capability == mjPLUGIN_ACTUATOR) playback->apply_torque(m, d);
  if (capability == mjPLUGIN_SENSOR) playback->measure_tracking_error(m, d, instance);
}

void register_plugin() noexcept {
  mjpPlugin plugin;
  mjp_defaultPlugin(&plugin);
  plugin.name = "legwright.gait";
  plugin.nattribute = kAttributeCount;
  plugin.attributes = kAttributes;
  plugin.capabilityflags = mjPLUGIN_ACTUATOR | mjPLUGIN_SENSOR;
  plugin.needstage = mjSTAGE_POS;
  plugin.nstate = +[](const mjModel*, int) noexcept { return 0; };
  plugin.nsensordata =
      +[](const mjModel* m, int instance, int) noexcept { return servo_count(m, instance); };
  plugin.init = &init;
  plugin.destroy = &destroy;
  plugin.reset =
      +[](const mjModel*, mjtNum*, void*, int) noexcept {};  // nothing to reset, but required
  plugin.compute = &compute;
  mjp_registerPlugin(&plugin);
}

}  // namespace
}  // namespace legwright

mjPLUGIN_LIB_INIT(legwright_gait) { legwright::register_plugin(); }
