// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/floating_root.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "mjcf/read/checks.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/text/text_edits.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kSix = 6;
constexpr double kSpans = 0.5;  // least volume of three unit axes

/// Whether a body moves by three slides and three hinges, each kind in all directions.
bool floats_by_six(const mjModel& model, int body) {
  if (model.body_jntnum[body] != kSix) return false;
  std::array<Matrix3d, 2> axes{Matrix3d::Zero(), Matrix3d::Zero()};
  std::array<int, 2> count{0, 0};
  for (int j = model.body_jntadr[body]; j < model.body_jntadr[body] + kSix; ++j) {
    const int type = model.jnt_type[j];
    if (type != mjJNT_SLIDE && type != mjJNT_HINGE) return false;
    const std::size_t kind = type == mjJNT_SLIDE ? 0 : 1;
    if (count[kind] == 3) return false;
    axes[kind].col(count[kind]++) = vector_at(model.jnt_axis, j);
  }
  return std::all_of(axes.begin(), axes.end(), [](const Matrix3d& of_kind) {
    return std::abs(of_kind.determinant()) > kSpans;
  });
}

/// That body; −1 where there is none or several things move in the world.
int find_root(const mjModel& model) {
  int found = -1;
  for (int b = 1; b < model.nbody; ++b) {
    if (model.body_parentid[b] != 0 || model.body_dofnum[b] == 0) continue;
    if (found >= 0 || !floats_by_six(model, b)) return -1;
    found = b;
  }
  return found >= 0 && model.njnt > kSix ? found : -1;
}

/// The body that an element belongs to, also through frames; null outside of bodies.
const XmlElement* body_around(const XmlElement& element) {
  const XmlElement* around = element.Parent()->ToElement();
  while (around != nullptr && is_tag(*around, "frame")) around = around->Parent()->ToElement();
  return around != nullptr && is_tag(*around, "body") ? around : nullptr;
}

/// The <joint> elements of the body in the main file; empty where they are elsewhere.
std::vector<const XmlElement*> joint_elements(const XmlFile& xml, const std::string& body) {
  std::vector<const XmlElement*> out;
  for_each_element(xml.root(), [&](const XmlElement& element) {
    const XmlElement* const around = is_tag(element, "joint") ? body_around(element) : nullptr;
    if (around != nullptr && attribute(*around, "name") == body) out.push_back(&element);
  });
  return out;
}

/// A name that nothing of the kind has.
std::string free_name(const mjModel& model) {
  std::string name = "root";
  while (mj_name2id(&model, mjOBJ_JOINT, name.c_str()) >= 0) name += "_";
  return name;
}

/// Throws InputError with all elements that name one of the six joints.
void refuse_references(const RobotFiles& files, const SixJointRoot& root) {
  const auto xml = load_xml(files.text(), files.file());
  Refusals reasons;
  for_each_element(xml->root(), [&](const XmlElement& element) {
    const bool lists = attribute(element, "objtype") == "joint";
    for (const char* name : {"joint", "joint1", "joint2", lists ? "objname" : "joint"}) {
      const std::string_view of = attribute(element, name);
      if (of.empty() || std::find(root.joints.begin(), root.joints.end(), of) == root.joints.end())
        continue;
      reasons.add(xml->error(
          element, fmt::format("attribute {}: names '{}', one of the six joints by which the trunk "
                               "'{}' floats; a walking robot floats by itself: remove this, and "
                               "init puts a free joint there",
                               name, of, root.body)));
    }
  });
  reasons.throw_if_any();
}

/// The six numbers that a trunk has in a keyframe, as seven of a free joint and its velocity.
struct FreeState {
  VectorXd qpos, qvel;
};

FreeState free_state(const mjModel& model, int body, const double* qpos, const double* qvel) {
  const DataPointer data(mj_makeData(&model));
  std::copy(qpos, qpos + model.nq, data->qpos);
  std::copy(qvel, qvel + model.nv, data->qvel);
  mj_fwdPosition(&model, data.get());
  mj_fwdVelocity(&model, data.get());
  std::array<double, 6> in_world{}, in_body{};  // turn first, then the origin's velocity
  mj_objectVelocity(&model, data.get(), mjOBJ_XBODY, body, in_world.data(), 0);
  mj_objectVelocity(&model, data.get(), mjOBJ_XBODY, body, in_body.data(), 1);
  const int q = model.jnt_qposadr[model.body_jntadr[body]], v = model.body_dofadr[body];
  FreeState out{VectorXd(model.nq + 1), VectorXd(model.nv)};
  out.qpos << VectorXd::Map(qpos, q), vector_at(data->xpos, body),
      Eigen::Vector4d::Map(data->xquat + std::ptrdiff_t{4} * body),
      VectorXd::Map(qpos + q + kSix, model.nq - q - kSix);
  out.qvel = VectorXd::Map(qvel, model.nv);
  out.qvel.segment<3>(v) = Vector3d::Map(in_world.data() + 3);
  out.qvel.segment<3>(v + 3) = Vector3d::Map(in_body.data());
  return out;
}

/// Gives keyframes the free joint's numbers. Those of velocities only where a keyframe has some.
void change_keyframes(TextEdits& edits, const RobotFiles& files, const XmlFile& xml,
                      const mjModel& model, int body) {
  std::vector<const XmlElement*> keys;
  for_each_element(xml.root(), [&](const XmlElement& element) {
    if (is_tag(element, "key")) keys.push_back(&element);
  });
  if (keys.size() != static_cast<std::size_t>(model.nkey))
    throw InputError(files.file().string(), 0, "keyframe",
                     "stands in an included file, where init cannot change it: put keyframes into "
                     "the main file, or a free joint in the place of the trunk's six");
  for (int k = 0; k < model.nkey; ++k) {
    const XmlElement& key = *keys[static_cast<std::size_t>(k)];
    const FreeState state =
        free_state(model, body, model.key_qpos + k * model.nq, model.key_qvel + k * model.nv);
    if (!attribute(key, "qpos").empty()) edits.set_numbers(key, "qpos", state.qpos);
    if (!attribute(key, "qvel").empty()) edits.set_numbers(key, "qvel", state.qvel);
  }
}

/// With `added` before the first of the joints and all six in comments, so that every line stays
/// where it was.
std::string replaced(const std::string& text, const std::filesystem::path& file,
                     const std::string& body, const std::string& added) {
  const auto xml = load_xml(text, file);
  std::string out = xml->text;
  const std::vector<const XmlElement*> joints = joint_elements(*xml, body);
  for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint) {
    const TagSpan& tag = xml->tag(**joint);
    std::string was = out.substr(tag.begin, tag.close_end - tag.begin);
    if (was.find("--") != std::string::npos)  // ends a comment: its lines alone
      std::erase_if(was, [](char sign) { return sign != '\n' && sign != '\r'; });
    std::string now = *joint == joints.front() ? added + " " : "";
    now += "<!-- " + was + " -->";
    out.replace(tag.begin, tag.close_end - tag.begin, now);
  }
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
    const int body = find_root(*model);
    if (body < 0) return std::nullopt;
    SixJointRoot out{name_of(*model, mjOBJ_BODY, body), {}};
    for (int j = model->body_jntadr[body]; j < model->body_jntadr[body] + kSix; ++j)
      out.joints.push_back(name_of(*model, mjOBJ_JOINT, j));
    if (out.body.empty()) return std::nullopt;
    return out;
  } catch (const InputError&) {
    return std::nullopt;  // its reader tells all faults
  }
}

RobotFiles with_free_root(const RobotFiles& files, const SixJointRoot& root) {
  refuse_references(files, root);
  const auto xml = load_xml(files.main_text(), files.file());
  const ModelPointer model = compile_mjcf(files.text(), files.file());
  const int body = mj_name2id(model.get(), mjOBJ_BODY, root.body.c_str());
  if (joint_elements(*xml, root.body).size() != kSix)
    throw InputError(files.file().string(), 0, fmt::format("body '{}'", root.body),
                     "floats by six joints that are not in the main file, where init could put a "
                     "free joint in their place: write <freejoint/> for them");
  TextEdits edits(*xml);
  change_keyframes(edits, files, *xml, *model, body);
  return files.with_main(replaced(edits.apply(), files.file(), root.body,
                                  fmt::format("<freejoint name=\"{}\"/>", free_name(*model))));
}

}  // namespace legwright
