// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read_robot.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "mjcf/bindings.hpp"
#include "mjcf/checks.hpp"
#include "mjcf/compile.hpp"
#include "mjcf/legs.hpp"
#include "mjcf/linear_actuators.hpp"
#include "mjcf/servos.hpp"
#include "mjcf/stretch.hpp"
#include "mjcf/tree.hpp"

namespace legwright {
namespace {

/// Reads no more than a robot may have, so that an endless device ends.
std::string read_text(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    throw InputError(file.string(), 0, "", "no such file; check the path of the robot");
  if (!std::filesystem::is_regular_file(status))
    throw InputError(file.string(), 0, "", "is no regular file; name the robot's MJCF file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw std::system_error(errno, std::generic_category(), "cannot open " + file.string());
  const std::size_t limit = XmlLimits{}.bytes + 1;
  std::string text(std::min<std::uintmax_t>(limit, std::filesystem::file_size(file)), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad())
    throw std::system_error(errno, std::generic_category(), "cannot read " + file.string());
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

void check_home(const XmlFile& xml, const mjModel& model, const Morphology& morphology) {
  for (int a = 0; a < morphology.joint_count(); ++a) {
    const Joint& joint = morphology.links[a + 1].joint;
    if (joint.nominal < joint.lower || joint.nominal > joint.upper)
      throw error_at(
          xml, model, mjOBJ_JOINT, mj_name2id(&model, mjOBJ_JOINT, joint.name.c_str()),
          fmt::format(
              "the home pose has {} rad, outside of its range {} to {}; change the range or the "
              "keyframe 'home'",
              joint.nominal, joint.lower, joint.upper));
  }
}

}  // namespace

RobotModel read_robot(const std::filesystem::path& file) {
  return parse_robot(read_text(file), file);
}

RobotModel parse_robot(const std::string& xml_text, const std::filesystem::path& file,
                       const Structure* known) {
  const auto xml = load_xml(xml_text, file);
  check_text(*xml);
  const ModelPointer model = compile_mjcf(xml->text, file);
  Structure structure = read_structure(*xml, *model, known);
  const std::vector<TendonSpan> tendons = read_tendons(*xml, *model, structure);
  Declarations declared = read_declarations(*xml, *model, structure);
  const StretchMap stretches = collect_stretches(declared.space, declared.bindings, file);
  RobotModel robot;
  const PlaceMap places = collect_places(declared.space, declared.bindings, file);
  robot.morphology =
      build_morphology(*xml, *model, structure, declared.space, declared.bindings, stretches,
                       places, read_printed(*xml, *model, stretches), tendons);
  check_home(*xml, *model, robot.morphology);
  check_arms(*xml, tendons, robot.morphology, declared.space);
  robot.servos = read_servos(*xml, *model, structure, robot.morphology, declared.space.initial());
  for (int a = 0; a < robot.morphology.joint_count(); ++a)
    if (robot.servos[a].tendon.empty())
      robot.morphology.links[a + 1].joint.torque_limit = robot.servos[a].torque_limit;
  for (LinearActuator& actuator : robot.morphology.linear_actuators)
    actuator.force_limit = robot.servos[actuator.joint].torque_limit;
  robot.file = file;
  robot.xml = xml_text;
  robot.space = std::move(declared.space);
  robot.bindings = std::move(declared.bindings);
  robot.root_body = name_of(*model, mjOBJ_BODY, structure.trunk);
  robot.structure = std::move(structure);
  return robot;
}

}  // namespace legwright
