// SPDX-License-Identifier: Apache-2.0
// Footfall patterns from the literature. A phase is the share of the cycle after the front left
// foot's touchdown (for hexapods and pairs: after the first listed foot of phase 0).
//   Muybridge 1887, Animals in Motion: names and supports of the horse's gaits, amble and canter
//     among them.
//   Hildebrand 1965, Science 150; 1977, J. Mammal. 58; 1989, BioScience 39: a symmetrical gait is
//     two numbers, the duty and the fore foot's lag behind the hind foot of its side: pace 0,
//     lateral sequence walk 1/4, trot 1/2.
//   Alexander 1984, Int. J. Robot. Res. 3: relative phases of the gaits of bipeds and quadrupeds;
//     walks have duties above, runs below one half. Collins and Stewart 1993, J. Nonlinear Sci. 3,
//     give the same table.
//   McGhee and Frank 1968, Math. Biosci. 3: of all creeping gaits the steadiest has the hind foot
//     land when the fore foot of its side lifts.
//   Wilson 1966, Annu. Rev. Entomol. 11: a hexapod's sides are half a cycle apart, on each the wave
//     runs from hind to front, and its delay is the swing's duration.
//   Wilson 1967, J. Exp. Biol. 47: eight legs step in two fours, each the odd legs of one side with
//     the even ones of the other.
// Within the ranges that they give, duties are those that suit small robots.
#include <algorithm>

#include "optimizer/motion/gait.hpp"

namespace legwright {
namespace {

constexpr int kMostTold = 8;
constexpr int kFewestForAWave = 5;  // with one foot in the air four stand

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
       0.4,
       {},
       "one side leads both pairs (Alexander 1984)"},
      {"rotary_gallop", {0.0, 0.1, 0.6, 0.5}, 0.4, {}, "a side each leads a pair (Alexander 1984)"},
      {"bound", {0.0, 0.0, 0.5, 0.5}, 0.5, {}, "front and hind pairs by turns (Alexander 1984)"},
      {"pronk", {0.0, 0.0, 0.0, 0.0}, 0.5, {}, "all four at once (Alexander 1984)"},
      {"crawl",
       {0.0, 0.5, 0.875, 0.375},
       0.875,
       {},
       "a foot at a time, the steadiest (McGhee and Frank 1968)"},
  };
}

std::vector<GaitPattern> hexapod_gaits() {  // front, middle, hind; left before right
  constexpr double kThird = 1.0 / 3.0, kSixth = 1.0 / 6.0;
  const std::vector<double> ripple{2 * kThird, kSixth, kThird, 5 * kSixth, 0.0, 0.5};
  const std::vector<double> wave{kThird, 5 * kSixth, kSixth, 2 * kThird, 0.0, 0.5};
  return {
      {"tripod", {0.0, 0.5, 0.5, 0.0, 0.0, 0.5}, 0.5, {}, "threes by turns (Wilson 1966)"},
      {"ripple", ripple, 2 * kThird, {}, "a wave on each side, two feet swing (Wilson 1966)"},
      {"wave", wave, 5 * kSixth, {}, "one foot at a time, hind to front (Wilson 1966)"},
  };
}

std::vector<GaitPattern> octopod_gaits() {  // four rows from front to hind; left before right
  const std::vector<double> ripple{0.75, 0.25, 0.5, 0.0, 0.25, 0.75, 0.0, 0.5};
  const std::vector<double> wave{0.375, 0.875, 0.25, 0.75, 0.125, 0.625, 0.0, 0.5};
  return {
      {"tetrapod",
       {0.0, 0.5, 0.5, 0.0, 0.0, 0.5, 0.5, 0.0},
       0.5,
       {},
       "fours by turns (Wilson 1967)"},
      {"ripple", ripple, 0.75, {}, "a wave on each side, two feet swing (Wilson 1967)"},
      {"wave", wave, 0.875, {}, "one foot at a time, hind to front (Wilson 1967)"},
  };
}

/// Feet whose places have no names: on five and more legs one may swing, and those that stand still
/// surround the COM.
std::vector<GaitPattern> wave_only(int foot_count) {
  GaitPattern wave{"wave", {}, 1.0 - 1.0 / foot_count, {}, "one foot at a time, hind to front"};
  for (int place = 0; place < foot_count; ++place)
    wave.touchdown.push_back(static_cast<double>(foot_count - 1 - place) / foot_count);
  return {wave};
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
    case 8:
      return octopod_gaits();
    default:
      return foot_count >= kFewestForAWave ? wave_only(foot_count) : std::vector<GaitPattern>{};
  }
}

std::vector<int> gait_library_feet() {
  std::vector<int> counts;
  for (int feet = 1; feet <= kMostTold; ++feet)
    if (!gait_library(feet).empty()) counts.push_back(feet);
  return counts;
}

std::vector<std::string> footfall_places(int foot_count) {
  switch (foot_count) {
    case 2:
      return {"L", "R"};
    case 4:
      return {"FL", "FR", "HL", "HR"};
    case 6:
      return {"FL", "FR", "ML", "MR", "HL", "HR"};
    case 8:
      return {"L1", "R1", "L2", "R2", "L3", "R3", "L4", "R4"};
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
  const auto include = [&](double phase) {
    int support = 0;
    for (std::size_t place = 0; place < foot_count; ++place)
      support += pattern.stands(place, phase);
    range.least = std::min(range.least, support);
    range.most = std::max(range.most, support);
  };
  for (std::size_t place = 0; place < foot_count; ++place) {
    include(pattern.touchdown[place]);
    include(pattern.touchdown[place] + pattern.duty_of(place));
  }
  return range;
}

}  // namespace legwright
