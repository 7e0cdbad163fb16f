// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "mjcf/read/read_robot.hpp"
#include "tools/session/history.hpp"
#include "tools/studio/event_hub.hpp"

namespace legwright {

/// A hand that pulls at a body.
struct PhysicsPush {
  int body = -1;                                    // of the drawn model; −1: none
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // world [N]
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // where, in the body's frame [m]
};

/// How the physics are to go on. What is not given is as the task has it.
struct PhysicsSettings {
  bool run = false;
  int task = 0;
  double stiffness = 1.0, damping = 1.0;       // factors on the servos' kp and kd
  std::optional<double> friction;              // of the floor
  std::optional<std::array<double, 2>> slope;  // along and across the way [rad]
  PhysicsPush push;
  double speed = 1.0;       // simulated over real time
  std::uint64_t reset = 0;  // another number: from the start of the gait
};

/// Plays the gait of a session's body in MuJoCo with the gait plugin, in real time on a thread of
/// its own, and tells the hub where everything is. Body and motion change under it as soon as they
/// are solved. Any thread may call.
class PhysicsPlayer {
 public:
  /// @param hub must live longer
  PhysicsPlayer(RobotModel robot, EventHub& hub);
  ~PhysicsPlayer();
  /// Ends it: nothing more is played or told. By one thread at a time.
  void close();
  PhysicsPlayer(const PhysicsPlayer&) = delete;
  PhysicsPlayer& operator=(const PhysicsPlayer&) = delete;

  void set(const PhysicsSettings& settings);
  PhysicsSettings settings() const;
  /// What is to be played from now on, once its motions are solved.
  void show(const StatePointer& state);

 private:
  class Play;
  class Pacing;
  struct Asked {
    PhysicsSettings settings;
    StatePointer state;
  };

  std::optional<Asked> asked(const StatePointer& refused, Pacing& pacing);
  void run();

  RobotModel robot_;
  EventHub& hub_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  PhysicsSettings settings_;
  StatePointer state_;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace legwright
