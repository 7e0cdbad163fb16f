// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/read_robot.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

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
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

void check_home(const XmlFile& xml, const mjModel& model, const Morphology& morphology,
                Refusals& reasons) {
  const bool in_degrees = angles_in_degrees(xml);
  for (int a = 0; a < morphology.joint_count(); ++a) {
    const Joint& joint = morphology.links[a + 1].joint;
    if (joint.nominal < joint.lower || joint.nominal > joint.upper)
      reasons.add(
          error_at(xml, model, mjOBJ_JOINT, mj_name2id(&model, mjOBJ_JOINT, joint.name.c_str()),
                   fmt::format("the home pose has {}, outside of its range {}; change the range or "
                               "the keyframe 'home'; "
                               "`legwright init ROBOT --write` looks for a pose to stand in",
                               angle_text(joint.nominal, in_degrees),
                               angle_range_text(joint.lower, joint.upper, in_degrees))));
  }
}

/// MuJoCo tells no line of what it finds when all is read, but the element's name and number.
int line_of_named(const XmlFile& xml, const std::string& message) {
  constexpr std::string_view kName = "Element name '", kId = "', id ";
  const std::size_t at = message.find(kName), id = message.find(kId, at);
  if (at == std::string::npos || id == std::string::npos) return 0;
  const std::string name = message.substr(at + kName.size(), id - at - kName.size());
  const bool is_key = message.find("keyframe") != std::string::npos;
  const std::string_view rest = std::string_view(message).substr(id + kId.size());
  const auto said = parse_number(rest.substr(0, rest.find_first_not_of("0123456789")));
  int number = said ? static_cast<int>(*said) : -1, line = 0;
  for_each_element(xml.root(), [&](const XmlElement& element) {
    const bool fits = is_key ? is_tag(element, "key") && number-- == 0
                             : !name.empty() && attribute(element, "name") == name;
    if (fits && line == 0) line = element.GetLineNum();
  });
  return line;
}

ModelPointer compiled(const XmlFile& xml) {
  try {
    return compile_mjcf(xml.text, xml.file);
  } catch (const InputError& fault) {
    if (fault.line() > 0) throw;
    throw InputError(fault.file(), line_of_named(xml, fault.message()), fault.where(),
                     fault.message());
  }
}

/// Reads one robot stage by stage. What a stage refuses is a reason, and it is left out: the stages
/// that do not hang on it tell theirs too, so that a file is mended once.
class RobotReader {
 public:
  RobotReader(const XmlFile& xml, Refusals& reasons) : xml_(xml), reasons_(reasons) {}

  /// @return the robot, whole where there is no reason
  RobotModel run(const Structure* known) {
    model_ = compiled(xml_);
    found_ = read_structure(xml_, *model_, known, reasons_);
    tendons_ = read_tendons(xml_, *model_, found_, reasons_);
    if (found_.is_whole) declared_ = read_declarations(xml_, *model_, found_.structure, reasons_);
    initial_ = declared_.space.initial();
    MovedParts moved = read_moved_parts();
    robot_.morphology = build_morphology(xml_, *model_, found_.structure, declared_.space,
                                         declared_.bindings, moved, tendons_, robot_.connectors);
    robot_.turning_parts = std::move(moved.turning);
    check_home(xml_, *model_, robot_.morphology, reasons_);
    if (found_.is_whole) check_arms(xml_, tendons_, robot_.morphology, declared_.space, reasons_);
    read_motors();
    if (reasons_.empty()) finish();
    return std::move(robot_);
  }

 private:
  /// What design parameters move, and what stands with it.
  MovedParts read_moved_parts() {
    MovedParts moved;
    moved.stretches = collect_stretches(declared_.space, declared_.bindings, xml_.file, reasons_);
    moved.places = collect_places(declared_.space, declared_.bindings, xml_.file, reasons_);
    check_places(xml_, *model_, moved.places, moved.stretches, reasons_);
    if (!found_.is_whole) return moved;
    moved.printed = read_printed(xml_, *model_, found_.structure, moved.stretches, reasons_);
    moved.turning = read_turning_parts(xml_, *model_, found_.structure, moved.stretches, reasons_);
    robot_.connectors = read_connectors(xml_, *model_, found_.structure, moved.stretches,
                                        moved.turning, initial_, reasons_);
    add_connector_masses(robot_.connectors, initial_, moved.printed);
    return moved;
  }

  void read_motors() {
    robot_.servos =
        read_servos(xml_, *model_, found_.structure, robot_.morphology, initial_, reasons_);
    read_motor_lines(xml_, found_.structure, robot_.morphology, robot_.servos, reasons_);
  }

  /// What the parts make together.
  void finish() {
    read_mobility(*model_, xml_.file, robot_.servos);
    for (int a = 0; a < robot_.morphology.joint_count(); ++a) {
      Joint& joint = robot_.morphology.links[a + 1].joint;
      joint.line = robot_.servos[a].line;
      if (robot_.servos[a].tendon.empty()) joint.torque_limit = robot_.servos[a].torque_limit;
    }
    set_gains(robot_.servos, initial_, robot_.morphology);
    for (LinearActuator& actuator : robot_.morphology.linear_actuators)
      actuator.force_limit = robot_.servos[actuator.joint].torque_limit;
    robot_.space = std::move(declared_.space);
    robot_.bindings = std::move(declared_.bindings);
    robot_.in_degrees = angles_in_degrees(xml_);
    robot_.root_body = name_of(*model_, mjOBJ_BODY, found_.structure.trunk);
    robot_.structure = std::move(found_.structure);
  }

  const XmlFile& xml_;
  Refusals& reasons_;
  ModelPointer model_;
  FoundStructure found_;
  std::vector<TendonSpan> tendons_;
  Declarations declared_;
  Eigen::VectorXd initial_;
  RobotModel robot_;
};

/// What else stands against a robot in whose text there are faults already, as far as these leave
/// it to be read: decimal commas are taken for points, slips in words for what is meant.
void add_faults_behind(const XmlFile& xml, const Structure* known, Refusals& reasons) {
  reasons.collect([&] {
    const auto words = load_xml(with_known_words(xml), xml.file);
    const auto mended = load_xml(with_decimal_points(*words), xml.file);
    Refusals names;  // of the scene: told already
    check_text(*mended, names);
    (void)RobotReader(*mended, reasons).run(known);
  });
}

RobotModel parse_text(const std::string& xml_text, const std::filesystem::path& file,
                      const Structure* known) {
  const auto xml = load_xml(xml_text, file);
  Refusals reasons;
  const bool is_readable = reasons.collect([&] { check_text(*xml, reasons); });
  check_declarations(*xml, reasons);
  RobotModel robot;
  if (!is_readable)
    add_faults_behind(*xml, known, reasons);
  else
    reasons.collect([&] { robot = RobotReader(*xml, reasons).run(known); });
  reasons.throw_if_any();
  robot.file = file;
  robot.xml = xml_text;
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
