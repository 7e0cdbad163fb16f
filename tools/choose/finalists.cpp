// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/finalists.hpp"

#include <algorithm>

namespace legwright {
namespace {

constexpr std::size_t kFinalists = 6;
constexpr std::size_t kStaying = 2;  // what was there before any tightening

auto first_unknown(auto& kept) {
  return std::find_if(kept.begin(), kept.end(), [](const Finalist& each) { return !each.known; });
}

}  // namespace

void Finalists::add(const Candidate& candidate, std::size_t place, const PlayedCandidate& played) {
  kept_.push_back({candidate, place, played.distance, played.to_the_end});
  drop();
}

const Finalist* Finalists::unknown() const {
  const auto at = first_unknown(kept_);
  return at == kept_.end() ? nullptr : &*at;
}

void Finalists::tell(const PlayedCandidate& played) {
  Finalist& each = *first_unknown(kept_);
  each.distance = played.distance;
  each.known = true;
  drop();
}

std::vector<Finalist> Finalists::in_order() const {
  std::vector<Finalist> out = kept_;
  std::sort(out.begin(), out.end(),
            [](const Finalist& a, const Finalist& b) { return a.place < b.place; });
  return out;
}

void Finalists::drop() {
  std::stable_sort(kept_.begin(), kept_.end(), [](const Finalist& a, const Finalist& b) {
    const bool a_stays = a.place < kStaying, b_stays = b.place < kStaying;
    return a_stays != b_stays ? a_stays : a.distance < b.distance;
  });
  std::size_t known = 0, kept = 0;
  for (; kept < kept_.size() && known < kFinalists; ++kept) known += kept_[kept].known;
  kept_.resize(kept);
}

}  // namespace legwright
