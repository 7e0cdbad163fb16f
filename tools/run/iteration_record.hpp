// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/record.hpp"

namespace legwright {

/// The first line of events.jsonl.
struct StartEvent {
  static constexpr RecordKind kKind{"legwright/events", 1, "optimize"};
  std::vector<std::string> tasks;
  std::string robot;
};
void fields(Fields& f, StartEvent& event);

/// Its last line, of a run that came to an end.
struct EndEvent {
  std::string status;
  double F = 0.0, seconds = 0.0;
};
void fields(Fields& f, EndEvent& event);

/// A line of events.jsonl: a design iteration of a run of one task.
struct IterationEvent {
  int index = 0;
  double F = 0.0, J = 0.0;
  ByName<double> terms, s;
  double design_gradient_norm = 0.0;
  int newton_iterations = 0;
  std::string motion_status;
  double speed_reached = 0.0;  // [m/s], on the spot [rad/s]
  double design_step = 0.0, seconds = 0.0;
  std::optional<std::string> start;  // which search it is of
};
void fields(Fields& f, IterationEvent& event);

struct JointTaskIteration {
  double F = 0.0, speed_reached = 0.0;
  int newton_iterations = 0;
  std::string motion_status;
};
void fields(Fields& f, JointTaskIteration& task);

/// The same of a run of several tasks.
struct JointIterationEvent {
  std::string start;   // which search it is of
  bool alone = false;  // for one of the tasks
  int index = 0;
  double F = 0.0;
  ByName<JointTaskIteration> tasks;
  ByName<double> s;
  double design_gradient_norm = 0.0, design_step = 0.0, seconds = 0.0;
};
void fields(Fields& f, JointIterationEvent& event);

/// The iterations that an events.jsonl tells of, in order; of a run of one task, or of several.
struct Iterations {
  std::vector<IterationEvent> single;
  std::vector<JointIterationEvent> joint;
};
/// Up to the first line that is torn. Throws IoError as record_of().
Iterations read_iterations(const std::filesystem::path& events_file);

/// metrics.json beside the design of an iteration, and in result/ until it is validated.
struct IterationMetrics {
  static constexpr RecordKind kKind{"legwright/iteration", 1, "optimize"};
  int index = 0;
  double F = 0.0, J = 0.0;
  ByName<double> terms, s;
  std::array<double, 2> planned_velocity{};
  double speed_reached = 0.0, speed_wanted = 0.0;  // [m/s], on the spot [rad/s]
  double heading_error = 0.0, ground_error = 0.0, slide_share = 0.0, root_residual = 0.0;
  ByName<double> design_gradient;
  double projected_gradient_norm = 0.0;
  int newton_iterations = 0;
  std::string motion_status;
};
void fields(Fields& f, IterationMetrics& metrics);

}  // namespace legwright
