// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/eyes.hpp"

#include <cmath>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kEyeLevel = 0.5;    // sine of how far an eye looks up or down
constexpr double kEyeAlong = 0.866;  // cosine of 30 degrees: others look along no axis

}  // namespace

std::optional<Eye> eye_of(const RobotModel& robot) {
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  std::optional<Eye> found;
  for (int c = 0; c < static_cast<int>(model->ncam); ++c) {
    if (model->cam_bodyid[c] != robot.structure.trunk || model->cam_mode[c] != mjCAMLIGHT_FIXED)
      continue;
    const Vector3d look = -rotation_at(model->cam_quat, c).col(2);
    const Vector2d level = look.head<2>();
    const bool is_outward = vector_at(model->cam_pos, c).head<2>().dot(level) > 0.0;
    if (std::abs(look.z()) > kEyeLevel || !is_outward) continue;
    const double most = level.cwiseAbs().maxCoeff();
    if (most < kEyeAlong * level.norm()) return std::nullopt;
    const Vector2d along = (level / most).array().round();
    if (found && found->along != along) return std::nullopt;
    if (!found) found = Eye{name_of(*model, mjOBJ_CAMERA, c), along};
  }
  return found;
}

}  // namespace legwright
