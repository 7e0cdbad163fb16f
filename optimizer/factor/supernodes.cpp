// SPDX-License-Identifier: Apache-2.0
#include "optimizer/factor/supernodes.hpp"

#include <algorithm>
#include <numeric>

namespace legwright {
namespace {

/// Rows below the diagonal of every column of L, ascending, and the elimination tree.
struct Structure {
  std::vector<std::vector<int>> below;
  std::vector<int> parent;  // −1: a root
};

Structure factor_structure(const SymmetricPattern& pattern, const std::vector<int>& order) {
  const int size = pattern.size();
  std::vector<int> place(size);
  for (int k = 0; k < size; ++k) place[order[k]] = k;
  Structure result{std::vector<std::vector<int>>(size), std::vector<int>(size, -1)};
  for (int j = 0; j < size; ++j)
    for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k) {
      const int a = place[pattern.rows[k]], b = place[j];
      if (a != b) result.below[std::min(a, b)].push_back(std::max(a, b));
    }
  std::vector<std::vector<int>> children(size);
  std::vector<int> mark(size, -1), merged;
  for (int j = 0; j < size; ++j) {
    merged.clear();
    const auto take = [&](int row) {
      if (row == j || mark[row] == j) return;
      mark[row] = j;
      merged.push_back(row);
    };
    for (const int row : result.below[j]) take(row);
    for (const int child : children[j])
      for (const int row : result.below[child]) take(row);
    std::sort(merged.begin(), merged.end());
    result.below[j] = merged;
    if (merged.empty()) continue;
    result.parent[j] = merged.front();
    children[merged.front()].push_back(j);
  }
  return result;
}

/// Time of a panel and of all that it updates [ns]: arithmetic, memory that updates touch, and the
/// fixed price of being one more panel. Only the order of magnitude matters.
double panel_time(double columns, double height) {
  constexpr double kPerPanel = 300.0, kPerEntry = 0.12, kFlopsPerNanosecond = 28.0;
  const double below = height - columns;
  double flops = 0.0;
  for (int j = 0; j < columns; ++j) flops += (height - j) * (height - j);
  return kPerPanel + kPerEntry * (0.5 * below * below + columns * height) +
         flops / kFlopsPerNanosecond;
}

/// A tree of clusters of columns that grow by merging with their children.
class Amalgamation {
 public:
  explicit Amalgamation(const Structure& structure)
      : structure_(structure), size_(static_cast<int>(structure.parent.size())) {
    height_.resize(size_);
    columns_.assign(size_, 1);
    children_.resize(size_);
    owner_.resize(size_);
    std::iota(owner_.begin(), owner_.end(), 0);
    for (int j = 0; j < size_; ++j) {
      height_[j] = 1 + static_cast<int>(structure.below[j].size());
      if (structure.parent[j] >= 0) children_[structure.parent[j]].push_back(j);
    }
  }

  void run() {
    for (int j = 0; j < size_; ++j)
      merge_children(j, [&](int child) { return same_structure(child, j); });
    for (int j = 0; j < size_; ++j)
      if (owner_[j] == j) merge_children(j, [&](int child) { return gain(child, j) > 0.0; });
  }

  double predicted() const {
    double time = 0.0;
    for (int j = 0; j < size_; ++j)
      if (owner_[j] == j) time += panel_time(columns_[j], height_[j]);
    return time;
  }

  /// Clusters by their last columns, each after its children, and their columns in the order of
  /// elimination.
  std::vector<std::vector<int>> clusters() const {
    std::vector<std::vector<int>> members(size_), result;
    for (int j = 0; j < size_; ++j) members[root(j)].push_back(j);
    std::vector<int> stack;
    for (int j = size_ - 1; j >= 0; --j)
      if (owner_[j] == j && structure_.parent[j] < 0) stack.push_back(j);
    std::vector<int> backwards;  // parents before children
    std::reverse(stack.begin(), stack.end());
    while (!stack.empty()) {
      const int j = stack.back();
      stack.pop_back();
      backwards.push_back(j);
      std::vector<int> below = children_[j];
      std::sort(below.begin(), below.end());
      stack.insert(stack.end(), below.begin(), below.end());
    }
    for (auto j = backwards.rbegin(); j != backwards.rend(); ++j) result.push_back(members[*j]);
    return result;
  }

 private:
  int root(int j) const {
    while (owner_[j] != j) j = owner_[j];
    return j;
  }
  bool same_structure(int child, int parent) const {
    return height_[child] - columns_[child] == height_[parent];
  }
  double gain(int child, int parent) const {
    return panel_time(columns_[child], height_[child]) +
           panel_time(columns_[parent], height_[parent]) -
           panel_time(columns_[child] + columns_[parent], columns_[child] + height_[parent]);
  }

  template <class Wanted>
  void merge_children(int parent, const Wanted& wanted) {
    for (bool changed = true; changed;) {
      changed = false;
      int best = -1;
      double best_gain = 0.0;
      for (const int child : children_[parent]) {
        if (!wanted(child)) continue;
        const double here = gain(child, parent);
        if (best < 0 || here > best_gain) best = child, best_gain = here;
      }
      if (best < 0) break;
      std::vector<int>& list = children_[parent];
      list.erase(std::find(list.begin(), list.end(), best));
      list.insert(list.end(), children_[best].begin(), children_[best].end());
      children_[best].clear();
      owner_[best] = parent;
      columns_[parent] += columns_[best];
      height_[parent] += columns_[best];
      changed = true;
    }
  }

  const Structure& structure_;
  int size_;
  std::vector<int> height_, columns_, owner_;
  std::vector<std::vector<int>> children_;
};

void add_segments(const int* place, int count, std::vector<RowSegment>& segments) {
  constexpr int kShortest = 4;  // neighbours worth an update of their own
  for (int i = 0; i < count;) {
    int end = i + 1;
    while (end < count && place[end] == place[end - 1] + 1) ++end;
    const bool together = end - i >= kShortest;
    if (!together && !segments.empty() && i > 0 && segments.back().target < 0)
      segments.back().length += end - i;
    else
      segments.push_back({i, together ? place[i] : -1, end - i});
    i = end;
  }
}

}  // namespace

Supernodes find_supernodes(const SymmetricPattern& pattern, const std::vector<int>& order) {
  const Structure structure = factor_structure(pattern, order);
  Amalgamation amalgamation(structure);
  amalgamation.run();
  Supernodes result;
  result.predicted = amalgamation.predicted();
  const std::vector<std::vector<int>> clusters = amalgamation.clusters();
  std::vector<int> place(pattern.size());  // old position → new
  result.first = {0};
  for (const std::vector<int>& cluster : clusters) {
    // Within a panel any order will do; that of H keeps neighbours together.
    std::vector<int> unknowns;
    unknowns.reserve(cluster.size());
    for (const int k : cluster) unknowns.push_back(order[k]);
    std::sort(unknowns.begin(), unknowns.end());
    result.order.insert(result.order.end(), unknowns.begin(), unknowns.end());
    result.first.push_back(static_cast<int>(result.order.size()));
  }
  std::vector<int> position(pattern.size());
  for (int k = 0; k < pattern.size(); ++k) position[result.order[k]] = k;
  for (int k = 0; k < pattern.size(); ++k) place[k] = position[order[k]];
  result.row_start = {0};
  for (int j = 0; j < result.count(); ++j) {
    for (int k = result.first[j]; k < result.first[j + 1]; ++k) result.rows.push_back(k);
    const auto below = result.rows.size();
    for (const int row : structure.below[clusters[j].back()]) result.rows.push_back(place[row]);
    std::sort(result.rows.begin() + static_cast<std::ptrdiff_t>(below), result.rows.end());
    result.row_start.push_back(static_cast<int>(result.rows.size()));
  }
  return result;
}

UpdatePlan plan_updates(const Supernodes& nodes) {
  std::vector<int> owner(nodes.order.size());
  for (int j = 0; j < nodes.count(); ++j)
    std::fill(owner.begin() + nodes.first[j], owner.begin() + nodes.first[j + 1], j);
  UpdatePlan plan;
  std::vector<std::vector<PanelUpdate>> by_target(nodes.count());
  for (int k = 0; k < nodes.count(); ++k) {
    const int* row = nodes.rows.data() + nodes.row_start[k];
    const int height = nodes.height(k);
    for (int begin = nodes.columns(k), end; begin < height; begin = end) {
      const int target = owner[row[begin]];
      for (end = begin; end < height && owner[row[end]] == target; ++end) {
      }
      PanelUpdate update{k, begin, end - begin, plan.places.size(), plan.segments.size(), 0};
      const int* target_row = nodes.rows.data() + nodes.row_start[target];
      int at = 0;
      for (int i = begin; i < height; ++i) {
        while (target_row[at] != row[i]) ++at;
        plan.places.push_back(at);
      }
      std::vector<RowSegment> segments;
      add_segments(plan.places.data() + update.place, height - begin, segments);
      plan.segments.insert(plan.segments.end(), segments.begin(), segments.end());
      update.segment_count = static_cast<int>(segments.size());
      by_target[target].push_back(update);
    }
  }
  plan.start = {0};
  for (const std::vector<PanelUpdate>& updates : by_target) {
    plan.updates.insert(plan.updates.end(), updates.begin(), updates.end());
    plan.start.push_back(plan.updates.size());
  }
  return plan;
}

}  // namespace legwright
