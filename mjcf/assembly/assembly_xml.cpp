// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/assembly_xml.hpp"

#include <fmt/format.h>

#include <set>

#include "mjcf/assembly/assembly_names.hpp"
#include "mjcf/read/robot_model.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kShortestCapsule = 1e-3;  // [m]; between nearer joints there is no capsule
constexpr double kRoundBody = 1e-9;        // [m]: an outline about its axis, which has no long side

/// A unit vector across `axis`, as near to `wanted` as can be; of those that are along it another.
Vector3d square_to(const Vector3d& axis, const Vector3d& wanted) {
  const Vector3d rest = wanted - axis.dot(wanted) * axis;
  if (rest.norm() > kRoundBody) return rest.normalized();
  const Vector3d other = std::abs(axis.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitZ();
  return (other - axis.dot(other) * axis).normalized();
}

/// Right-handed: the first column along `axis`, the second along `side`, which is square to it.
Matrix3d frame_of(const Vector3d& axis, const Vector3d& side) {
  Matrix3d out;
  out << axis, side, axis.cross(side);
  return out;
}

/// The servo with its horn at the origin, looking along the joint's axis, its body towards what
/// carries it.
Eigen::Isometry3d servo_pose(const AssemblyJoint& joint, const Vector3d& towards) {
  const ModuleJoint& own = *joint.servo.joint;
  const Vector3d body = inertia_of(joint.servo).centre - own.position;
  const Matrix3d of_module = frame_of(own.axis, square_to(own.axis, body)),
                 placed = Eigen::AngleAxisd(joint.roll, joint.axis) *
                          frame_of(joint.axis, square_to(joint.axis, towards));
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  out.linear() = placed * of_module.transpose();
  out.translation() = -(out.linear() * own.position);
  return out;
}

/// Collects the lines of a file, indented.
class XmlLines {
 public:
  void add(const std::string& line) { text_ += std::string(depth_, ' ') + line + "\n"; }
  void open(const std::string& line) {
    add(line);
    depth_ += 2;
  }
  void close(const char* tag) {
    depth_ -= 2;
    add(fmt::format("</{}>", tag));
  }
  void empty() { text_ += "\n"; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t depth_ = 0;
};

class AssemblyWriter {
 public:
  AssemblyWriter(const Assembly& assembly, double height)
      : assembly_(assembly), limbs_(placed_limbs(assembly)), height_(height) {}

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
    write_actuators();
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
                         format_number(assembly_.link_radius),
                         format_number(assembly_.link_density)));
    out_.close("default");
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
    out_.close("asset");
  }

  void write_trunk() {
    out_.open(fmt::format("<body name=\"trunk\" pos=\"0 0 {}\">", format_number(rounded(height_))));
    out_.add("<freejoint name=\"root\"/>");
    write_module(assembly_.trunk, {}, "shell");
    for (std::size_t k = 0; k < assembly_.parts.size(); ++k) {
      const AssemblyPart& part = assembly_.parts[k];
      out_.open(fmt::format("<body name=\"{}\" pos=\"{}\">", part_name(part, k),
                            rounded_words(part.position)));
      write_module(part.module, {}, "part");
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

  /// The servo of a joint on the body that is open, and the link that it moves.
  void write_joint(const PlacedLimb& limb, std::size_t k) {
    const AssemblyLimb& of = *limb.of;
    const AssemblyJoint& joint = of.joints[k];
    const std::string name = joint_name(limb, joint);
    const Vector3d place = k == 0 ? limb.hip : limb.vector(joint.offset);
    // Towards the joint above; of a hip towards the trunk's middle.
    const Vector3d towards = k == 0 ? Vector3d(-limb.vector(limb.hip)) : Vector3d(-joint.offset);
    out_.open(fmt::format("<body name=\"{}\" pos=\"{}\">", servo_name(limb, joint),
                          rounded_words(place)));
    write_module(joint.servo, {servo_pose(joint, towards), limb.mirrored}, "servo");
    out_.close("body");
    out_.open(
        fmt::format("<body name=\"{}\" pos=\"{}\">", link_name(limb, joint), rounded_words(place)));
    out_.add(joint_element(limb, joint, name));
    const bool last = k + 1 == of.joints.size();
    const Vector3d end = limb.vector(last ? of.foot_offset : of.joints[k + 1].offset);
    if (end.norm() > kShortestCapsule)
      out_.add(fmt::format("<geom class=\"link\" fromto=\"0 0 0 {}\"/>", rounded_words(end)));
    if (last)
      write_foot(limb);
    else
      write_joint(limb, k + 1);
    out_.close("body");
  }

  std::string joint_element(const PlacedLimb& limb, const AssemblyJoint& joint,
                            const std::string& name) const {
    const ModuleJoint& servo = *joint.servo.joint;
    std::string out =
        fmt::format("<joint name=\"{}\" axis=\"{}\"", name, rounded_words(limb.hinge(joint.axis)));
    if (const auto range = joint.range ? joint.range : servo.range)
      out +=
          fmt::format(" range=\"{} {}\"", format_number((*range)[0]), format_number((*range)[1]));
    const auto add = [&](const char* attribute, const std::optional<double>& value) {
      if (value) out += fmt::format(" {}=\"{}\"", attribute, format_number(*value));
    };
    add("armature", servo.reflected_inertia ? servo.reflected_inertia : assembly_.armature);
    add("frictionloss", servo.friction);
    add("damping", servo.damping);
    return out + "/>";
  }

  void write_foot(const PlacedLimb& limb) {
    const AssemblyLimb& of = *limb.of;
    ModulePlace place;
    place.pose.translation() = of.foot_offset;
    place.mirrored = limb.mirrored;
    double volume = 0.0;
    for (const OutlineShape& shape : of.foot.outline) volume += shape.volume();
    const std::vector<std::string> geoms = outline_geoms(of.foot, place, "");
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
        const double kp = joint.servo.joint->kp.value_or(limit / kFullTorqueError),
                     kv = joint.servo.joint->kd.value_or(kDampingTime * kp);
        out_.add(fmt::format(
            "<position name=\"{}\" joint=\"{}\" kp=\"{}\" kv=\"{}\" forcerange=\"{} {}\"/>",
            servo_name(limb, joint), joint_name(limb, joint), format_number(rounded(kp)),
            format_number(rounded(kv)), format_number(rounded(-limit)),
            format_number(rounded(limit))));
      }
    out_.close("actuator");
  }

  const Assembly& assembly_;
  const std::vector<PlacedLimb> limbs_;
  const double height_;
  XmlLines out_;
};

}  // namespace

std::string assembly_xml(const Assembly& assembly, double height) {
  return AssemblyWriter(assembly, height).run();
}

}  // namespace legwright
