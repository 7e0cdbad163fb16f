// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/build_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "mjcf/assembly/assembly_names.hpp"
#include "mjcf/assembly/assembly_xml.hpp"
#include "mjcf/assembly/cable_notes.hpp"
#include "mjcf/assembly/limb_hulls.hpp"
#include "mjcf/assembly/linear_joint.hpp"
#include "mjcf/assembly/overlap_words.hpp"
#include "mjcf/assembly/print_bounds.hpp"
#include "mjcf/assembly/reflected_inertia.hpp"
#include "mjcf/assembly/tray_mass.hpp"
#include "mjcf/propose/declare.hpp"
#include "mjcf/propose/standing_pose.hpp"
#include "mjcf/read/feet.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

constexpr double kClearanceMissed = 1e-3;  // of it
constexpr double kHeightGrain = 1e6;       // heights are written to a millionth of a metre

/// Height of the trunk's frame at which what reaches lowest touches the ground [m].
double standing_height(const Assembly& assembly, const std::filesystem::path& file) {
  Assembly plain = assembly;
  plain.link_shape = LinkShape::capsule;  // hulls do not touch
  const ModelPointer model = compile_mjcf(assembly_xml(plain, 0.0), file);
  const DataPointer data = kinematics_at(*model, nullptr, file);
  double low = std::numeric_limits<double>::infinity();
  for (int g = 0; g < static_cast<int>(model->ngeom); ++g)
    if (collides(*model, g)) low = std::min(low, lowest_point(*model, *data, g));
  return std::round(-low * kHeightGrain) / kHeightGrain;
}

/// Keyframe `home`: the pose that was found, or the vectors as they are.
std::string home_key(const Assembly& assembly, double height,
                     const std::optional<StandingPose>& pose) {
  std::string zeros, controls;
  for (const PlacedLimb& limb : placed_limbs(assembly))
    for (const AssemblyJoint& joint : limb.of->joints) {
      zeros += " 0";
      controls += " " + (joint.is_linear() ? format_number(rounded(length_at(joint, 0.0))) : "0");
    }
  const std::string qpos =
      pose ? pose->qpos : fmt::format("0 0 {} 1 0 0 0{}", format_number(height), zeros);
  return fmt::format("<key name=\"home\" qpos=\"{}\" ctrl=\"{}\"/>", qpos,
                     pose ? pose->ctrl : controls.substr(1));
}

/// The links whose printed parts come nearer to the servo that turns them than asked for, and those
/// for whose modules there is none; of mirror images and copies each.
std::vector<std::string> notes_on_hulls(const Assembly& assembly) {
  std::vector<std::string> near, none, sliding, out;
  if (assembly.link_shape == LinkShape::capsule) return out;
  for (const PlacedLimb& limb : placed_limbs(assembly)) {
    const std::vector<LinkHulls> hulls = limb_hulls(assembly, limb);
    for (std::size_t k = 0; k < hulls.size(); ++k) {
      const std::string name = link_name(limb, limb.of->joints[k]);
      if (at_linear_joint(*limb.of, k))
        sliding.push_back(name);
      else if (hulls[k].hulls.empty())
        none.push_back(name);
      else if (hulls[k].clearance < (1.0 - kClearanceMissed) * assembly.link_clearance)
        near.push_back(fmt::format("{} {:.1f} mm", name, 1e3 * hulls[k].clearance));
    }
  }
  if (!near.empty())
    out.push_back(
        fmt::format("printed parts come nearer to the servo that turns them than {:.3g} mm: {}; "
                    "turn the servo by roll, move the next joint away or narrow its range",
                    1e3 * assembly.link_clearance, fmt::join(near, ", ")));
  if (!none.empty())
    out.push_back(
        fmt::format("no attachment of the next module faces the horn of {}: capsules are printed "
                    "there; [[attachment]] in the module's file gives one",
                    fmt::join(none, ", ")));
  if (!sliding.empty())
    out.push_back(
        fmt::format("links at linear actuators are capsules, with arms to their pivots: {}; "
                    "`legwright parts` prints none of them",
                    fmt::join(sliding, ", ")));
  return out;
}

/// What of servos and feet is not known, once each.
std::vector<std::string> notes_on(const Assembly& assembly) {
  std::set<std::string> continuous, feet;
  for (const AssemblyLimb& limb : assembly.limbs) {
    if (!limb.foot.friction) feet.insert(limb.foot.name);
    for (const AssemblyJoint& joint : limb.joints) {
      const bool known = joint.is_linear() ? joint.servo.slide->continuous_force.has_value()
                                           : joint.servo.joint->continuous_torque.has_value();
      if (!known) continuous.insert(joint.servo.name);
    }
  }
  std::vector<std::string> out = notes_on_inertia(assembly);
  if (assembly.torque == TorqueLimit::continuous && !continuous.empty())
    out.push_back(
        fmt::format("the continuous torque of {} is not known: the stall torque is the "
                    "limit of their joints; lower it by torque_share",
                    fmt::join(continuous, ", ")));
  if (!feet.empty())
    out.push_back(
        fmt::format("the friction of {} is not known: {} is assumed, rubber on a dry floor; "
                    "[foot] friction in the module's file gives it",
                    fmt::join(feet, ", "), kFootFriction));
  return out;
}

/// Why a proposal is none for a robot with linear actuators: the body of one stays on its mount,
/// and its pivots lie in a plane square to the joint's axis. Empty where it is one.
std::string why_not_changed(const Assembly& assembly, const Proposal& proposal) {
  const auto names = [&](const std::string& name) {
    return (proposal.binding + " ").find(" " + name + " ") != std::string::npos;
  };
  for (const PlacedLimb& limb : placed_limbs(assembly))
    for (const AssemblyJoint& joint : limb.of->joints) {
      if (!joint.is_linear()) continue;
      if (proposal.binding.starts_with("place ") && names(mount_name(limb, joint)))
        return "the body of the linear actuator stays where mount says";
      if (proposal.binding.starts_with("axis ") && names(joint_name(limb, joint)))
        return fmt::format(
            "the axis of joint {} stays square to the plane in which its linear actuator pushes",
            joint_name(limb, joint));
    }
  return "";
}

/// What may change, without what linear actuators keep.
std::vector<Proposal> without_linear(const Assembly& assembly,
                                     const std::vector<Proposal>& proposals,
                                     std::vector<std::string>& left_out) {
  std::vector<Proposal> out;
  for (const Proposal& proposal : proposals)
    if (const std::string why = why_not_changed(assembly, proposal); why.empty())
      out.push_back(proposal);
    else
      left_out.push_back(proposal.name + ": " + why);
  return out;
}

/// Throws InputError where the robot, of which no other pose to stand in was found, is drawn at an
/// angle that a joint does not reach.
void check_drawn_angles(const Assembly& assembly) {
  for (const PlacedLimb& limb : placed_limbs(assembly))
    for (const AssemblyJoint& joint : limb.of->joints)
      if (joint.range && ((*joint.range)[0] > 0.0 || (*joint.range)[1] < 0.0))
        throw InputError(fmt::format(
            "joint \"{}\" of limb \"{}\" has the range [{}, {}], outside of which it is drawn, at "
            "zero, and no pose is found in which the robot stands within all ranges; draw the limb "
            "at an angle that the joint reaches, from which its range then counts",
            joint.name, limb.name, (*joint.range)[0], (*joint.range)[1]));
}

void append(std::vector<std::string>& to, const std::vector<std::string>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// The largest trunk of a design, by its sizes as drawn.
Eigen::Vector3d largest_trunk(const std::vector<Proposal>& proposals) {
  Eigen::Vector3d out = Eigen::Vector3d::Ones();
  for (const Proposal& each : proposals) {
    if (each.binding == "stretch x: trunk") out.x() = each.upper / each.value;
    if (each.binding == "stretch y: trunk") out.y() = each.upper / each.value;
  }
  return out;
}

/// Of the mass of a printed trunk, which is `tray` [kg].
std::string tray_note(const Assembly& assembly, double tray) {
  const std::string as =
      fmt::format("its tray, of {:.4g} kg/m3, is printed for the largest of its designs",
                  assembly.link_density);
  if (assembly.trunk_as_printed)
    return fmt::format(
        "the trunk weighs {:.3g} kg, as {}; mass under [trunk] is for one that is heavier, as with "
        "electronics and cables",
        tray, as);
  return fmt::format(
      "the trunk weighs {:.3g} kg, as {}, and not the {:.3g} kg of its {}: a mass that is left out "
      "is that of the tray",
      tray, as, assembly.trunk.mass,
      assembly.trunk_line > 0 ? fmt::format("file (line {})", assembly.trunk_line) : "module");
}

/// @param largest the trunk of its largest design
BuiltRobot built_as_given(const Assembly& assembly, const std::filesystem::path& file,
                          Eigen::Vector3d& largest) {
  const double height = standing_height(assembly, file);
  const std::string body = assembly_xml(assembly, height);
  const std::optional<StandingPose> pose = find_standing_pose(body, file);
  if (!pose) check_drawn_angles(assembly);
  const std::string standing =
      with_lines_in_section(body, file, "keyframe", {home_key(assembly, height, pose)});
  const ProposedParameters proposed = propose_parameters(standing, file);
  if (!proposed.not_standing.empty())
    throw InputError(file.string(), 0, "",
                     fmt::format("the robot does not stand: {}; draw its limbs below the trunk, or "
                                 "stretched out downwards, from where a pose is searched for",
                                 proposed.not_standing));
  std::vector<std::string> left_out = proposed.left_out;
  const std::vector<Proposal> proposals = without_linear(assembly, proposed.proposals, left_out);
  const PrintBounds bounds =
      assembly.print ? print_bounds(assembly, proposals) : PrintBounds{proposals, {}, {}};
  BuiltRobot out;
  largest = largest_trunk(bounds.proposals);
  out.xml = with_declarations(standing, file, bounds.proposals);
  out.found = propose_parameters(out.xml, file);
  out.found.left_out = left_out;
  append(out.found.left_out, bounds.left_out);
  if (pose) out.pose = pose->words;
  out.overlaps = module_overlaps(*compile_mjcf(out.xml, file), file);
  for (const std::vector<std::string>& notes :
       {overlap_notes(assembly, out.overlaps), notes_on(assembly), notes_on_hulls(assembly),
        notes_on_cables(assembly), bounds.notes})
    append(out.notes, notes);
  return out;
}

}  // namespace

BuiltRobot build_robot(const Assembly& assembly, const std::filesystem::path& file) {
  Eigen::Vector3d largest;
  BuiltRobot out = built_as_given(assembly, file, largest);
  if (!assembly.print) return out;
  const double tray = tray_mass(assembly, largest);
  if (tray <= assembly.trunk.mass && !assembly.trunk_as_printed) return out;
  Assembly weighed = assembly;
  weighed.trunk.mass = tray;
  out = built_as_given(weighed, file, largest);
  out.notes.push_back(tray_note(assembly, tray));
  return out;
}

}  // namespace legwright
