// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/assembly.hpp"

#include <algorithm>

namespace legwright {
void expand_jacobian(const PlannedElement& element, const Eigen::MatrixXd& J,
                     const std::vector<Eigen::MatrixXd>& jacobians, int columns,
                     ElementWorkspace& workspace) {
  const ElementPlan& plan = *element.plan;
  const int rows = static_cast<int>(J.rows());
  workspace.expanded.setZero(columns, rows);
  for (int row = 0; row < rows; ++row) {
    double* out = workspace.expanded.col(row).data();
    for (const ElementPlan::Direct& direct : plan.direct)
      if (direct.column < columns) out[direct.column] += J(row, direct.variable);
    for (std::size_t k = 0; k < plan.through.size(); ++k) {
      const ElementPlan::Through& through = plan.through[k];
      const Eigen::MatrixXd& block = jacobians[static_cast<std::size_t>(element.blocks[k])];
      for (int d = 0; d < through.size; ++d) {
        const double factor = J(row, through.variable + d);
        if (factor == 0.0) continue;
        const double* chain = block.col(d).data();
        for (const ElementPlan::Run& run : through.runs) {
          if (run.to >= columns) break;
          for (int c = 0; c < run.count; ++c) out[run.to + c] += factor * chain[run.from + c];
        }
      }
    }
  }
}

namespace {

/// Adds entry · left rightᵀ of two local variables behind Jacobians to the lower triangle of H.
void add_product(double entry, const LocalRow& left, const LocalRow& right, int columns,
                 Eigen::MatrixXd& H) {
  for (const ElementPlan::Run& across : right.through->runs) {
    if (across.to >= columns) return;
    for (int b = across.to; b < across.to + across.count; ++b) {
      const double factor = entry * right.chain[across.from + b - across.to];
      double* __restrict__ out = H.col(b).data();
      for (const ElementPlan::Run& run : left.through->runs) {
        if (run.to >= columns) break;
        const double* from = left.chain + run.from - run.to;
        for (int a = std::max(run.to, b); a < run.to + run.count; ++a) out[a] += factor * from[a];
      }
    }
  }
}

/// Adds entry · (e rowᵀ + row eᵀ), e the unit vector of a column, to the lower triangle of H.
void add_beside(double entry, int column, const LocalRow& row, int columns, Eigen::MatrixXd& H) {
  double* __restrict__ below = H.col(column).data();
  double* beside = H.data() + column;
  for (const ElementPlan::Run& run : row.through->runs) {
    if (run.to >= columns) return;
    const double* from = row.chain + run.from - run.to;
    const int end = run.to + run.count;
    int a = run.to;
    for (; a < std::min(end, column); ++a) beside[a * H.rows()] += entry * from[a];
    if (a == column && a < end) below[a] += entry * from[a];
    for (; a < end; ++a) below[a] += entry * from[a];
  }
}

/// Adds entry · (left rightᵀ + right leftᵀ) of two local variables to the lower triangle of H, or
/// entry · left leftᵀ of one and the same.
void add_entry(const CurvatureEntry& at, const std::vector<LocalRow>& rows, int columns,
               Eigen::MatrixXd& H) {
  const LocalRow &left = rows[static_cast<std::size_t>(at.row)],
                 &right = rows[static_cast<std::size_t>(at.column)];
  if (left.through != nullptr && right.through != nullptr) {
    add_product(at.value, left, right, columns, H);
    if (at.row != at.column) add_product(at.value, right, left, columns, H);
  } else if (left.through != nullptr) {
    if (right.column < columns) add_beside(at.value, right.column, left, columns, H);
  } else if (right.through != nullptr) {
    if (left.column < columns) add_beside(at.value, left.column, right, columns, H);
  } else {
    const auto [lower, upper] = std::minmax(left.column, right.column);
    if (upper >= columns) return;
    H(upper, lower) += at.row != at.column && lower == upper ? 2.0 * at.value : at.value;
  }
}

/// Adds Eᵀ C E by two products of full matrices, E the rows as vectors.
void add_full(const Eigen::MatrixXd& C, const std::vector<LocalRow>& rows, int columns,
              ElementWorkspace& workspace) {
  Eigen::MatrixXd &E = workspace.local_by_clique, &CE = workspace.bent;
  E.setZero(C.rows(), columns);
  for (int i = 0; i < C.rows(); ++i) {
    if (rows[i].through == nullptr) {
      if (rows[i].column < columns) E(i, rows[i].column) = 1.0;
      continue;
    }
    for (const ElementPlan::Run& run : rows[i].through->runs)
      for (int k = 0; k < run.count && run.to < columns; ++k)
        E(i, run.to + k) = rows[i].chain[run.from + k];
  }
  CE = C.lazyProduct(E);
  for (int b = 0; b < columns; ++b)
    for (int a = b; a < columns; ++a) workspace.hessian(a, b) += E.col(a).dot(CE.col(b));
}

}  // namespace

void expand_curvature(const PlannedElement& element, const std::vector<Eigen::MatrixXd>& jacobians,
                      int columns, ElementWorkspace& workspace) {
  const ElementPlan& plan = *element.plan;
  const Eigen::MatrixXd& C = workspace.curvature;
  std::vector<LocalRow>& rows = workspace.rows;
  rows.assign(static_cast<std::size_t>(C.rows()), LocalRow{columns});
  for (const ElementPlan::Direct& direct : plan.direct)
    rows[direct.variable].column = direct.column;
  for (std::size_t k = 0; k < plan.through.size(); ++k) {
    const ElementPlan::Through& through = plan.through[k];
    const Eigen::MatrixXd& block = jacobians[static_cast<std::size_t>(element.blocks[k])];
    for (int d = 0; d < through.size; ++d)
      rows[through.variable + d] = {-1, &through, block.col(d).data()};
  }
  // Of most terms most entries of C are zero.
  std::vector<CurvatureEntry>& entries = workspace.entries;
  entries.clear();
  for (int j = 0; j < C.cols(); ++j)
    for (int i = j; i < C.rows(); ++i)
      if (C(i, j) != 0.0) entries.push_back({i, j, C(i, j)});
  if (4 * static_cast<Eigen::Index>(entries.size()) > C.size()) {
    add_full(C, rows, columns, workspace);
    return;
  }
  for (const CurvatureEntry& entry : entries) add_entry(entry, rows, columns, workspace.hessian);
}

namespace {

/// Three rows of a residual at a time; missing ones count nothing.
struct Triple {
  const double *e0, *e1, *e2;
  double w0, w1, w2;

  Triple(const Eigen::MatrixXd& expanded, const Eigen::VectorXd& second, int row) {
    const int last = static_cast<int>(expanded.cols()) - 1;
    e0 = expanded.col(row).data();
    e1 = expanded.col(std::min(row + 1, last)).data();
    e2 = expanded.col(std::min(row + 2, last)).data();
    w0 = second[row];
    w1 = row + 1 <= last ? second[row + 1] : 0.0;
    w2 = row + 2 <= last ? second[row + 2] : 0.0;
  }
  /// out_a = Σ weight · e_a e_b for the clique columns a from `first` on.
  void set(int b, int first, int count, double* __restrict__ out) const {
    const double f0 = w0 * e0[b], f1 = w1 * e1[b], f2 = w2 * e2[b];
    const double *x0 = e0 + first, *x1 = e1 + first, *x2 = e2 + first;
    for (int k = 0; k < count; ++k) out[k] = f0 * x0[k] + f1 * x1[k] + f2 * x2[k];
  }
  /// out_a += Σ weight · e_a e_b for the clique columns a from `first` on.
  void add(int b, int first, int count, double* __restrict__ out) const {
    const double f0 = w0 * e0[b], f1 = w1 * e1[b], f2 = w2 * e2[b];
    const double *x0 = e0 + first, *x1 = e1 + first, *x2 = e2 + first;
    if (f1 == 0.0 && f2 == 0.0) {
      if (f0 == 0.0) return;
      for (int k = 0; k < count; ++k) out[k] += f0 * x0[k];
    } else {
      for (int k = 0; k < count; ++k) out[k] += f0 * x0[k] + f1 * x1[k] + f2 * x2[k];
    }
  }
};

}  // namespace

void rank_hessian(ElementWorkspace& workspace) {
  const int columns = static_cast<int>(workspace.expanded.rows());
  workspace.hessian.resize(columns, columns);  // nobody reads the upper triangle
  for (int row = 0; row < static_cast<int>(workspace.expanded.cols()); row += 3) {
    const Triple triple(workspace.expanded, workspace.second, row);
    for (int b = 0; b < columns; ++b) {
      double* out = workspace.hessian.col(b).data() + b;
      if (row == 0)
        triple.set(b, b, columns - b, out);
      else
        triple.add(b, b, columns - b, out);
    }
  }
}

void scatter_rank(const Clique& clique, const Eigen::MatrixXd& expanded,
                  const Eigen::VectorXd& second, const HessianTarget& target) {
  const int motion = clique.motion_count, columns = static_cast<int>(expanded.rows());
  for (int row = 0; row < static_cast<int>(expanded.cols()); row += 3) {
    const Triple triple(expanded, second, row);
    clique.for_each_run([&](int b, int first, int count, int position) {
      triple.add(b, first, count, target.mm + position);
    });
    for (int k = motion; k < columns; ++k) {
      double* ms = target.ms->col(clique.slots[k]).data();
      for (const Clique::Segment& segment : clique.segments)
        triple.add(k, segment.start, segment.end - segment.start,
                   ms + clique.slots[segment.start] - target.design_size);
      double* ss = target.ss->col(clique.slots[k]).data();
      for (int l = k; l < columns; ++l) triple.add(k, l, 1, ss + clique.slots[l]);
    }
  }
}

void scatter(const Clique& clique, const Eigen::MatrixXd& hessian, const HessianTarget& target) {
  clique.for_each_run([&](int b, int first, int count, int position) {
    const double* __restrict__ from = hessian.col(b).data() + first;
    double* __restrict__ out = target.mm + position;
    for (int k = 0; k < count; ++k) out[k] += from[k];
  });
  if (target.ms == nullptr) return;
  const int motion = clique.motion_count, n = target.design_size;
  for (int k = motion; k < static_cast<int>(clique.slots.size()); ++k) {
    const int column = clique.slots[k];
    for (int a = 0; a < motion; ++a) (*target.ms)(clique.slots[a] - n, column) += hessian(k, a);
    double* ss = target.ss->col(column).data();
    for (int l = k; l < static_cast<int>(clique.slots.size()); ++l)
      ss[clique.slots[l]] += hessian(l, k);
  }
}

}  // namespace legwright
