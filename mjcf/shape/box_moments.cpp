// SPDX-License-Identifier: Apache-2.0
#include "mjcf/shape/box_moments.hpp"

#include <Eigen/Geometry>

#include "mjcf/text/model_arrays.hpp"

namespace legwright {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::optional<Vector3d> box_moments(const mjModel& model, const mjData& data, int body) {
  const Matrix3d axes = matrix_at(data.xmat, body);
  Eigen::AlignedBox3d box;
  for (int g = 0; g < model.ngeom; ++g) {
    if (model.body_weldid[model.geom_bodyid[g]] != model.body_weldid[body]) continue;
    const Vector3d middle = vector_at(model.geom_aabb, 2 * g);
    const Vector3d half = vector_at(model.geom_aabb, 2 * g + 1);
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      const Vector3d at = vector_at(data.geom_xpos, g) +
                          matrix_at(data.geom_xmat, g) * (middle + signs.cwiseProduct(half));
      box.extend(Vector3d(axes.transpose() * (at - vector_at(data.xpos, body))));
    }
  }
  if (box.isEmpty()) return std::nullopt;
  const Vector3d squares = box.sizes().cwiseAbs2();
  return model.body_mass[body] / 12.0 * (Vector3d::Constant(squares.sum()) - squares);
}

}  // namespace legwright
