// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/assembly_xml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "mjcf/assembly/assembly_names.hpp"
#include "mjcf/assembly/joint_drive.hpp"
#include "mjcf/assembly/limb_hulls.hpp"
#include "mjcf/assembly/linear_joint.hpp"
#include "mjcf/assembly/link_sizes.hpp"
#include "mjcf/assembly/module_words.hpp"
#include "mjcf/assembly/reflected_inertia.hpp"
#include "mjcf/assembly/xml_lines.hpp"
#include "mjcf/read/connectors.hpp"
#include "mjcf/read/motor_lines.hpp"
#include "mjcf/read/printed_robot.hpp"
#include "mjcf/read/robot_model.hpp"
#include "mjcf/read/turning_parts.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kShortestCapsule = 1e-3;  // [m]; between nearer joints there is no capsule
constexpr double kPivotRadius = 0.003;     // [m], as drawn

class AssemblyWriter {
 public:
  AssemblyWriter(const Assembly& assembly, double height)
      : assembly_(assembly), limbs_(placed_limbs(assembly)), height_(height) {
    for (const PlacedLimb& limb : limbs_) {
      const std::vector<LinkHulls> hulls = limb_hulls(assembly, limb);
      for (std::size_t k = 0; k < hulls.size(); ++k) place_hulls(limb, k, hulls[k]);
    }
  }

  std::string run() {
    out_.add(
        fmt::format("<!-- {}, an assembly of {}. Metres, kilograms, radians; x forward, y left, "
                    "z up. -->",
                    assembly_.name, fmt::join(module_names(), ", ")));
    out_.open(fmt::format("<mujoco model=\"{}\">", assembly_.name));
    out_.add("<compiler angle=\"radian\" autolimits=\"true\"/>");
    write_defaults();
    out_.empty();
    out_.open("<worldbody>");
    write_trunk();
    out_.close("worldbody");
    out_.empty();
    write_tendons();
    write_actuators();
    write_declarations();
    out_.close("mujoco");
    return out_.text();
  }

 private:
  /// Each once; none holds what a comment may not.
  std::set<std::string> module_names() const {
    std::set<std::string> names{assembly_.trunk.name};
    for (const AssemblyPart& part : assembly_.parts) names.insert(part.module.name);
    for (const AssemblyLimb& limb : assembly_.limbs) {
      names.insert(limb.foot.name);
      for (const AssemblyJoint& joint : limb.joints) names.insert(joint.servo.name);
    }
    return names;
  }

  void write_defaults() {
    const char* touch = assembly_.only_feet_touch ? " contype=\"0\" conaffinity=\"0\"" : "";
    out_.empty();
    out_.open("<default>");
    out_.add(fmt::format("<geom group=\"1\" density=\"0\"{}/>", touch));
    out_.open("<default class=\"link\">");
    out_.add(fmt::format("<geom type=\"capsule\" size=\"{}\" density=\"{}\" material=\"print\"/>",
                         format_number(link_radius(assembly_)),
                         format_number(assembly_.link_density)));
    if (!placed_.empty()) {
      // What collides in the place of hulls, which nobody sees.
      out_.open("<default class=\"collider\">");
      out_.add("<geom group=\"3\" density=\"0\"/>");
      out_.close("default");
    }
    out_.close("default");
    if (!placed_.empty()) {
      out_.open("<default class=\"connector\">");
      out_.add("<geom type=\"mesh\" contype=\"0\" conaffinity=\"0\" material=\"print\"/>");
      out_.close("default");
    }
    out_.open("<default class=\"foot\">");
    out_.add("<geom contype=\"1\" conaffinity=\"1\" solref=\"0.005 1\" material=\"rubber\"/>");
    out_.close("default");
    out_.close("default");
    out_.empty();
    out_.open("<asset>");
    out_.add("<material name=\"shell\" rgba=\"0.08 0.52 0.52 1\" specular=\"0.3\"/>");
    out_.add("<material name=\"part\" rgba=\"0.3 0.33 0.4 1\" specular=\"0.3\"/>");
    out_.add("<material name=\"print\" rgba=\"0.93 0.62 0.2 1\" specular=\"0.3\"/>");
    out_.add("<material name=\"servo\" rgba=\"0.2 0.22 0.26 1\" specular=\"0.4\"/>");
    out_.add("<material name=\"rubber\" rgba=\"0.07 0.07 0.08 1\" specular=\"0.05\"/>");
    for (const PlacedHull& hull : placed_)
      out_.add(fmt::format("<mesh name=\"{}\" vertex=\"{}\"/>", hull.name, hull.written.vertices));
    out_.close("asset");
  }

  void write_trunk() {
    out_.open(fmt::format("<body name=\"trunk\" pos=\"0 0 {}\">", format_number(rounded(height_))));
    out_.add("<freejoint name=\"root\"/>");
    write_module(assembly_.trunk, {}, "shell");
    declare(assembly_.trunk, {}, "body", "trunk");
    for (std::size_t k = 0; k < assembly_.parts.size(); ++k) {
      const AssemblyPart& part = assembly_.parts[k];
      out_.open(fmt::format("<body name=\"{}\" pos=\"{}\">", part_name(part, k),
                            rounded_words(part.position)));
      write_module(part.module, {}, "part");
      declare(part.module, {}, "body", part_name(part, k));
      out_.close("body");
    }
    for (const PlacedLimb& limb : limbs_) {
      out_.empty();
      write_joint(limb, 0);
    }
    out_.close("body");
  }

  /// <inertial> and geoms of what keeps its mass and shape.
  void write_module(const Module& module, const ModulePlace& place, const char* material) {
    out_.add(inertial_element(module, place));
    for (const std::string& geom :
         outline_geoms(module, place, fmt::format(" material=\"{}\"", material)))
      out_.add(geom);
  }

  void declare(const Module& module, const ModulePlace& place, const char* sort,
               const std::string& of, const std::string& joint = "") {
    modules_.push_back(module_declaration(module, place, sort, of, joint));
  }

  /// The servo of a joint on the body that is open, and the link that it moves.
  void write_joint(const PlacedLimb& limb, std::size_t k) {
    const AssemblyLimb& of = *limb.of;
    const AssemblyJoint& joint = of.joints[k];
    const std::string name = joint_name(limb, joint);
    const Vector3d place = k == 0 ? limb.hip : limb.vector(joint.offset);
    out_.open(fmt::format("<body name=\"{}\" pos=\"{}\">", servo_name(limb, joint),
                          rounded_words(place)));
    const ModulePlace servo{
        joint.is_linear() ? linear_pose(joint) : servo_pose(joint, towards_above(limb, k)),
        limb.mirrored};
    write_module(joint.is_linear() ? without_rod(joint.servo) : joint.servo, servo, "servo");
    declare(joint.servo, servo, "body", servo_name(limb, joint), name);
    if (joint.is_linear())
      out_.add(site_element(mount_name(limb, joint), limb.vector(pivots_of(joint).mount)));
    out_.close("body");
    if (joint.is_linear()) write_mount(limb, joint, place);
    out_.open(
        fmt::format("<body name=\"{}\" pos=\"{}\">", link_name(limb, joint), rounded_words(place)));
    out_.add(joint_element(limb, joint, name));
    const bool last = k + 1 == of.joints.size();
    const Vector3d end = limb.vector(last ? of.foot_offset : of.joints[k + 1].offset);
    const auto is_of_link = [&](const PlacedHull& hull) {
      return hull.limb == &limb && hull.joint == k;
    };
    const bool has_hulls = std::any_of(placed_.begin(), placed_.end(), is_of_link);
    if (end.norm() > kShortestCapsule)
      out_.add(fmt::format("<geom class=\"{}\" fromto=\"0 0 0 {}\"/>",
                           has_hulls ? "collider" : "link", rounded_words(end)));
    for (const PlacedHull& hull : placed_) {
      if (!is_of_link(hull)) continue;
      out_.open(fmt::format("<body name=\"{}\">", hull.name));
      out_.add(fmt::format("<inertial {}/>", hull.written.inertial));
      out_.add(fmt::format("<geom class=\"connector\" mesh=\"{}\"/>", hull.name));
      out_.close("body");
    }
    if (joint.is_linear()) write_lever(limb, joint);
    if (last)
      write_foot(limb);
    else
      write_joint(limb, k + 1);
    out_.close("body");
  }

  static std::string site_element(const std::string& name, const Vector3d& place) {
    return fmt::format("<site name=\"{}\" pos=\"{}\" size=\"{}\" group=\"1\"/>", name,
                       rounded_words(place), format_number(kPivotRadius));
  }

  /// What holds the body of a linear actuator: from its pivot straight to the link that carries it.
  void write_mount(const PlacedLimb& limb, const AssemblyJoint& joint, const Vector3d& place) {
    const Vector3d mount = limb.vector(pivots_of(joint).mount), above = -limb.vector(joint.offset);
    const double share = std::clamp(mount.dot(above) / above.squaredNorm(), 0.0, 1.0);
    const Vector3d from = share * above;
    if ((mount - from).norm() < kShortestCapsule) return;
    out_.open(fmt::format("<body name=\"{}\" pos=\"{}\">", mount_arm_name(limb, joint),
                          rounded_words(place)));
    out_.add(fmt::format("<geom class=\"link\" fromto=\"{} {}\"/>", rounded_words(from),
                         rounded_words(mount)));
    out_.close("body");
  }

  /// What its rod pulls at, and the rod, which weighs at its pivot.
  void write_lever(const PlacedLimb& limb, const AssemblyJoint& joint) {
    const Vector3d lever = limb.vector(pivots_of(joint).lever);
    const double rod = joint.servo.mass - without_rod(joint.servo).mass;
    out_.open(fmt::format("<body name=\"{}\">", lever_arm_name(limb, joint)));
    out_.add(fmt::format("<geom class=\"link\" fromto=\"0 0 0 {}\"/>", rounded_words(lever)));
    if (rod > 0.0)
      out_.add(
          fmt::format("<geom type=\"sphere\" size=\"{}\" pos=\"{}\" mass=\"{}\" "
                      "material=\"servo\"/>",
                      format_number(rounded(rod_radius(joint.servo).value_or(kPivotRadius))),
                      rounded_words(lever), format_number(rounded(rod))));
    out_.add(site_element(lever_name(limb, joint), lever));
    out_.close("body");
  }

  std::string joint_element(const PlacedLimb& limb, const AssemblyJoint& joint,
                            const std::string& name) const {
    std::string out =
        fmt::format("<joint name=\"{}\" axis=\"{}\"", name, rounded_words(limb.hinge(joint.axis)));
    if (const auto range = drive_range(joint))
      out +=
          fmt::format(" range=\"{} {}\"", format_number((*range)[0]), format_number((*range)[1]));
    const auto add = [&](const char* attribute, const std::optional<double>& value) {
      if (value) out += fmt::format(" {}=\"{}\"", attribute, format_number(*value));
    };
    add("armature", armature_of(joint, assembly_));
    if (joint.servo.joint) {
      add("frictionloss", joint.servo.joint->friction);
      add("damping", joint.servo.joint->damping);
    }
    return out + "/>";
  }

  /// Each rod of a linear actuator, from pivot to pivot; its range is the stroke.
  void write_tendons() {
    if (!has_linear_joints(assembly_)) return;
    out_.open("<tendon>");
    for (const PlacedLimb& limb : limbs_)
      for (const AssemblyJoint& joint : limb.of->joints) {
        if (!joint.is_linear()) continue;
        const ModuleSlide& slide = *joint.servo.slide;
        out_.open(
            fmt::format("<spatial name=\"{}\" range=\"{} {}\" width=\"{}\" material=\"servo\">",
                        rod_name(limb, joint), format_number(rounded(slide.retracted)),
                        format_number(rounded(slide.extended())),
                        format_number(rounded(rod_radius(joint.servo).value_or(kPivotRadius)))));
        out_.add(fmt::format("<site site=\"{}\"/>", mount_name(limb, joint)));
        out_.add(fmt::format("<site site=\"{}\"/>", lever_name(limb, joint)));
        out_.close("spatial");
      }
    out_.close("tendon");
    out_.empty();
  }

  void write_foot(const PlacedLimb& limb) {
    const AssemblyLimb& of = *limb.of;
    ModulePlace place;
    place.pose.translation() = of.foot_offset;
    place.mirrored = limb.mirrored;
    double volume = 0.0;
    for (const OutlineShape& shape : of.foot.outline) volume += shape.volume();
    const std::vector<std::string> geoms = outline_geoms(of.foot, place, "");
    ModulePlace from_geom = place;
    from_geom.pose.translation() = -of.foot.outline.front().position;
    declare(of.foot, from_geom, "geom", foot_name(limb, 0));
    for (std::size_t k = 0; k < geoms.size(); ++k) {
      const double mass = of.foot.mass * of.foot.outline[k].volume() / volume;
      out_.add(
          fmt::format("<geom name=\"{}\" class=\"foot\" mass=\"{}\" friction=\"{} 0.005 "
                      "0.0001\" {}",
                      foot_name(limb, k), format_number(rounded(mass)),
                      format_number(of.foot.friction.value_or(kFootFriction)),
                      geoms[k].substr(std::string("<geom ").size())));
    }
  }

  void write_actuators() {
    out_.open("<actuator>");
    for (const PlacedLimb& limb : limbs_)
      for (const AssemblyJoint& joint : limb.of->joints) {
        const double limit = torque_limit(assembly_, joint.servo);
        const DriveGains gains = drive_gains(joint, assembly_);
        const std::string at = joint.is_linear() ? "tendon=\"" + rod_name(limb, joint)
                                                 : "joint=\"" + joint_name(limb, joint);
        out_.add(
            fmt::format("<position name=\"{}\" {}\" kp=\"{}\" kv=\"{}\" forcerange=\"{} {}\"/>",
                        servo_name(limb, joint), at, format_number(rounded(gains.kp)),
                        format_number(rounded(gains.kv)), format_number(rounded(-limit)),
                        format_number(rounded(limit))));
      }
    out_.close("actuator");
  }

  /// Torque at rest and speed without load of each joint whose servo has both; of linear actuators
  /// force and speed.
  std::vector<std::string> motor_lines() const {
    std::vector<std::string> out;
    for (const PlacedLimb& limb : limbs_)
      for (const AssemblyJoint& joint : limb.of->joints)
        if (const auto line = drive_line(joint.servo))
          out.push_back(fmt::format("<numeric name=\"{}{}\" data=\"{} {}\"/>", kMotorPrefix,
                                    joint_name(limb, joint),
                                    format_number(rounded(line->stall_torque)),
                                    format_number(rounded(line->no_load_speed))));
    return out;
  }

  /// Motors, modules, what turns with axes, and which hulls go with which points of the design.
  void write_declarations() {
    out_.empty();
    out_.open("<custom>");
    if (assembly_.print)
      out_.add(fmt::format("<text name=\"{}\" data=\"bed {} {} m margin {} m\"/>", kPrintText,
                           format_number(assembly_.print->bed.x()),
                           format_number(assembly_.print->bed.y()),
                           format_number(assembly_.print->margin)));
    for (const std::string& motor : motor_lines()) out_.add(motor);
    for (const std::string& module : modules_) out_.add(module);
    if (!assembly_.print || assembly_.print->turn > 0.0) declare_turning_servos();
    for (const PlacedHull& hull : placed_)
      out_.add(fmt::format("<text name=\"{}{}\" data=\"{}\"/>", kConnectorPrefix, hull.name,
                           hull.written.data));
    out_.close("custom");
  }

  void declare_turning_servos() {
    for (const PlacedLimb& limb : limbs_)
      for (const AssemblyJoint& joint : limb.of->joints)
        if (!joint.is_linear())
          out_.add(fmt::format("<text name=\"{}{}\" data=\"joint {}\"/>", kTurnsPrefix,
                               servo_name(limb, joint), joint_name(limb, joint)));
  }

  void place_hulls(const PlacedLimb& limb, std::size_t k, const LinkHulls& hulls) {
    const AssemblyLimb& of = *limb.of;
    const bool last = k + 1 == of.joints.size();
    const std::string end =
        last ? "geom " + foot_name(limb, 0) : "body " + servo_name(limb, of.joints[k + 1]);
    const Vector3d place = last ? of.foot_offset : of.joints[k + 1].offset;
    const Vector3d from = last ? of.foot.outline.front().position : Vector3d(Vector3d::Zero());
    for (const LinkHull& hull : hulls.hulls) {
      const std::string name = hull_name(limb, of.joints[k], hull.role);
      placed_.push_back({&limb, k, name,
                         written_hull(hull, limb, assembly_.link_density,
                                      joint_name(limb, of.joints[k]), end, place, from)});
    }
  }

  struct PlacedHull {
    const PlacedLimb* limb;
    std::size_t joint;
    std::string name;
    WrittenHull written;
  };

  const Assembly& assembly_;
  const std::vector<PlacedLimb> limbs_;
  const double height_;
  std::vector<PlacedHull> placed_;
  std::vector<std::string> modules_;  // as they are declared, in the order of the file
  XmlLines out_;
};

}  // namespace

std::string assembly_xml(const Assembly& assembly, double height) {
  return AssemblyWriter(assembly, height).run();
}

}  // namespace legwright
