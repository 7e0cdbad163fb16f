// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/read_robot.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "mjcf/read/bindings.hpp"
#include "mjcf/read/checks.hpp"
#include "mjcf/read/connectors.hpp"
#include "mjcf/read/legs.hpp"
#include "mjcf/read/linear_actuators.hpp"
#include "mjcf/read/motor_lines.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/servos.hpp"
#include "mjcf/read/stretch.hpp"
#include "mjcf/read/time_step.hpp"
#include "mjcf/read/tree.hpp"
#include "mjcf/text/angle_words.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/mjcf_words.hpp"

namespace legwright {
namespace {

void check_home(const XmlFile& xml, const mjModel& model, const Morphology& morphology) {
  const bool in_degrees = angles_in_degrees(xml);
  for (int a = 0; a < morphology.joint_count(); ++a) {
    const Joint& joint = morphology.links[a + 1].joint;
    if (joint.nominal < joint.lower || joint.nominal > joint.upper)
      throw error_at(
          xml, model, mjOBJ_JOINT, mj_name2id(&model, mjOBJ_JOINT, joint.name.c_str()),
          fmt::format("the home pose has {}, outside of its range {}; change the range or "
                      "the keyframe 'home'; "
                      "`legwright init ROBOT --write` looks for a pose to stand in",
                      angle_text(joint.nominal, in_degrees),
                      angle_range_text(joint.lower, joint.upper, in_degrees)));
  }
}

void add_all(const InputError& fault, Refusals& reasons) {
  if (fault.reasons().empty()) reasons.add(fault);
  for (const InputError& reason : fault.reasons()) reasons.add(reason);
}

/// Does some work; what it refuses is reported together with reasons that are known already.
template <class Work>
auto together_with(Refusals& reasons, const Work& work) {
  try {
    auto out = work();
    reasons.throw_if_any();
    return out;
  } catch (const InputError& error) {
    if (reasons.empty()) throw;
    add_all(error, reasons);
  }
  reasons.throw_if_any();
  throw std::logic_error("a refusal without a reason");
}

/// What else stands against a robot in whose text there are faults already, as far as these leave
/// it to be read: decimal commas are taken for points, slips in words for what is meant.
void add_structure_faults(const XmlFile& xml, const Structure* known, Refusals& reasons) {
  try {
    const auto words = load_xml(with_known_words(xml), xml.file);
    const auto mended = load_xml(with_decimal_points(*words), xml.file);
    Refusals names;  // of the scene: told already
    check_text(*mended, names);
    const ModelPointer model = compile_mjcf(mended->text, xml.file);
    const Structure structure = read_structure(*mended, *model, known);
    (void)read_tendons(*mended, *model, structure);
    (void)read_declarations(*mended, *model, structure);
  } catch (const InputError& fault) {
    add_all(fault, reasons);
  }
}

/// All that the text tells, in one list.
void check_whole_text(const XmlFile& xml, const Structure* known, Refusals& reasons) {
  bool is_readable = true;
  try {
    check_text(xml, reasons);
  } catch (const InputError& fault) {
    add_all(fault, reasons);
    is_readable = false;
  }
  check_declarations(xml, reasons);
  if (is_readable) return;
  add_structure_faults(xml, known, reasons);
  reasons.throw_if_any();
}

RobotModel parse_text(const std::string& xml_text, const std::filesystem::path& file,
                      const Structure* known) {
  const auto xml = load_xml(xml_text, file);
  Refusals reasons;
  check_whole_text(*xml, known, reasons);
  ModelPointer model;
  std::vector<TendonSpan> tendons;
  Declarations declared;
  Structure structure = together_with(reasons, [&] {
    model = compile_mjcf(xml->text, file);
    Structure found = read_structure(*xml, *model, known);
    tendons = read_tendons(*xml, *model, found);
    declared = read_declarations(*xml, *model, found);
    return found;
  });
  const StretchMap stretches = collect_stretches(declared.space, declared.bindings, file);
  RobotModel robot;
  const PlaceMap places = collect_places(declared.space, declared.bindings, file);
  const Eigen::VectorXd initial = declared.space.initial();
  PrintedMap printed = read_printed(*xml, *model, structure, stretches);
  robot.turning_parts = read_turning_parts(*xml, *model, structure, stretches);
  robot.connectors =
      read_connectors(*xml, *model, structure, stretches, robot.turning_parts, initial);
  add_connector_masses(robot.connectors, initial, printed);
  robot.morphology = build_morphology(*xml, *model, structure, declared.space, declared.bindings,
                                      {stretches, places, printed, robot.turning_parts}, tendons,
                                      robot.connectors);
  check_home(*xml, *model, robot.morphology);
  check_arms(*xml, tendons, robot.morphology, declared.space);
  robot.servos = read_servos(*xml, *model, structure, robot.morphology, declared.space.initial());
  read_motor_lines(*xml, structure, robot.servos);
  read_mobility(*model, file, robot.servos);
  for (int a = 0; a < robot.morphology.joint_count(); ++a) {
    Joint& joint = robot.morphology.links[a + 1].joint;
    joint.line = robot.servos[a].line;
    if (robot.servos[a].tendon.empty()) joint.torque_limit = robot.servos[a].torque_limit;
  }
  set_gains(robot.servos, declared.space.initial(), robot.morphology);
  for (LinearActuator& actuator : robot.morphology.linear_actuators)
    actuator.force_limit = robot.servos[actuator.joint].torque_limit;
  robot.file = file;
  robot.xml = xml_text;
  robot.space = std::move(declared.space);
  robot.bindings = std::move(declared.bindings);
  robot.in_degrees = angles_in_degrees(*xml);
  robot.root_body = name_of(*model, mjOBJ_BODY, structure.trunk);
  robot.structure = std::move(structure);
  return robot;
}

}  // namespace

RobotModel read_robot(const std::filesystem::path& file, const FileReach& reach) {
  return parse_robot(RobotFiles::read(file, reach));
}

RobotModel parse_robot(const std::string& xml_text, const std::filesystem::path& file,
                       const Structure* known) {
  return parse_robot(RobotFiles::from_text(xml_text, file), known);
}

RobotModel parse_robot(const RobotFiles& files, const Structure* known) {
  RobotModel robot =
      files.at_their_lines([&] { return parse_text(files.text(), files.file(), known); });
  robot.files = files;
  return robot;
}

void gather(RobotModel& robot) {
  robot.files = robot.files.gathered();
  robot.xml = robot.files.text();
}

}  // namespace legwright
