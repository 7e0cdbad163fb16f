// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <memory>

#include "plugin/pd_playback.hpp"
#include "plugin/robot_state.hpp"

namespace legwright {

/// The robot as the plan has it, see-through, to be drawn beside the real one. Owns a copy of the
/// model without plugins, so that making its data calls none of them.
class Ghost {
 public:
  /// Copies the model: costs its size in memory. Throws std::bad_alloc.
  Ghost(const mjModel* m, const Robot& robot);

  /// Adds the ghost's geoms, as they are in the plan at `time`, to the scene: decoration of the
  /// groups that the viewer shows. Adds nothing where the scene has not the room for all of it.
  void draw(const PdPlayback& playback, double time, const mjvOption* option,
            mjvScene* scene) const noexcept;

 private:
  struct Free {
    void operator()(mjModel* m) const noexcept { mj_deleteModel(m); }
    void operator()(mjData* d) const noexcept { mj_deleteData(d); }
  };
  Robot robot_;
  std::unique_ptr<mjModel, Free> model_;
  std::unique_ptr<mjData, Free> data_;
  int most_geoms_ = 0;
};

}  // namespace legwright
