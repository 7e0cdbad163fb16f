// SPDX-License-Identifier: Apache-2.0
#include "tools/run/iteration_record.hpp"

#include "tools/run/events.hpp"

namespace legwright {

void fields(Fields& f, StartEvent& event) {
  f.constant("event", "start");
  f("tasks", event.tasks);
  f("robot", event.robot);
}

void fields(Fields& f, EndEvent& event) {
  f.constant("event", "end");
  f("status", event.status);
  f("F", event.F);
  f("seconds", event.seconds);
}

void fields(Fields& f, IterationEvent& event) {
  f.constant("event", "iteration");
  f("index", event.index);
  f("F", event.F);
  f("J", event.J, "the further objective of the body");
  f("terms", event.terms, "of F, weighted");
  f("s", event.s, "design parameters, SI");
  f("design_gradient_norm", event.design_gradient_norm, "projected onto the bounds");
  f("newton_iterations", event.newton_iterations);
  f("motion_status", event.motion_status);
  f("speed_reached", event.speed_reached, "of the plan, m/s; on the spot rad/s");
  f("design_step", event.design_step);
  f("seconds", event.seconds);
  f("start", event.start, "which search it is of");
}

void fields(Fields& f, JointTaskIteration& task) {
  f("F", task.F);
  f("speed_reached", task.speed_reached);
  f("newton_iterations", task.newton_iterations);
  f("motion_status", task.motion_status);
}

void fields(Fields& f, JointIterationEvent& event) {
  f.constant("event", "iteration");
  f("start", event.start, "which search it is of");
  f("alone", event.alone, "whether for one of the tasks");
  f("index", event.index);
  f("F", event.F);
  f("tasks", event.tasks);
  f("s", event.s, "design parameters, SI");
  f("design_gradient_norm", event.design_gradient_norm, "projected onto the bounds");
  f("design_step", event.design_step);
  f("seconds", event.seconds);
}

Iterations read_iterations(const std::filesystem::path& events_file) {
  Iterations out;
  const std::string name = events_file.string();
  for (const Json& event : read_events(events_file)) {
    if (!event.is_object() || event.value("event", Json()) != "iteration") continue;
    if (event.contains("tasks"))
      out.joint.push_back(record_of<JointIterationEvent>(event, name));
    else
      out.single.push_back(record_of<IterationEvent>(event, name));
  }
  return out;
}

void fields(Fields& f, IterationMetrics& metrics) {
  f("index", metrics.index);
  f("F", metrics.F);
  f("J", metrics.J, "the further objective of the body");
  f("terms", metrics.terms, "of F, weighted");
  f("s", metrics.s, "design parameters, SI");
  f("planned_velocity", metrics.planned_velocity, "m/s, of the centre of mass over a cycle");
  f("speed_reached", metrics.speed_reached, "of the plan, m/s; on the spot rad/s");
  f("speed_wanted", metrics.speed_wanted);
  f("heading_error_rad", metrics.heading_error);
  f("ground_error_m", metrics.ground_error);
  f("slide_share", metrics.slide_share);
  f("root_residual", metrics.root_residual);
  f("design_gradient", metrics.design_gradient, "dF/ds");
  f("projected_gradient_norm", metrics.projected_gradient_norm);
  f("newton_iterations", metrics.newton_iterations);
  f("motion_status", metrics.motion_status);
}

}  // namespace legwright
