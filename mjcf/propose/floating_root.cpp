// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/floating_root.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "mjcf/propose/root_chain.hpp"
#include "mjcf/read/checks.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/text/text_edits.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kSix = 6;

/// The body that an element belongs to, also through frames; null outside of bodies.
const XmlElement* body_around(const XmlElement& element) {
  const XmlElement* around = element.Parent()->ToElement();
  while (around != nullptr && is_tag(*around, "frame")) around = around->Parent()->ToElement();
  return around != nullptr && is_tag(*around, "body") ? around : nullptr;
}

/// The trunk in the main file, innermost, and the bodies around it that carry it; empty where they
/// are elsewhere.
std::vector<const XmlElement*> chain_elements(const XmlFile& xml, const SixJointRoot& root) {
  std::vector<const XmlElement*> out;
  for (const XmlElement* body = find_named(xml.root(), "body", root.body); body != nullptr;
       body = body_around(*body))
    out.push_back(body);
  if (out.size() != root.carriers.size() + 1) out.clear();
  return out;
}

/// The <joint> elements of a body.
std::vector<const XmlElement*> joint_elements(const XmlElement& body) {
  std::vector<const XmlElement*> out;
  for_each_element(body, [&](const XmlElement& element) {
    if (is_tag(element, "joint") && body_around(element) == &body) out.push_back(&element);
  });
  return out;
}

/// A name that nothing of the kind has.
std::string free_name(const mjModel& model) {
  std::string name = "root";
  while (mj_name2id(&model, mjOBJ_JOINT, name.c_str()) >= 0) name += "_";
  return name;
}

/// What an element names that goes, by an attribute of a kind: "joint", "body2", objname …; empty
/// where it names none.
std::string named_by(const XmlElement& element, const char* name, const std::string& kind,
                     const std::vector<std::string>& gone) {
  const std::string_view of = attribute(element, name);
  const bool is_object = name == std::string_view("objname");
  const std::string_view type = attribute(element, "objtype");
  if (of.empty() || (is_object && type != kind && !(kind == "body" && type == "xbody"))) return "";
  return std::find(gone.begin(), gone.end(), of) == gone.end() ? "" : std::string(of);
}

/// Whether an element stands in a body that goes and can stand in the trunk as well.
bool moves_along(const XmlElement& element, const XmlElement& carrier) {
  const bool shows =
      is_tag(element, "camera") || is_tag(element, "light") || is_tag(element, "site");
  return shows && element.Parent() == &carrier;
}

/// Throws InputError with all elements that name what goes: one of the six joints, or a body that
/// carries the trunk or a geom of it, and with all else that stands in such a body, unless it moves
/// along.
void refuse_references(const RobotFiles& files, const SixJointRoot& root) {
  const auto xml = load_xml(files.text(), files.file());
  Refusals reasons;
  const auto names = [&](const XmlElement& element, const char* kind, const auto& gone,
                         const auto& fault) {
    const std::string one = std::string(kind) + "1", two = std::string(kind) + "2";
    const char* const looks = kind == std::string_view("body") ? "target" : kind;
    for (const char* name : {kind, one.c_str(), two.c_str(), "objname", looks}) {
      const std::string of = named_by(element, name, kind, gone);
      if (of.empty()) continue;
      reasons.add(
          xml->error(element, fmt::format("attribute {}: names '{}', {}", name, of, fault)));
      return;
    }
  };
  const std::string of_joints = fmt::format(
      "one of the six joints by which the trunk '{}' floats; a walking robot floats by itself: "
      "remove this, and init puts a free joint there",
      root.body);
  const std::string of_bodies = fmt::format(
      "which does nothing but carry the trunk '{0}' on its way to float; name '{0}' or remove "
      "this, "
      "and init puts a free joint there",
      root.body);
  for_each_element(xml->root(), [&](const XmlElement& element) {
    names(element, "joint", root.joints, of_joints);
    names(element, "body", root.carriers, of_bodies);
    names(element, "geom", root.geoms, of_bodies);
  });
  for (const XmlElement* body : chain_elements(*xml, root))
    for_each_element(*body, [&](const XmlElement& element) {
      const bool stays = body_around(element) != body || attribute(*body, "name") == root.body;
      for (const char* tag : {"joint", "inertial", "geom", "frame", "body"})
        if (stays || is_tag(element, tag) || moves_along(element, *body)) return;
      reasons.add(xml->error(
          element,
          fmt::format("stands in a body that does nothing but carry the trunk '{0}' on its "
                      "way to float; put it into '{0}' or remove it, and init puts a free "
                      "joint there",
                      root.body)));
    });
  reasons.throw_if_any();
}

/// The six numbers that a trunk has in a keyframe, as seven of a free joint and its velocity.
struct FreeState {
  VectorXd qpos, qvel;
};

FreeState free_state(const mjModel& model, int body, int first, const double* qpos,
                     const double* qvel) {
  const DataPointer data(mj_makeData(&model));
  std::copy(qpos, qpos + model.nq, data->qpos);
  std::copy(qvel, qvel + model.nv, data->qvel);
  mj_fwdPosition(&model, data.get());
  mj_fwdVelocity(&model, data.get());
  std::array<double, 6> in_world{}, in_body{};  // turn first, then the origin's velocity
  mj_objectVelocity(&model, data.get(), mjOBJ_XBODY, body, in_world.data(), 0);
  mj_objectVelocity(&model, data.get(), mjOBJ_XBODY, body, in_body.data(), 1);
  const int q = model.jnt_qposadr[first], v = model.jnt_dofadr[first];
  FreeState out{VectorXd(model.nq + 1), VectorXd(model.nv)};
  out.qpos << VectorXd::Map(qpos, q), vector_at(data->xpos, body),
      Eigen::Vector4d::Map(data->xquat + std::ptrdiff_t{4} * body),
      VectorXd::Map(qpos + q + kSix, model.nq - q - kSix);
  out.qvel = VectorXd::Map(qvel, model.nv);
  out.qvel.segment<3>(v) = Vector3d::Map(in_world.data() + 3);
  out.qvel.segment<3>(v + 3) = Vector3d::Map(in_body.data());
  return out;
}

/// An error at an element that may stand in any of the robot's files.
InputError at_named(const RobotFiles& files, const char* tag, const std::string& name,
                    const std::string& message) {
  const auto whole = load_xml(files.text(), files.file());
  const XmlElement* const element = find_named(whole->root(), tag, name);
  return files.located(whole->error(element ? *element : whole->root(), message));
}

InputError at_first_key(const RobotFiles& files, const std::string& message) {
  const auto whole = load_xml(files.text(), files.file());
  const XmlElement* key = nullptr;
  for_each_element(whole->root(), [&](const XmlElement& element) {
    if (!key && is_tag(element, "key")) key = &element;
  });
  return files.located(whole->error(key ? *key : whole->root(), message));
}

/// Gives keyframes the free joint's numbers. Those of velocities only where a keyframe has some.
void change_keyframes(TextEdits& edits, const RobotFiles& files, const XmlFile& xml,
                      const mjModel& model, int body, int first) {
  std::vector<const XmlElement*> keys;
  for_each_element(xml.root(), [&](const XmlElement& element) {
    if (is_tag(element, "key")) keys.push_back(&element);
  });
  if (keys.size() != static_cast<std::size_t>(model.nkey))
    throw at_first_key(
        files,
        "stands in an included file, where init cannot change it: put keyframes into "
        "the main file, or a free joint in the place of the trunk's six");
  for (int k = 0; k < model.nkey; ++k) {
    const XmlElement& key = *keys[static_cast<std::size_t>(k)];
    const FreeState state = free_state(model, body, first, model.key_qpos + k * model.nq,
                                       model.key_qvel + k * model.nv);
    if (!attribute(key, "qpos").empty()) edits.set_numbers(key, "qpos", state.qpos);
    if (!attribute(key, "qvel").empty()) edits.set_numbers(key, "qvel", state.qvel);
  }
}

/// Where the carried trunk stands while all of the six are at rest, in its own attributes, and the
/// class of defaults that it had from around it.
void place_trunk(TextEdits& edits, const std::vector<const XmlElement*>& chain,
                 const mjModel& model, int body, const std::filesystem::path& file) {
  const XmlElement& trunk = *chain.front();
  const DataPointer data = kinematics_at(model, model.qpos0, file);
  edits.set_numbers(trunk, "pos", vector_at(data->xpos, body));
  for (const char* name : {"euler", "axisangle", "xyaxes", "zaxis"}) edits.remove(trunk, name);
  edits.set_numbers(trunk, "quat", Eigen::Vector4d::Map(data->xquat + std::ptrdiff_t{4} * body));
  const XmlElement* around = &trunk;
  while (around != chain.back() && !has_attribute(*around, "childclass"))
    around = around->Parent()->ToElement();
  if (around != &trunk && has_attribute(*around, "childclass"))
    edits.set(trunk, "childclass", std::string(attribute(*around, "childclass")));
}

/// The class of defaults that a body's elements have from it or from bodies around it.
std::string class_within(const XmlFile& xml, const XmlElement& body) {
  for (const XmlElement* around = &body; around != nullptr;
       around = around->Parent() ? around->Parent()->ToElement() : nullptr)
    if (has_attribute(*around, "childclass")) return std::string(attribute(*around, "childclass"));
  const XmlElement* const defaults = xml.root().FirstChildElement("default");
  const bool named = defaults != nullptr && has_attribute(*defaults, "class");
  return named ? std::string(attribute(*defaults, "class")) : "main";
}

/// Cameras, lights and sites of the bodies that carried the trunk, for it, each in a frame that has
/// the place and the class of its body; without line ends.
std::string moved_along(const XmlFile& xml, const std::vector<const XmlElement*>& chain,
                        const mjModel& model, const std::filesystem::path& file) {
  const DataPointer data = kinematics_at(model, model.qpos0, file);
  const auto pose_of_body = [&](const XmlElement& body) {
    const std::string name(attribute(body, "name"));
    const int id = mj_name2id(&model, mjOBJ_BODY, name.c_str());
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = rotation_at(data->xquat, id);
    pose.translation() = vector_at(data->xpos, id);
    return pose;
  };
  std::string out;
  for (std::size_t k = 1; k < chain.size(); ++k) {
    const Eigen::Isometry3d in_trunk =
        pose_of_body(*chain.front()).inverse() * pose_of_body(*chain[k]);
    const Eigen::Quaterniond turn(in_trunk.rotation());
    const Eigen::Vector4d quat(turn.w(), turn.x(), turn.y(), turn.z());
    for_each_element(*chain[k], [&](const XmlElement& element) {
      if (!moves_along(element, *chain[k])) return;
      const TagSpan& tag = xml.tag(element);
      std::string text = xml.text.substr(tag.begin, tag.close_end - tag.begin);
      for (char& c : text)
        if (c == '\n' || c == '\r') c = ' ';
      out += fmt::format("<frame childclass=\"{}\" pos=\"{}\" quat=\"{}\">{}</frame>",
                         escape_xml(class_within(xml, *chain[k])),
                         format_numbers(in_trunk.translation()), format_numbers(quat), text);
    });
  }
  return out;
}

/// As a comment of as many lines: two dashes would end it.
std::string commented(std::string was) {
  for (std::size_t at; (at = was.find("--")) != std::string::npos;) was.insert(at + 1, " ");
  return "<!-- " + was + " -->";
}

/// With `added` before the first joint of the trunk, what moves along at its head, and all six in
/// comments, and with them the bodies that carried it, so that every line stays where it was.
std::string replaced(const std::string& text, const std::filesystem::path& file,
                     const SixJointRoot& root, const std::string& added, const std::string& moved) {
  const auto xml = load_xml(text, file);
  std::string out = xml->text;
  const std::vector<const XmlElement*> chain = chain_elements(*xml, root);
  const TagSpan &trunk = xml->tag(*chain.front()), &outer = xml->tag(*chain.back());
  const auto comment = [&](std::size_t begin, std::size_t end, const std::string& before) {
    if (end > begin)
      out.replace(begin, end - begin, before + commented(out.substr(begin, end - begin)));
  };
  comment(trunk.close_end, outer.close_end, "");
  const std::vector<const XmlElement*> joints = joint_elements(*chain.front());
  for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint) {
    const TagSpan& tag = xml->tag(**joint);
    comment(tag.begin, tag.close_end, *joint == joints.front() ? added + " " : "");
  }
  out.insert(trunk.end, (joints.empty() ? added : "") + moved);
  comment(outer.begin, trunk.begin, "");
  return out;
}

}  // namespace

std::optional<SixJointRoot> find_six_joint_root(const std::string& text,
                                                const std::filesystem::path& file) {
  try {
    const auto xml = load_xml(text, file);
    bool floats = false;
    for_each_element(xml->root(), [&](const XmlElement& element) {
      floats = floats || is_tag(element, "freejoint") || attribute(element, "type") == "free";
    });
    if (floats) return std::nullopt;
    check_values(*xml);
    const ModelPointer model = compile_mjcf(xml->text, file);
    return find_floating_chain(*model);
  } catch (const InputError&) {
    return std::nullopt;  // its reader tells all faults
  }
}

RobotFiles with_free_root(const RobotFiles& files, const SixJointRoot& root) {
  refuse_references(files, root);
  const auto xml = load_xml(files.main_text(), files.file());
  const ModelPointer model = compile_mjcf(files.text(), files.file());
  const int body = mj_name2id(model.get(), mjOBJ_BODY, root.body.c_str());
  const std::vector<const XmlElement*> chain = chain_elements(*xml, root);
  std::size_t joints = 0;
  for (const XmlElement* const of : chain) joints += joint_elements(*of).size();
  const bool is_carried = chain.size() > 1;
  if (joints != kSix || (is_carried && !is_tag(*chain.back()->Parent()->ToElement(), "worldbody")))
    throw at_named(files, "body", root.body,
                   "floats by six joints that are not in the main file, or in a frame, where "
                   "init could put a free joint in their place: write <freejoint/> for them");
  TextEdits edits(*xml);
  if (is_carried) place_trunk(edits, chain, *model, body, files.file());
  change_keyframes(edits, files, *xml, *model, body, root.first);
  const std::string moved = moved_along(*xml, chain, *model, files.file());
  return files.with_main(replaced(edits.apply(), files.file(), root,
                                  fmt::format("<freejoint name=\"{}\"/>", free_name(*model)),
                                  moved));
}

}  // namespace legwright
