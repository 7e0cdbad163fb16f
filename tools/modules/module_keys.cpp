// SPDX-License-Identifier: Apache-2.0
// The table of keys of a module file.
#include "tools/modules/key_rows.hpp"
#include "tools/modules/module_file.hpp"

namespace legwright {
namespace {

constexpr Range kPlaceInModule{-1.0, 1.0, false, false, "m"};
constexpr Range kTorqueRange{0.0, 1000.0, true, false, "N m"};

std::vector<TaskKey> keys_of_the_module() {
  return {
      text_key("name", "needed", "\"XL430-W250\"",
               "By which assemblies name it: letters, digits, `_`, `-` and `.`."),
      text_key("kind", "needed", "\"servo\"",
               "`servo`, `linear` (an actuator whose rod slides), `foot`, `trunk`, `battery`, "
               "`computer` or "
               "`payload`."),
      text_key("maker", "needed", "\"ROBOTIS\"", "Who makes it."),
      text_key("about", "none", "\"hobby servo with a serial bus\"", "A sentence for people."),
      number_key("mass", {0.0, 100.0, true, false, "kg"}, "needed", "0.0572",
                 "Spread evenly over the outline."),
      number_key("voltage", {0.0, 1000.0, true, false, "V"}, "none", "11.1",
                 "At which torques and speed hold."),
      number_key("price", {0.0, 1e6, false, false, ""}, "none", "23.9",
                 "Of one, in the currency of all your prices; no source is asked for. The bill of "
                 "`legwright parts` sums them."),
      tables_key("outline", "needed", "[{shape = \"box\", size = [0.02, 0.03, 0.02]}]",
                 "`[[outline]]`, once for each box, cylinder or ball of which its shape is made."),
      text_key("outline.shape", "needed", "\"box\"", "`box`, `cylinder` or `sphere`."),
      numbers_key("outline.size", {0.0, 5.0, true, false, "m"}, 0, "needed",
                  "[0.0285, 0.0465, 0.034]",
                  "Of a box its widths along x, y and z; of a cylinder radius and length; of a "
                  "sphere its radius."),
      numbers_key("outline.position", kPlaceInModule, 3, "`[0, 0, 0]`", "[0.0, 0.0, 0.01]",
                  "Of its middle, in the module's frame."),
      numbers_key("outline.axis", kDirectionRange, 3, "`[0, 0, 1]`", "[0.0, 1.0, 0.0]",
                  "Direction of a cylinder; of any length."),
      text_key("outline.on", "`\"body\"`", "\"rod\"",
               "`body`, or `rod` of a linear actuator, drawn retracted."),
      names_key("unknown", "none", "[\"joint.friction\"]",
                "Figures that no source gives. What a module of its kind may have must be given "
                "or stand here."),
  };
}

std::vector<TaskKey> keys_of_the_joint() {
  return {
      numbers_key("joint.position", kPlaceInModule, 3, "needed", "[0.0, 0.012, 0.017]",
                  "Where the output axis leaves the module: the middle of its horn."),
      numbers_key("joint.axis", kDirectionRange, 3, "`[0, 0, 1]`", "[0.0, 0.0, 1.0]",
                  "Of the output, out of the module; of any length."),
      number_key("joint.stall_torque", kTorqueRange, "needed", "1.4",
                 "Stall torque of a geared servo, peak torque of a brushless joint."),
      number_key("joint.continuous_torque", kTorqueRange, "none", "0.3",
                 "What it holds as long as one likes, or rated torque, as its maker says."),
      number_key("joint.no_load_speed", {0.0, 1000.0, true, false, "rad/s"}, "none", "5.97",
                 "Of the output."),
      number_key("joint.gear_ratio", {0.0, 10000.0, true, false, ""}, "none", "258.5",
                 "Turns of the motor for one of the output."),
      number_key("joint.reflected_inertia", {0.0, 10.0, true, false, "kg m2"}, "none", "0.0026",
                 "Rotor inertia times the square of the ratio: the joint's `armature`."),
      number_key("joint.friction", {0.0, 100.0, false, false, "N m"}, "none", "0.05",
                 "Dry friction at the output: the joint's `frictionloss`."),
      number_key("joint.damping", {0.0, 100.0, false, false, "N m s/rad"}, "none", "0.02",
                 "Viscous friction at the output."),
      numbers_key("joint.range", kAngleRangeOfJoint, 2, "no limit", "[-2.618, 2.618]",
                  "Least and largest angle, zero between them or one of them."),
      number_key("joint.kp", {0.0, 1e6, true, false, "N m/rad"}, "torque limit / 0.0375 rad",
                 "40.0", "Advice for its gain."),
      number_key("joint.kd", {0.0, 1e5, true, false, "N m s/rad"}, "0.015 s times the gain", "0.6",
                 "Advice for its damping gain."),
      number_key("foot.friction", {0.0, 5.0, true, false, ""}, "0.8", "0.9",
                 "Of sliding, in the robot's file. In scenes of Legwright the floor's holds: "
                 "`limits.floor_friction` of a task."),
  };
}

std::vector<TaskKey> keys_of_the_slide() {
  constexpr Range kForce{0.0, 1e5, true, false, "N"};
  return {
      numbers_key("slide.position", kPlaceInModule, 3, "needed", "[0.0, 0.0, -0.05]",
                  "Of the pivot on its body: the middle of the hole there."),
      numbers_key("slide.axis", kDirectionRange, 3, "`[0, 0, 1]`", "[0.0, 0.0, 1.0]",
                  "From there to the pivot at the rod's end; of any length."),
      number_key("slide.retracted_length", {0.0, 5.0, true, false, "m"}, "needed", "0.118",
                 "Between both pivots with the rod in: hole to hole."),
      number_key("slide.stroke", {0.0, 5.0, true, false, "m"}, "needed", "0.05",
                 "How far the rod comes out."),
      number_key("slide.max_force", kForce, "needed", "50.0",
                 "The most that it moves, pushing or pulling: what gears, screw or current allow."),
      number_key("slide.stall_force", kForce, "`max_force`", "100.0",
                 "Where the straight line of force and speed would begin, at rest."),
      number_key("slide.continuous_force", kForce, "none", "20.0",
                 "Rated force: what it moves as long as one likes."),
      number_key("slide.no_load_speed", {0.0, 100.0, true, false, "m/s"}, "none", "0.032",
                 "Of the rod."),
      number_key("slide.backdrive_force", {0.0, 1e5, false, false, "N"}, "none", "31.0",
                 "That moves the rod without power; zero: it does not hold by itself. For people: "
                 "no robot has it."),
      number_key("slide.gear_ratio", {0.0, 10000.0, true, false, ""}, "none", "35.0",
                 "Of the gears before the screw."),
      number_key("slide.reflected_mass", {0.0, 1e6, true, false, "kg"},
                 "0.03 s times `stall_force` over `no_load_speed`", "90.0",
                 "Of the rotor, as the rod feels it."),
      number_key("slide.kp", {0.0, 1e9, true, false, "N/m"},
                 "force limit / (0.0375 rad times the moment arm)", "90000.0",
                 "Advice for its gain."),
      number_key("slide.kd", {0.0, 1e8, true, false, "N s/m"},
                 "0.015 s times the gain, or half of what would stop all swinging", "900.0",
                 "Advice for its damping gain."),
  };
}

std::vector<TaskKey> keys_of_attachments_and_sources() {
  return {
      tables_key("attachment", "none",
                 "[{name = \"back\", position = [0, 0, -0.01], normal = [0, 0, -1]}]",
                 "`[[attachment]]`, once for each place where another part is fixed."),
      text_key("attachment.name", "needed", "\"back\"", "Of the place."),
      text_key("attachment.on", "`\"body\"`", "\"horn\"",
               "`body`, or what moves: `horn` of a servo, `rod` of a linear "
               "actuator, drawn retracted."),
      numbers_key("attachment.position", kPlaceInModule, 3, "needed", "[0.0, 0.0, -0.017]",
                  "Its middle."),
      numbers_key("attachment.normal", kDirectionRange, 3, "needed", "[0.0, 0.0, -1.0]",
                  "Out of the module; of any length."),
      text_key("attachment.screws", "none", "\"M2\"",
               "Size of its screws: `M1.6`, `M2`, `M2.5`, `M2.6`, `M3`, `M4`, `M5` or `M6`; with "
               "`circle` and `count`, or `holes`, or both."),
      number_key("attachment.circle", {0.0, 1.0, true, false, "m"}, "none", "0.016",
                 "Diameter of the circle on which they are, about the attachment's middle."),
      integer_key("attachment.count", {1.0, 64.0, false, false, ""}, "needed with `circle`", "4",
                  "How many are on it, evenly."),
      number_key("attachment.turn", kAngleRangeOfJoint, "0", "0.7854",
                 "Of the first about the normal, from the module's x, or y where the normal is "
                 "along x."),
      numbers_key("attachment.holes", kPlaceInModule, 0, "none", "[0.008, 0.0, 0.018]",
                  "Where single ones are, in the attachment's plane: three numbers each."),
      names_key("cable", "none", "[\"left\", \"right\"]",
                "Names of attachments on the body at which cables leave: printed parts have a slot "
                "there. A figure: a source or an assumption names it."),
      tables_key("source", "none",
                 "[{title = \"data sheet\", address = \"https://…\", figures = [\"mass\"]}]",
                 "`[[source]]`, once for each page or data sheet that figures are from. A figure "
                 "that two name was compared."),
      text_key("source.title", "needed", "\"e-Manual, XL430-W250\"", "Of the page."),
      text_key("source.address", "needed",
               "\"https://emanual.robotis.com/docs/en/dxl/x/xl430-w250/\"",
               "Where it is: a URL, a file's name, or who measured it and when."),
      names_key("source.figures", "needed", "[\"mass\", \"joint.stall_torque\"]",
                "Keys whose figures it gives."),
      text_key("source.note", "none", "\"53.5 g with the old horn\"",
               "What differs from elsewhere, or how it was read."),
      tables_key("assumption", "none",
                 "[{figures = [\"joint.position\"], why = \"the drawing is not at hand\"}]",
                 "`[[assumption]]`, once for each reason why figures without a source are as they "
                 "are."),
      names_key("assumption.figures", "needed", "[\"joint.position\"]", "Keys of them."),
      text_key("assumption.why", "needed", "\"half the width from the end\"", "What was assumed."),
  };
}

}  // namespace

const std::vector<TaskKey>& module_keys() {
  static const std::vector<TaskKey> keys = [] {
    std::vector<TaskKey> all;
    for (const auto& part : {keys_of_the_module(), keys_of_the_joint(), keys_of_the_slide(),
                             keys_of_attachments_and_sources()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return keys;
}

}  // namespace legwright
