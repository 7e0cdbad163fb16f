// SPDX-License-Identifier: Apache-2.0
// examples/broken/robots: one robot for each class of fault, refused with file, line, element,
// fault and cure.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/input_error.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

struct Refusal {
  int line;                        // 0: the fault has no line
  std::vector<std::string> parts;  // element, fault, cure
  std::string file = {};           // where the fault is told, below the folder; empty: the robot's
};

const std::map<std::string, Refusal>& refusals() {
  static const std::map<std::string, Refusal> table = {
      {"actuator_armature", {23, {"position 'knee_servo'", "write armature"}}},
      {"actuator_damping", {23, {"position 'knee_servo'", "write damping"}}},
      {"actuator_delay", {23, {"position 'knee_servo'", "delays its control"}}},
      {"actuator_integral", {23, {"pid 'knee_servo'", "has dynamics of its own", "remove it"}}},
      {"actuator_muscle",
       {23, {"muscle 'knee_servo'", "is a muscle: it only pulls", "<position>"}}},
      {"actuator_of_rates",
       {23, {"general 'knee_servo'", "how fast its force shall change", "dyntype=\"none\""}}},
      {"attribute_without_quotes", {8, {"XML", "an attribute is malformed", "both quotes"}}},
      {"ball_joint", {14, {"joint 'knee'", "ball joints are not supported", "use three hinges"}}},
      {"bounds_crossed",
       {29, {"'legwright/thigh_length'", "lower 0.16 > upper 0.06", "exchange them"}}},
      {"decimal_comma", {16, {"geom 'foot'", "attribute pos: '-0,08'", "write a decimal point"}}},
      {"doctype", {3, {"<!DOCTYPE>", "remove it"}}},
      {"element_not_closed", {6, {"XML", "an element is not closed", "is the file complete?"}}},
      {"empty", {0, {"no root element", "expected <mujoco>"}}},
      {"engine_plugin", {5, {"extension", "engine plugins", "plain MJCF"}}},
      {"equality_loop",
       {26, {"connect 'loop'", "parallel linkages are not supported", "remove this"}}},
      {"foot_name_with_blank", {16, {"geom 'left foot'", "holds a blank", "rename it"}}},
      {"gravity_compensated", {9, {"body 'thigh'", "attribute gravcomp", "remove it"}}},
      {"gravity_disabled", {5, {"flag", "is switched off", "remove the attribute"}}},
      {"gravity_in_centimetres",
       {5, {"option", "attribute gravity: 0 0 -981", "a file in centimetres", "by 0.01"}}},
      {"gravity_of_the_moon",
       {5, {"option", "attribute gravity: 0 0 -1.62", "write that or remove"}}},
      {"gravity_sideways", {5, {"option", "attribute gravity: 1 0 -9.81", "write that or remove"}}},
      {"hexadecimal", {16, {"geom 'foot'", "attribute size: '0x1p-6'", "write it like"}}},
      {"home_outside_range",
       {14, {"joint 'knee'", "-2.8 rad, outside of its range -2 to 2 rad", "change the range"}}},
      {"home_too_short", {26, {"key 'home'", "attribute qpos: 8 numbers, the robot has 9"}}},
      {"include", {5, {"include", "'legs.xml' is not there", "check the path"}}},
      {"include_absolute", {5, {"include", "'/nowhere/legs.xml' is not there", "check the path"}}},
      {"include_cycle",
       {3,
        {"include", "parts/cycle.xml > parts/cycle_back.xml > parts/cycle.xml", "remove this"},
        "parts/cycle_back.xml"}},
      {"include_device", {5, {"include", "'/dev/zero' is a device", "name a regular file"}}},
      {"include_doctype", {2, {"<!DOCTYPE>", "remove it"}, "parts/doctype.xml"}},
      {"include_folder", {5, {"include", "'parts' is a folder", "name a regular file"}}},
      {"include_itself",
       {5, {"include", "include_itself.xml > include_itself.xml", "remove this <include>"}}},
      {"include_nan", {4, {"geom", "attribute rgba: 'nan'", "write it like"}, "parts/nan.xml"}},
      {"include_no_elements",
       {2, {"mujocoinclude", "without elements", "remove the <include>"}, "parts/no_elements.xml"}},
      {"include_not_closed", {3, {"XML", "an element is not closed"}, "parts/not_closed.xml"}},
      {"include_twice",
       {6, {"include", "a second time, first by", "include_twice.xml:5", "remove one"}}},
      {"include_unknown_element",
       {4, {"wheel", "is no element of MJCF", "correct the word"}, "parts/unknown_element.xml"}},
      {"include_urdf", {2, {"robot", "an included URDF", "convert the file"}, "parts/hopper.urdf"}},
      {"include_with_content", {5, {"include", "holds elements", "holds nothing"}}},
      {"include_with_prefix", {5, {"include", "attribute prefix", "remove it"}}},
      {"include_without_file", {5, {"include", "names no file", "write the file's path"}}},
      {"inertial_not_used",
       {11, {"inertial in body 'thigh'", "does not use these numbers", "remove that setting"}}},
      {"infinite", {8, {"inertial in body 'trunk'", "attribute mass: 'inf'", "write it like"}}},
      {"joint_reference", {10, {"joint 'hip'", "attribute ref", "remove ref"}}},
      {"joint_without_actuator",
       {14,
        {"joint 'knee'", "has no actuator", "add <position joint=\"knee\"",
         "else remove the joint"}}},
      {"joint_without_name", {14, {"body 'shank'", "has no name", "give it one"}}},
      {"leg_without_foot",
       {13, {"body 'shank'", "a leg without a foot", "add <geom type=\"sphere\">"}}},
      {"length_bound_not_positive",
       {29, {"'legwright/thigh_length'", "must stay positive", "-0.06"}}},
      {"mesh_absolute", {5, {"mesh 'skin'", "'/nowhere/skin.stl' is not there", "check the path"}}},
      {"mesh_backslash",
       {5, {"mesh 'skin'", "a path of a Windows computer", "copy the file beside"}}},
      {"mesh_empty", {5, {"mesh 'skin'", "parts/empty.stl' is empty", "is the copy complete?"}}},
      {"mesh_file", {6, {"mesh 'skin'", "'../../skin.stl' is not there", "check the path"}}},
      {"mesh_fitted_in_stretched",
       {15, {"geom", "a geom fitted to a mesh", "use a mesh or plain geoms"}}},
      {"mesh_foot_with_weight",
       {17, {"geom 'foot'", "its sole, -0.1 m along the stretch", "give the body an <inertial>"}}},
      {"mesh_folder", {5, {"mesh 'skin'", "'parts' is a folder", "name a regular file"}}},
      {"mesh_url", {5, {"mesh 'skin'", "has ://", "copy the file"}}},
      {"meshdir_missing",
       {6, {"mesh 'skin'", "'../meshes/skin.stl' is not there", "check the path"}}},
      {"mesh_words", {5, {"MuJoCo", "STL", "as a binary STL"}}},
      {"mirrored_stretch", {30, {"'legwright/thigh_length'", "'~thigh'", "remove it"}}},
      {"mocap_body", {6, {"body 'trunk'", "mocap bodies", "remove it"}}},
      {"model_in_model",
       {5, {"model 'leg'", "refers to the file", "_flat.xml', m.MjModel.from_xml_path('"}}},
      {"motor_without_limit", {23, {"motor 'knee_motor'", "no torque limit", "add forcerange"}}},
      {"nan", {9, {"body 'thigh'", "attribute pos: 'nan'", "write it like"}}},
      {"no_free_root", {6, {"body 'trunk'", "no free root", "add <freejoint/>"}}},
      {"no_trunk",
       {7, {"body 'left_thigh'", "no trunk: 2 bodies hang at the world", "start from the URDF"}}},
      {"no_limb", {6, {"body 'trunk'", "no limb", "add legs"}}},
      {"no_sentence",
       {30, {"'legwright/thigh_length'", "nothing for people", "UNIT | BINDING | SENTENCE"}}},
      {"no_target",
       {32, {"'legwright/hip_yaw'", "names no body, joint or site", "behind the colon"}}},
      {"not_mjcf",
       {3, {"robot", "is a URDF, expected MJCF", "legwright init FILE.urdf -o robot.xml"}}},
      {"not_utf8", {3, {"UTF-8"}}},
      {"numeric_without_text",
       {31, {"numeric 'legwright/hip_yaw'", "no <text>", "UNIT | BINDING | SENTENCE"}}},
      {"overflow", {8, {"inertial in body 'trunk'", "'1e999'", "finite"}}},
      {"parameter_decimal_comma",
       {29, {"'legwright/thigh_length'", "'0,1'", "write a decimal point"}}},
      {"parameter_name_with_blank", {31, {"'legwright/hip yaw'", "letters, digits", "rename it"}}},
      {"parameter_nan", {29, {"'legwright/thigh_length'", "'nan'", "write it like"}}},
      {"parameter_twice", {32, {"legwright/hip_yaw", "repeated name"}}},
      {"parameter_two_numbers", {29, {"'legwright/thigh_length'", "2 numbers; expected three"}}},
      {"replicate", {20, {"replicate", "generated parts are not read", "m.mj_saveLastXML('"}}},
      {"slide_joint", {14, {"joint 'knee'", "slide joints are not supported", "use a hinge"}}},
      {"springdamper_nan",
       {14, {"joint 'knee'", "attribute springdamper: 'nan'", "write it like"}}},
      {"start_outside_bounds",
       {29, {"'legwright/thigh_length'", "0.1 lies outside of its bounds 0.12 to 0.16", "widen"}}},
      {"stretched_off_hinge",
       {32,
        {"'legwright/thigh_length'", "from its hinge 'hip_roll' on would move its hinge 'hip'",
         "a body of its own"}}},
      {"stretched_twice",
       {34, {"'legwright/thigh_z'", "already stretched", "use perpendicular directions"}}},
      {"printed_oblique", {11, {"geom", "oblique to a stretch", "turn it along or across"}}},
      {"target_named_twice", {32, {"'legwright/hip_yaw'", "names 'hip' twice", "name it once"}}},
      {"tendon",
       {13,
        {"body 'shank'", "no joint moves by itself", "fixed tendon 'cable'",
         "remove what couples"}}},
      {"tendon_over_two_hinges",
       {28, {"spatial 'piston'", "must span exactly one hinge", "two links"}}},
      {"text_without_numeric", {31, {"text 'legwright/hip_yaw'", "no <numeric>", "add one"}}},
      {"text_without_parts", {30, {"'legwright/thigh_length'", "UNIT | BINDING | SENTENCE"}}},
      {"texture_file",
       {6, {"texture 'skin'", "the file 'skin.png' is not there", "check the path"}}},
      {"texture_huge", {5, {"texture 'skin'", "more than 16384 pixels", "make it smaller"}}},
      {"trailing_text", {16, {"geom 'foot'", "attribute size: '0.012m'", "write it like"}}},
      {"truncated", {14, {"XML", "is the file complete?"}}},
      {"two_actuators",
       {14,
        {"joint 'knee': has no actuator", "position 'knee_servo'", "second actuator of joint 'hip'",
         "leave one"}}},
      {"two_free_roots",
       {20, {"body 'ball'", "second free root with joints besides body 'trunk'", "remove"}}},
      {"unit_does_not_fit",
       {30,
        {"'legwright/thigh_length'", "'rad' does not fit 'stretch'",
         "a stretch and a place are in m"}}},
      {"unknown_binding",
       {30, {"'legwright/thigh_length'", "'bend' is unknown", "'stretch', 'axis' and 'place'"}}},
      {"unknown_body",
       {30,
        {"'legwright/thigh_length'", "body 'tigh', which is not in the model",
         "correct the name"}}},
      {"unknown_direction",
       {30, {"'legwright/thigh_length'", "direction 'along' is unknown", "write link, x, y or z"}}},
      {"unknown_element", {8, {"wheel", "is no element of MJCF", "correct the word"}}},
      {"unknown_joint",
       {32,
        {"'legwright/hip_yaw'", "joint 'hips', which is not in the model", "correct the name"}}},
      {"unknown_unit",
       {30, {"'legwright/thigh_length'", "unknown unit 'cm'", "write m for a length"}}},
      {"value_differs_from_model",
       {29, {"'legwright/thigh_length'", "declares 0.11 m", "measures 0.1 m", "write that"}}},
      {"wind_infinite", {5, {"option", "attribute wind: 'inf'", "write it like"}}},
      {"zero_axis", {14, {"joint 'knee'", "zero axis", "write the direction"}}},
      // Hostile or careless in ways that MuJoCo itself lets pass, or tells late.
      {"attribute_empty", {11, {"inertial in body 'thigh'", "attribute mass: is empty", "write"}}},
      {"attribute_twice", {14, {"XML", "an attribute is malformed", "each name once"}}},
      {"bell_in_name", {10, {"attribute name: holds a control character", "remove it"}}},
      {"boundmass_weightless",
       {4, {"compiler", "gives mass to body 'lid', which has none", "remove boundmass"}}},
      {"comment_not_closed", {25, {"XML", "a comment is not closed by -->"}}},
      {"composite", {9, {"composite", "generated parts are not read", "m.mj_saveLastXML('"}}},
      {"control_character", {10, {"UTF-8"}}},
      {"entity_bomb", {3, {"<!DOCTYPE>", "remove it"}}},
      {"far_away", {6, {"body 'trunk'", "200000 is beyond any robot", "in millimetres or grams?"}}},
      {"free_inside", {23, {"unknown transmission target 'knee'", "mend the file"}}},
      {"inertia_of_no_body", {9, {"thigh", "A + B >= C", "mend the file"}}},
      {"iterations_without_end", {5, {"option", "iterations: 2000000000 is beyond any robot"}}},
      {"joint_name_with_blank", {10, {"joint 'left hip'", "holds a blank", "rename it"}}},
      {"key_nan", {26, {"key 'home'", "attribute qpos: 'nan'", "write it like"}}},
      {"limb_on_the_world",
       {21, {"joint 'shoulder'", "does not hang on the trunk", "hang it there or remove it"}}},
      {"massless_link", {13, {"shank", "mass and inertia of moving bodies", "mend the file"}}},
      {"memory_without_end", {5, {"size", "memory: '900T' is beyond any robot", "remove it"}}},
      {"name_too_long", {10, {"joint", "300 bytes long", "shorten it"}}},
      {"names_twice", {13, {"repeated name 'thigh' in body", "mend the file"}}},
      {"negative_mass", {9, {"thigh", "mass and inertia of moving bodies", "mend the file"}}},
      {"negative_size", {16, {"size 0 must be positive", "foot", "mend the file"}}},
      {"parameter_name_markup", {31, {"'legwright/<b>'", "letters, digits", "rename it"}}},
      {"parameter_name_path", {31, {"'legwright/../../hip_yaw'", "letters, digits", "rename it"}}},
      {"parameter_name_too_long", {31, {"at most 80", "rename it"}}},
      {"text_after_the_root", {35, {"XML", "markup that readers understand differently"}}},
      {"texture_too_large", {5, {"texture 'sky'", "larger than 16384", "make it smaller"}}},
      {"textures_together", {8, {"texture 'sand'", "more than 512 MB", "make them smaller"}}},
      {"two_free_joints", {6, {"more than 6 dofs in body 'trunk'", "mend the file"}}},
      {"unknown_attribute",
       {14, {"joint 'knee': attribute colour", "MJCF has none", "correct the word"}}},
      {"unknown_class", {14, {"unknown default class name 'soft'", "mend the file"}}},
      {"user_numbers_without_end", {5, {"size", "nuserdata: 2000000000 is beyond any robot"}}},
      {"utf16", {1, {"UTF-8", "save the file as UTF-8"}}},
  };
  return table;
}

TEST(BrokenRobots, EachIsRefusedWithPlaceFaultAndCure) {
  const std::filesystem::path folder = test::source_path("examples/broken/robots");
  for (const auto& [name, refusal] : refusals()) {
    const std::filesystem::path file = folder / (name + ".xml");
    try {
      read_robot(file);
      ADD_FAILURE() << name << " was accepted";
    } catch (const InputError& error) {
      const std::string message = error.what();
      const std::string place = (refusal.file.empty() ? file : folder / refusal.file).string() +
                                (refusal.line ? ":" + std::to_string(refusal.line) : "") + ": ";
      EXPECT_EQ(message.substr(0, place.size()), place) << message;
      for (const std::string& part : refusal.parts)
        EXPECT_NE(message.find(part), std::string::npos)
            << name << ": '" << part << "' not in: " << message;
    }
  }
}

TEST(BrokenRobots, TableAndFolderHoldTheSameNames) {
  std::set<std::string> listed, found;
  for (const auto& [name, refusal] : refusals()) listed.insert(name);
  for (const auto& entry :
       std::filesystem::directory_iterator(test::source_path("examples/broken/robots")))
    if (entry.is_regular_file()) found.insert(entry.path().stem().string());
  EXPECT_EQ(listed, found);
}

/// Control: the robot they were all made from is accepted, so each is refused for its own fault.
TEST(BrokenRobots, MendedRobotIsAccepted) {
  const std::string broken =
      test::read_file(test::source_path("examples/broken/robots/zero_axis.xml"));
  const RobotModel robot =
      parse_robot(test::with(broken, "axis=\"0 0 0\"", "axis=\"0 1 0\""), "mended.xml");
  EXPECT_EQ(robot.space.size(), 2);
  EXPECT_EQ(robot.morphology.joint_count(), 2);
}

}  // namespace
}  // namespace legwright
