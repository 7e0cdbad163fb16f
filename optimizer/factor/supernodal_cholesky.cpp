// SPDX-License-Identifier: Apache-2.0
#include "optimizer/factor/supernodal_cholesky.hpp"

#include <algorithm>

namespace legwright {
namespace {

constexpr int kSlack = 8;  // numbers that kernels may read beyond an end

int rounded_up(int count, int step) { return (count + step - 1) / step * step; }

}  // namespace

SupernodalCholesky::SupernodalCholesky(CpuPath path) : kernels_(&cholesky_kernels(path)) {}

void SupernodalCholesky::analyse(const SymmetricPattern& pattern) {
  plan_ = plan_of(pattern);
  const auto size = static_cast<std::size_t>(pattern.size());
  panels_.assign(plan_->panel_start.back() + kSlack, 0.0);
  least_pivot_.assign(size, 0.0);
  inverse_diagonal_.assign(size, 0.0);
  x_.assign(size + kSlack, 0.0);
  gathered_.assign(static_cast<std::size_t>(plan_->tallest) + kSlack, 0.0);
  many_.clear();
  below_.clear();
}

int SupernodalCholesky::factor(const double* values, const Eigen::VectorXd& diagonal,
                               const Eigen::VectorXd& shift, double tolerance) {
  const SupernodalPlan& plan = *plan_;
  const Supernodes& nodes = plan.nodes;
  const UpdatePlan& pulled = plan.updates;
  for (std::size_t k = 0; k < least_pivot_.size(); ++k)
    least_pivot_[k] = tolerance * diagonal[nodes.order[k]];
  for (int j = 0; j < nodes.count(); ++j) {
    double* const to = panel(j);
    const int first = nodes.first[j], columns = nodes.columns(j);
    std::fill(to, panels_.data() + plan.panel_start[j + 1], 0.0);
    for (std::size_t k = plan.load_start[j]; k < plan.load_start[j + 1]; ++k) {
      const SupernodalPlan::Load& load = plan.loads[k];
      if (load.step == 1)
        for (int i = 0; i < load.length; ++i) to[load.target + i] += values[load.source + i];
      else
        for (int i = 0; i < load.length; ++i)
          to[load.target + i * load.step] += values[load.source + i];
    }
    for (int c = 0; c < columns; ++c)
      to[static_cast<std::size_t>(c) * plan.stride[j] + c] += shift[nodes.order[first + c]];
    for (std::size_t k = pulled.start[j]; k < pulled.start[j + 1]; ++k) {
      const PanelUpdate& update = pulled.updates[k];
      kernels_->subtract_update(panel(update.source) + update.first_row, plan.stride[update.source],
                                nodes.columns(update.source), update.columns,
                                pulled.segments.data() + update.segments, update.segment_count,
                                pulled.places.data() + update.place, to, plan.stride[j]);
    }
    const int bad =
        kernels_->factor_panel(to, plan.stride[j], nodes.height(j), columns,
                               least_pivot_.data() + first, inverse_diagonal_.data() + first);
    if (bad >= 0) return nodes.order[first + bad];
  }
  return -1;
}

void SupernodalCholesky::solve(Eigen::VectorXd& x) {
  const Supernodes& nodes = plan_->nodes;
  const int size = static_cast<int>(inverse_diagonal_.size());
  for (int k = 0; k < size; ++k) x_[k] = x[nodes.order[k]];
  const auto visit = [&](int j, bool down) {
    const int first = nodes.first[j], columns = nodes.columns(j), rows = nodes.height(j);
    const int* row = nodes.rows.data() + nodes.row_start[j];
    const double* inverse = inverse_diagonal_.data() + first;
    for (int r = 0; r < rows; ++r) gathered_[r] = x_[row[r]];
    (down ? kernels_->forward : kernels_->backward)(panel(j), plan_->stride[j], rows, columns,
                                                    inverse, gathered_.data());
    const int changed = down ? rows : columns;
    for (int r = 0; r < changed; ++r) x_[row[r]] = gathered_[r];
  };
  for (int j = 0; j < nodes.count(); ++j) visit(j, true);
  for (int j = nodes.count() - 1; j >= 0; --j) visit(j, false);
  for (int k = 0; k < size; ++k) x[nodes.order[k]] = x_[k];
}

void SupernodalCholesky::solve(Eigen::MatrixXd& x) {
  constexpr int kMostVectors = 3;
  const Supernodes& nodes = plan_->nodes;
  const std::vector<int>& stride = plan_->stride;
  const int size = static_cast<int>(inverse_diagonal_.size()), lanes = kernels_->lanes;
  const auto total = static_cast<int>(x.cols());
  const int widest = std::min(rounded_up(total, lanes), kMostVectors * lanes);
  const std::size_t wanted = static_cast<std::size_t>(size) * widest + kSlack;
  if (many_.size() < wanted) {
    many_.resize(wanted);
    below_.resize(gathered_.size() * kMostVectors * lanes);
  }
  for (int begin = 0; begin < total; begin += widest) {
    const int count = std::min(widest, total - begin), width = rounded_up(count, lanes);
    for (int k = 0; k < size; ++k)
      for (int c = 0; c < width; ++c)
        many_[static_cast<std::size_t>(k) * width + c] =
            c < count ? x(nodes.order[k], begin + c) : 0.0;
    const auto arguments = [&](int j, auto visit) {
      visit(panel(j), stride[j], nodes.height(j), nodes.columns(j),
            inverse_diagonal_.data() + nodes.first[j], nodes.rows.data() + nodes.row_start[j]);
    };
    for (int j = 0; j < nodes.count(); ++j)
      arguments(j, [&](auto... panel) {
        kernels_->forward_many(panel..., many_.data(), width, width / lanes);
      });
    for (int j = nodes.count() - 1; j >= 0; --j)
      arguments(j, [&](auto... panel) {
        kernels_->backward_many(panel..., many_.data(), width, width / lanes, below_.data());
      });
    for (int k = 0; k < size; ++k)
      for (int c = 0; c < count; ++c)
        x(nodes.order[k], begin + c) = many_[static_cast<std::size_t>(k) * width + c];
  }
}

}  // namespace legwright
