// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/init_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "mjcf/read/foot_words.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/servos.hpp"
#include "mjcf/read/solver_options.hpp"
#include "mjcf/read/time_step.hpp"
#include "mjcf/read/world_parts.hpp"
#include "mjcf/text/angle_words.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/write/skins.hpp"
#include "tools/task/servo_sag.hpp"

namespace legwright {
namespace {

constexpr std::size_t kWidth = 100;    // of lists [columns]
constexpr double kSamePlace = 0.5e-3;  // what is printed alike [m]

/// A line of the tree: names of a leg, or of a leg and its mirror image, and what holds for them.
struct TreeLine {
  std::string names, what;
};

/// Words behind `head`, in lines of kWidth; those that follow start below the first word.
std::string list_text(const std::string& head, const std::vector<std::string>& words) {
  std::string text = head, line;
  const auto room = kWidth - std::min(kWidth, head.size());
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string word = words[k] + (k + 1 < words.size() ? "," : "");
    if (!line.empty() && line.size() + 1 + word.size() > room) {
      text += line + "\n" + std::string(head.size(), ' ');
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return text + line + "\n";
}

std::string range_text(const Joint& joint, bool in_degrees) {
  if (!std::isfinite(joint.lower) && !std::isfinite(joint.upper)) return "any angle";
  return angle_range_text(joint.lower, joint.upper, in_degrees);
}

std::string servo_text(const Servo& servo) {
  const bool linear = !servo.tendon.empty();
  const std::string limit = std::isfinite(servo.torque_limit)
                                ? fmt::format("{:.4g} {}", servo.torque_limit, linear ? "N" : "N m")
                                : "no limit";
  const std::string kp =
      servo.kp < 1e3 ? fmt::format("{:.4g}", servo.kp) : fmt::format("{:.0f}", servo.kp);
  const std::string line = servo.line
                               ? fmt::format(", none left at {:.3g} {}", servo.line->no_load_speed,
                                             linear ? "m/s" : "rad/s")
                               : "";
  return fmt::format("{:10} kp {} {}", limit + line, kp, linear ? "N/m" : "N m/rad");
}

/// @param place in the chain of the leg, from the trunk down
std::string joint_text(const ProposedParameters& found, const Limb& limb, std::size_t place) {
  const auto link = static_cast<std::size_t>(limb.links[place]);
  return fmt::format("{:8} {:21} {}", axis_name(limb.axes[place]),
                     range_text(found.model.morphology.links[link].joint, found.model.in_degrees),
                     servo_text(found.model.servos[link - 1]));
}

/// Where a leg has joints of its own; those above it are told with all legs that they carry.
std::size_t own_joints(const Limb& limb) { return static_cast<std::size_t>(limb.shared); }

/// Joints between the trunk and several legs, as a waist, each once.
std::vector<TreeLine> shared_joints(const ProposedParameters& found) {
  std::vector<TreeLine> lines;
  std::set<int> told;
  for (const Limb& limb : found.limbs)
    for (std::size_t k = 0; k < own_joints(limb); ++k)
      if (told.insert(limb.links[k]).second)
        lines.push_back(
            {found.model.morphology.links[static_cast<std::size_t>(limb.links[k])].joint.name,
             joint_text(found, limb, k)});
  return lines;
}

const Foot& foot_of(const ProposedParameters& found, const Limb& limb) {
  return found.model.morphology.feet[static_cast<std::size_t>(limb.foot)];
}

/// Two places as far on either side of a plane.
std::string side_text(double metres, double middle) {
  const double apart = std::abs(metres - middle);
  return middle == 0.0 ? fmt::format("+-{:.3f}", apart)
                       : fmt::format("{:.3f}+-{:.3f}", middle, apart);
}

/// @param both whether it tells of both legs of a pair, whose places differ by one sign
std::string foot_text(const ProposedParameters& found, const Limb& limb, bool both) {
  const auto shown = [](double metres) {  // no minus in front of zero
    return std::abs(metres) < kSamePlace ? 0.0 : metres;
  };
  const Across side = sides_across(found.facing.ahead);
  std::string place[3];
  for (int k = 0; k < 3; ++k)
    place[k] = both && k == static_cast<int>(side)
                   ? side_text(limb.home[k], middle_of_sides(found.limbs, side))
                   : fmt::format("{:.3f}", shown(limb.home[k]));
  return fmt::format("foot     {} at {} m", touching_part(found.model, limb.foot),
                     fmt::join(place, ", "));
}

void add_leg(const ProposedParameters& found, const Limb& limb, std::vector<TreeLine>& lines) {
  const auto& links = found.model.morphology.links;
  for (std::size_t k = own_joints(limb); k < limb.links.size(); ++k)
    lines.push_back(
        {links[static_cast<std::size_t>(limb.links[k])].joint.name, joint_text(found, limb, k)});
  lines.push_back({foot_of(found, limb).name, foot_text(found, limb, false)});
}

/// A leg and its mirror image, side by side; beneath each other where ranges, servos or feet
/// differ.
void add_pair(const ProposedParameters& found, const Limb& left, const Limb& right,
              std::vector<TreeLine>& lines) {
  const auto& links = found.model.morphology.links;
  const auto add = [&](const std::string& a, const std::string& a_is, const std::string& b,
                       const std::string& b_is) {
    if (a_is == b_is) {
      lines.push_back({a + " | " + b, a_is});
      return;
    }
    lines.push_back({a, a_is});
    lines.push_back({b, b_is});
  };
  for (std::size_t k = own_joints(left); k < left.links.size(); ++k)
    add(links[static_cast<std::size_t>(left.links[k])].joint.name, joint_text(found, left, k),
        links[static_cast<std::size_t>(right.links[k])].joint.name, joint_text(found, right, k));
  const Across side = sides_across(found.facing.ahead);
  const Eigen::Vector3d image =
      point_in_mirror(right.home, side, middle_of_sides(found.limbs, side));
  const bool both = (left.home - image).norm() < kSamePlace;
  add(foot_of(found, left).name, foot_text(found, left, both), foot_of(found, right).name,
      foot_text(found, right, both));
}

std::string leg_title(const ProposedParameters& found, const Limb& limb) {
  const int rows = found.limbs.back().row + 1;
  std::string row = row_name(limb.row, rows);
  if (rows > 3) row = fmt::format("row {} of {}", limb.row + 1, rows);
  if (limb.partner < 0) return row.empty() ? "leg" : row + (rows > 3 ? ", a leg" : " leg");
  return row.empty() ? "pair, left | right" : row + (rows > 3 ? ", " : " ") + "pair, left | right";
}

std::string title(const ProposedParameters& found) {
  const Morphology& morphology = found.model.morphology;
  return fmt::format("{}: {:.4g} kg, {} leg{}, {} joints that move\n", morphology.name,
                     morphology.total_mass(), morphology.foot_count(),
                     morphology.foot_count() == 1 ? "" : "s", morphology.joint_count());
}

/// "front_thigh_length: why" as {name, why}.
std::pair<std::string, std::string> split(const std::string& left_out) {
  const std::size_t colon = left_out.find(": ");
  if (colon == std::string::npos) return {left_out, ""};
  return {left_out.substr(0, colon), left_out.substr(colon + 2)};
}

/// "front_thigh_length (thigh_length)" for a proposal that was left out because the file declares
/// the same by another name; else empty.
std::string other_name(const std::string& name, const std::string& why) {
  const std::string start = "text 'legwright/", clash = "already stretched";
  const std::size_t end = why.find('\'', start.size());
  if (why.rfind(start, 0) != 0 || end == std::string::npos ||
      why.find(clash) == std::string::npos ||
      why.find("by 'legwright/" + name + "'") == std::string::npos)
    return "";
  return fmt::format("{} ({})", name, why.substr(start.size(), end - start.size()));
}

std::string left_out_text(const std::vector<std::string>& left_out) {
  std::vector<std::pair<std::string, std::vector<std::string>>> reasons;
  std::vector<std::string> others;
  for (const std::string& line : left_out) {
    const auto [name, why] = split(line);
    if (const std::string other = other_name(name, why); !other.empty()) {
      others.push_back(other);
      continue;
    }
    const auto same =
        std::find_if(reasons.begin(), reasons.end(),
                     [&, &because = why](const auto& reason) { return reason.first == because; });
    if (same == reasons.end())
      reasons.push_back({why, {name}});
    else
      same->second.push_back(name);
  }
  std::string text;
  if (!others.empty()) text += list_text("declared  by other names: ", others);
  for (const auto& [why, names] : reasons)
    text += list_text("left out  ", names) + "          " + why + "\n";
  return text;
}

std::string table_of(const std::vector<Proposal>& proposals) {
  std::size_t width = 4;
  for (const Proposal& p : proposals) width = std::max(width, p.name.size());
  std::string text = fmt::format("  {:{}}  {:>7}  {:>7}  {:>7}  {:4} {}\n", "name", width, "now",
                                 "from", "to", "unit", "moves");
  for (const Proposal& p : proposals)
    text += fmt::format("  {:{}}  {:7.4f}  {:7.4f}  {:7.4f}  {:4} {}\n", p.name, width, p.value,
                        p.lower, p.upper, p.unit, p.binding);
  return text;
}

/// What keeps the robot from standing in its home pose.
std::string standing_notes(const ProposedParameters& found) {
  std::string text;
  for (const std::string& note :
       {weak_motors_text(servo_sag(found.model).hardest), found.not_standing})
    if (!note.empty()) text += "  " + note + "\n";
  return text;
}

}  // namespace

std::string file_notes(const RobotModel& robot) {
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  std::string text;
  for (const std::string& note :
       {describe_surroundings(surroundings_of(*model)),
        describe_overridden(overridden_options(model->opt, step_of_scenes(robot.servos))),
        describe_skins(*model), describe_dynamics(robot.servos), describe_step(robot.servos)})
    if (!note.empty()) text += "  " + note + "\n";
  return text;
}

std::string robot_tree(const ProposedParameters& found) {
  std::vector<std::pair<std::string, std::vector<TreeLine>>> legs;
  if (std::vector<TreeLine> shared = shared_joints(found); !shared.empty())
    legs.emplace_back("above several legs", std::move(shared));
  for (std::size_t k = 0; k < found.limbs.size(); ++k) {
    const Limb& limb = found.limbs[k];
    if (limb.partner >= 0 && limb.partner < static_cast<int>(k)) continue;  // beside the other
    auto& [name, lines] = legs.emplace_back(leg_title(found, limb), std::vector<TreeLine>{});
    if (limb.partner < 0)
      add_leg(found, limb, lines);
    else
      add_pair(found, limb, found.limbs[static_cast<std::size_t>(limb.partner)], lines);
  }
  std::size_t width = 0;
  for (const auto& [name, lines] : legs)
    for (const TreeLine& line : lines) width = std::max(width, line.names.size());
  std::string text = title(found) + fmt::format("trunk {}\n", found.model.root_body);
  for (const auto& [name, lines] : legs) {
    text += "  " + name + "\n";
    for (const TreeLine& line : lines)
      text += fmt::format("    {:{}}  {}\n", line.names, width, line.what);
  }
  return text + held_text(found.model.structure) + file_notes(found.model) + standing_notes(found);
}

std::string robot_summary(const ProposedParameters& found) {
  return title(found) + held_text(found.model.structure) + file_notes(found.model) +
         standing_notes(found);
}

std::string proposal_summary(const ProposedParameters& found) {
  const auto lengths = std::count_if(found.proposals.begin(), found.proposals.end(),
                                     [](const Proposal& p) { return p.unit == "m"; });
  const auto angles = static_cast<std::ptrdiff_t>(found.proposals.size()) - lengths;
  const int had = found.model.space.size();
  return fmt::format("{} design parameter{} ({} length{}, {} angle{}) in its <custom> section{}\n",
                     found.proposals.size(), found.proposals.size() == 1 ? "" : "s", lengths,
                     lengths == 1 ? "" : "s", angles, angles == 1 ? "" : "s",
                     had > 0 ? fmt::format(", beside the {} that were there", had) : "");
}

std::string declared_summary(const ProposedParameters& found) {
  const int had = found.model.space.size();
  return had == 0 ? "nothing to write: no design parameter can be proposed\n"
                  : fmt::format("nothing to add: the file declares {} design parameter{}\n", had,
                                had == 1 ? "" : "s");
}

std::string proposal_table(const ProposedParameters& found) {
  const std::size_t count = found.proposals.size();
  std::vector<std::string> declared;
  for (const DesignParameter& parameter : found.model.space.parameters)
    declared.push_back(parameter.name);
  std::string text = "\n";
  if (!declared.empty())
    text += list_text(fmt::format("declared  {}: ", declared.size()), declared);
  if (count > 0)
    text += fmt::format("{}{} design parameter{} {}:\n", count, declared.empty() ? "" : " more",
                        count == 1 ? "" : "s", declared.empty() ? "proposed" : "could be added") +
            table_of(found.proposals);
  else if (declared.empty())
    text += "no design parameter can be proposed: the body stays, only the motion is planned\n";
  return text + left_out_text(found.left_out);
}

}  // namespace legwright
