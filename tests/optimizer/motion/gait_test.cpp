// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/gait.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/optimizer/motion/in_order.hpp"

namespace legwright {
namespace {

GaitPattern pattern(int feet, const std::string& name) {
  for (const GaitPattern& candidate : gait_library(feet))
    if (candidate.name == name) return candidate;
  throw std::out_of_range(name);
}

int stance_knots(const Gait& gait, int foot) {
  int count = 0;
  for (int knot = 0; knot < gait.knot_count(); ++knot) count += gait.in_contact(knot, foot);
  return count;
}

TEST(Gait, FollowsTheContactFormulaWhateverTheRounding) {
  // 7/10 − 0.7 and friends must land on touchdown, not one knot after it.
  for (int knots : {8, 10, 20, 24, 30, 49})
    for (int touchdown = 0; touchdown < knots; ++touchdown) {
      const GaitPattern p{"one", {static_cast<double>(touchdown) / knots}, 0.5};
      const Gait gait(p, 1.0, knots, {0});
      EXPECT_TRUE(gait.in_contact(touchdown, 0)) << touchdown << "/" << knots;
      EXPECT_FALSE(gait.in_contact(touchdown - 1, 0)) << touchdown << "/" << knots;
      EXPECT_EQ(stance_knots(gait, 0), (knots + 1) / 2);
    }
}

TEST(Gait, HoldsADutyForEachFoot) {
  const GaitPattern p{"own", {0.0, 0.5, 0.25}, 0.1, {0.25, 0.5, 1.0}};
  const Gait gait(p, 1.0, 24, {2, 0, 1});  // first place: foot 2
  EXPECT_EQ(stance_knots(gait, 2), 6);
  EXPECT_EQ(stance_knots(gait, 0), 12);
  EXPECT_EQ(stance_knots(gait, 1), 24);
  EXPECT_TRUE(gait.in_contact(12, 0));
  EXPECT_FALSE(gait.in_contact(11, 0));
  EXPECT_EQ(support_range(gait), (SupportRange{1, 2}));
}

TEST(Gait, PlacesColumnsInTheRobotsFootOrder) {
  const std::vector<int> order{3, 2, 1, 0};
  const Gait straight(pattern(4, "walk"), 1.0, 24, test::in_order(4));
  const Gait reversed(pattern(4, "walk"), 1.0, 24, order);
  for (int knot = 0; knot < 24; ++knot)
    for (int place = 0; place < 4; ++place)
      EXPECT_EQ(reversed.in_contact(knot, order[place]), straight.in_contact(knot, place));
}

TEST(Gait, WrapsKnotsAndWidensPlantedOnBothSides) {
  const Gait gait(pattern(4, "trot"), 0.4, 24, test::in_order(4));
  EXPECT_EQ(gait.in_contact(24, 0), gait.in_contact(0, 0));
  EXPECT_EQ(gait.in_contact(-1, 0), gait.in_contact(23, 0));
  EXPECT_DOUBLE_EQ(gait.time_step(), 0.4 / 24);
  int planted = 0;
  for (int knot = 0; knot < 24; ++knot) planted += gait.planted(knot, 0, 2);
  EXPECT_EQ(planted, 12 + 4);
  EXPECT_TRUE(gait.planted(-2, 0, 2));
  EXPECT_FALSE(gait.planted(-3, 0, 2));
  EXPECT_TRUE(gait.planted(13, 0, 2));
  EXPECT_FALSE(gait.planted(14, 0, 2));
}

TEST(Gait, RefusesWhatCannotBeAGait) {
  const GaitPattern good{"p", {0.0, 0.5}, 0.5};
  EXPECT_NO_THROW(Gait(good, 1.0, 8, {0, 1}));
  EXPECT_THROW(Gait(good, 0.0, 8, {0, 1}), std::invalid_argument);
  EXPECT_THROW(Gait(good, std::numeric_limits<double>::quiet_NaN(), 8, {0, 1}),
               std::invalid_argument);
  EXPECT_THROW(Gait(good, 1.0, 8, {0, 1, 2}), std::invalid_argument);
  EXPECT_THROW(Gait(good, 1.0, 8, {0, 0}), std::invalid_argument);
  EXPECT_THROW(Gait({"p", {0.0, 1.0}, 0.5}, 1.0, 8, {0, 1}), std::invalid_argument);
  EXPECT_THROW(Gait({"p", {0.0, 0.5}, 0.0}, 1.0, 8, {0, 1}), std::invalid_argument);
  EXPECT_THROW(Gait({"p", {0.0, 0.5}, 0.5, {0.5, 1.1}}, 1.0, 8, {0, 1}), std::invalid_argument);
  EXPECT_THROW(Gait({"p", {0.0, 0.5}, 0.5, {0.5}}, 1.0, 8, {0, 1}), std::invalid_argument);
  // 0.05 of eight knots is less than one, and no knot falls on 0.06 … 0.11.
  EXPECT_THROW(Gait({"p", {0.0, 0.06}, 0.05}, 1.0, 8, {0, 1}), std::invalid_argument);
}

TEST(FootfallOrder, GoesFrontToHindAndLeftToRight) {
  const std::vector<Eigen::Vector3d> feet{
      {-0.1, -0.1, 0}, {0.12, -0.1, 0}, {0.1, 0.1, 0}, {-0.12, 0.1, 0}};
  EXPECT_EQ(footfall_order(feet), (std::vector<int>{2, 1, 3, 0}));
  const std::vector<Eigen::Vector3d> biped{{0.0, -0.1, 0}, {0.01, 0.1, 0}};
  EXPECT_EQ(footfall_order(biped), (std::vector<int>{1, 0}));
  const std::vector<Eigen::Vector3d> hexapod{{0.1, 0.1, 0}, {0.1, -0.1, 0}, {0, 0.12, 0},
                                             {0, -0.12, 0}, {-0.1, 0.1, 0}, {-0.1, -0.1, 0}};
  EXPECT_EQ(footfall_order(hexapod), test::in_order(6));
  EXPECT_TRUE(footfall_order({}).empty());
}

TEST(FootfallDiagram, DrawsOneLinePerFoot) {
  const Gait gait(pattern(2, "walk"), 1.0, 10, {0, 1});
  EXPECT_EQ(footfall_diagram(gait, {"left", "r"}), "left  ######....\nr     #....#####\n");
}

}  // namespace
}  // namespace legwright
