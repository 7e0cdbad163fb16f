// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/moving_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

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

Eigen::Vector3d carried_point(const mjModel& model, const Structure& structure, int body) {
  Eigen::Vector3d origin = vector_at(model.body_pos, body);
  const std::vector<int> hinges = moving_joints(model, structure, body);
  if (hinges.empty()) return origin;
  return origin + rotation_at(model.body_quat, body) * vector_at(model.jnt_pos, hinges.front());
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
