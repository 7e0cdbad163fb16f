// SPDX-License-Identifier: Apache-2.0
// Each gait of the library against a table written down here by hand: duty, order of the footfalls,
// and how many feet stand. All three are counted from the contact flags of a fine gait, not from
// the pattern's own numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "optimizer/motion/gait.hpp"
#include "tests/optimizer/motion/in_order.hpp"

namespace legwright {
namespace {

constexpr int kFineKnots =
    840;  // fifths, sixths, sevenths, eighths and their multiples fall on knots

struct Known {
  int feet;
  const char* name;
  double duty;
  const char* order;  // from phase 0 on; + joins feet that land together
  int least, most;    // feet on the ground
};

std::ostream& operator<<(std::ostream& out, const Known& known) {
  return out << known.feet << " feet, " << known.name;
}

const Known kTable[] = {
    {2, "walk", 0.6, "L R", 1, 2},
    {2, "run", 0.4, "L R", 0, 1},
    {4, "walk", 0.75, "FL HR FR HL", 3, 3},
    {4, "amble", 0.45, "FL HR FR HL", 1, 2},
    {4, "trot", 0.5, "FL+HR FR+HL", 2, 2},
    {4, "pace", 0.6, "FL+HL FR+HR", 2, 4},
    {4, "canter", 0.35, "FL+HR FR HL", 0, 3},
    {4, "transverse_gallop", 0.4, "FL FR HL HR", 1, 2},
    {4, "rotary_gallop", 0.4, "FL FR HR HL", 1, 2},
    {4, "bound", 0.5, "FL+FR HL+HR", 2, 2},
    {4, "pronk", 0.5, "FL+FR+HL+HR", 0, 4},
    {4, "crawl", 0.875, "FL HR FR HL", 3, 4},
    {6, "tripod", 0.5, "FL+MR+HL FR+ML+HR", 3, 3},
    {6, "ripple", 2.0 / 3.0, "HL FR ML HR FL MR", 4, 4},
    {6, "wave", 5.0 / 6.0, "HL ML FL HR MR FR", 5, 5},
    {5, "wave", 4.0 / 5.0, "5 4 3 2 1", 4, 4},
    {7, "wave", 6.0 / 7.0, "7 6 5 4 3 2 1", 6, 6},
    {8, "tetrapod", 0.5, "L1+R2+L3+R4 R1+L2+R3+L4", 4, 4},
    {8, "ripple", 0.75, "R2+L4 R1+L3 L2+R4 L1+R3", 6, 6},
    {8, "wave", 7.0 / 8.0, "L4 L3 L2 L1 R4 R3 R2 R1", 7, 7},
};

/// "FL+HR FR+HL" from the contact flags.
std::string counted_order(const Gait& gait, const std::vector<std::string>& places) {
  std::string order;
  for (int knot = 0; knot < gait.knot_count(); ++knot) {
    std::string together;
    for (int foot = 0; foot < gait.foot_count(); ++foot)
      if (gait.in_contact(knot, foot) && !gait.in_contact(knot - 1, foot))
        together += (together.empty() ? "" : "+") + places[static_cast<std::size_t>(foot)];
    if (!together.empty()) order += (order.empty() ? "" : " ") + together;
  }
  return order;
}

std::string told_order(const GaitPattern& pattern, const std::vector<std::string>& places) {
  std::string order;
  for (const std::vector<int>& together : touchdown_order(pattern)) {
    order += order.empty() ? "" : " ";
    for (std::size_t k = 0; k < together.size(); ++k)
      order += (k ? "+" : "") + places[static_cast<std::size_t>(together[k])];
  }
  return order;
}

class GaitLibrary : public testing::TestWithParam<Known> {
 protected:
  static GaitPattern pattern() {
    for (const GaitPattern& candidate : gait_library(GetParam().feet))
      if (candidate.name == GetParam().name) return candidate;
    ADD_FAILURE() << "not in the library";
    return {GetParam().name, std::vector<double>(static_cast<std::size_t>(GetParam().feet), 0.0)};
  }
};

TEST_P(GaitLibrary, HasDutyOrderAndSupportOfTheTable) {
  const Known& known = GetParam();
  const GaitPattern p = pattern();
  const Gait gait(p, 1.0, kFineKnots, test::in_order(known.feet));
  for (int foot = 0; foot < known.feet; ++foot) {
    int stance = 0;
    for (int knot = 0; knot < kFineKnots; ++knot) stance += gait.in_contact(knot, foot);
    EXPECT_EQ(stance, std::lround(known.duty * kFineKnots)) << "foot " << foot;
  }
  const std::vector<std::string> places = footfall_places(known.feet);
  EXPECT_EQ(counted_order(gait, places), known.order);
  EXPECT_EQ(told_order(p, places), known.order);
  EXPECT_EQ(support_range(gait), (SupportRange{known.least, known.most}));
  EXPECT_EQ(support_range(p), (SupportRange{known.least, known.most}));
  EXPECT_NE(p.about, "");
}

TEST_P(GaitLibrary, TableNoticesAnotherDutyAndAnotherOrder) {
  GaitPattern p = pattern();
  p.duty = std::fmod(p.duty + 0.45, 1.0);
  if (p.duty < 0.1) p.duty += 0.1;
  const double last = p.touchdown.back();
  p.touchdown.front() = p.touchdown.front() == last ? last + 0.05 : last;
  const Known& known = GetParam();
  const Gait gait(p, 1.0, kFineKnots, test::in_order(known.feet));
  EXPECT_NE(counted_order(gait, footfall_places(known.feet)), known.order);
  if (known.most < known.feet) {
    EXPECT_NE(support_range(gait), (SupportRange{known.least, known.most}));
  }
}

INSTANTIATE_TEST_SUITE_P(Table, GaitLibrary, testing::ValuesIn(kTable), [](const auto& instance) {
  return std::to_string(instance.param.feet) + "_" + instance.param.name;
});

TEST(GaitLibraryTable, ListsEveryGaitOnce) {
  std::map<int, std::multiset<std::string>> table, library;
  for (const Known& known : kTable) table[known.feet].insert(known.name);
  for (int feet = 0; feet <= 8; ++feet)
    for (const GaitPattern& p : gait_library(feet)) library[feet].insert(p.name);
  EXPECT_EQ(library, table);
}

TEST(GaitLibraryTable, TellsTheNumbersOfFeetThatHaveGaits) {
  EXPECT_EQ(gait_library_feet(), (std::vector<int>{2, 4, 5, 6, 7, 8}));
  EXPECT_TRUE(gait_library(3).empty())
      << "two feet on the ground, and one that takes a third of the cycle";
  ASSERT_EQ(gait_library(12).size(), 1u) << "more than eight feet have a wave as well";
  EXPECT_EQ(support_range(gait_library(12)[0]), (SupportRange{11, 11}));
}

TEST(GaitLibraryTable, EightFeetAreMirroredHalfACycleLater) {
  for (const GaitPattern& p : gait_library(8))
    for (std::size_t row = 0; row < 4; ++row)
      EXPECT_DOUBLE_EQ(std::abs(p.touchdown[2 * row] - p.touchdown[2 * row + 1]), 0.5) << p.name;
}

TEST(GaitLibraryTable, SymmetricalGaitsHaveHildebrandsLags) {
  // The fore foot's touchdown after the hind foot's of the same side; and sides half a cycle apart.
  const std::map<std::string, double> lags{
      {"walk", 0.25}, {"amble", 0.25}, {"trot", 0.5}, {"pace", 0.0}, {"crawl", 0.125}};
  for (const GaitPattern& p : gait_library(4)) {
    const auto found = lags.find(p.name);
    if (found == lags.end()) continue;
    for (std::size_t side : {0u, 1u})
      EXPECT_DOUBLE_EQ(std::fmod(p.touchdown[side] - p.touchdown[2 + side] + 1.0, 1.0),
                       found->second)
          << p.name;
    EXPECT_DOUBLE_EQ(std::abs(p.touchdown[0] - p.touchdown[1]), 0.5) << p.name;
  }
}

TEST(SupportRange, SeesWhatNoKnotSees) {
  // Flight of 1 % of the cycle: eight knots step over it.
  const GaitPattern p{"run", {0.0, 0.5}, 0.49};
  EXPECT_EQ(support_range(p), (SupportRange{0, 1}));
  EXPECT_EQ(support_range(Gait(p, 1.0, 8, {0, 1})), (SupportRange{1, 1}));
  EXPECT_EQ(support_range(GaitPattern{"own", {0.0, 0.5}, 0.1, {0.6, 1.0}}), (SupportRange{1, 2}));
}

TEST(FootfallPlaces, NamesEachPlaceOnce) {
  for (int feet = 0; feet <= 8; ++feet) {
    const std::vector<std::string> places = footfall_places(feet);
    EXPECT_EQ(static_cast<int>(places.size()), feet);
    EXPECT_EQ(std::set<std::string>(places.begin(), places.end()).size(), places.size());
  }
}

}  // namespace
}  // namespace legwright
