// SPDX-License-Identifier: Apache-2.0
// The table of keys of an assembly file.
#include "tools/modules/assembly_file.hpp"
#include "tools/modules/key_rows.hpp"

namespace legwright {
namespace {

constexpr Range kPlaceInRobot{-5.0, 5.0, false, false, "m"};

std::vector<TaskKey> keys_of_the_assembly() {
  return {
      text_key("name", "the file's name", "\"puppy\"",
               "Of the robot: letters, digits, `_` and `-`."),
      text_key("servo", "needed, unless each joint has one", "\"XL430-W250\"",
               "Module of all joints that name none of their own."),
      text_key("torque", "`\"stall\"`", "\"continuous\"",
               "Which torque limits the joints: `stall`, which is the peak torque of brushless "
               "joints, or `continuous`, where the servo has none the stall torque."),
      number_key("torque_share", {0.0, 1.0, true, false, ""}, "1", "0.5",
                 "How much of that torque they may use."),
      number_key("armature", {0.0, 10.0, true, false, "kg m2"},
                 "0.005 for each N m of stall torque; none of gears below 100", "0.0075",
                 "Of joints whose servo's reflected inertia is not known."),
      text_key("contacts", "`\"all\"`", "\"feet\"",
               "What touches: `all`, but for neighbours in a limb, or the `feet` alone."),
      text_key("trunk.module", "none", "\"plate_200x100\"",
               "Module of the kind `trunk`; or `size` and `mass`."),
      numbers_key("trunk.size", {0.0, 5.0, true, false, "m"}, 3, "none", "[0.2, 0.1, 0.04]",
                  "Length, width and height of a box."),
      number_key("trunk.mass", {0.0, 1000.0, true, false, "kg"}, "none; of `[print]` its tray's",
                 "0.4",
                 "Of that box. A robot with `[print]` has a trunk of at least what its tray weighs "
                 "as it is printed, at the largest of its designs; `build` tells it."),
      tables_key("part", "none", "[{module = \"lipo_3s_2200\"}]",
                 "`[[part]]`, once for each thing that rides on the trunk."),
      text_key("part.module", "needed", "\"lipo_3s_2200\"",
               "A module that is no servo and no linear actuator."),
      numbers_key("part.position", kPlaceInRobot, 3, "`[0, 0, 0]`", "[0.0, 0.0, 0.02]",
                  "In the trunk's frame."),
      text_key(
          "link.shape", "`\"hull\"`", "\"hull\"",
          "What is printed between modules: `hull`, the convex hull of their attachment points "
          "that face each other, which follows the design, or `capsule`, from joint to joint."),
      number_key(
          "link.radius", {0.0, 0.5, true, false, "m"}, "0.006", "0.005",
          "Of a hull's round pads on horns and attachments, and of capsules, which collide in "
          "the place of hulls. With `[print]` the default is as wide as the servos' screws need, "
          "else 0.4 of "
          "their width, and less in a ball foot."),
      number_key("link.wall", {0.0, 0.1, true, false, "m"}, "0.003", "0.004",
                 "Thickness of those pads. With `[print]` the default is as thick as the servos' "
                 "torques and the robot's weight on its feet need."),
      number_key("link.clearance", {0.0, 0.1, true, false, "m"}, "0.001", "0.002",
                 "Of a hull to the servo that turns it, at each angle of its range; `build` tells "
                 "where it is less."),
      number_key("link.density", {0.0, 20000.0, true, false, "kg/m3"}, "1240", "800.0",
                 "Of their material, filled: PLA's by default."),
      numbers_key(
          "print.bed", {0.0, 10.0, true, false, "m"}, 2, "`[0.22, 0.22]`", "[0.18, 0.18]",
          "Of the printer. `[print]`, also an empty one, gives what may change "
          "bounds within which parts fit: lengths get narrower ones, axes stay but for `turn`."),
      number_key("print.margin", {0.0, 1.0, false, false, "m"}, "0.004", "0.006",
                 "That parts leave free at each side of the bed, as for a skirt, a brim or clips."),
      number_key(
          "print.turn", {0.0, 1.0, false, false, "rad"}, "0", "0.5",
          "How far a design may turn the axis of a joint, and with it its servo, either way; "
          "clearance and bed narrow that too."),
  };
}

std::vector<TaskKey> keys_of_limbs() {
  return {
      tables_key("limb", "needed", "[{name = \"F\"}]",
                 "`[[limb]]`, once for limbs of one build: a chain of servos with a foot."),
      text_key("limb.name", "needed, unless `names` is given", "\"leg\"",
               "Of the limb. Of several copies a number stands behind it, of mirror images an L "
               "or R."),
      names_key("limb.names", "none", "[\"F\", \"H\"]", "Of the copies, one each."),
      numbers_key("limb.hip", kPlaceInRobot, 3, "needed", "[0.1, 0.06, 0.0]",
                  "Where its first joint is, in the trunk's frame."),
      text_key("limb.mirror", "none", "\"y\"",
               "`y`: there is a mirror image in the x-z plane of each."),
      integer_key("limb.copies", {1, 16, false, false, ""}, "1", "2", "How many there are."),
      numbers_key("limb.step", kPlaceInRobot, 3, "needed with `copies`", "[-0.2, 0.0, 0.0]",
                  "From the hip of a copy to that of the next."),
      text_key("limb.foot", "needed", "\"ball_foot_12\"", "Module of the kind `foot`."),
      numbers_key("limb.foot_offset", kPlaceInRobot, 3, "needed", "[0.0, 0.0, -0.09]",
                  "From the last joint to the foot's frame, a ball's centre."),
      tables_key("limb.joint", "needed", "[{name = \"hip\", axis = [0, 1, 0]}]",
                 "Its joints from the trunk on, as `[[limb.joint]]` or in one line each."),
      text_key("limb.joint.name", "needed", "\"knee\"", "Of the joint within its limb."),
      text_key("limb.joint.link", "the joint's name and `_link`", "\"shank\"",
               "Of the link that it moves, after which its length is named."),
      numbers_key("limb.joint.axis", kDirectionRange, 3, "needed", "[0.0, 1.0, 0.0]",
                  "About which it turns; the servo's horn looks along it. Of any length."),
      numbers_key("limb.joint.offset", kPlaceInRobot, 3, "needed but of the first",
                  "[0.0, 0.0, -0.08]", "From the joint above it."),
      text_key("limb.joint.servo", "`servo` of the file", "\"XM430-W350\"",
               "Module of the kind `servo`; of the kind `linear` below the first joint."),
      numbers_key(
          "limb.joint.lever", kPlaceInRobot, 3,
          "half the stroke to the front, square to axis and link above", "[0.015, 0.0, 0.0]",
          "Of a linear actuator: its rod's pivot on the link that it moves, from the joint."),
      numbers_key("limb.joint.mount", kPlaceInRobot, 3,
                  "from the lever along the link above, at half the stroke", "[0.02, 0.0, 0.13]",
                  "Of a linear actuator: its body's pivot on the link above, from the joint."),
      numbers_key("limb.joint.range", kAngleRangeOfJoint, 2, "the servo's, the stroke's",
                  "[-1.5, 1.5]",
                  "Least and largest angle; zero is as the vectors say. Without zero, as of a knee "
                  "that does not stretch, the robot stands in a pose that is searched for. Of a "
                  "linear actuator's joint what its stroke allows, or less."),
      number_key(
          "limb.joint.roll", {-7.0, 7.0, false, false, "rad"}, "0", "1.5708",
          "Turns the servo's body about its axis; at 0 it lies towards the joint above. A linear "
          "actuator turns about its rod; at 0 its longer side is away from the joint."),
  };
}

}  // namespace

const std::vector<TaskKey>& assembly_keys() {
  static const std::vector<TaskKey> keys = [] {
    std::vector<TaskKey> all = keys_of_the_assembly();
    const std::vector<TaskKey> limbs = keys_of_limbs();
    all.insert(all.end(), limbs.begin(), limbs.end());
    return all;
  }();
  return keys;
}

}  // namespace legwright
