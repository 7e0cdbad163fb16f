// SPDX-License-Identifier: Apache-2.0
// Footfall patterns from the literature. A phase is the share of the cycle after the front left foot's touchdown
// (for hexapods and pairs: after the first listed foot of phase 0).
//   Muybridge 1887, Animals in Motion: names and supports of the horse's gaits, amble and canter among them.
//   Hildebrand 1965, Science 150; 1977, J. Mammal. 58; 1989, BioScience 39: a symmetrical gait is two numbers, the duty and
//     the fore foot's lag behind the hind foot of its side: pace 0, lateral sequence walk 1/4, trot 1/2.
//   Alexander 1984, Int. J. Robot. Res. 3: relative phases of the gaits of bipeds and quadrupeds; walks have duties above,
//     runs below one half. Collins and Stewart 1993, J. Nonlinear Sci. 3, give the same table.
//   McGhee and Frank 1968, Math. Biosci. 3: of all creeping gaits the steadiest has the hind foot land when the fore foot of
//     its side lifts.
//   Wilson 1966, Annu. Rev. Entomol. 11: a hexapod's sides are half a cycle apart, on each the wave runs from hind to front,
//     and its delay is the swing's duration.
// Within the ranges that they give, duties are those that suit small robots.
#include <algorithm>

#include "optimizer/motion/gait.hpp"

namespace legwright {
namespace {

constexpr double kPhaseTolerance = 1e-9;  // phases closer than this are the same

std::vector<GaitPattern> biped_gaits() {  // left, right
  return {
      {"walk", {0.0, 0.5}, 0.6, {}, "feet by turns, both down in between (Alexander 1984)"},
      {"run", {0.0, 0.5}, 0.4, {}, "feet by turns, flight in between (Alexander 1984)"},
  };
}

std::vector<GaitPattern> quadruped_gaits() {  // front left, front right, hind left, hind right
  const std::vector<double> singlefoot{0.0, 0.5, 0.75, 0.25};
  return {
      {"walk", singlefoot, 0.75, {}, "four even beats, hind before front (Hildebrand 1965)"},
      {"amble", singlefoot, 0.45, {}, "the walk's beats at a run, no flight (Muybridge 1887)"},
      {"trot", {0.0, 0.5, 0.5, 0.0}, 0.5, {}, "diagonal pairs by turns (Hildebrand 1965)"},
      {"pace", {0.0, 0.5, 0.0, 0.5}, 0.6, {}, "pairs of one side by turns (Hildebrand 1965)"},
      {"canter", {0.0, 0.3, 0.7, 0.0}, 0.35, {}, "three beats, right lead (Alexander 1984)"},
      {"transverse_gallop",
       {0.0, 0.1, 0.5, 0.6},
       0.3,
       {},
       "one side leads both pairs (Alexander 1984)"},
      {"rotary_gallop", {0.0, 0.1, 0.6, 0.5}, 0.3, {}, "a side each leads a pair (Alexander 1984)"},
      {"bound", {0.0, 0.0, 0.5, 0.5}, 0.4, {}, "front and hind pairs by turns (Alexander 1984)"},
      {"pronk", {0.0, 0.0, 0.0, 0.0}, 0.4, {}, "all four at once (Alexander 1984)"},
      {"crawl",
       {0.0, 0.5, 0.875, 0.375},
       0.875,
       {},
       "a foot at a time, the steadiest (McGhee and Frank 1968)"},
  };
}

std::vector<GaitPattern> hexapod_gaits() {  // front, middle, hind; left before right
  constexpr double third = 1.0 / 3.0, sixth = 1.0 / 6.0;
  const std::vector<double> ripple{2 * third, sixth, third, 5 * sixth, 0.0, 0.5};
  const std::vector<double> wave{third, 5 * sixth, sixth, 2 * third, 0.0, 0.5};
  return {
      {"tripod", {0.0, 0.5, 0.5, 0.0, 0.0, 0.5}, 0.5, {}, "threes by turns (Wilson 1966)"},
      {"ripple", ripple, 2 * third, {}, "a wave on each side, two feet swing (Wilson 1966)"},
      {"wave", wave, 5 * sixth, {}, "one foot at a time, hind to front (Wilson 1966)"},
  };
}

}  // namespace

std::vector<GaitPattern> gait_library(int foot_count) {
  switch (foot_count) {
    case 2:
      return biped_gaits();
    case 4:
      return quadruped_gaits();
    case 6:
      return hexapod_gaits();
    default:
      return {};
  }
}

std::vector<std::string> footfall_places(int foot_count) {
  switch (foot_count) {
    case 2:
      return {"L", "R"};
    case 4:
      return {"FL", "FR", "HL", "HR"};
    case 6:
      return {"FL", "FR", "ML", "MR", "HL", "HR"};
    default:
      break;
  }
  std::vector<std::string> names;
  for (int place = 1; place <= foot_count; ++place) names.push_back(std::to_string(place));
  return names;
}

std::vector<std::vector<int>> touchdown_order(const GaitPattern& pattern) {
  std::vector<int> places;
  for (std::size_t place = 0; place < pattern.touchdown.size(); ++place)
    places.push_back(static_cast<int>(place));
  const auto phase = [&](int place) { return pattern.touchdown[static_cast<std::size_t>(place)]; };
  std::stable_sort(places.begin(), places.end(), [&](int a, int b) { return phase(a) < phase(b); });
  std::vector<std::vector<int>> order;
  for (int place : places) {
    if (order.empty() || phase(place) - phase(order.back().front()) > kPhaseTolerance)
      order.emplace_back();
    order.back().push_back(place);
  }
  for (std::vector<int>& together : order) std::sort(together.begin(), together.end());
  return order;
}

SupportRange support_range(const GaitPattern& pattern) {
  // Support changes at touchdowns and lift-offs only and is constant from each to the next.
  const std::size_t foot_count = pattern.touchdown.size();
  SupportRange range{static_cast<int>(foot_count), 0};
  const auto look = [&](double phase) {
    int support = 0;
    for (std::size_t place = 0; place < foot_count; ++place)
      support += pattern.stands(place, phase);
    range.least = std::min(range.least, support);
    range.most = std::max(range.most, support);
  };
  for (std::size_t place = 0; place < foot_count; ++place) {
    look(pattern.touchdown[place]);
    look(pattern.touchdown[place] + pattern.duty_of(place));
  }
  return range;
}

}  // namespace legwright
