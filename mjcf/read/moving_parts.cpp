// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/moving_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "mjcf/read/feet.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {

bool has_parts_of(const mjModel& model, const Structure& structure) {
  return structure.moves.size() == static_cast<std::size_t>(model.njnt) &&
         structure.reads_tendon.size() == static_cast<std::size_t>(model.ntendon) &&
         structure.trunk < model.nbody &&
         std::all_of(structure.feet.begin(), structure.feet.end(), [&](const FootContact& foot) {
           return foot.geom < model.ngeom && foot.site < model.nsite &&
                  (foot.others.empty() || foot.others.back() < model.ngeom);
         });
}

std::vector<int> moving_joints(const mjModel& model, const Structure& structure, int body) {
  std::vector<int> out;
  for (int j = model.body_jntadr[body]; j < model.body_jntadr[body] + model.body_jntnum[body]; ++j)
    if (structure.moves[static_cast<std::size_t>(j)]) out.push_back(j);
  return out;
}

namespace {

/// Ends that a body carries through bodies without joints: its own, if it has one.
void collect_ends(const mjModel& model, const Structure& structure, int body,
                  std::vector<int>& ends) {
  if (!moving_joints(model, structure, body).empty()) {
    ends.push_back(body);
    return;
  }
  if (model.body_jntnum[body] > 0) return;
  for (const FootContact& foot : structure.feet)
    if (foot_body(model, foot) == body) ends.push_back(body);
  for (int below = body + 1; below < model.nbody; ++below)
    if (model.body_parentid[below] == body) collect_ends(model, structure, below, ends);
}

}  // namespace

int end_of_fixed(const mjModel& model, const Structure& structure, int body) {
  if (moving_joints(model, structure, model.body_parentid[body]).empty()) return body;
  std::vector<int> ends;
  collect_ends(model, structure, body, ends);
  return ends.size() == 1 ? ends.front() : body;
}

Eigen::Vector3d carried_point(const mjModel& model, const Structure& structure, int body) {
  const int end = end_of_fixed(model, structure, body);
  const std::vector<int> hinges = moving_joints(model, structure, end);
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  if (!hinges.empty()) point = vector_at(model.jnt_pos, hinges.front());
  for (int at = end;; at = model.body_parentid[at]) {
    point = (vector_at(model.body_pos, at) + rotation_at(model.body_quat, at) * point).eval();
    if (at == body) return point;
  }
}

int moving_body(const mjModel& model, const Structure& structure, int body) {
  while (body > 0 && body != structure.trunk && moving_joints(model, structure, body).empty())
    body = model.body_parentid[body];
  return body;
}

std::string held_text(const Structure& structure) {
  std::vector<std::pair<std::string, std::string>> lines;
  for (const FrozenJoint& frozen : structure.frozen) {
    const std::string title = !frozen.name.empty()   ? frozen.name
                              : !frozen.body.empty() ? fmt::format("a joint of {}", frozen.body)
                                                     : "an unnamed joint";
    const auto same = std::find_if(lines.begin(), lines.end(),
                                   [&](const auto& line) { return line.first == frozen.why; });
    if (same == lines.end())
      lines.emplace_back(frozen.why, title);
    else
      same->second += ", " + title;
  }
  std::string text;
  for (const auto& [why, joints] : lines)
    text += fmt::format("  {}, held in the home pose: {}\n", why, joints);
  return text;
}

int home_keyframe(const mjModel& model) {
  const int found = mj_name2id(&model, mjOBJ_KEY, kStandingKey);
  if (found >= 0) return found;
  const int home = mj_name2id(&model, mjOBJ_KEY, "home");
  return home < 0 && model.nkey == 1 ? 0 : home;
}

const mjtNum* home_qpos(const mjModel& model) {
  const int home = home_keyframe(model);
  return home >= 0 ? model.key_qpos + home * model.nq : model.qpos0;
}

}  // namespace legwright
