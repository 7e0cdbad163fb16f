// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/facing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "mjcf/propose/eyes.hpp"
#include "mjcf/propose/side_words.hpp"
#include "mjcf/read/limbs.hpp"
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
constexpr std::size_t kRows = 6;  // legs, of which two rows can be told from four feet of a square

/// Where a limb hangs at the trunk or waist [m].
Vector2d hip_of(const Morphology& morphology, const Limb& limb, const Eigen::VectorXd& s) {
  const Link& first =
      morphology
          .links[static_cast<std::size_t>(limb.links.at(static_cast<std::size_t>(limb.shared)))];
  return first.parent == 0 ? Vector2d(first.origin.at(s).head<2>()) : Vector2d(limb.home.head<2>());
}

/// 1, −1 or 0: whether the names of a limb call it front, hind or neither.
int row_of(const Morphology& morphology, const Limb& limb) {
  if (const int row = row_word(morphology.feet[static_cast<std::size_t>(limb.foot)].name))
    return row;
  for (const int l : limb.links) {
    const Link& link = morphology.links[static_cast<std::size_t>(l)];
    for (const std::string& name : {link.name, link.joint.name})
      if (const int row = row_word(name)) return row;
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

/// Of legs that no name calls front or hind.
Facing facing_without_names(const RobotModel& robot, const Eigen::Matrix2Xd& hips) {
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
  Vector2d front = Vector2d::Zero(), hind = front;
  int fronts = 0, hinds = 0;
  Eigen::Matrix2Xd hips(2, static_cast<Eigen::Index>(limbs.size()));
  for (std::size_t k = 0; k < limbs.size(); ++k) {
    const Vector2d hip = hip_of(robot.morphology, limbs[k], s);
    hips.col(static_cast<Eigen::Index>(k)) = hip;
    const int row = row_of(robot.morphology, limbs[k]);
    if (row != 0) (row > 0 ? front : hind) += hip;
    fronts += row > 0;
    hinds += row < 0;
  }
  Facing out;
  if (fronts > 0 && hinds > 0) {
    const Vector2d apart = front / fronts - hind / hinds;
    const double more = apart.cwiseAbs().maxCoeff(), less = apart.cwiseAbs().minCoeff();
    const double spread = (hips.rowwise().maxCoeff() - hips.rowwise().minCoeff()).maxCoeff();
    if (!(more > kTimesAlong * less && more > kAhead * spread)) return out;
    const Vector2d ahead = nearest_axis(apart);
    if (ahead == Vector2d::UnitX()) return out;
    return turned_to(ahead, fmt::format("the legs that are called front hang {:.3g} m along {} "
                                        "from those that are called hind",
                                        more, facing_text(ahead)));
  }
  return limbs.empty() ? out : facing_without_names(robot, hips);
}

}  // namespace legwright
