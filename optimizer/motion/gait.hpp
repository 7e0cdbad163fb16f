// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace legwright {

/// Phases closer than this are the same: 3/24 and 0.125 must agree whatever the rounding.
inline constexpr double kPhaseTolerance = 1e-9;

/// A footfall pattern: when each foot touches down, as a fraction of the cycle, and for how long.
struct GaitPattern {
  std::string name;
  std::vector<double> touchdown;       // per foot in footfall order (see footfall_order), in [0, 1)
  double duty = 0.75;                  // stance fraction of the cycle, 0 < duty ≤ 1
  std::vector<double> foot_duty = {};  // where feet differ: per foot in footfall order; else empty
  std::string about = {};              // what it is and whose measure, in a sentence

  double duty_of(std::size_t place) const { return foot_duty.empty() ? duty : foot_duty[place]; }
  /// Whether the foot of this place is on the ground at a phase of the cycle; at its touchdown it
  /// is, at its lift-off it is not, whatever the rounding.
  bool stands(std::size_t place, double phase) const;
};

/// How many feet are on the ground over a cycle.
struct SupportRange {
  int least = 0, most = 0;
  bool operator==(const SupportRange&) const = default;
};

/// The library's patterns for a robot of `foot_count` feet; empty if there is none: for one and for
/// three feet. Five, seven and more than eight have a wave only.
std::vector<GaitPattern> gait_library(int foot_count);

/// Numbers of feet with gaits, up to eight: those that messages list.
std::vector<int> gait_library_feet();

/// Short names of the places in footfall order: FL, FR, HL, HR for four feet, L1, R1, L2 … for
/// eight; "1", "2", … where there are no usual ones.
std::vector<std::string> footfall_places(int foot_count);

/// The places that touch down together, in the order of their touchdowns from phase 0 on.
std::vector<std::vector<int>> touchdown_order(const GaitPattern& pattern);

/// Least and most feet on the ground at any time of the cycle, from the phases themselves.
SupportRange support_range(const GaitPattern& pattern);

/// Knots of a stance, both included; beyond 0 … T − 1 where it passes the end of the cycle.
struct Stance {
  int first = 0, last = 0;
};

/// c_i^j over one cycle as data: knots × feet, in the robot's foot order. Knot `knot_count` is knot
/// 0.
class Gait {
 public:
  Gait() = default;
  /// @param order footfall_order() of the robot. Throws std::invalid_argument where a foot has no
  /// stance knot.
  Gait(const GaitPattern& pattern, double period, int knot_count, const std::vector<int>& order);

  const std::string& name() const { return name_; }
  double period() const { return period_; }       // [s]
  int knot_count() const { return knot_count_; }  // T
  int foot_count() const { return static_cast<int>(contact_.cols()); }
  double time_step() const { return period_ / knot_count_; }  // h [s]
  bool in_contact(int knot, int foot) const { return contact_(wrap(knot), foot); }
  /// Contact widened by `margin` knots on both sides: the two halves of eq (14) and a margin of
  /// time.
  bool planted(int knot, int foot, int margin) const;
  /// The stance, widened so, that a planted knot belongs to; of a foot that never lifts a cycle to
  /// either side.
  Stance stance_around(int knot, int foot, int margin) const;

 private:
  int wrap(int knot) const { return ((knot % knot_count_) + knot_count_) % knot_count_; }

  std::string name_;
  double period_ = 1.0;
  int knot_count_ = 0;
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> contact_;
};

/// Least and most feet on the ground at any knot.
SupportRange support_range(const Gait& gait);

/// Feet from front to hind, left before right, by their positions (x forward, y left) [m]: the
/// order in which GaitPattern lists them. Feet closer than a fifth of the longest side along x
/// share a row.
std::vector<int> footfall_order(const std::vector<Eigen::Vector3d>& feet);

/// The gait as a footfall diagram of text: one line per foot, # stance, . swing.
std::string footfall_diagram(const Gait& gait, const std::vector<std::string>& foot_names);

}  // namespace legwright
