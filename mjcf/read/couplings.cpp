// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/couplings.hpp"

#include <fmt/format.h>

#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/elements.hpp"

namespace legwright {
namespace {

std::string title(const mjModel& model, mjtObj type, int id, const std::string& kind) {
  const std::string name = name_of(model, type, id);
  return name.empty() ? kind : fmt::format("{} '{}'", kind, name);
}

/// Whether a tendon acts by itself.
bool pulls(const mjModel& model, int t) {
  return model.tendon_limited[t] || model.tendon_stiffness[t] != 0.0 ||
         model.tendon_damping[t] != 0.0 || model.tendon_frictionloss[t] != 0.0;
}

/// Whether something acts along each tendon; else it only measures.
std::vector<bool> acting_tendons(const mjModel& model) {
  std::vector<bool> out;
  for (int t = 0; t < static_cast<int>(model.ntendon); ++t) out.push_back(pulls(model, t));
  for (int a = 0; a < model.nactuator; ++a)
    if (model.actuator_trntype[a] == mjTRN_TENDON)
      out[static_cast<std::size_t>(model.actuator_trnid[2 * a])] = true;
  return out;
}

/// Joints from a body up to the world.
std::vector<int> joints_above(const mjModel& model, int body) {
  std::vector<int> out;
  for (; body > 0; body = model.body_parentid[body])
    for (int j = 0; j < model.body_jntnum[body]; ++j)
      if (model.jnt_type[model.body_jntadr[body] + j] != mjJNT_FREE)
        out.push_back(model.body_jntadr[body] + j);
  return out;
}

int coupled_body(const mjModel& model, int type, int id) {
  return type == mjOBJ_SITE ? model.site_bodyid[id] : id;
}

}  // namespace

int lone_joint(const mjModel& model, int tendon) {
  const int first = model.tendon_adr[tendon];
  return model.tendon_num[tendon] == 1 && model.wrap_type[first] == mjWRAP_JOINT &&
                 model.tendon_armature[tendon] == 0.0 && !pulls(model, tendon)
             ? model.wrap_objid[first]
             : -1;
}

bool joins_two_sites(const mjModel& model, int tendon) {
  const int first = model.tendon_adr[tendon];
  return model.tendon_num[tendon] == 2 && model.wrap_type[first] == mjWRAP_SITE &&
         model.wrap_type[first + 1] == mjWRAP_SITE;
}

std::vector<int> joints_under(const mjModel& model, int tendon) {
  std::vector<int> out;
  int bodies = 0;
  std::map<int, int> below;  // by joint: how many of the tendon's bodies hang on it
  const auto add = [&](int body) {
    ++bodies;
    for (const int joint : joints_above(model, body)) ++below[joint];
  };
  for (int k = 0; k < model.tendon_num[tendon]; ++k) {
    const int wrap = model.tendon_adr[tendon] + k, object = model.wrap_objid[wrap];
    switch (model.wrap_type[wrap]) {
      case mjWRAP_JOINT:
        out.push_back(object);
        break;
      case mjWRAP_SITE:
        add(model.site_bodyid[object]);
        break;
      case mjWRAP_SPHERE:
      case mjWRAP_CYLINDER:
        add(model.geom_bodyid[object]);
        break;
      default:
        break;
    }
  }
  // What all bodies have above them does not bend the tendon.
  for (const auto& [joint, count] : below)
    if (count < bodies) out.push_back(joint);
  return out;
}

std::map<int, std::string> coupled_joints(const XmlFile& xml, const mjModel& model) {
  std::map<int, std::string> out;
  const auto couple_tendon = [&](int tendon, const std::string& by) {
    for (const int joint : joints_under(model, tendon)) out.emplace(joint, by);
  };
  const SectionElements constraints(xml, "equality"), tendons(xml, "tendon");
  const std::vector<bool> acts = acting_tendons(model);
  for (int e = 0; e < model.neq; ++e) {
    if (!model.eq_active0[e]) continue;
    const std::string by = title(model, mjOBJ_EQUALITY, e,
                                 fmt::format("equality constraint ({})", constraints[e].Name()));
    for (const int id : {model.eq_obj1id[e], model.eq_obj2id[e]}) {
      if (id < 0) continue;
      if (model.eq_type[e] == mjEQ_JOINT) out.emplace(id, by);
      if (model.eq_type[e] == mjEQ_TENDON) couple_tendon(id, by);
    }
  }
  for (int t = 0; t < static_cast<int>(model.ntendon); ++t) {
    if (joins_two_sites(model, t) || !acts[static_cast<std::size_t>(t)] ||
        lone_joint(model, t) >= 0)
      continue;
    couple_tendon(t, title(model, mjOBJ_TENDON, t, std::string(tendons[t].Name()) + " tendon"));
  }
  return out;
}

std::map<int, std::string> joints_of_driven_tendons(const mjModel& model) {
  std::map<int, std::string> out;
  for (int a = 0; a < model.nactuator; ++a) {
    const int tendon = model.actuator_trnid[2 * a];
    if (model.actuator_trntype[a] != mjTRN_TENDON || joins_two_sites(model, tendon)) continue;
    const std::vector<int> joints = joints_under(model, tendon);
    if (joints.size() < 2) continue;
    for (const int joint : joints) out.emplace(joint, name_of(model, mjOBJ_ACTUATOR, a));
  }
  return out;
}

void check_loops(const XmlFile& xml, const mjModel& model, const Structure& structure,
                 Refusals& reasons) {
  const SectionElements constraints(xml, "equality");
  for (int e = 0; e < model.neq; ++e) {
    const int type = model.eq_type[e];
    if (!model.eq_active0[e] || type == mjEQ_JOINT || type == mjEQ_TENDON) continue;
    const XmlElement& element = constraints[e];
    if (type != mjEQ_CONNECT && type != mjEQ_WELD) {
      reasons.add(
          xml.error(element, "ties soft bodies, which the planner does not know; remove it"));
      continue;
    }
    const int one = coupled_body(model, model.eq_objtype[e], model.eq_obj1id[e]),
              two = coupled_body(model, model.eq_objtype[e], model.eq_obj2id[e]);
    if (one > 0 && two > 0 &&
        moving_body(model, structure, one) == moving_body(model, structure, two))
      continue;  // both are held by the same link: it ties nothing that moves
    reasons.add(xml.error(
        element,
        one == 0 || two == 0
            ? "equality constraints that hold a body in the world are not played; remove it"
            : "closes a loop; legs with parallel linkages are not supported, as the planner knows "
              "trees of hinges only, each with its own motor. What it can plan is a robot with "
              "open legs: remove this and the links that end here without a foot, and give each "
              "hinge that is left an actuator (the angles of the real motors follow from the "
              "linkage)"));
  }
}

}  // namespace legwright
