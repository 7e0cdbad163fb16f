// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/assembly_text.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>
#include <vector>

#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

std::string quoted(const std::string& text) { return fmt::format("\"{}\"", text); }

std::string list(const Vector3d& v) {
  return fmt::format("[{}, {}, {}]", format_number(v.x()), format_number(v.y()),
                     format_number(v.z()));
}

/// The servo that most joints have, the first of those; empty where there is no joint.
std::string common_servo(const Assembly& assembly) {
  std::map<std::string, int> counts;
  for (const AssemblyLimb& limb : assembly.limbs)
    for (const AssemblyJoint& joint : limb.joints)
      if (!joint.is_linear()) ++counts[joint.servo.name];
  std::string best;
  for (const AssemblyLimb& limb : assembly.limbs)
    for (const AssemblyJoint& joint : limb.joints)
      if (!joint.is_linear() && (best.empty() || counts[joint.servo.name] > counts[best]))
        best = joint.servo.name;
  return best;
}

class AssemblyText {
 public:
  explicit AssemblyText(const Assembly& assembly)
      : assembly_(assembly), servo_(common_servo(assembly)) {}

  std::string run() {
    write_whole();
    write_trunk();
    write_link();
    write_print();
    for (const AssemblyPart& part : assembly_.parts) {
      head("[[part]]");
      line("module", quoted(part.module.name));
      if (part.position != Vector3d::Zero()) line("position", list(part.position));
    }
    for (const AssemblyLimb& limb : assembly_.limbs) write_limb(limb);
    return out_;
  }

 private:
  void head(const std::string& name) { out_ += "\n" + name + "\n"; }
  void line(const char* key, const std::string& value) {
    out_ += fmt::format("{} = {}\n", key, value);
  }
  void number_unless(const char* key, double value, double otherwise) {
    if (value != otherwise) line(key, format_number(value));
  }

  void write_whole() {
    const Assembly other;
    line("name", quoted(assembly_.name));
    if (!servo_.empty()) line("servo", quoted(servo_));
    if (assembly_.torque == TorqueLimit::continuous) line("torque", quoted("continuous"));
    number_unless("torque_share", assembly_.torque_share, other.torque_share);
    if (assembly_.armature) line("armature", format_number(*assembly_.armature));
    if (assembly_.only_feet_touch) line("contacts", quoted("feet"));
  }

  /// A box of one's own has no module.
  void write_trunk() {
    head("[trunk]");
    const Module& trunk = assembly_.trunk;
    if (!is_own_box(trunk)) return line("module", quoted(trunk.name));
    line("size", list(trunk.outline.front().size));
    if (!assembly_.trunk_as_printed) line("mass", format_number(trunk.mass));
  }

  void write_link() {
    const Assembly other;
    const std::string before = std::move(out_);
    out_.clear();
    if (assembly_.link_shape == LinkShape::capsule) line("shape", quoted("capsule"));
    if (assembly_.link_radius) line("radius", format_number(*assembly_.link_radius));
    if (assembly_.link_wall) line("wall", format_number(*assembly_.link_wall));
    number_unless("clearance", assembly_.link_clearance, other.link_clearance);
    number_unless("density", assembly_.link_density, other.link_density);
    out_ = before + (out_.empty() ? "" : "\n[link]\n") + out_;
  }

  void write_print() {
    if (!assembly_.print) return;
    head("[print]");
    const Eigen::Vector2d& bed = assembly_.print->bed;
    if (bed != PrintLimits{}.bed)
      line("bed", fmt::format("[{}, {}]", format_number(bed.x()), format_number(bed.y())));
    number_unless("margin", assembly_.print->margin, PrintLimits{}.margin);
    number_unless("turn", assembly_.print->turn, PrintLimits{}.turn);
  }

  void write_limb(const AssemblyLimb& limb) {
    head("[[limb]]");
    if (limb.names.size() == 1) {
      line("name", quoted(limb.names.front()));
    } else {
      std::vector<std::string> names;
      for (const std::string& name : limb.names) names.push_back(quoted(name));
      line("names", fmt::format("[{}]", fmt::join(names, ", ")));
    }
    line("hip", list(limb.hip));
    if (limb.names.size() > 1) {
      line("step", list(limb.step));
      line("copies", fmt::format("{}", limb.names.size()));
    }
    if (limb.mirrored) line("mirror", quoted("y"));
    line("foot", quoted(limb.foot.name));
    line("foot_offset", list(limb.foot_offset));
    for (std::size_t k = 0; k < limb.joints.size(); ++k) write_joint(limb.joints[k], k == 0);
  }

  void write_joint(const AssemblyJoint& joint, bool first) {
    head("[[limb.joint]]");
    line("name", quoted(joint.name));
    if (joint.link != joint.name + "_link") line("link", quoted(joint.link));
    line("axis", list(rounded(joint.axis)));
    if (!first) line("offset", list(joint.offset));
    if (joint.servo.name != servo_) line("servo", quoted(joint.servo.name));
    if (joint.lever) line("lever", list(*joint.lever));
    if (joint.mount) line("mount", list(*joint.mount));
    if (joint.range)
      line("range", fmt::format("[{}, {}]", format_number((*joint.range)[0]),
                                format_number((*joint.range)[1])));
    if (joint.roll != 0.0) line("roll", format_number(joint.roll));
  }

  const Assembly& assembly_;
  const std::string servo_;
  std::string out_;
};

}  // namespace

bool is_own_box(const Module& trunk) { return trunk.maker.empty() && trunk.attachments.empty(); }

std::string assembly_text(const Assembly& assembly) { return AssemblyText(assembly).run(); }

}  // namespace legwright
