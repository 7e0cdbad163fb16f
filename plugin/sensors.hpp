// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <iterator>
#include <vector>

#include "plugin/pd_playback.hpp"
#include "plugin/robot_state.hpp"

namespace legwright {

/// What a sensor of `legwright.sensor` measures (plugin/README.md has units and sizes).
enum class SensorKind {
  phase,
  planned_contact,
  measured_contact,
  tracking_error,
  base_error,
  torque_share
};

/// The keys of a sensor's configuration, in the order in which they are registered.
inline constexpr const char* kSensorAttributes[] = {"kind", "gait"};
inline constexpr int kSensorAttributeCount = static_cast<int>(std::size(kSensorAttributes));

/// Number of values of the sensors of an instance of `legwright.sensor`, a guess of 1 where its
/// configuration is wrong: its constructor tells that.
/// @param gait_slot slot of the plugin legwright.gait.
int sensor_size(const mjModel* m, int instance, int gait_slot) noexcept;

/// One instance of `legwright.sensor`: looks at one instance of `legwright.gait`. Immutable.
class GaitSensor {
 public:
  /// Throws ConfigError for an unknown kind, a gait that is not there or is not the only one, feet
  /// that are not in the model, a base that cannot move.
  GaitSensor(const mjModel* m, int instance, int gait_slot);

  int gait() const noexcept { return gait_; }  // the instance it looks at
  /// Writes the values of all sensors that refer to the instance. Allocates nothing.
  void measure(const mjModel* m, mjData* d, const PdPlayback& playback) const noexcept;

 private:
  void write(const mjModel* m, const mjData* d, const PdPlayback& playback,
             mjtNum* out) const noexcept;

  SensorKind kind_;
  int gait_ = -1;
  std::vector<int> sensors_;       // of the model
  std::vector<int> foot_of_geom_;  // for measured contact
  int size_ = 0;
};

/// q* − q [rad or m] of each actuator's joint; what sensors of legwright.gait itself tell as well.
void write_tracking_error(const mjModel* m, const mjData* d, const PdPlayback& playback,
                          mjtNum* out) noexcept;

}  // namespace legwright
