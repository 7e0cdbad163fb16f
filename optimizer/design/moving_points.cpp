// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/moving_points.hpp"

#include <algorithm>

#include "optimizer/design/inertia.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr std::size_t kMostBits = 64;

/// R(s) of an end's turns, and its derivatives, in the order of the parameters that turn it.
struct EndTurn {
  Matrix3d turn = Matrix3d::Identity();
  std::vector<int> parameters;
  std::vector<Matrix3d> first;
  std::vector<std::vector<Matrix3d>> second;
};

EndTurn turn_at(const std::vector<TurnedVector::Turn>& turns, const VectorXd& s) {
  EndTurn out;
  const std::size_t n = turns.size();
  out.first.assign(n, Matrix3d::Zero());
  out.second.assign(n, std::vector<Matrix3d>(n, Matrix3d::Zero()));
  for (Eigen::Index c = 0; c < 3 && n > 0; ++c) {
    const AxisAtDesign column = axis_at({Vector3d::Unit(c), turns}, s);
    out.turn.col(c) = column.axis;
    out.parameters = column.parameters;
    for (std::size_t k = 0; k < n; ++k) {
      out.first[k].col(c) = column.first[k];
      for (std::size_t l = 0; l < n; ++l) out.second[k][l].col(c) = column.second[k][l];
    }
  }
  return out;
}

void add_turned(const Matrix3d& turn, const std::vector<Vector3d>& of, std::uint64_t bit,
                std::size_t start, MovingPoints::Moves& to) {
  to.ends |= bit;
  for (std::size_t i = 0; i < of.size(); ++i) to.steps[start + i] += turn * of[i];
}

}  // namespace

MovingPoints::MovingPoints(const HullPart& hull, const std::vector<int>& parameters,
                           const VectorXd& s) {
  std::size_t count = 0;
  for (const HullPart::End& end : hull.ends) count += end.points.size();
  points.reserve(count);
  first.assign(parameters.size(), {0, std::vector<Vector3d>(count, Vector3d::Zero())});
  second.resize(pair(parameters.size(), 0));
  for (std::size_t e = 0; e < hull.ends.size(); ++e)
    add(hull.ends[e], std::uint64_t{1} << std::min(e, kMostBits - 1), count, parameters, s);
}

void MovingPoints::add(const HullPart::End& end, std::uint64_t bit, std::size_t count,
                       const std::vector<int>& parameters, const VectorXd& s) {
  const auto index_of = [&](int parameter) {
    return static_cast<std::size_t>(
        std::lower_bound(parameters.begin(), parameters.end(), parameter) - parameters.begin());
  };
  const Vector3d origin = end.origin.at(s);
  const EndTurn turn = turn_at(end.turns, s);
  const std::size_t start = points.size();
  for (const Vector3d& point : end.points) points.emplace_back(origin + turn.turn * point);
  end_of.resize(points.size(), bit);
  for (const AffineVector::Slope& slope : end.origin.slopes) {
    if (slope.slope.isZero(0.0)) continue;
    Moves& moves = first[index_of(slope.parameter)];
    moves.ends |= bit;
    for (std::size_t i = start; i < points.size(); ++i) moves.steps[i] += slope.slope;
  }
  for (std::size_t a = 0; a < turn.parameters.size(); ++a) {
    const std::size_t k = index_of(turn.parameters[a]);
    add_turned(turn.first[a], end.points, bit, start, first[k]);
    for (std::size_t b = 0; b < turn.parameters.size(); ++b) {
      const std::size_t l = index_of(turn.parameters[b]);
      if (l > k) continue;
      Moves& moves = second[pair(k, l)];
      moves.steps.resize(count, Vector3d::Zero());
      add_turned(turn.second[a][b], end.points, bit, start, moves);
    }
  }
}

}  // namespace legwright
