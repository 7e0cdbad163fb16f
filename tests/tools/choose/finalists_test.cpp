// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/finalists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace legwright {
namespace {

PlayedCandidate failed(double distance, bool to_the_end) {
  PlayedCandidate out;
  out.distance = distance;
  out.to_the_end = to_the_end;
  return out;
}

/// The first two of all and the four nearest of the others.
std::vector<std::size_t> nearest_of(const std::vector<double>& distances) {
  std::vector<std::size_t> out;
  for (std::size_t i = 2; i < distances.size(); ++i) out.push_back(i);
  std::sort(out.begin(), out.end(),
            [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
  if (out.size() > 4) out.resize(4);
  out.insert(out.begin(), {0, 1});
  std::sort(out.begin(), out.end());
  return out;
}

TEST(Finalists, AreTheNearestWhateverWasKnownBefore) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  int told = 0, unknown = 0;
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<double> distances;
    Finalists finalists;
    for (std::size_t place = 0; place < 30; ++place) {
      distances.push_back(10.0 * any(random));
      const bool known = place < 2 || any(random) < 0.4;
      unknown += !known;
      const double at_least = known ? distances.back() : any(random) * distances.back();
      finalists.add({std::to_string(place), {}, {}, {}}, place, failed(at_least, known));
    }
    while (const Finalist* each = finalists.unknown()) {
      finalists.tell(failed(distances[each->place], true));
      ++told;
    }
    std::vector<std::size_t> places;
    for (const Finalist& each : finalists.in_order()) {
      places.push_back(each.place);
      EXPECT_EQ(each.distance, distances[each.place]);
      EXPECT_EQ(each.design.name, std::to_string(each.place));
    }
    EXPECT_EQ(places, nearest_of(distances));
  }
  EXPECT_LT(told, unknown) << "most need not be known";
}

TEST(Finalists, AreFewerWhereFewerFailed) {
  Finalists finalists;
  finalists.add({"optimum", {}, {}, {}}, 0, failed(3.0, true));
  EXPECT_EQ(finalists.unknown(), nullptr);
  EXPECT_EQ(finalists.in_order().size(), 1u);
}

}  // namespace
}  // namespace legwright
