// SPDX-License-Identifier: Apache-2.0
#include "tools/run/export_readme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/files/clean_text.hpp"

namespace legwright {
namespace {

/// Text within a line of Markdown: every sign that could mean something is escaped.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : clean_utf8(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      default:
        if (std::string_view("\\`*_{}[]#!|~").find(c) != std::string_view::npos) out += '\\';
        out += c;
    }
  }
  return out;
}

/// A block of code, which no line of it can end.
std::string code_block(const std::string& text) { return "    " + clean_utf8(text) + "\n"; }

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("| {} | {} |\n", name, value.empty() ? "unknown" : value);
}

std::string provenance(const ExportFacts& facts) {
  std::string out = "## Where it comes from\n\n| | |\n|---|---|\n";
  out += row("robot", escaped(facts.robot_file));
  out += row("its SHA-256", escaped(facts.robot_sha256));
  out += row("task", escaped(facts.task_file));
  out += row("its SHA-256", escaped(facts.task_sha256));
  out +=
      row("made by", "Legwright " + escaped(facts.version) + ", MuJoCo " + escaped(facts.engine));
  out += row("the search", escaped(facts.status));
  return out + "\nThe command was:\n\n" + code_block(facts.command);
}

/// Rounding errors are none.
std::string number(double value) {
  return fmt::format("{:.6g}", std::abs(value) < 1e-12 ? 0.0 : value);
}

std::string changes(const ExportFacts& facts) {
  std::string out =
      "## What changed\n\nWhat does not follow from these numbers is as it was, byte for byte.\n\n"
      "| parameter | before | after | change | unit | what it is |\n|---|---:|---:|---:|---|---|\n";
  for (const ExportedParameter& p : facts.parameters) {
    const double change = p.after - p.before;
    out +=
        fmt::format("| {} | {} | {} | {} | {} | {} |\n", escaped(p.name), number(p.before),
                    number(p.after), std::abs(change) > 1e-12 ? fmt::format("{:+.6g}", change) : "",
                    escaped(p.unit), escaped(p.sentence));
  }
  if (facts.parameters.empty())
    out += "| none | | | | | the robot declares no design parameter |\n";
  return out + fmt::format("\nMass: {:.6g} kg before, {:.6g} kg after.\n", facts.mass_before,
                           facts.mass_after);
}

std::string judgement(const ExportFacts& facts) {
  std::string out = "## What physics says\n\n";
  for (const std::string& verdict : facts.verdicts) out += "- " + escaped(verdict) + "\n";
  for (const auto& [file, sum] : facts.scenes)
    if (!facts.verdicts.empty())
      out += fmt::format("- Judged: `{}` of the run, SHA-256 `{}`\n", escaped(file), sum);
  for (const std::string& sum : facts.limits)
    out += fmt::format("- Judged by limits with the SHA-256 `{}`\n", escaped(sum));
  if (facts.verdicts.empty() && !facts.chosen_verdict.empty())
    out += "- " + escaped(facts.chosen_verdict) +
           "\n- So the search played it, at half, default and double gains; `legwright validate`, "
           "which also disturbs it and changes the numerics, was not run.\n";
  else if (facts.verdicts.empty())
    out += "- The gait of this design was not validated (`legwright validate`).\n";
  if (facts.servo_kp)
    out += fmt::format(
        "- **Judged with firmer servos than this file has**: those that are softer were played "
        "with kp {0} N m/rad, as far "
        "as their torque limits go. With the file's own gains, or motors that nobody commands, the "
        "gait "
        "is not promised; raise kp here, or command the joints so.\n",
        *facts.servo_kp);
  if (!facts.touches.empty()) out += "- **It touches itself**: " + escaped(facts.touches) + ".\n";
  return out + "- " + escaped(facts.standing) + "\n";
}

/// What the files of the gait hold, for whoever writes a driver.
std::string gait_files(const ExportFacts& facts) {
  if (facts.gaits.empty()) return "";
  const bool several = !facts.gaits.front().empty();
  std::string out = "## The gait\n\n`play.py` walks it in stock MuJoCo, without Legwright:\n\n";
  for (const std::string& task : facts.gaits)
    out += code_block("python play.py --view" + (several ? " " + task : ""));
  const char* const prefix = several ? "TASK_" : "";
  out += fmt::format(
      "\n| file | holds |\n|---|---|\n"
      "| `{0}gait.csv` | one cycle: targets `q:JOINT` [rad; slides m], feed-forward `tau:JOINT` [N "
      "m; N], "
      "and the planned root, COM, feet and their forces, SI units in the names. The rows are "
      "control "
      "points of a periodic uniform cubic B-spline: at row i a target is (q₋ + 4 q + q₊)/6, its "
      "speed "
      "(q₊ − q₋)/(2h), h the step of `time_s`. Torques are linear between the rows. |\n"
      "| `{0}gains.json` | period, travel and turn of a cycle, and each servo's kp, kd and limit: "
      "τ = "
      "kp (q* − q) + kd (dq*/dt − dq/dt) + tau. A servo on a tendon does so along its length L: F "
      "= "
      "kp (L(q*) − L) + kd (dL*/dt − dL/dt) + tau/L′. |\n"
      "| `{0}walk.xml` | the robot as the gait was judged: ground, payload, limits and servos of "
      "its "
      "task, no plugin |\n"
      "| `{0}plugin_walk.xml` | the same played by Legwright's plugin; a comment in it says how to "
      "load that |\n\n",
      prefix);
  return out;
}

/// URDF and the ROS 2 package, with what is lost.
std::string urdf_files(const ExportFacts& facts) {
  if (!facts.urdf) return "";
  std::string out = fmt::format(
      "## URDF\n\n`urdf/{0}.urdf` is the same robot: MuJoCo reads masses, inertias, axes and "
      "ranges "
      "of the MJCF from it. A link's frame is at the anchor of its joint. A URDF has no root that "
      "floats; in MuJoCo it gets one so:\n\n"
      "    spec = mujoco.MjSpec.from_file('urdf/{0}.urdf')\n"
      "    spec.worldbody.first_body().add_freejoint()\n"
      "    model = spec.compile()\n\n"
      "What URDF cannot say, or says otherwise:\n\n",
      facts.name);
  for (const std::string& lost : facts.urdf_lost) out += "- " + escaped(lost) + "\n";
  if (facts.ros_package.empty()) return out + "\n";
  return out +
         fmt::format(
             "\n## ROS 2\n\n`ros/{0}` is a package for a workspace's `src` with that URDF, "
             "each gait as a `trajectory_msgs/JointTrajectory` in `config`, a node that "
             "publishes it cycle by cycle, and a launch file:\n\n"
             "    colcon build --packages-select {0} && source install/setup.bash\n"
             "    ros2 launch {0} walk.launch.py\n\n"
             "The gait is open loop: nothing balances the robot. No controller is configured; "
             "the node's `topic` is that of a joint trajectory controller. Legwright's tests "
             "parse these files but do not run ROS. In `package.xml` fill in maintainer and "
             "licence: the robot's is below.\n\n",
             facts.ros_package);
}

std::string list(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + escaped(name);
  return out;
}

}  // namespace

std::string export_readme(const ExportFacts& facts) {
  std::string out =
      fmt::format("# {}\n\n", escaped(facts.model.empty() ? facts.name : facts.model));
  if (!facts.picture.empty())
    out += fmt::format("![The robot in its home pose]({})\n\n", facts.picture);
  out += fmt::format(
      "A legged robot in MJCF, co-designed with a gait. `{0}.xml` is the robot, `scene.xml` adds a "
      "level floor and the numerics it was judged with, but nothing else of its task: no payload, "
      "slope, weaker motors or stiffer servos; both open in MuJoCo without any plugin:\n\n"
      "    python -m mujoco.viewer --mjcf=scene.xml\n\n",
      facts.name);
  if (!facts.others.empty()) out += "The robot also consists of: " + list(facts.others) + ".\n\n";
  out += gait_files(facts) + urdf_files(facts) + provenance(facts) + "\n" + changes(facts) + "\n" +
         judgement(facts);
  out += "\n## Licence\n\n";
  out += facts.licences.empty()
             ? "No licence stood beside the robot's file. Ask its author before you pass it on.\n"
             : "Carried over from beside the robot's file: " + list(facts.licences) + ".\n";
  return out;
}

}  // namespace legwright
