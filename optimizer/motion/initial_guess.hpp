// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/home_stance.hpp"
#include "optimizer/motion/layout.hpp"
#include "optimizer/motion/path.hpp"
#include "optimizer/motion/task.hpp"

namespace legwright {

/// The home stance of the initial design with what the task says instead. On a slope its feet are
/// moved downhill below the COM, until gravity's line through the COM meets the ground where it
/// would on the level. The footprint follows the hips of the design unless the task says otherwise
/// (Task::follow_hips).
StyleTargets style_targets(const Morphology& morphology, const Eigen::VectorXd& initial,
                           const Task& task);

/// The same with the footprint of the design initial + change.
StyleTargets at_design(StyleTargets style, const Eigen::VectorXd& change);

/// m₀, a walk without dynamics: the COM glides along the wanted path; each foot stands still where
/// its footprint passes in the middle of its stance, and swings from there to the next along the
/// wanted profile; the trunk is level and faces the heading; joints follow by inverse kinematics
/// from the home pose (motion/whole_body_ik), within their ranges, as near as they come; stance
/// feet share the weight so that it does not tip. Knot T is knot 0 one cycle later.
Eigen::VectorXd initial_guess(const Morphology& morphology, const Layout& layout, const Task& task,
                              const WantedPath& path, const StyleTargets& style,
                              const Eigen::VectorXd& s);

}  // namespace legwright
