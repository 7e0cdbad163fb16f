// SPDX-License-Identifier: Apache-2.0
#include "optimizer/factor/supernodal_plan.hpp"

#include <algorithm>
#include <list>
#include <mutex>
#include <utility>

namespace legwright {
namespace {

constexpr std::size_t kKept = 8;  // plans of the patterns asked for last

struct KnownPlan {
  SymmetricPattern pattern;
  std::shared_ptr<const SupernodalPlan> plan;
};

bool same(const SymmetricPattern& a, const SymmetricPattern& b) {
  return a.starts == b.starts && a.rows == b.rows;
}

/// Of the columns of a panel: whole vectors, and columns that do not all fall into the same cache
/// set.
int stride_of(int height) {
  const int whole = (height + 7) / 8 * 8;
  return whole % 64 == 0 ? whole + 8 : whole;
}

}  // namespace

SupernodalPlan::SupernodalPlan(const SymmetricPattern& pattern) {
  for (const std::vector<int>& order : elimination_orders(pattern)) {
    Supernodes found = find_supernodes(pattern, order);
    if (nodes.first.empty() || found.predicted < nodes.predicted) nodes = std::move(found);
  }
  updates = plan_updates(nodes);
  plan_panels();
  plan_loads(pattern);
}

void SupernodalPlan::plan_panels() {
  panel_start = {0};
  for (int j = 0; j < nodes.count(); ++j) {
    tallest = std::max(tallest, nodes.height(j));
    stride.push_back(stride_of(nodes.height(j)));
    panel_start.push_back(panel_start.back() +
                          static_cast<std::size_t>(stride.back()) * nodes.columns(j));
  }
}

void SupernodalPlan::plan_loads(const SymmetricPattern& pattern) {
  const int size = pattern.size();
  std::vector<int> place(size), owner(size);
  for (int k = 0; k < size; ++k) place[nodes.order[k]] = k;
  for (int j = 0; j < nodes.count(); ++j)
    std::fill(owner.begin() + nodes.first[j], owner.begin() + nodes.first[j + 1], j);
  std::vector<std::vector<Load>> by_panel(nodes.count());
  for (int j = 0; j < size; ++j)
    for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k) {
      const int a = place[pattern.rows[k]], b = place[j];
      const int column = std::min(a, b), row = std::max(a, b), node = owner[column];
      const auto begin = nodes.rows.begin() + nodes.row_start[node];
      const auto end = nodes.rows.begin() + nodes.row_start[node + 1];
      const auto at = static_cast<int>(std::lower_bound(begin, end, row) - begin);
      const int target = at + (column - nodes.first[node]) * stride[node];
      const int step = a >= b ? 1 : stride[node];
      std::vector<Load>& own = by_panel[node];
      Load* last = own.empty() ? nullptr : &own.back();
      if (last && last->step == step && last->source + last->length == k &&
          last->target + last->length * step == target)
        ++last->length;
      else
        own.push_back({k, target, step, 1});
    }
  load_start = {0};
  for (const std::vector<Load>& own : by_panel) {
    loads.insert(loads.end(), own.begin(), own.end());
    load_start.push_back(loads.size());
  }
}

std::shared_ptr<const SupernodalPlan> plan_of(const SymmetricPattern& pattern) {
  static std::mutex turns;
  static std::list<KnownPlan> known;  // the last that was asked for first
  const auto find = [&] {
    const auto at = std::find_if(known.begin(), known.end(), [&](const KnownPlan& each) {
      return same(each.pattern, pattern);
    });
    if (at == known.end()) return false;
    known.splice(known.begin(), known, at);
    return true;
  };
  {
    const std::lock_guard lock(turns);
    if (find()) return known.front().plan;
  }
  auto plan = std::make_shared<const SupernodalPlan>(pattern);  // others need not wait
  const std::lock_guard lock(turns);
  if (!find()) known.push_front({pattern, std::move(plan)});
  if (known.size() > kKept) known.pop_back();
  return known.front().plan;
}

}  // namespace legwright
