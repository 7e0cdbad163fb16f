// SPDX-License-Identifier: Apache-2.0
#include "tools/render/gait_animation.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>

namespace legwright {
namespace {

constexpr int kAnimationWidth = 480, kAnimationHeight = 360;
constexpr double kFramesPerSecond = 24.0;
constexpr int kMostCycles = 2;
constexpr double kUnseen = 0.006;  // [m] a jump of the floor that nobody sees
constexpr Rgb kLabelColour{70, 76, 84};

/// Side of the pattern on the first floor that has one [m]; MuJoCo counts repeats per metre.
double floor_tile(const mjModel& model) {
  for (int g = 0; g < model.ngeom; ++g) {
    const int material = model.geom_matid[g];
    if (model.geom_type[g] != mjGEOM_PLANE || material < 0 || !model.mat_texuniform[material])
      continue;
    const double repeat = model.mat_texrepeat[2 * material];
    return repeat > 0.0 ? 1.0 / repeat : 0.0;
  }
  return 0.0;
}

ModelPointer with_floor(const mjModel& model, const LoopFloor& floor) {
  ModelPointer copy(mj_copyModel(nullptr, &model));
  if (!copy) throw std::bad_alloc();
  for (int g = 0; g < copy->ngeom; ++g) {
    const int material = copy->geom_matid[g];
    if (copy->geom_type[g] != mjGEOM_PLANE || material < 0) continue;
    for (std::size_t axis : {0U, 1U}) {
      copy->mat_texrepeat[2 * static_cast<std::size_t>(material) + axis] /=
          static_cast<float>(floor.stretch[axis]);
    }
    break;
  }
  return copy;
}

/// Where the poses come from: the simulation once it passed, otherwise the plan.
class PoseSource {
 public:
  explicit PoseSource(const GaitClip& clip) : clip_(clip), period_(clip.plan.period) {
    const double end = clip.playback ? clip.playback->time.back() : 0.0;
    whole_ = static_cast<int>(std::floor(end / period_ + 1e-6));
    simulated_ = clip.passed.value_or(false) && whole_ >= 2;
  }
  bool simulated() const { return simulated_; }
  int most_cycles() const { return simulated_ ? std::min(kMostCycles, whole_ - 1) : kMostCycles; }
  std::vector<double> pose(double time, int cycles) const {
    if (!simulated_) return clip_.planned_at(time);
    return pose_at(*clip_.model, *clip_.playback, (whole_ - cycles) * period_ + time);
  }

 private:
  const GaitClip& clip_;
  double period_;
  int whole_ = 0;
  bool simulated_ = false;
};

}  // namespace

LoopFloor loop_floor(const std::array<double, 2>& travel, double tile) {
  if (tile <= 0.0) return {};
  for (int cycles = 1; cycles <= kMostCycles; ++cycles) {
    LoopFloor floor{cycles, {0.0, 0.0}};
    bool fits = true;
    for (std::size_t axis : {0U, 1U}) {
      const double way = std::abs(travel[axis]) * cycles;
      if (way < kUnseen) continue;
      const double tiles = std::max(1.0, std::round(way / tile));
      floor.stretch[axis] = way / tiles / tile;
      fits = fits && std::abs(floor.stretch[axis] - 1.0) <= 0.4;
    }
    if (!fits) continue;
    for (std::size_t axis : {0U, 1U}) {  // squares stay square where there is a choice
      if (floor.stretch[axis] == 0.0) floor.stretch[axis] = floor.stretch[1 - axis];
      if (floor.stretch[axis] == 0.0) floor.stretch[axis] = 1.0;
    }
    return floor;
  }
  return {};
}

Animation animate_gait(const GlContext& context, const GaitClip& clip) {
  const PoseSource source(clip);
  const auto way = [&](int cycles) {
    const auto from = source.pose(0.0, cycles), to = source.pose(cycles * clip.plan.period, cycles);
    return std::array<double, 2>{to[0] - from[0], to[1] - from[1]};
  };
  LoopFloor floor = loop_floor(way(1), floor_tile(*clip.model));
  const bool turns = std::abs(clip.plan.turn) > 0.01;  // then no pattern joins
  if (turns || floor.cycles > source.most_cycles()) floor = {};
  const ModelPointer model = with_floor(*clip.model, floor);
  const double seconds = floor.cycles * clip.plan.period;
  const int count = std::max(8, static_cast<int>(std::lround(seconds * kFramesPerSecond)));
  const auto travel = way(floor.cycles);
  Poses poses, at_home;  // the latter with the way taken out
  for (int k = 0; k < count; ++k) {
    poses.push_back(source.pose(seconds * k / count, floor.cycles));
    at_home.push_back(poses.back());
    for (std::size_t axis : {0U, 1U}) at_home.back()[axis] -= travel[axis] * k / count;
  }
  const View home = frame_robot(*model, at_home, side_view(travel[0], travel[1]), kSideElevation,
                                static_cast<double>(kAnimationWidth) / kAnimationHeight, 0.10);
  Renderer renderer(context, *model, kAnimationWidth * kSampling, kAnimationHeight * kSampling,
                    RenderStyle::cheap);
  const Mask label = renderer.text(source.simulated() ? "simulated by MuJoCo" : "planned gait");
  Animation animation;
  for (int k = 0; k < count; ++k) {
    View view = home;
    for (std::size_t axis : {0U, 1U}) view.lookat[axis] += travel[axis] * k / count;
    if (turns) view.azimuth += clip.plan.turn * 180.0 / std::numbers::pi * floor.cycles * k / count;
    Image frame = downsample(renderer.render(poses[static_cast<std::size_t>(k)], view), kSampling);
    stamp(frame, label, 10, 8, kLabelColour);
    animation.frames.push_back(std::move(frame));
    animation.end_ms.push_back(static_cast<int>(std::lround(1000.0 * seconds * (k + 1) / count)));
  }
  return animation;
}

}  // namespace legwright
