// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plugin/trajectory.hpp"

namespace legwright {

/// How a foot kept to the plan. Strides of the first cycle do not count.
struct FootMeasures {
  std::string name;
  int stances = 0;         // complete ones that were looked at
  double slip_mean = 0.0;  // path of the contact point on the ground during one stance [m]
  double slip_max = 0.0;
  int missed = 0;               // planned stances in which the foot never touched the ground
  double touchdown_mean = 0.0;  // actual minus planned time of touchdown [s]: positive is late
  double touchdown_max = 0.0;   // largest magnitude of that [s]
  /// Stances of the plan in the first cycle, [touchdown, last knot with force] [s]; the second may
  /// exceed the period.
  std::vector<std::pair<double, double>> planned;
  std::vector<std::pair<double, double>> contacts;  // measured, from the start up to a limit [s]
};

/// Follows one foot through a roll-out. A stride lasts from the middle of one planned swing to the
/// middle of the next; its touchdown is the first contact after the foot was seen off the ground,
/// against the first knot in which the plan puts force on it. A foot that never left the ground
/// touched down when its stride began.
class FootWatch {
 public:
  /// @param foot index in the trajectory @param contacts_until record contacts up to here [s]
  FootWatch(const Trajectory& trajectory, int foot, double contacts_until);

  /// @param time [s] since phase 0; rising @param slip_speed of the contact point, if any [m/s]
  void observe(double time, double step, bool in_contact, double slip_speed);
  FootMeasures finish(double end_time);

 private:
  struct Stride {  // within one cycle
    double begin, touchdown;
  };
  struct Now {
    double begin, touchdown;
    bool counts;
    bool was_off = false;
    std::optional<double> touched = std::nullopt;
    double slip = 0.0;
  };
  Stride stride(long long index) const;
  void close();

  double period_, contacts_until_;
  std::vector<Stride> strides_;
  long long next_ = 0;
  std::optional<Now> now_;
  std::optional<double> contact_since_;
  double slip_sum_ = 0.0, touchdown_sum_ = 0.0;
  int touchdowns_ = 0;
  FootMeasures out_;
};

}  // namespace legwright
