// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <memory>
#include <span>

namespace legwright {

inline constexpr double kFieldOfView =
    24.0;  // [deg], vertical: a little telephoto, so that links keep their proportions

struct DataDeleter {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using DataPointer = std::unique_ptr<mjData, DataDeleter>;
struct ModelDeleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
using ModelPointer = std::unique_ptr<mjModel, ModelDeleter>;

/// How cameras are turned so that up in a picture is against gravity: of a slope gravity is what is oblique in the
/// world. Identity where gravity is along z.
Eigen::Matrix3d turn_of_sight(const mjModel& model);

/// Puts the model in a pose: positions of everything that is drawn, no dynamics (so no solver, no
/// warnings, no plugin call). Throws std::invalid_argument for a qpos of the wrong size or with
/// non-finite numbers.
void place(const mjModel& model, mjData& data, std::span<const double> qpos);

}  // namespace legwright
