// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/root_chain.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "mjcf/read/feet.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;

constexpr int kJointsOfARoot = 6;
constexpr double kSpans = 0.5;      // least volume of three unit axes
constexpr double kWeighing = 0.02;  // of the robot's mass: more is no mere carrier

/// The one child of a body; −1 where it has none or several.
int only_child(const mjModel& model, int body) {
  int found = -1;
  for (int b = body + 1; b < model.nbody; ++b) {
    if (model.body_parentid[b] != body) continue;
    if (found >= 0) return -1;
    found = b;
  }
  return found;
}

/// Whether a body may go: it weighs next to nothing and touches nothing.
bool only_carries(const mjModel& model, int body) {
  const double all = model.body_subtreemass[model.body_rootid[body]];
  if (model.body_mass[body] > kWeighing * all) return false;
  for (int g = 0; g < model.ngeom; ++g)
    if (model.geom_bodyid[g] == body && collides(model, g)) return false;
  return true;
}

/// From a child of the world down to the body that has the sixth joint, or, where the joints are
/// those of several, to what is fixed on that; empty where there are not six joints, or bodies
/// above the last do more than carry it. A body that has all six may be the trunk itself, or a
/// frame around it: what stands in it stays.
std::vector<int> chain_from(const mjModel& model, int first) {
  std::vector<int> out{first};
  int joints = model.body_jntnum[first];
  while (joints < kJointsOfARoot) {
    const int next = only_child(model, out.back());
    if (next < 0 || !only_carries(model, out.back())) return {};
    out.push_back(next);
    joints += model.body_jntnum[next];
  }
  if (joints > kJointsOfARoot) return {};
  if (out.size() == 1) return out;
  while (only_carries(model, out.back())) {
    const int next = only_child(model, out.back());
    if (next < 0 || model.body_jntnum[next] > 0) break;
    out.push_back(next);
  }
  return out;
}

/// Whether six joints are three slides and three hinges, each kind in all directions.
bool spans_space(const mjModel& model, const mjData& data, int first) {
  std::array<Matrix3d, 2> axes{Matrix3d::Zero(), Matrix3d::Zero()};
  std::array<int, 2> count{0, 0};
  for (int j = first; j < first + kJointsOfARoot; ++j) {
    const int type = model.jnt_type[j];
    if (type != mjJNT_SLIDE && type != mjJNT_HINGE) return false;
    const std::size_t kind = type == mjJNT_SLIDE ? 0 : 1;
    if (count[kind] == 3) return false;
    axes[kind].col(count[kind]++) = vector_at(data.xaxis, j);
  }
  return std::all_of(axes.begin(), axes.end(), [](const Matrix3d& of_kind) {
    return std::abs(of_kind.determinant()) > kSpans;
  });
}

}  // namespace

std::optional<SixJointRoot> find_floating_chain(const mjModel& model) {
  int first = -1;
  for (int b = 1; b < model.nbody; ++b) {
    if (model.body_parentid[b] != 0 || model.body_dofnum[b] == 0) continue;
    if (first >= 0) return std::nullopt;  // several things move in the world
    first = b;
  }
  if (first < 0 || model.njnt <= kJointsOfARoot) return std::nullopt;
  const std::vector<int> chain = chain_from(model, first);
  const DataPointer data = kinematics_at(model, model.qpos0, "");
  SixJointRoot out;
  out.first = model.body_jntadr[first];
  if (chain.empty() || !spans_space(model, *data, out.first)) return std::nullopt;
  out.body = name_of(model, mjOBJ_BODY, chain.back());
  if (out.body.empty()) return std::nullopt;
  for (int j = out.first; j < out.first + kJointsOfARoot; ++j)
    out.joints.push_back(name_of(model, mjOBJ_JOINT, j));
  for (const int body : chain) {
    if (body == chain.back()) break;
    out.carriers.push_back(name_of(model, mjOBJ_BODY, body));
    for (int g = 0; g < model.ngeom; ++g)
      if (model.geom_bodyid[g] == body) out.geoms.push_back(name_of(model, mjOBJ_GEOM, g));
  }
  return out;
}

}  // namespace legwright
