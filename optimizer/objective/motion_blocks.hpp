// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "optimizer/motion/layout.hpp"
#include "optimizer/objective/derived/quantity.hpp"
#include "optimizer/objective/element_plan.hpp"

namespace legwright {

/// Where the second derivatives of MotionLoads stand in ∂G/∂m: a block for each pose, and one for
/// each pair of poses.
class MotionBlocks {
 public:
  /// Asks for the blocks that derived quantities may load; before Sparsity::build.
  void plan(const Layout& layout, const DerivedBlocks& blocks, ElementPlanner& planner);
  /// Finds them; after it.
  void locate();
  /// Adds what was asked for to the values of ∂G/∂m.
  void add(const Morphology& morphology, const RobotAtPoint& robot, const MotionLoads& loads,
           double* mm) const;

 private:
  struct Block {
    std::shared_ptr<const Clique> clique;
    /// Earlier pose's coordinate → index among the values of its column's entry in the row of the
    /// (later) pose's coordinate 0, if there is one.
    std::vector<int> column;
  };
  int pose_size_ = 0;
  std::vector<Block> poses_, pairs_;  // as in MotionLoads
};

}  // namespace legwright
