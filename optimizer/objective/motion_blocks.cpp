// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/motion_blocks.hpp"

#include <algorithm>

namespace legwright {

void MotionBlocks::plan(const Layout& layout, const DerivedBlocks& blocks,
                        ElementPlanner& planner) {
  pose_size_ = layout.pose_size();
  std::size_t most_poses = 0;  // of one quantity
  for (const auto& block : blocks) most_poses = std::max(most_poses, block->pose_count());
  const int T = layout.knot_count();
  const auto clique_of = [&](const std::vector<int>& knots) {
    std::vector<int> slots;
    for (const int knot : knots)
      for (int c = 0; c < pose_size_; ++c) slots.push_back(layout.pose(knot) + c);
    return planner.clique_of(std::move(slots));
  };
  if (most_poses > 0) {
    for (int i = 0; i <= T; ++i) poses_.push_back({clique_of({i}), {}});
    poses_.push_back({clique_of({T - 1}), {}});  // moved back by one cycle
  }
  if (most_poses > 1) {
    for (int i = 0; i < T; ++i) pairs_.push_back({clique_of({i, i + 1}), {}});
    pairs_.push_back({clique_of({T - 1, 0}), {}});
  }
}

void MotionBlocks::locate() {
  const auto find = [this](std::vector<Block>& blocks, int first_row) {
    for (Block& block : blocks) {
      block.column.resize(static_cast<std::size_t>(pose_size_));
      block.clique->for_each_run([&](int column, int first, int, int position) {
        if (first >= first_row && column < pose_size_)
          block.column[static_cast<std::size_t>(column)] = position - (first - first_row);
      });
    }
  };
  find(poses_, 0);
  find(pairs_, pose_size_);
}

void MotionBlocks::add(const Morphology& morphology, const RobotAtPoint& robot,
                       const MotionLoads& loads, double* mm) const {
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    if (loads.poses[i].empty()) continue;
    const int* column = poses_[i].column.data();
    loads.poses[i].for_each(morphology, robot.poses[i],
                            [&](int a, int b, double value) { mm[column[a] + b] += value; });
  }
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (loads.pairs[i].empty()) continue;
    const bool wraps = i + 1 == pairs_.size();  // the first pose of this pair is the later one
    const PoseKinematics &first = robot.poses[wraps ? i + 1 : i],
                         &second = robot.poses[wraps ? 0 : i + 1];
    const int* column = pairs_[i].column.data();
    if (wraps)
      loads.pairs[i].for_each(morphology, first, second,
                              [&](int a, int b, double value) { mm[column[b] + a] += value; });
    else
      loads.pairs[i].for_each(morphology, first, second,
                              [&](int a, int b, double value) { mm[column[a] + b] += value; });
  }
}

}  // namespace legwright
