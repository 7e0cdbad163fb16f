// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "tools/simulate/rollout.hpp"
#include "tools/validate/foot_watch.hpp"
#include "tools/validate/self_contact.hpp"

namespace legwright {

/// What the task wants of the trunk.
struct WantedMotion {
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // along x, y of the heading frame [m/s]
  double turn_rate = 0.0;                              // [rad/s]
  Eigen::Vector2d forward = Eigen::Vector2d::UnitX();  // where it faces in that frame, for words

  bool travels() const { return velocity.norm() > 1e-6; }
  bool turns() const { return std::abs(turn_rate) > 1e-6; }
};

/// What happened in one roll-out, with all that was seen of its feet.
struct Measurements : RolloutMetrics {
  std::vector<FootMeasures> feet;
};

struct MeasureOptions {
  int settle_cycles = 2;        // left out of the speeds
  double contacts_until = 4.0;  // record contacts of the feet up to here [s]
};

/// Plays a scene and measures, in several goes where it may end early: what has been measured at
/// the end of each is what one roll-out of so many cycles measures, to the bit.
class GaitMeasurement {
 public:
  /// Keeps a reference to the scene. @param plan_velocity that the plan reached along its arc
  /// [m/s], heading frame; zero if unknown
  GaitMeasurement(const Scene& scene, const WantedMotion& wanted,
                  const Eigen::Vector2d& plan_velocity, const RolloutOptions& rollout_options = {},
                  const MeasureOptions& options = {});
  ~GaitMeasurement();
  GaitMeasurement(GaitMeasurement&&) noexcept;

  /// @param also sees each moment of the roll-out from here on
  Measurements play_to(int cycles, const std::function<void(const RolloutSample&)>& also = {});
  /// What was played so far.
  const Rollout& played() const;

 private:
  class Measurer;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Plays the scene and measures. @param plan_velocity that the plan reached along its arc [m/s],
/// heading frame; zero if unknown.
/// @param played if given, receives the roll-out itself (frames).
/// @param also sees each moment of the same roll-out
Measurements measure(const Scene& scene, const WantedMotion& wanted,
                     const Eigen::Vector2d& plan_velocity, const RolloutOptions& rollout_options,
                     const MeasureOptions& options = {}, Rollout* played = nullptr,
                     const std::function<void(const RolloutSample&)>& also = {});

}  // namespace legwright
