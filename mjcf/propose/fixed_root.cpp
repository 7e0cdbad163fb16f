// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/fixed_root.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

#include "mjcf/propose/trunk_element.hpp"
#include "mjcf/read/checks.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/text_edits.hpp"
#include "mjcf/text/unused_name.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {
namespace {

constexpr int kFewestLimbs = 2;  // one is an arm on its stand

bool has_joints(const XmlElement& body) {
  bool found = false;
  for_each_element(body, [&](const XmlElement& part) { found = found || is_tag(part, "joint"); });
  return found;
}

/// Whether a body stands in the world itself, also in frames.
bool stands_in_the_world(const XmlElement& body) {
  const XmlElement* around = body.Parent()->ToElement();
  while (around != nullptr && is_tag(*around, "frame")) around = around->Parent()->ToElement();
  return around != nullptr && is_tag(*around, "worldbody");
}

/// The one body in the world with joints below it, of a file without a free one; else null.
const XmlElement* only_jointed_body(const XmlFile& xml) {
  std::vector<const XmlElement*> found;
  bool floats = false;
  for_each_element(xml.root(), [&](const XmlElement& element) {
    floats = floats || is_free_joint(element);
    if (is_tag(element, "body") && stands_in_the_world(element) && has_joints(element))
      found.push_back(&element);
  });
  return !floats && found.size() == 1 ? found.front() : nullptr;
}

/// The body of a model that is fixed to the world and carries all that moves in it, in limbs of
/// its own; −1 where there is none.
int fixed_trunk(const mjModel& model) {
  int trunk = -1, limbs = 0;
  for (int b = 1; b < model.nbody; ++b) {
    if (model.body_dofnum[b] == 0 || model.body_weldid[model.body_parentid[b]] != 0) continue;
    const int root = model.body_rootid[b];
    if (root == b || (trunk >= 0 && root != trunk)) return -1;
    trunk = root;
    ++limbs;
  }
  return limbs >= kFewestLimbs && model.body_mocapid[trunk] < 0 ? trunk : -1;
}

/// Numbers of the free joint before those that a keyframe has, which are of no joint before it.
void add_to_keyframes(TextEdits& edits, const std::vector<const XmlElement*>& keys,
                      const mjModel& model, int trunk, const std::filesystem::path& file) {
  const DataPointer data = kinematics_at(model, model.qpos0, file);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const auto at = static_cast<std::ptrdiff_t>(k);
    Eigen::VectorXd qpos(model.nq + 7), qvel = Eigen::VectorXd::Zero(model.nv + 6);
    qpos << vector_at(data->xpos, trunk),
        Eigen::Vector4d::Map(data->xquat + std::ptrdiff_t{4} * trunk),
        Eigen::VectorXd::Map(model.key_qpos + at * model.nq, model.nq);
    qvel.tail(model.nv) = Eigen::VectorXd::Map(model.key_qvel + at * model.nv, model.nv);
    if (has_attribute(*keys[k], "qpos")) edits.set_numbers(*keys[k], "qpos", qpos);
    if (has_attribute(*keys[k], "qvel")) edits.set_numbers(*keys[k], "qvel", qvel);
  }
}

RobotFiles freed(const RobotFiles& files, std::string* told) {
  const auto xml = load_xml(files.main_text(), files.file());
  const auto all = load_xml(files.text(), files.file());
  const XmlElement* const body = only_jointed_body(*xml);
  if (body == nullptr || only_jointed_body(*all) == nullptr) return files;
  check_values(*all);
  const ModelPointer model = compile_mjcf(files.text(), files.file());
  const int trunk = fixed_trunk(*model);
  std::vector<const XmlElement*> keys;
  for_each_element(xml->root(), [&](const XmlElement& element) {
    if (is_tag(element, "key")) keys.push_back(&element);
  });
  if (trunk < 0 || keys.size() != static_cast<std::size_t>(model->nkey)) return files;
  TextEdits edits(*xml);
  add_to_keyframes(edits, keys, *model, trunk, files.file());
  const std::string edited = edits.apply();
  const auto again = load_xml(edited, files.file());
  const std::string joint = unused_name(*model, mjOBJ_JOINT, "root");
  std::string text = again->text;
  text.insert(again->tag(*only_jointed_body(*again)).end,
              fmt::format("<freejoint name=\"{}\"/>", joint));
  const std::string name = name_of(*model, mjOBJ_BODY, trunk);
  *told = fmt::format("a free joint for the trunk{}, which is drawn fixed to the world",
                      name.empty() ? "" : " '" + name + "'");
  return files.with_main(std::move(text));
}

}  // namespace

RobotFiles with_freed_trunk(const RobotFiles& files, std::string* told) {
  told->clear();
  try {
    return freed(files, told);
  } catch (const InputError&) {
    told->clear();
    return files;  // its reader tells all faults
  }
}

}  // namespace legwright
