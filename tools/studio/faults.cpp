// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "optimizer/objective/violations.hpp"
#include "optimizer/terms/registry.hpp"

namespace legwright {
namespace {

// Of equalities, in leg lengths, weights or radians: what nobody sees is no fault.
constexpr double kLeastBroken = 0.01;
constexpr std::size_t kMostFaults = 40;

/// A fault that goes on over some knots.
struct Fault {
  Violation worst;
  int first = 0, last = 0;
};

/// What kind of fault a page draws: by the term that tells it.
std::string kind_of(std::string_view term) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kKinds{{
      {"stance_foot", "slip"},
      {"friction_cone", "cone"},
      {"least_normal_force", "unloaded"},
      {"limb_clearance", "touch"},
      {"joint_limits", "joint"},
      {"stroke_limits", "joint"},
      {"torque_limits", "torque"},
      {"actuator_force", "torque"},
      {"ground_height", "ground"},
      {"swing_height", "swing"},
      {"flat_foot", "ground"},
      {"force_balance", "balance"},
      {"torque_balance", "balance"},
      {"periodicity", "cycle"},
  }};
  for (const auto& [name, kind] : kKinds)
    if (name == term) return std::string(kind);
  return "misfit";
}

std::string words_of(const Violation& worst) {
  const TermEntry* entry = find_term(worst.term);
  std::string words = std::string(entry ? entry->cost_label : worst.term);
  if (!worst.where.empty()) words += fmt::format(", {}", worst.where);
  const bool length = worst.unit == "m";
  return words + fmt::format(": {:.3g}{}", length ? 1e3 * worst.amount : worst.amount,
                             length               ? " mm"
                             : worst.unit.empty() ? ""
                                                  : " " + std::string(worst.unit));
}

/// The link that something is at: the name of a foot, a joint or a link; of a pair the first.
int link_of(const Morphology& morphology, const std::string& where) {
  const std::string name = where.substr(0, where.find(" - "));
  for (const Foot& foot : morphology.feet)
    if (foot.name == name) return foot.link;
  for (std::size_t k = 1; k < morphology.links.size(); ++k)
    if (morphology.links[k].joint.name == name || morphology.links[k].name == name)
      return static_cast<int>(k);
  return 0;
}

int root_body(const mjModel& model) {
  for (int joint = 0; joint < model.njnt; ++joint)
    if (model.jnt_type[joint] == mjJNT_FREE) return model.jnt_bodyid[joint];
  return 0;
}

std::vector<Fault> faults_of(const std::vector<Violation>& broken) {
  std::vector<Fault> faults;
  for (const Violation& one : broken) {
    const auto before = std::find_if(faults.rbegin(), faults.rend(), [&](const Fault& fault) {
      return fault.worst.term == one.term && fault.worst.where == one.where &&
             one.knot <= fault.last + 1;
    });
    if (before == faults.rend()) {
      faults.push_back({one, one.knot, one.knot});
      continue;
    }
    before->last = one.knot;
    if (one.relative > before->worst.relative) before->worst = one;
  }
  std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
    return a.worst.relative > b.worst.relative;
  });
  if (faults.size() > kMostFaults) faults.resize(kMostFaults);
  return faults;
}

}  // namespace

Json faults_json(const SessionState& state, int task, const mjModel& model) {
  const auto k = static_cast<std::size_t>(task);
  const Objective& objective = *state.problem->objectives.at(k);
  const double knots = objective.layout().knot_count();
  Json out = Json::array();
  for (const Fault& fault :
       faults_of(broken_elements(objective, state.s(), state.now->tasks.at(k).m, kLeastBroken))) {
    const int link = link_of(objective.morphology(), fault.worst.where);
    const auto& one = objective.morphology().links.at(static_cast<std::size_t>(link));
    const std::string joint = link == 0 ? "" : one.joint.name;
    const int hinge = joint.empty() ? -1 : mj_name2id(&model, mjOBJ_JOINT, joint.c_str());
    out.push_back({{"kind", kind_of(fault.worst.term)},
                   {"term", fault.worst.term},
                   {"from", fault.first / knots},
                   {"to", std::min(1.0, (fault.last + 1) / knots)},
                   {"where", fault.worst.where},
                   {"joint", joint},
                   {"body", hinge < 0 ? root_body(model) : model.jnt_bodyid[hinge]},
                   {"at", {0, 0, 0}},
                   {"amount", fault.worst.amount},
                   {"unit", fault.worst.unit},
                   {"share", fault.worst.relative},
                   {"words", words_of(fault.worst)}});
  }
  return out;
}

}  // namespace legwright
