// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/pose_correction.hpp"

#include <Eigen/Cholesky>
#include <limits>
#include <numeric>

namespace legwright {
namespace {

using Eigen::VectorXd;

// The Jacobian of the base serves all steps of a correction.
constexpr int kCorrections = 4;
constexpr double kSmallMiss = 1e-6;    // of the leg length: a miss that counts for nothing
constexpr double kPoseDamping = 1e-3;  // of (leg length)², where a leg is stretched
// The trunk turns less than joints do: its momentum would spoil eq (13).
constexpr double kTrunkTurn = 0.1;

}  // namespace

PoseCorrection::PoseCorrection(const Morphology& morphology, const Layout& layout,
                               const VectorXd& units)
    : morphology_(morphology),
      layout_(layout),
      units_(units),
      ancestry_(morphology),
      knots_(static_cast<std::size_t>(layout.knot_count()) + 1) {
  columns_.resize(static_cast<std::size_t>(layout.pose_size()) + layout.design_size());
  std::iota(columns_.begin(), columns_.end(), 0);
}

void PoseCorrection::compute_miss(const VectorXd& m, int knot, VectorXd& out) {
  pose_.compute(morphology_, geometry_, m.segment(at(layout_.pose(knot)), layout_.pose_size()),
                PoseDetail::place);
  out.resize(miss_size());
  out.head<3>() =
      pose_.first_moment(0) / geometry_.total_mass - m.segment<3>(at(layout_.com(knot)));
  for (int j = 0; j < layout_.foot_count(); ++j)
    out.segment<3>(3 + 3 * j) =
        foot_place(morphology_, geometry_, pose_, j) - m.segment<3>(at(layout_.foot(knot, j)));
}

void PoseCorrection::take_design(const VectorXd& s) {
  if (geometry_s_.size() == s.size() && geometry_s_ == s) return;
  geometry_ = GeometryAtDesign(morphology_, s);
  geometry_s_ = s;
}

void PoseCorrection::set_base(const VectorXd& s, const VectorXd& m) {
  take_design(s);
  base_s_ = s;
  base_m_ = m;
  for (int i = 0; i <= layout_.knot_count(); ++i) linearise(m, i);
}

void PoseCorrection::linearise(const VectorXd& m, int index) {
  Knot& knot = knots_[index];
  const int size = layout_.pose_size(), columns = size + layout_.design_size();
  compute_miss(m, index, knot.miss);
  const auto q = m.segment(at(layout_.pose(index)), size);
  pose_.compute(morphology_, geometry_, q, PoseDetail::design);
  knot.jacobian.resize(columns, miss_size());
  const auto add = [&](int first) {
    rows_.setZero(columns, 3);
    point_.add_jacobian(rows_);
    knot.jacobian.middleCols<3>(first) = rows_;
  };
  com_from_pose(geometry_, ancestry_, pose_, columns_, point_);
  add(0);
  for (int j = 0; j < layout_.foot_count(); ++j) {
    foot_from_pose(morphology_, geometry_, ancestry_, pose_, j, columns_, point_);
    add(3 + 3 * j);
  }
  VectorXd room = units_.segment(at(layout_.pose(index)), size).cwiseAbs2();
  room.segment<3>(3) *= kTrunkTurn * kTrunkTurn;
  scaled_ = room.asDiagonal() * knot.jacobian.topRows(size);
  normal_ = knot.jacobian.topRows(size).transpose() * scaled_;
  normal_.diagonal().array() += kPoseDamping * morphology_.leg_length * morphology_.leg_length;
  knot.pull_back = normal_.llt().solve(scaled_.transpose()).transpose();
}

void PoseCorrection::predict_miss(const VectorXd& m, int index) {
  const Knot& knot = knots_[index];
  const int size = layout_.pose_size();
  const auto moved = [&](int slot, int count) {
    return m.segment(at(slot), count) - base_m_.segment(at(slot), count);
  };
  wanted_ = knot.miss;
  wanted_ += knot.jacobian.topRows(size).transpose() * moved(layout_.pose(index), size);
  wanted_ += knot.jacobian.bottomRows(layout_.design_size()).transpose() * (geometry_s_ - base_s_);
  wanted_.head<3>() -= moved(layout_.com(index), 3);
  for (int j = 0; j < layout_.foot_count(); ++j)
    wanted_.segment<3>(3 + 3 * j) -= moved(layout_.foot(index, j), 3);
}

void PoseCorrection::correct_pose(const Knot& knot, int index, VectorXd& m) {
  const int start = at(layout_.pose(index)), size = layout_.pose_size();
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0;; ++k) {
    compute_miss(m, index, miss_);
    miss_ -= wanted_;
    const double now = miss_.norm();
    if (!(now < least)) break;
    least = now;
    best_ = m.segment(start, size);
    if (k == kCorrections || now < kSmallMiss * morphology_.leg_length) return;
    m.segment(start, size) -= knot.pull_back * miss_;
  }
  if (least < std::numeric_limits<double>::infinity()) m.segment(start, size) = best_;
}

void PoseCorrection::correct(const VectorXd& s, VectorXd& m) {
  take_design(s);
  for (int i = 0; i <= layout_.knot_count(); ++i) {
    predict_miss(m, i);
    correct_pose(knots_[i], i, m);
  }
}

}  // namespace legwright
