// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/home_stance_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "mjcf/read/feet.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/elements.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kTouch = 1e-3;  // [m]: as low as the feet

/// Lowest points of the feet in the pose of `data` [m].
std::vector<double> soles(const XmlFile& xml, const mjModel& model, const Structure& structure,
                          const mjData& data) {
  const TreeElements elements = find_elements(xml, model);
  std::vector<double> out;
  for (const FootContact& foot : structure.feet) {
    const int body = foot_body(model, foot);
    const Vector3d point = foot_point(xml, elements, model, foot, {}).constant,
                   up = Vector3d::Map(data.xmat + 9 * body + 6);
    out.push_back(data.xpos[3 * body + 2] + up.dot(point) - foot.radius);
  }
  return out;
}

}  // namespace

std::string why_not_standing(const XmlFile& xml, const mjModel& model, const Structure& structure) {
  if (structure.feet.empty()) return "";
  const DataPointer data = kinematics_at(model, home_qpos(model), xml.file);
  mj_comPos(&model, data.get());
  const std::vector<double> feet = soles(xml, model, structure, *data);
  double mean = 0.0;
  for (const double foot : feet) mean += foot / static_cast<double>(feet.size());
  const double lowest = *std::min_element(feet.begin(), feet.end()),
               centre = data->subtree_com[3 * structure.trunk + 2];
  std::string fault;
  if (centre <= mean)
    fault = fmt::format("its feet are {:.3g} m above its centre of mass", mean - centre);
  double low = std::numeric_limits<double>::infinity();
  for (int g = 0; g < model.ngeom && fault.empty(); ++g) {
    const int body = model.geom_bodyid[g];
    if (model.body_rootid[body] != structure.trunk || !collides(model, g) ||
        moving_body(model, structure, body) != structure.trunk)
      continue;
    const double own = lowest_point(model, *data, g);
    if (own >= std::min(low, lowest + kTouch)) continue;
    low = own;
    const std::string name = name_of(model, mjOBJ_BODY, body);
    fault = fmt::format("{} reaches as low as its feet",
                        name.empty() ? "a body without name" : "body '" + name + "'");
  }
  if (fault.empty()) return "";
  return fmt::format(
      "the robot does not stand in its home pose ({}): {}; give the file a keyframe named home in "
      "which the feet carry the trunk, like <keyframe><key name=\"home\" qpos=\"…\"/></keyframe>",
      home_keyframe(model) >= 0 ? "its keyframe" : "the pose that the file draws", fault);
}

}  // namespace legwright
