// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/foot_pictures.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <optional>

#include "mjcf/read/feet.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/scene/seen_shapes.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/listed.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

// Of the last link, from its hinge to where it touches: collision shapes are simpler than meshes.
constexpr double kHeightApart = 0.1;
constexpr double kPlaceApart = 0.3;

/// The lowest geom of a link that collides, or else the lowest of its meshes that do not.
std::optional<int> lowest_geom(const mjModel& model, const mjData& data, const Structure& structure,
                               int link, bool colliding) {
  std::optional<int> out;
  for (int g = 0; g < model.ngeom; ++g) {
    if (moving_body(model, structure, model.geom_bodyid[g]) != link ||
        collides(model, g) != colliding || (!colliding && model.geom_type[g] != mjGEOM_MESH))
      continue;
    if (!out || lowest_point(model, data, g) < lowest_point(model, data, *out)) out = g;
  }
  return out;
}

}  // namespace

std::vector<std::string> feet_beside_pictures(const RobotModel& robot) {
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  const DataPointer data = kinematics_at(*model, home_qpos(*model), robot.file);
  const std::vector<int> groups = drawn_groups(*model);
  const auto is_drawn = [&](int geom) {
    return groups[static_cast<std::size_t>(geom)] <= kHighestSeenGroup &&
           model->geom_rgba[4 * geom + 3] > 0.0F;
  };
  std::vector<std::string> feet;
  std::string worst;
  double most = 0.0;
  for (const FootContact& foot : robot.structure.feet) {
    const int link = moving_body(*model, robot.structure, foot_body(*model, foot));
    const auto shape = lowest_geom(*model, *data, robot.structure, link, true),
               picture = lowest_geom(*model, *data, robot.structure, link, false);
    const std::vector<int> hinges = moving_joints(*model, robot.structure, link);
    if (!shape || !picture || hinges.empty()) continue;
    const Vector3d touches = lowest_place(*model, *data, *shape),
                   shows = lowest_place(*model, *data, *picture);
    const double length = (touches - vector_at(data->xanchor, hinges.back())).norm();
    const double higher =
        lowest_point(*model, *data, *picture) - lowest_point(*model, *data, *shape);
    if (higher > 0.0 && is_drawn(*shape)) continue;  // the foot of a link that ends above it
    const double beside = (touches - shows).head<2>().norm();
    const double share =
        std::max(std::abs(higher) / (kHeightApart * length), beside / (kPlaceApart * length));
    if (!(share > 1.0)) continue;
    feet.push_back("'" + foot.name + "'");
    if (share < most) continue;
    most = share;
    const char* const kinds[] = {"plane",     "height field", "ball", "capsule",
                                 "ellipsoid", "cylinder",     "box",  "mesh"};
    worst = fmt::format(
        "of '{}' a {} that collides reaches {:.2g} m {} than its meshes, {:.2g} m "
        "beside their lowest point",
        foot.name, kinds[model->geom_type[*shape]], std::abs(higher),
        higher < 0.0 ? "less low" : "lower", beside);
  }
  if (feet.empty()) return {};
  return {
      fmt::format("the collision shapes of feet {} are not what is drawn of them: {}, in the "
                  "home pose. The robot stands on what collides, in MuJoCo too; draw these "
                  "shapes as the meshes are, or let the meshes collide",
                  listed(feet, 6), worst)};
}

}  // namespace legwright
