// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/design/design.hpp"
#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/task.hpp"

namespace legwright::bench {

/// The robot at one design, with nothing left to choose.
Morphology frozen(Morphology robot, const Eigen::VectorXd& s);

/// Gives the robot `count` parameters: three of four move what hangs below a link, and one of the
/// link's masses, along a random direction; the others turn a joint axis.
DesignSpace give_parameters(Morphology& robot, int count);

/// A robot of `rows` rows of two legs, each a copy of the frozen hexapod's middle legs, in rows a
/// leg's length apart, on its trunk. Limbs are not kept off the trunk.
Morphology with_rows(const Morphology& hexapod, int rows);

/// The same task for a robot of with_rows(): feet of odd rows on the left step with those of even
/// rows on the right.
Task alternating(Task task, const Morphology& robot);

}  // namespace legwright::bench
