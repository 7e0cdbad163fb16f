// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

#include "plugin/trajectory.hpp"
#include "tools/run/metrics_record.hpp"
#include "tools/validate/flight_path.hpp"

namespace legwright {

/// How a foot kept to the plan, with more than metrics.json tells.
struct FootMeasures : FootMetrics {
  double liftoff_mean = 0.0;  // as touchdown, for the end of the stance [s]
  double liftoff_max = 0.0;
  double landing_mean = 0.0;  // downward speed just before touchdown [m/s]
  double landing_max = 0.0;
  double roll_mean = 0.0;  // angle by which the foot rolled on the ground during one stance [rad]
  double roll_max = 0.0;
};

/// What a foot does at one moment.
struct FootMoment {
  bool in_contact = false;
  double slip_speed = 0.0;                              // of its contact point [m/s]
  double sink_speed = 0.0;                              // of its centre, downwards [m/s]
  Eigen::Vector2d roll_rate = Eigen::Vector2d::Zero();  // about the world's x and y [rad/s]
  Eigen::Vector3d sole = Eigen::Vector3d::Zero();       // its lowest point, ground at z = 0 [m]
};

/// Follows one foot through a roll-out. A stride lasts from the middle of one planned swing to the
/// middle of the next; its touchdown is the first contact after the foot was seen off the ground,
/// against the first knot in which the plan puts force on it. A foot that never left the ground
/// touched down when its stride began, and lifted off when it ended; lift-off is the end of the
/// last contact of a stride, against the last knot with force. A step is the longest flight that
/// ends in a stride: a foot that chatters when it lands flies a few more times, but not for long.
class FootWatch {
 public:
  /// @param foot index in the trajectory @param contacts_until record contacts for so long [s]
  /// @param start first time that will be observed: the cycle after it does not count [s]
  FootWatch(const Trajectory& trajectory, int foot, double contacts_until, double start = 0.0);

  /// @param time [s] since phase 0; rising
  void observe(double time, double step, const FootMoment& moment);
  /// @param end_time on the same clock
  FootMeasures finish(double end_time);

 private:
  struct Stride {  // within one cycle
    double begin, touchdown, liftoff;
  };
  struct Now {
    Stride planned;
    bool counts;
    bool was_off = false, is_down = false;
    std::optional<double> touched = std::nullopt, lifted = std::nullopt;
    double slip = 0.0, landing_speed = 0.0;
    std::size_t longest_flight = 0;  // that ended in this stride, in moments
    double clearance = 0.0;          // of that
    Eigen::Vector2d roll = Eigen::Vector2d::Zero();
  };
  struct Tally {  // of one quantity over the stances
    double sum = 0.0, largest = 0.0;
    int count = 0;
    void add(double value);
    double mean() const { return count > 0 ? sum / count : 0.0; }
  };
  Stride stride(long long index) const;
  void close(double time);
  void follow_flight(const FootMoment& moment);

  double period_, contacts_until_, counts_from_;
  std::vector<Stride> strides_;
  long long next_ = 0;
  std::optional<Now> now_;
  std::optional<double> contact_since_;
  double sink_speed_ = 0.0;  // a moment ago
  FlightPath flight_;
  double least_clearance_ = std::numeric_limits<double>::infinity();
  Tally slip_, touchdown_, liftoff_, landing_, roll_, clearance_;
  FootMeasures out_;
};

}  // namespace legwright
