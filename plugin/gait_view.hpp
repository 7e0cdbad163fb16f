// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <vector>

#include "plugin/drawing.hpp"
#include "plugin/ghost.hpp"
#include "plugin/pd_playback.hpp"

namespace legwright {

/// What one instance adds to the viewer's scene, each under one of the viewer's own switches:
///   geom group `ghost_group`   the ghost,
///   mjVIS_COM                  planned COM and its path, a cycle back and a cycle ahead,
///   mjVIS_CONTACTPOINT         planned paths and holds of the feet,
///   mjVIS_CONTACTFORCE         planned forces on the feet, to the scale of the measured ones.
/// Belongs to one mjData; not for several threads at once.
class GaitView {
 public:
  /// @param playback must outlive it.
  GaitView(const mjModel* m, const PdPlayback& playback);

  void draw(const mjModel* m, const mjData* d, const mjvOption* option, mjvScene* scene);

 private:
  void draw_com(Pen& pen, const SplinePhase& now) const noexcept;
  void draw_feet(Pen& pen, const SplinePhase& now) const noexcept;
  void draw_forces(const mjModel* m, const mjData* d, Pen& pen) const noexcept;
  Point point_of_force(const mjModel* m, const mjData* d, int foot) const noexcept;

  const PdPlayback& playback_;
  PlannedMotion plan_;
  Robot robot_;
  double size_;                    // mean size of a body [m]: decoration follows it
  std::vector<int> foot_of_geom_;  // −1: no foot; feet that the model does not name are left out
  std::vector<int> geom_of_foot_;  // −1: not in the model
  std::unique_ptr<Ghost> ghost_;   // made when it is first shown
};

}  // namespace legwright
