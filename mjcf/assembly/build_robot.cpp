// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/build_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "mjcf/assembly/assembly_xml.hpp"
#include "mjcf/propose/declare.hpp"
#include "mjcf/propose/standing_pose.hpp"
#include "mjcf/read/feet.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

constexpr double kHeightGrain = 1e6;  // heights are written to a millionth of a metre

/// Height of the trunk's frame at which what reaches lowest touches the ground [m].
double standing_height(const Assembly& assembly, const std::filesystem::path& file) {
  const ModelPointer model = compile_mjcf(assembly_xml(assembly, 0.0), file);
  const DataPointer data = kinematics_at(*model, nullptr, file);
  double low = std::numeric_limits<double>::infinity();
  for (int g = 0; g < static_cast<int>(model->ngeom); ++g)
    if (collides(*model, g)) low = std::min(low, lowest_point(*model, *data, g));
  return std::round(-low * kHeightGrain) / kHeightGrain;
}

std::size_t joint_count(const Assembly& assembly) {
  std::size_t count = 0;
  for (const PlacedLimb& limb : placed_limbs(assembly)) count += limb.of->joints.size();
  return count;
}

/// Keyframe `home`: the pose that was found, or the vectors as they are.
std::string home_key(const Assembly& assembly, double height,
                     const std::optional<StandingPose>& pose) {
  std::string zeros;
  for (std::size_t k = 0; k < joint_count(assembly); ++k) zeros += " 0";
  const std::string qpos =
      pose ? pose->qpos : fmt::format("0 0 {} 1 0 0 0{}", format_number(height), zeros);
  return fmt::format("<key name=\"home\" qpos=\"{}\" ctrl=\"{}\"/>", qpos,
                     pose ? pose->ctrl : zeros.substr(1));
}

/// What of the servos is not known, once each.
std::vector<std::string> notes_on(const Assembly& assembly) {
  std::set<std::string> inertia, continuous;
  for (const AssemblyLimb& limb : assembly.limbs)
    for (const AssemblyJoint& joint : limb.joints) {
      if (!joint.servo.joint->reflected_inertia && !assembly.armature)
        inertia.insert(joint.servo.name);
      if (!joint.servo.joint->continuous_torque) continuous.insert(joint.servo.name);
    }
  std::vector<std::string> out;
  if (!inertia.empty())
    out.push_back(
        fmt::format("the reflected inertia of {} is not known: their joints have no "
                    "armature, without which gaits hang on details; armature = 0.004 gives one",
                    fmt::join(inertia, ", ")));
  if (assembly.torque == TorqueLimit::continuous && !continuous.empty())
    out.push_back(
        fmt::format("the continuous torque of {} is not known: the stall torque is the "
                    "limit of their joints; lower it by torque_share",
                    fmt::join(continuous, ", ")));
  return out;
}

}  // namespace

BuiltRobot build_robot(const Assembly& assembly, const std::filesystem::path& file) {
  const double height = standing_height(assembly, file);
  const std::string body = assembly_xml(assembly, height);
  const std::optional<StandingPose> pose = find_standing_pose(body, file);
  const std::string standing =
      with_lines_in_section(body, file, "keyframe", {home_key(assembly, height, pose)});
  const ProposedParameters proposed = propose_parameters(standing, file);
  if (!proposed.not_standing.empty())
    throw InputError(file.string(), 0, "",
                     fmt::format("the robot does not stand: {}; draw its limbs below the trunk, or "
                                 "stretched out downwards, from where a pose is searched for",
                                 proposed.not_standing));
  BuiltRobot out;
  out.xml = with_declarations(standing, file, proposed.proposals);
  out.found = propose_parameters(out.xml, file);
  out.found.left_out = proposed.left_out;
  if (pose) out.pose = pose->words;
  out.notes = notes_on(assembly);
  return out;
}

}  // namespace legwright
