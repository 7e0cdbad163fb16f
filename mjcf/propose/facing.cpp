// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/facing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "mjcf/propose/eyes.hpp"
#include "mjcf/propose/side_words.hpp"
#include "mjcf/read/limbs.hpp"
#include "optimizer/design/kinematics.hpp"
#include "optimizer/motion/faced_frame.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;

constexpr double kTimesAlong = 2.0;    // times as far apart along one axis as along the other
constexpr double kClearer = 2.0;       // times as clear as the other way to see hips in two rows
constexpr double kRowsApart = 0.5;     // of the spread within a row: closer ones are none
constexpr double kLeastSpread = 0.01;  // of all hips: rows are not straighter
constexpr double kAhead = 0.1;         // of the spread of all hips: called rows are so far apart
constexpr double kLonger = 1.5;        // times as far apart along one axis as along the other: told
constexpr double kHingeAlong = 0.95;   // cosine between a hinge and an axis along which it is
constexpr std::size_t kRows = 6;  // legs, of which two rows can be told from four feet of a square

/// Where a limb hangs at the trunk or waist, in the trunk's frame, home pose [m].
Vector2d hip_of(const Limb& limb, const PoseKinematics& home) {
  return home.origin(limb.links.at(static_cast<std::size_t>(limb.shared))).head<2>();
}

/// What names tell of where a limb is: row_word() or lateral_word().
using Word = int (*)(const std::string& name);

/// 1, −1 or 0: which of two sides the names of a limb call it, or neither.
int side_of(const Morphology& morphology, const Limb& limb, Word word) {
  if (const int side = word(morphology.feet[static_cast<std::size_t>(limb.foot)].name)) return side;
  for (const int l : limb.links) {
    const Link& link = morphology.links[static_cast<std::size_t>(l)];
    for (const std::string& name : {link.name, link.joint.name})
      if (const int side = word(name)) return side;
  }
  return 0;
}

Vector2d nearest_axis(const Vector2d& along) {
  return std::abs(along.x()) >= std::abs(along.y()) ? Vector2d(std::copysign(1.0, along.x()), 0.0)
                                                    : Vector2d(0.0, std::copysign(1.0, along.y()));
}

/// How clearly hips stand in two rows of as many on either side of an axis: the gap between the
/// rows over the spread within one.
struct Rows {
  double gap = 0.0, clear = 0.0;
};
Rows rows_beside(const Eigen::Matrix2Xd& hips, Eigen::Index across) {
  std::vector<double> at(static_cast<std::size_t>(hips.cols()));
  for (Eigen::Index k = 0; k < hips.cols(); ++k) at[static_cast<std::size_t>(k)] = hips(across, k);
  std::sort(at.begin(), at.end());
  const std::size_t half = at.size() / 2;
  if (at.size() % 2 != 0 || half == 0) return {};
  const double gap = at[half] - at[half - 1];
  const double spread = std::max(at[half - 1] - at.front(), at.back() - at[half]);
  const double least = kLeastSpread * (at.back() - at.front());
  return {gap, gap / std::max({spread, least, 1e-9})};
}

Facing turned_to(const Vector2d& ahead, const std::string& known) {
  return {ahead, known,
          fmt::format("{0}, so it seems to face {1} of its trunk's frame: front and hind, left and "
                      "right are so meant here; a task says so by forward = \"{1}\" in [travel]",
                      known, facing_text(ahead))};
}

/// How far the limbs that names call one side stand from those that they call the other [m].
/// @param called whether there are such; the way is zero where they stand askew, or too near
Vector2d way_between(const RobotModel& robot, const std::vector<Limb>& limbs,
                     const Eigen::Matrix2Xd& hips, Word word, bool& called) {
  Vector2d one = Vector2d::Zero(), other = one;
  int ones = 0, others = 0;
  for (std::size_t k = 0; k < limbs.size(); ++k) {
    const int side = side_of(robot.morphology, limbs[k], word);
    if (side != 0) (side > 0 ? one : other) += hips.col(static_cast<Eigen::Index>(k));
    ones += side > 0;
    others += side < 0;
  }
  called = ones > 0 && others > 0;
  if (!called) return Vector2d::Zero();
  const Vector2d apart = one / ones - other / others;
  const double more = apart.cwiseAbs().maxCoeff(), less = apart.cwiseAbs().minCoeff();
  const double spread = (hips.rowwise().maxCoeff() - hips.rowwise().minCoeff()).maxCoeff();
  if (!(more > kTimesAlong * less && more > kAhead * spread)) return Vector2d::Zero();
  return more * nearest_axis(apart);
}

/// Of two legs that no name calls left or right: they stand side by side, and feet reach ahead.
Facing facing_of_two(const std::vector<Limb>& limbs, const Eigen::Matrix2Xd& hips) {
  const Vector2d apart = (hips.col(0) - hips.col(1)).cwiseAbs();
  if (!(apart.x() > kTimesAlong * apart.y())) return {};
  const double reach = limbs[0].home.y() + limbs[1].home.y() - hips.row(1).sum();
  return turned_to(Vector2d(0.0, reach < -kAhead * apart.x() ? -1.0 : 1.0),
                   fmt::format("its two hips stand {:.3g} m apart along x", apart.x()));
}

/// Whether a leg hangs below its hip and swings along y: most of its hinges turn about x,
/// and none about z, as those of legs that reach out sideways do.
bool swings_along_y(const Limb& limb, const Vector2d& hip) {
  std::array<int, 3> about{};
  for (const Eigen::Vector3d& axis : limb.axes)
    for (int k = 0; k < 3; ++k)
      about.at(static_cast<std::size_t>(k)) += std::abs(axis[k]) > kHingeAlong;
  return about[0] >= 2 && about[0] > about[1] && about[2] == 0 &&
         std::abs(limb.home.y() - hip.y()) < std::abs(limb.home.z());
}

/// Of legs that no name calls front or hind, left or right.
Facing facing_without_names(const RobotModel& robot, const std::vector<Limb>& limbs,
                            const Eigen::Matrix2Xd& hips) {
  Facing out;
  const Rows along_x = rows_beside(hips, 1), along_y = rows_beside(hips, 0);
  if (hips.cols() >= static_cast<Eigen::Index>(kRows) && along_y.clear > kRowsApart &&
      along_y.clear > kClearer * along_x.clear)
    return turned_to(
        Vector2d::UnitY(),
        fmt::format("its hips stand in two rows along y, {:.3g} m apart", along_y.gap));
  if (const std::optional<Eye> eye = eye_of(robot); eye && eye->along != out.ahead)
    return turned_to(eye->along, fmt::format("the camera{} of its trunk looks along {}",
                                             eye->camera.empty() ? "" : " '" + eye->camera + "'",
                                             facing_text(eye->along)));
  if (hips.cols() == 2) return facing_of_two(limbs, hips);
  Eigen::Index swinging = 0;
  for (std::size_t k = 0; k < limbs.size(); ++k)
    swinging += swings_along_y(limbs[k], hips.col(static_cast<Eigen::Index>(k)));
  if (swinging == hips.cols())
    return turned_to(Vector2d::UnitY(), "its legs swing in planes along y");
  const Vector2d spread = hips.rowwise().maxCoeff() - hips.rowwise().minCoeff();
  if (hips.cols() == 4 && spread.y() > kLonger * spread.x())
    out.remark = fmt::format(
        "its hips are {:.3g} m apart along y and {:.3g} m along x, and no name tells front from "
        "hind: +x of its trunk's frame is taken for ahead; if it faces y, say so by forward = "
        "\"+y\" in [travel], and to init by --forward +y",
        spread.y(), spread.x());
  return out;
}

}  // namespace

Facing facing_of(const RobotModel& robot) {
  const Eigen::VectorXd s = robot.space.initial();
  const std::vector<Limb> limbs = find_limbs(robot.morphology, s);
  if (limbs.empty()) return {};
  Eigen::Matrix2Xd hips(2, static_cast<Eigen::Index>(limbs.size()));
  const PoseKinematics home = home_pose(robot.morphology, GeometryAtDesign(robot.morphology, s));
  for (std::size_t k = 0; k < limbs.size(); ++k)
    hips.col(static_cast<Eigen::Index>(k)) = hip_of(limbs[k], home);
  bool called = false;
  const Vector2d front = way_between(robot, limbs, hips, row_word, called);
  if (called) {
    const Vector2d ahead = nearest_axis(front);
    if (front.isZero() || ahead == Vector2d::UnitX()) return {};
    return turned_to(ahead, fmt::format("the legs that are called front hang {:.3g} m along {} "
                                        "from those that are called hind",
                                        front.norm(), facing_text(ahead)));
  }
  const Vector2d left = way_between(robot, limbs, hips, lateral_word, called);
  if (left.isZero()) return facing_without_names(robot, limbs, hips);
  const Vector2d beside = nearest_axis(left), ahead(beside.y(), -beside.x());
  if (ahead == Vector2d::UnitX()) return {};
  return turned_to(ahead, fmt::format("the legs that are called left hang {:.3g} m along {} from "
                                      "those that are called right",
                                      left.norm(), facing_text(beside)));
}

}  // namespace legwright
