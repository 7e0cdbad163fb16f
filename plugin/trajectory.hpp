// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace legwright {

/// A trajectory that cannot be read or written. The message says where (row, column), what was
/// there and what was expected; it names no file, because the text may come from anywhere.
class TrajectoryError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How a cycle of the gait joins the next one; what a trajectory's table of knots does not say.
struct CycleSettings {
  std::optional<double> period;    // s; without it, the spacing of the knots times their number
  std::array<double, 3> travel{};  // m per cycle, world: root, COM and feet move on by this much
  double turn = 0.0;               // rad per cycle, added to root_rz
};

/// One period of a gait: knots 0 … T−1 as rows of a table, and how the next period joins on.
/// Frames: world z up; root rotation as rotation vector, world from trunk; forces act on the foot.
struct Trajectory {
  double period = 0.0;  // s
  std::array<double, 3> travel{};
  double turn = 0.0;
  std::vector<std::string> joint_names;
  std::vector<bool> joint_slides;  // q in m and tau in N, not rad and N·m; empty: all are hinges
  std::vector<std::string> foot_names;
  int knot_count = 0;
  std::vector<double> table;  // knot_count × column_count(), row by row

  int joint_count() const { return static_cast<int>(joint_names.size()); }
  int foot_count() const { return static_cast<int>(foot_names.size()); }
  bool slides(int joint) const {
    const auto index = static_cast<std::size_t>(joint);
    return index < joint_slides.size() && joint_slides[index];
  }
  int column_count() const { return foot_column(foot_count(), 0); }

  // Columns: time_s is 0, then as named here. `axis` counts x, y, z; of the root also rx, ry, rz (3
  // … 5).
  int target_column(int joint) const { return 1 + joint; }
  int torque_column(int joint) const { return 1 + joint_count() + joint; }
  int root_column(int axis) const { return 1 + 2 * joint_count() + axis; }
  int com_column(int axis) const { return root_column(6) + axis; }
  int foot_column(int foot, int axis) const { return com_column(3) + 7 * foot + axis; }
  int force_column(int foot, int axis) const { return foot_column(foot, 3) + axis; }
  int contact_column(int foot) const { return foot_column(foot, 6); }

  double& at(int knot, int column) { return table[index(knot, column)]; }
  double at(int knot, int column) const { return table[index(knot, column)]; }

  /// Names of the columns, with units, in order: the header of the text.
  std::vector<std::string> header() const;

 private:
  std::size_t index(int knot, int column) const {
    return static_cast<std::size_t>(knot) * static_cast<std::size_t>(column_count()) +
           static_cast<std::size_t>(column);
  }
};

/// A trajectory of zeros with its time column filled in, for a producer to complete.
/// @param period s. Throws TrajectoryError for what parse_trajectory would refuse.
Trajectory blank_trajectory(std::vector<std::string> joint_names,
                            std::vector<std::string> foot_names, int knot_count, double period);

/// Reads the rows of a trajectory (plugin/README.md has the format).
/// Throws TrajectoryError for the first thing that is wrong; the result satisfies check_trajectory.
Trajectory parse_trajectory(std::string_view text, const CycleSettings& cycle = {});

/// Throws TrajectoryError unless names, sizes, numbers and times are such as parse_trajectory
/// accepts.
void check_trajectory(const Trajectory& trajectory);

/// The text that parse_trajectory reads back to the same bits: rows separated by ";\n".
/// Throws TrajectoryError if check_trajectory does.
std::string write_trajectory(const Trajectory& trajectory);

/// The same table for people and spreadsheets: commas, line breaks, and a last row for knot T.
/// @param last_knot that row, column_count() numbers; if empty, knot 0 moved on by one cycle.
std::string write_motion_csv(const Trajectory& trajectory, std::span<const double> last_knot = {});

}  // namespace legwright
