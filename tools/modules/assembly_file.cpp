// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/assembly_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "mjcf/assembly/assembly_names.hpp"
#include "mjcf/assembly/tray_mass.hpp"
#include "mjcf/text/nearest_word.hpp"
#include "tools/modules/linear_pivots.hpp"
#include "tools/modules/table_values.hpp"
#include "tools/task/task_table.hpp"
#include "tools/task/toml_text.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kShortestOffset = 1e-3;  // [m], of a link, from joint to joint or foot

class AssemblyReader {
 public:
  AssemblyReader(const std::string& text, const std::filesystem::path& file,
                 const ModuleLibrary& library, AssemblyState state)
      : toml_(parse_toml(text, file)),
        problems_(file.string(), "docs/assembly_file.md has all keys"),
        library_(library),
        state_(state),
        root_(table(&toml_, "")) {
    out_.name = file.stem().string();
  }

  Assembly run() {
    read_whole();
    read_trunk();
    for (const toml::table* part : root_.tables("part")) read_part(part);
    const std::vector<const toml::table*> limbs = root_.tables("limb");
    root_.require(!limbs.empty() || state_ == AssemblyState::draft, "limb",
                  "[[limb]] with name, hip, joint, foot and foot_offset");
    for (const toml::table* limb : limbs) read_limb(limb);
    check_placed_names();
    check_places();
    root_.finish();
    problems_.throw_if_any();
    if (out_.trunk_as_printed) out_.trunk.mass = tray_mass(out_);
    return std::move(out_);
  }

 private:
  TaskTable table(const toml::table* toml, const std::string& path) {
    return {toml, path, problems_, lines_, assembly_keys()};
  }

  void refuse(TaskTable& in, std::string_view key, const std::string& message) {
    problems_.add(in.line_of(key), in.full(key), message);
  }

  /// The module that a key names; another kind than `kind` or `other` is refused. Null where there
  /// is none.
  const Module* module_of(TaskTable& in, std::string_view key, ModuleKind kind,
                          std::optional<ModuleKind> other = {}) {
    const auto name = in.text(key);
    if (!name) return nullptr;
    const auto may = [&](const Module& each) { return each.kind == kind || each.kind == other; };
    const ModuleFile* found = library_.find_or_null(*name);
    if (found && may(found->module)) return &found->module;
    if (found)
      refuse(in, key,
             fmt::format("names \"{}\", which is a {}; expected a {}", *name,
                         found->module.kind_name(), kModuleKinds[static_cast<std::size_t>(kind)]));
    else
      refuse_unknown(in, key, *name, may);
    return nullptr;
  }

  /// Offers the nearest of those that may stand there.
  template <typename May>
  void refuse_unknown(TaskTable& in, std::string_view key, const std::string& name,
                      const May& may_stand_there) {
    std::vector<std::string> names;
    for (const ModuleFile& file : library_.modules())
      if (may_stand_there(file.module)) names.push_back(file.module.name);
    const std::string guess = nearest(name, names);
    refuse(in, key,
           fmt::format("names \"{}\", which is not in the library; {}", name,
                       guess.empty() ? fmt::format("there are {}; --library DIR reads others",
                                                   fmt::join(names, ", "))
                                     : fmt::format("did you mean \"{}\"?", guess)));
  }

  /// One of two words. @return whether it is the second
  bool second_of(TaskTable& in, std::string_view key, const char* first, const char* second) {
    const std::string word = in.text(key).value_or(first);
    if (word != first && word != second)
      refuse(in, key, fmt::format("is \"{}\"; expected \"{}\" or \"{}\"", word, first, second));
    return word == second;
  }

  void read_whole() {
    if (const auto name = root_.text("name")) out_.name = *name;
    if (!is_plain_name(out_.name))
      refuse(root_, "name",
             fmt::format("is {}\"{}\"; expected letters, digits, '_' and '-': {}name = \"puppy\"",
                         root_.has("name") ? "" : "missing, and the file's name is ", out_.name,
                         root_.has("name") ? "" : "add "));
    servo_ = module_of(root_, "servo", ModuleKind::servo);
    if (second_of(root_, "torque", "stall", "continuous")) out_.torque = TorqueLimit::continuous;
    out_.torque_share = root_.number("torque_share").value_or(out_.torque_share);
    out_.armature = root_.number("armature");
    out_.only_feet_touch = second_of(root_, "contacts", "all", "feet");
    read_link();
    read_print();
  }

  void read_link() {
    TaskTable link = table(root_.table("link"), "link");
    if (second_of(link, "shape", "hull", "capsule")) out_.link_shape = LinkShape::capsule;
    for (const char* const key : {"wall", "clearance"})
      if (link.has(key) && out_.link_shape == LinkShape::capsule)
        refuse(link, key, "is of hulls; take it out, or let shape be \"hull\"");
    out_.link_wall = link.number("wall");
    out_.link_clearance = link.number("clearance").value_or(out_.link_clearance);
    out_.link_radius = link.number("radius");
    out_.link_density = link.number("density").value_or(out_.link_density);
    link.finish();
  }

  void read_print() {
    const toml::table* toml = root_.table("print");
    if (toml && out_.link_shape == LinkShape::capsule)
      refuse(root_, "print", "is of hulls; take it out, or let [link] shape be \"hull\"");
    if (!toml) return;
    TaskTable print = table(toml, "print");
    out_.print = PrintLimits{};
    if (const auto bed = print.numbers("bed")) out_.print->bed = {(*bed)[0], (*bed)[1]};
    out_.print->margin = print.number("margin").value_or(out_.print->margin);
    if (out_.print->room().minCoeff() <= 0.0)
      refuse(print, print.has("margin") ? "margin" : "bed",
             fmt::format("a margin of {} m at each side of a bed of {} x {} m leaves no room: give "
                         "a margin of a few millimetres, as 0.004, on a bed of [0.22, 0.22]",
                         out_.print->margin, out_.print->bed.x(), out_.print->bed.y()));
    out_.print->turn = print.number("turn").value_or(out_.print->turn);
    print.finish();
  }

  void read_trunk() {
    const toml::table* toml = root_.table("trunk");
    root_.require(toml != nullptr, "trunk", "[trunk] with size = [0.2, 0.1, 0.04], mass = 0.4");
    if (!toml) return;
    TaskTable in = table(toml, "trunk");
    const auto size = in.numbers("size");
    const auto mass = in.number("mass");
    const bool named = in.has("module");
    if (const Module* module = module_of(in, "module", ModuleKind::trunk)) out_.trunk = *module;
    if (named && (size || mass))
      refuse(in, "module",
             "stands beside size or mass; give the module, or the box's size and mass");
    if (!named) {
      in.require(in.has("size"), "size", "size = [0.2, 0.1, 0.04]");
      in.require(in.has("mass") || out_.print, "mass", "mass = 0.4");
      OutlineShape box;
      box.size = size ? vector_of(*size) : Vector3d::Ones();
      out_.trunk.name = "trunk";
      out_.trunk.kind = ModuleKind::trunk;
      out_.trunk.mass = mass.value_or(1.0);
      out_.trunk_as_printed = !mass && out_.print;
      out_.trunk.outline = {box};
    }
    out_.trunk_line = in.line_of(named ? "module" : mass ? "mass" : "size");
    in.finish();
  }

  void read_part(const toml::table* toml) {
    TaskTable in = table(toml, "part");
    AssemblyPart part;
    const auto name = in.text("module");
    in.require(name.has_value(), "module", "module = \"lipo_3s_2200\"");
    const ModuleFile* found = name ? library_.find_or_null(*name) : nullptr;
    if (name && !found)
      refuse_unknown(in, "module", *name, [](const Module& other) { return !other.is_drive(); });
    if (found && found->module.is_drive())
      refuse(in, "module",
             fmt::format("names \"{}\", a {}, which stands in a limb's joint; expected what rides "
                         "on the trunk",
                         *name,
                         found->module.kind == ModuleKind::servo ? "servo" : "linear actuator"));
    if (found) part.module = found->module;
    part.line = in.line_of("module");
    if (const auto position = in.numbers("position")) part.position = vector_of(*position);
    in.finish();
    out_.parts.push_back(part);
  }

  void read_limb(const toml::table* toml) {
    TaskTable in = table(toml, "limb");
    AssemblyLimb limb;
    limb_lines_.push_back(static_cast<int>(toml->source().begin.line));
    const auto hip = in.numbers("hip");
    in.require(hip.has_value(), "hip", "hip = [0.1, 0.06, 0.0]");
    if (hip) limb.hip = vector_of(*hip);
    if (!hip) unplaced_.insert(out_.limbs.size());
    limb.line = in.line_of("hip");
    read_copies(in, limb);
    if (const auto mirror = in.text("mirror")) {
      limb.mirrored = *mirror == "y";
      if (!limb.mirrored)
        refuse(in, "mirror",
               fmt::format("is \"{}\"; expected \"y\", across which legs mirror", *mirror));
      if (limb.mirrored && hip && std::abs(limb.hip.y()) <= kInThePlane) {
        refuse(in, "mirror",
               "leaves the hip where it is, in the x-z plane; move it aside, or take "
               "mirror out");
        one_place_told_.insert(out_.limbs.size());
      }
    }
    in.require(in.has("foot"), "foot", "foot = \"ball_foot_12\"");
    if (const Module* foot = module_of(in, "foot", ModuleKind::foot)) limb.foot = *foot;
    const auto offset = in.numbers("foot_offset");
    in.require(offset.has_value(), "foot_offset", "foot_offset = [0.0, 0.0, -0.09]");
    if (offset) limb.foot_offset = vector_of(*offset);
    if (offset && limb.foot_offset.norm() < kShortestOffset)
      refuse(in, "foot_offset", "has no length; expected where the foot is: [0.0, 0.0, -0.09]");
    const std::vector<const toml::table*> joints = in.tables("joint");
    in.require(!joints.empty(), "joint", "joint = [{name = \"hip\", axis = [0, 1, 0]}]");
    std::set<std::string> names;
    for (const toml::table* joint : joints) read_joint(joint, limb, names);
    in.finish();
    check_names(in, limb);
    out_.limbs.push_back(limb);
  }

  void read_copies(TaskTable& in, AssemblyLimb& limb) {
    const int copies = in.integer("copies").value_or(1);
    const auto step = in.numbers("step");
    in.require(step.has_value() || copies == 1, "step", "step = [-0.2, 0.0, 0.0]");
    if (step) limb.step = vector_of(*step);
    if (!step && copies > 1) unplaced_.insert(out_.limbs.size());
    if (step && copies > 1 && limb.step.norm() < kSameHip) {
      refuse(in, "step",
             "has no length, which puts all copies in one place; expected the way from one hip "
             "to the next: [-0.2, 0.0, 0.0]");
      one_place_told_.insert(out_.limbs.size());
    }
    const auto name = in.text("name");
    const auto names = in.names("names");
    in.require(name.has_value() || names.has_value(), "name", "name = \"leg\"");
    if (names && names->size() != static_cast<std::size_t>(copies))
      refuse(in, "names",
             fmt::format("has {} names for {} limbs; give one for each of the copies",
                         names->size(), copies));
    for (int k = 0; k < copies; ++k)
      limb.names.push_back(names && names->size() > static_cast<std::size_t>(k)
                               ? (*names)[static_cast<std::size_t>(k)]
                           : copies > 1 ? fmt::format("{}{}", name.value_or("leg"), k + 1)
                                        : name.value_or("leg"));
  }

  void check_names(TaskTable& in, const AssemblyLimb& limb) {
    const char* key = in.has("names") ? "names" : "name";
    for (const std::string& name : limb.names) {
      if (!is_plain_name(name))
        refuse(in, key, fmt::format("has \"{}\"; expected letters, digits, '_' and '-'", name));
      if (limb_names_.insert(name).second) continue;
      refuse(in, key, fmt::format("has \"{}\" a second time; give each limb its own name", name));
      name_twice_ = true;
    }
  }

  /// Of mirror images L or R stands behind the name, which another limb may have by itself.
  void check_placed_names() {
    if (name_twice_) return;  // else all that is named after them is told too
    std::set<std::string> names;
    bool twice = false;
    for (const PlacedLimb& limb : placed_limbs(out_)) {
      if (names.insert(limb.name).second) continue;
      twice = true;
      problems_.add(limb_lines_[index_of(limb)], "limb",
                    fmt::format("makes \"{}\" a second time, once of a mirror image; give each "
                                "limb its own name",
                                limb.name));
    }
    if (twice) return;
    for (const NameClash& clash : name_clashes(out_))
      refuse(root_, "limb",
             fmt::format("would name {} and {} alike, \"{}\"; give one of them another name",
                         clash.first, clash.second, clash.name));
  }

  std::size_t index_of(const PlacedLimb& limb) const {
    return static_cast<std::size_t>(limb.of - out_.limbs.data());
  }

  /// Of limbs whose places were read; those that a refused number leaves out are told already, and
  /// so are those of one name.
  void check_places() {
    const std::vector<PlacedLimb> limbs = placed_limbs(out_);
    for (std::size_t b = 0; b < limbs.size(); ++b)
      for (std::size_t a = 0; a < b; ++a) {
        if ((limbs[a].hip - limbs[b].hip).norm() >= kSameHip || limbs[a].name == limbs[b].name ||
            (limbs[a].of == limbs[b].of && one_place_told_.contains(index_of(limbs[b]))) ||
            unplaced_.contains(index_of(limbs[a])) || unplaced_.contains(index_of(limbs[b])))
          continue;
        problems_.add(
            limb_lines_[index_of(limbs[b])], "limb",
            fmt::format("puts the hips of \"{}\" and \"{}\" in one place, [{}]; move one aside "
                        "by hip or step",
                        limbs[a].name, limbs[b].name, fmt::join(limbs[b].hip, ", ")));
      }
  }

  void read_joint(const toml::table* toml, AssemblyLimb& limb, std::set<std::string>& names) {
    TaskTable in = table(toml, "limb.joint");
    AssemblyJoint joint;
    const auto name = in.text("name");
    in.require(name.has_value(), "name", "name = \"knee\"");
    joint.name = name.value_or("joint");
    joint.line = in.line_of("name");
    joint.link = in.text("link").value_or(joint.name + "_link");
    if (!is_plain_name(joint.name))
      refuse(in, "name",
             fmt::format("is \"{}\"; expected letters, digits, '_' and '-'", joint.name));
    if (name && !names.insert(joint.name).second)
      refuse(in, "name",
             fmt::format("is \"{}\" a second time in this limb; give each joint its own name",
                         joint.name));
    const bool twin = std::ranges::any_of(
        limb.joints, [&](const AssemblyJoint& other) { return other.link == joint.link; });
    if (!is_plain_name(joint.link) || twin || joint.link.ends_with("_servo"))
      refuse(in, "link",
             fmt::format("is \"{}\"; expected letters, digits, '_' and '-', another name for each "
                         "link, and none that ends in _servo, as those of servos do",
                         joint.link));
    in.require(in.has("axis"), "axis", "axis = [0, 1, 0]");
    if (const auto axis = direction_in(in, "axis", problems_)) joint.axis = *axis;
    const auto offset = in.numbers("offset");
    const bool first = limb.joints.empty();
    in.require(offset.has_value() || first, "offset", "offset = [0.0, 0.0, -0.08]");
    if (offset) joint.offset = vector_of(*offset);
    if (!first && offset && joint.offset.norm() < kShortestOffset)
      refuse(in, "offset",
             "is shorter than 1 mm, which puts the joint into the one above it; expected the way "
             "from there: [0.0, 0.0, -0.08]");
    if (first && offset && joint.offset.norm() > 0.0)
      refuse(in, "offset", "is of the first joint, which is where hip says; take it out");
    const bool turned = read_servo(in, joint);
    joint.roll = in.number("roll").value_or(0.0);
    joint.range = angle_range_in(in, "range", problems_);
    if (turned && (first || offset)) read_linear_pivots(in, problems_, first, joint);
    if (joint.is_linear() && out_.print)
      refuse(in, "servo",
             fmt::format("names {}, a linear actuator, beside [print]: the links at one are not "
                         "printed, so nothing fits them to a bed; take [print] out",
                         joint.servo.name));
    in.finish();
    limb.joints.push_back(joint);
  }

  /// What turns a joint: a servo or a linear actuator. @return whether it is known
  bool read_servo(TaskTable& in, AssemblyJoint& joint) {
    const Module* own =
        in.has("servo") ? module_of(in, "servo", ModuleKind::servo, ModuleKind::linear) : servo_;
    if (own) joint.servo = *own;
    if (!in.has("servo") && !root_.has("servo"))
      in.require(false, "servo", "servo = \"XL430-W250\", here or at the top of the file");
    return own != nullptr;
  }

  toml::table toml_;
  Problems problems_;
  std::map<std::string, int> lines_;
  const ModuleLibrary& library_;
  const AssemblyState state_;
  Assembly out_;
  const Module* servo_ = nullptr;  // of joints without their own
  std::set<std::string> limb_names_;
  bool name_twice_ = false;
  std::vector<int> limb_lines_;
  std::set<std::size_t> one_place_told_;  // limbs of which that is told already
  std::set<std::size_t> unplaced_;        // limbs of which hip or step was not read
  TaskTable root_;
};

}  // namespace

Assembly parse_assembly(const std::string& text, const std::filesystem::path& file,
                        const ModuleLibrary& library, AssemblyState state) {
  return AssemblyReader(text, file, library, state).run();
}

bool is_assembly(const std::string& text, const std::filesystem::path& file) {
  const toml::table toml = parse_toml(text, file);
  return !toml.contains("robot") && (toml.contains("trunk") || toml.contains("limb"));
}

}  // namespace legwright
