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
  nodes_ = {};
  for (const std::vector<int>& order : elimination_orders(pattern)) {
    Supernodes found = find_supernodes(pattern, order);
    if (nodes_.first.empty() || found.predicted < nodes_.predicted) nodes_ = std::move(found);
  }
  plan_ = plan_updates(nodes_);

  stride_.clear();
  panel_start_ = {0};
  int tallest = 0;
  for (int j = 0; j < nodes_.count(); ++j) {
    tallest = std::max(tallest, nodes_.height(j));
    int stride = rounded_up(nodes_.height(j), 8);
    if (stride % 64 == 0) stride += 8;  // columns must not all fall into the same cache set
    stride_.push_back(stride);
    panel_start_.push_back(panel_start_.back() +
                           static_cast<std::size_t>(stride) * nodes_.columns(j));
  }
  const auto size = static_cast<std::size_t>(pattern.size());
  panels_.assign(panel_start_.back() + kSlack, 0.0);
  least_pivot_.assign(size, 0.0);
  inverse_diagonal_.assign(size, 0.0);
  x_.assign(size + kSlack, 0.0);
  gathered_.assign(static_cast<std::size_t>(tallest) + kSlack, 0.0);
  many_.clear();
  below_.clear();
  plan_loads(pattern);
}

void SupernodalCholesky::plan_loads(const SymmetricPattern& pattern) {
  const int size = pattern.size();
  std::vector<int> place(size), owner(size);
  for (int k = 0; k < size; ++k) place[nodes_.order[k]] = k;
  for (int j = 0; j < nodes_.count(); ++j)
    std::fill(owner.begin() + nodes_.first[j], owner.begin() + nodes_.first[j + 1], j);
  std::vector<std::vector<Load>> by_panel(nodes_.count());
  for (int j = 0; j < size; ++j)
    for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k) {
      const int a = place[pattern.rows[k]], b = place[j];
      const int column = std::min(a, b), row = std::max(a, b), node = owner[column];
      const auto begin = nodes_.rows.begin() + nodes_.row_start[node];
      const auto end = nodes_.rows.begin() + nodes_.row_start[node + 1];
      const auto at = static_cast<int>(std::lower_bound(begin, end, row) - begin);
      const int target = at + (column - nodes_.first[node]) * stride_[node];
      const int step = a >= b ? 1 : stride_[node];
      std::vector<Load>& loads = by_panel[node];
      Load* last = loads.empty() ? nullptr : &loads.back();
      if (last && last->step == step && last->source + last->length == k &&
          last->target + last->length * step == target)
        ++last->length;
      else
        loads.push_back({k, target, step, 1});
    }
  loads_.clear();
  load_start_ = {0};
  for (const std::vector<Load>& loads : by_panel) {
    loads_.insert(loads_.end(), loads.begin(), loads.end());
    load_start_.push_back(loads_.size());
  }
}

int SupernodalCholesky::factor(const double* values, const Eigen::VectorXd& diagonal,
                               const Eigen::VectorXd& shift, double tolerance) {
  for (std::size_t k = 0; k < least_pivot_.size(); ++k)
    least_pivot_[k] = tolerance * diagonal[nodes_.order[k]];
  for (int j = 0; j < nodes_.count(); ++j) {
    double* const to = panel(j);
    const int first = nodes_.first[j], columns = nodes_.columns(j);
    std::fill(to, panels_.data() + panel_start_[j + 1], 0.0);
    for (std::size_t k = load_start_[j]; k < load_start_[j + 1]; ++k) {
      const Load& load = loads_[k];
      if (load.step == 1)
        for (int i = 0; i < load.length; ++i) to[load.target + i] += values[load.source + i];
      else
        for (int i = 0; i < load.length; ++i)
          to[load.target + i * load.step] += values[load.source + i];
    }
    for (int c = 0; c < columns; ++c)
      to[static_cast<std::size_t>(c) * stride_[j] + c] += shift[nodes_.order[first + c]];
    for (std::size_t k = plan_.start[j]; k < plan_.start[j + 1]; ++k) {
      const PanelUpdate& update = plan_.updates[k];
      kernels_->subtract_update(panel(update.source) + update.first_row, stride_[update.source],
                                nodes_.columns(update.source), update.columns,
                                plan_.segments.data() + update.segments, update.segment_count,
                                plan_.places.data() + update.place, to, stride_[j]);
    }
    const int bad =
        kernels_->factor_panel(to, stride_[j], nodes_.height(j), columns,
                               least_pivot_.data() + first, inverse_diagonal_.data() + first);
    if (bad >= 0) return nodes_.order[first + bad];
  }
  return -1;
}

void SupernodalCholesky::solve(Eigen::VectorXd& x) {
  const int size = static_cast<int>(inverse_diagonal_.size());
  for (int k = 0; k < size; ++k) x_[k] = x[nodes_.order[k]];
  const auto visit = [&](int j, bool down) {
    const int first = nodes_.first[j], columns = nodes_.columns(j), rows = nodes_.height(j);
    const int* row = nodes_.rows.data() + nodes_.row_start[j];
    const double* inverse = inverse_diagonal_.data() + first;
    for (int r = 0; r < rows; ++r) gathered_[r] = x_[row[r]];
    (down ? kernels_->forward : kernels_->backward)(panel(j), stride_[j], rows, columns, inverse,
                                                    gathered_.data());
    const int changed = down ? rows : columns;
    for (int r = 0; r < changed; ++r) x_[row[r]] = gathered_[r];
  };
  for (int j = 0; j < nodes_.count(); ++j) visit(j, true);
  for (int j = nodes_.count() - 1; j >= 0; --j) visit(j, false);
  for (int k = 0; k < size; ++k) x[nodes_.order[k]] = x_[k];
}

void SupernodalCholesky::solve(Eigen::MatrixXd& x) {
  constexpr int kMostVectors = 3;
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
            c < count ? x(nodes_.order[k], begin + c) : 0.0;
    const auto arguments = [&](int j, auto visit) {
      visit(panel(j), stride_[j], nodes_.height(j), nodes_.columns(j),
            inverse_diagonal_.data() + nodes_.first[j], nodes_.rows.data() + nodes_.row_start[j]);
    };
    for (int j = 0; j < nodes_.count(); ++j)
      arguments(j, [&](auto... panel) {
        kernels_->forward_many(panel..., many_.data(), width, width / lanes);
      });
    for (int j = nodes_.count() - 1; j >= 0; --j)
      arguments(j, [&](auto... panel) {
        kernels_->backward_many(panel..., many_.data(), width, width / lanes, below_.data());
      });
    for (int k = 0; k < size; ++k)
      for (int c = 0; c < count; ++c)
        x(nodes_.order[k], begin + c) = many_[static_cast<std::size_t>(k) * width + c];
  }
}

}  // namespace legwright
