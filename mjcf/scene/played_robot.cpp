// SPDX-License-Identifier: Apache-2.0
#include "mjcf/scene/played_robot.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "mjcf/read/feet.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/tree.hpp"
#include "mjcf/read/world_parts.hpp"
#include "mjcf/scene/make_room.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/references.hpp"

namespace legwright {
namespace {

using tinyxml2::XMLElement;

XMLElement& writable(const XmlElement* element) { return *const_cast<XMLElement*>(element); }

/// Whether the plan's foot is the geom itself.
bool is_ball(const mjModel& model, const FootContact& foot) {
  return foot.geom >= 0 && model.geom_type[foot.geom] == mjGEOM_SPHERE && foot.others.empty() &&
         !foot.middle;
}

/// Names of elements by their kind.
using NamesByKind = std::map<std::string, std::set<std::string>>;

class Player {
 public:
  Player(XmlFile& xml, const mjModel& model, const Structure& structure)
      : xml_(xml),
        model_(model),
        structure_(structure),
        elements_(find_elements(xml, model)),
        root_(*xml.dom.RootElement()) {}

  void run() {
    drop_other_tendons();  // first, as they are known by their places
    drop_surroundings();
    if (!beside_.empty()) drop_bodies_beside();
    for (const FootContact& foot : structure_.feet) name_foot(foot);
    if (!structure_.frozen.empty() || !beside_.empty()) trim_keyframes();
    if (!structure_.frozen.empty()) {
      for (int b = 1; b < model_.nbody; ++b)
        if (!is_beside(b)) hold(b);
      while (XMLElement* all = root_.FirstChildElement("equality")) root_.DeleteChild(all);
    }
    drop_references("actuator");
    drop_references("sensor");
    drop_references("custom");
  }

 private:
  /// A floor comes in their place; what names one of them goes with it.
  void drop_surroundings() {
    bool any = false;
    for (int g = 0; g < model_.ngeom; ++g) {
      if (!is_of_surroundings(model_, g)) continue;
      XMLElement& geom = writable(elements_.geoms[static_cast<std::size_t>(g)]);
      if (const char* name = geom.Attribute("name")) record_removed("geom", name);
      geom.Parent()->DeleteChild(&geom);
      any = true;
    }
    if (any) drop_references("contact");
  }

  bool is_beside(int body) const {
    return std::count(beside_.begin(), beside_.end(), model_.body_rootid[body]) > 0;
  }

  /// What moves beside the robot goes, with all that names one of its parts, and its numbers in
  /// keyframes.
  void drop_bodies_beside() {
    for (const int root : beside_) {
      XMLElement& body = writable(elements_.bodies[static_cast<std::size_t>(root)]);
      for_each_element(body, [&](const XmlElement& part) {
        const std::string kind = is_tag(part, "freejoint") ? "joint" : part.Name();
        if (const char* name = part.Attribute("name")) record_removed(kind, name);
      });
      body.Parent()->DeleteChild(&body);
    }
    drop_watching(root_);
    for (const char* section : {"asset", "contact", "deformable", "equality", "tendon"})
      drop_references(section);
  }

  /// Cameras and lights that look at a body that is gone.
  void drop_watching(XMLElement& element) {
    const auto& bodies = removed_["body"];
    for (XMLElement *child = element.FirstChildElement(), *next = nullptr; child; child = next) {
      next = child->NextSiblingElement();
      const char* const target = child->Attribute("target");
      if ((is_tag(*child, "camera") || is_tag(*child, "light")) && target && bodies.count(target)) {
        if (const char* name = child->Attribute("name")) record_removed(child->Name(), name);
        element.DeleteChild(child);
      } else {
        drop_watching(*child);
      }
    }
  }

  void name_foot(const FootContact& foot) {
    if (foot.geom >= 0) {
      writable(elements_.geoms[static_cast<std::size_t>(foot.geom)])
          .SetAttribute("name", foot.name.c_str());
      if (!is_ball(model_, foot)) mark_point(foot);
      return;
    }
    // A ball at the site, without weight.
    XMLElement& site = writable(elements_.sites[static_cast<std::size_t>(foot.site)]);
    XMLElement* const ball = xml_.dom.NewElement("geom");
    site.Parent()->InsertAfterChild(&site, ball);
    ball->SetAttribute("name", foot.name.c_str());
    ball->SetAttribute("type", "sphere");
    ball->SetAttribute("size", format_number(foot.radius).c_str());
    // A site in a frame stands where the frame is; its own pos may come from a class.
    ball->SetAttribute("pos", format_numbers(pose_of(xml_, site).translation()).c_str());
    for (const auto& [name, value] :
         {std::pair{"mass", "0"}, {"contype", "1"}, {"conaffinity", "1"}, {"condim", "3"}})
      ball->SetAttribute(name, value);
  }

  /// The point of a foot that the plan moves, where it is not the middle of a ball: a site, which
  /// is a ball of the foot's radius, or a box where that is zero.
  void mark_point(const FootContact& foot) {
    const int body = foot_body(model_, foot);
    XMLElement* const site =
        writable(elements_.bodies[static_cast<std::size_t>(body)]).InsertNewChildElement("site");
    const double small = 0.002;  // [m], for the eye only
    const bool is_point = foot.radius == 0.0;
    site->SetAttribute("name", (kFootSite + foot.name).c_str());
    site->SetAttribute("type", is_point ? "box" : "sphere");
    site->SetAttribute(
        "size", format_numbers(Eigen::Vector3d::Constant(is_point ? small : foot.radius)).c_str());
    site->SetAttribute(
        "pos", format_numbers(foot_point(xml_, elements_, model_, foot, {}).constant).c_str());
    site->SetAttribute("quat", "1 0 0 0");
    site->SetAttribute("group", "4");
  }

  /// Takes a body's held joints away and draws it where they hold it.
  void hold(int body) {
    Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
    std::vector<int> before;  // joints that go on moving, declared before a held one
    bool any = false;
    for (int j = model_.body_jntadr[body]; j < model_.body_jntadr[body] + model_.body_jntnum[body];
         ++j) {
      if (structure_.moves[static_cast<std::size_t>(j)] || model_.jnt_type[j] == mjJNT_FREE) {
        before.push_back(j);
        continue;
      }
      const Eigen::Isometry3d held = held_displacement(model_, j);
      moved = moved * held;
      for (const int earlier : before) seen_from_behind(earlier, held);
      XMLElement& joint = writable(elements_.joints[static_cast<std::size_t>(j)]);
      if (joint.Attribute("name")) record_removed("joint", joint.Attribute("name"));
      joint.Parent()->DeleteChild(&joint);
      any = true;
    }
    if (!any || moved.isApprox(Eigen::Isometry3d::Identity(), 0.0)) return;
    XMLElement& element = writable(elements_.bodies[static_cast<std::size_t>(body)]);
    const Eigen::Isometry3d pose = pose_of(xml_, element) * moved;
    const Eigen::Quaterniond q(pose.linear());
    for (const char* name : {"euler", "axisangle", "xyaxes", "zaxis"})
      element.DeleteAttribute(name);
    element.SetAttribute("pos", format_numbers(pose.translation()).c_str());
    element.SetAttribute("quat",
                         format_numbers(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z())).c_str());
  }

  /// The body's own frame now has the held displacement in it, and a hinge declared before it turns
  /// about the same line of the parent all the same: D₀D₁ = D₁(D₁⁻¹D₀D₁).
  void seen_from_behind(int joint, const Eigen::Isometry3d& held) {
    const auto found = lines_.try_emplace(joint, vector_at(model_.jnt_axis, joint),
                                          vector_at(model_.jnt_pos, joint));
    auto& [axis, anchor] = found.first->second;
    if (held.isApprox(Eigen::Isometry3d::Identity(), 0.0)) return;
    axis = held.linear().transpose() * axis;
    anchor = held.inverse() * anchor;
    XMLElement& element = writable(elements_.joints[static_cast<std::size_t>(joint)]);
    element.SetAttribute("axis", format_numbers(axis).c_str());
    element.SetAttribute("pos", format_numbers(anchor).c_str());
  }

  void record_removed(const std::string& kind, const std::string& name) {
    removed_[kind].insert(name);
  }

  /// Whether an element names something that is gone: joint="…", site1="…", objtype/objname.
  bool refers_to_gone(const XMLElement& element) const {
    bool found = false;
    for (const auto& [kind, names] : removed_)
      for_each_reference(element, kind, [&found, &names = names](const char*, const char* name) {
        found = found || names.count(name) > 0;
      });
    return found;
  }

  /// Drops the elements of a section that name something that is gone, they or one in them; then
  /// their own names are gone too.
  void drop_references(const char* section) {
    for (XMLElement* all = root_.FirstChildElement(section); all;
         all = all->NextSiblingElement(section))
      for (XMLElement *element = all->FirstChildElement(), *next = nullptr; element;
           element = next) {
        next = element->NextSiblingElement();
        bool drop = false;
        for_each_element(*element,
                         [&](const XmlElement& part) { drop = drop || refers_to_gone(part); });
        if (!drop) continue;
        if (const char* name = element->Attribute("name")) record_removed(section, name);
        all->DeleteChild(element);
      }
  }

  /// Only linear actuators pull at something; the others hold, or measure, what no longer moves.
  void drop_other_tendons() {
    std::size_t tendon = 0;
    for (XMLElement* all = root_.FirstChildElement("tendon"); all;
         all = all->NextSiblingElement("tendon"))
      for (XMLElement *element = all->FirstChildElement(), *next = nullptr; element;
           element = next, ++tendon) {
        next = element->NextSiblingElement();
        if (structure_.reads_tendon[tendon]) continue;
        if (const char* name = element->Attribute("name")) record_removed("tendon", name);
        all->DeleteChild(element);
      }
  }

  /// Leaves out the numbers of the joints that go, and controls, whose actuators go.
  void trim_keyframes() {
    std::vector<bool> keep_q(static_cast<std::size_t>(model_.nq), true),
        keep_v(static_cast<std::size_t>(model_.nv), true);
    const auto leave_out = [&](int j) {
      const int type = model_.jnt_type[j];
      const int q = type == mjJNT_FREE ? 7 : type == mjJNT_BALL ? 4 : 1;
      const int v = type == mjJNT_FREE ? 6 : type == mjJNT_BALL ? 3 : 1;
      std::fill_n(keep_q.begin() + model_.jnt_qposadr[j], q, false);
      std::fill_n(keep_v.begin() + model_.jnt_dofadr[j], v, false);
    };
    for (const FrozenJoint& frozen : structure_.frozen) leave_out(frozen.joint);
    for (int j = 0; j < model_.njnt; ++j)
      if (is_beside(model_.jnt_bodyid[j])) leave_out(j);
    const auto trim = [](XMLElement& key, const char* name, const std::vector<bool>& keep) {
      if (!key.Attribute(name)) return;
      const auto numbers = parse_numbers(key.Attribute(name));
      std::string text;
      for (std::size_t k = 0; k < keep.size(); ++k)
        if (keep[k]) text.append(text.empty() ? "" : " ").append(format_number((*numbers)[k]));
      key.SetAttribute(name, text.c_str());
    };
    for (XMLElement* keys = root_.FirstChildElement("keyframe"); keys;
         keys = keys->NextSiblingElement("keyframe"))
      for (XMLElement* key = keys->FirstChildElement("key"); key;
           key = key->NextSiblingElement("key")) {
        trim(*key, "qpos", keep_q);
        trim(*key, "qvel", keep_v);
        key->DeleteAttribute("ctrl");
        key->DeleteAttribute("act");
      }
  }

  XmlFile& xml_;
  const mjModel& model_;
  const Structure& structure_;
  const std::vector<int> beside_ = bodies_beside(model_);
  const TreeElements elements_;
  XMLElement& root_;
  NamesByKind removed_;
  std::map<int, std::pair<Eigen::Vector3d, Eigen::Vector3d>> lines_;  // of joints: axis, anchor
};

bool is_played_as_it_is(const mjModel& model, const Structure& structure) {
  const auto& reads = structure.reads_tendon;
  for (int g = 0; g < model.ngeom; ++g)
    if (is_of_surroundings(model, g)) return false;
  return structure.frozen.empty() && bodies_beside(model).empty() &&
         std::count(reads.begin(), reads.end(), false) == 0 &&
         std::all_of(structure.feet.begin(), structure.feet.end(), [&](const FootContact& foot) {
           return is_ball(model, foot) && name_of(model, mjOBJ_GEOM, foot.geom) == foot.name;
         });
}

}  // namespace

std::string played_robot(const RobotModel& robot, const std::string& design_xml) {
  std::string robot_xml = make_room(design_xml, robot.file);
  const ModelPointer model = compile_mjcf(robot_xml, robot.file);
  if (!has_parts_of(*model, robot.structure))
    throw std::invalid_argument("scene: the text is not of this robot");
  if (is_played_as_it_is(*model, robot.structure)) return robot_xml;
  const auto xml = load_xml(robot_xml, robot.file);
  Player(*xml, *model, robot.structure).run();
  tinyxml2::XMLPrinter printer;
  xml->dom.Print(&printer);
  return printer.CStr();
}

}  // namespace legwright
