// SPDX-License-Identifier: Apache-2.0
#include "plugin/trajectory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "plugin/spline.hpp"
#include "tests/plugin/mutate.hpp"
#include "tests/plugin/toy_trajectory.hpp"
#include "tests/support/paths.hpp"

namespace legwright {
namespace {

/// Message with which the text is refused; empty if it is not.
std::string refusal(const std::string& text, const CycleSettings& cycle = {}) {
  try {
    parse_trajectory(text, cycle);
    return "";
  } catch (const TrajectoryError& error) {
    return error.what();
  }
}

const std::string kHeader =
    "time_s q:a_rad tau:a_Nm root_x_m root_y_m root_z_m root_rx_rad root_ry_rad root_rz_rad "
    "com_x_m com_y_m com_z_m";

/// A valid text whose knot `knot` is replaced by `row`.
std::string text_with(int knot, const std::string& row) {
  std::string text = kHeader;
  for (int i = 0; i < 4; ++i) {
    text += "; ";
    text += i == knot ? row : std::to_string(i).append(" 0.5 0 0 0 0 0 0 0 0 0 0");
  }
  return text;
}

TEST(Trajectory, ReadsBackWhatItWroteToTheBit) {
  Trajectory t = toy_trajectory(3, 2, 7, 0.7, 1);
  t.at(2, 1) = 0.1 + 0.2;
  t.at(3, 1) = -0.0;
  t.at(4, 1) = 4.9e-324;
  const std::string text = write_trajectory(t);
  const Trajectory back = parse_trajectory(text, {t.period, {1, 2, 3}, 4});
  EXPECT_EQ(back.joint_names, t.joint_names);
  EXPECT_EQ(back.foot_names, t.foot_names);
  EXPECT_EQ(back.knot_count, t.knot_count);
  EXPECT_EQ(back.table, t.table);
  EXPECT_EQ(back.period, t.period);
  EXPECT_EQ(back.travel[1], 2);
  EXPECT_EQ(back.turn, 4);
  EXPECT_EQ(write_trajectory(back), text);
}

TEST(Trajectory, FindsThePeriodInTheTimes) {
  const Trajectory t = toy_trajectory(1, 0, 5, 0.7, 1);
  EXPECT_NEAR(parse_trajectory(write_trajectory(t)).period, 0.7, 1e-15);
}

TEST(Trajectory, RowsMayBeSeparatedBySemicolonsLineBreaksOrBoth) {
  const std::string text = write_trajectory(toy_trajectory(2, 1, 5, 0.7, 1));
  std::string breaks, semicolons;
  for (const char c : text) {
    if (c != ';') breaks += c == '\n' ? std::string("\r\n") : std::string(1, c);
    if (c != '\n') semicolons += c;
  }
  const Trajectory t = parse_trajectory(text);
  EXPECT_EQ(parse_trajectory(breaks).table, t.table);
  EXPECT_EQ(parse_trajectory(semicolons + ";\n ;").table, t.table);
}

TEST(Trajectory, ColumnsAreInTheOrderOfTheHeader) {
  const Trajectory t = toy_trajectory(2, 2, 4, 1.0, 1);
  const std::vector<std::string> header = t.header();
  ASSERT_EQ(static_cast<int>(header.size()), t.column_count());
  const auto name = [&header](int column) { return header[static_cast<std::size_t>(column)]; };
  EXPECT_EQ(name(0), "time_s");
  EXPECT_EQ(name(t.target_column(1)), "q:b_rad");
  EXPECT_EQ(name(t.torque_column(0)), "tau:a_Nm");
  EXPECT_EQ(name(t.root_column(2)), "root_z_m");
  EXPECT_EQ(name(t.root_column(3)), "root_rx_rad");
  EXPECT_EQ(name(t.com_column(0)), "com_x_m");
  EXPECT_EQ(name(t.foot_column(1, 1)), "foot:B_y_m");
  EXPECT_EQ(name(t.force_column(1, 2)), "foot:B_fz_N");
  EXPECT_EQ(name(t.contact_column(0)), "contact:A");
}

TEST(Trajectory, MotionCsvEndsWithKnotT) {
  Trajectory t = toy_trajectory(1, 1, 4, 2.0, 3);
  t.travel = {0.5, 0.0, 0.0};
  const auto lines = [](const std::string& text) {
    std::vector<std::string> result;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) result.push_back(line);
    return result;
  };
  const auto moved = lines(write_motion_csv(t));
  ASSERT_EQ(moved.size(), 6u);  // header, knots 0 … 4
  EXPECT_EQ(moved[0].substr(0, 23), "time_s,q:a_rad,tau:a_Nm");
  EXPECT_EQ(moved[5].substr(0, 2), "2,");
  const auto same_but_moved = [&](int column) {
    std::istringstream first(moved[1]), last(moved[5]);
    std::string a, b;
    for (int i = 0; i <= column; ++i) std::getline(first, a, ','), std::getline(last, b, ',');
    return std::stod(b) - std::stod(a);
  };
  EXPECT_NEAR(same_but_moved(t.root_column(0)), 0.5, 1e-12);
  EXPECT_NEAR(same_but_moved(t.foot_column(0, 0)), 0.5, 1e-12);
  EXPECT_EQ(same_but_moved(t.target_column(0)), 0.0);
  const std::vector<double> own(static_cast<std::size_t>(t.column_count()), 9.0);
  EXPECT_EQ(lines(write_motion_csv(t, own))[5].substr(0, 6), "9,9,9,");
  EXPECT_THROW(write_motion_csv(t, std::span(own).first(3)), TrajectoryError);
}

struct BadText {
  std::string text, message;
};
void PrintTo(const BadText&, std::ostream* out) { *out << "bad text"; }  // else bytes of pointers
class RefusedTrajectory : public testing::TestWithParam<BadText> {};

TEST_P(RefusedTrajectory, SaysWhereAndWhy) {
  const std::string said = refusal(GetParam().text);
  EXPECT_NE(said.find(GetParam().message), std::string::npos) << "said: " << said;
}

const BadText kBadTexts[] = {
    {"", "empty"},
    {" ;;\n", "empty"},
    {"time_s", "column 2: got the end of the row, expected q:JOINT_rad"},
    {"time q:a_rad", "column 1: got \"time\", expected \"time_s\""},
    {"time_s tau:a_Nm", "column 2: got \"tau:a_Nm\", expected q:JOINT_rad"},
    {"time_s q:a_deg", "column 2: got \"q:a_deg\""},
    {"time_s q:a_rad tau:b_Nm", "column 3: got \"tau:b_Nm\", expected \"tau:a_Nm\""},
    {"time_s q:a_rad tau:a_Nm root_x_m", "4 columns, the next should be \"root_y_m\""},
    {kHeader + " foot:A_x_m", "13 columns, the next should be \"foot:A_y_m\""},
    {kHeader + " surplus", "column 13: got \"surplus\", expected the end of the row"},
    {"time_s q:a,b_rad tau:a,b_Nm", "the next should be"},
    {kHeader, "0 knots; expected at least 4"},
    {kHeader + ";0 1 2 3 4 5 6 7 8 9 0 1", "1 knots; expected at least 4"},
    {text_with(2, "2 0.5 0 0 0 0"), "row 3 (knot 2): 6 values, expected 12"},
    {text_with(2, "2 0.5 0 0 0 0 0 0 0 0 0 0 7"), "row 3 (knot 2): 13 values, expected 12"},
    {text_with(1, "1 0,5 0 0 0 0 0 0 0 0 0 0"), "row 2 (knot 1), column 2 (q:a_rad): got \"0,5\""},
    {text_with(1, "1 nan 0 0 0 0 0 0 0 0 0 0"), "got \"nan\""},
    {text_with(1, "1 -inf 0 0 0 0 0 0 0 0 0 0"), "got \"-inf\""},
    {text_with(1, "1 1e999 0 0 0 0 0 0 0 0 0 0"), "got \"1e999\""},
    {text_with(1, "1 2e10 0 0 0 0 0 0 0 0 0 0"), "got \"2e10\""},
    {text_with(1, "1 0x1p3 0 0 0 0 0 0 0 0 0 0"), "got \"0x1p3\""},
    {text_with(1, "1 +1 0 0 0 0 0 0 0 0 0 0"), "got \"+1\""},
    {text_with(1, "1 0.5rad 0 0 0 0 0 0 0 0 0 0"), "got \"0.5rad\""},
    {text_with(1, "1 \x01\xff 0 0 0 0 0 0 0 0 0 0"), "got \"??\""},
    {text_with(0, "0.5 0 0 0 0 0 0 0 0 0 0 0"), "row 1 (knot 0), column 1 (time_s): got 0.5"},
    {text_with(2, "1 0 0 0 0 0 0 0 0 0 0 0"),
     "row 3 (knot 2), column 1 (time_s): got 1, not later"},
    {text_with(2, "2.1 0 0 0 0 0 0 0 0 0 0 0"),
     "row 3 (knot 2), column 1 (time_s): got 2.1, expected 2"},
    {text_with(3, "-3 0 0 0 0 0 0 0 0 0 0 0"), "got -3, expected times that rise"},
};
INSTANTIATE_TEST_SUITE_P(All, RefusedTrajectory, testing::ValuesIn(kBadTexts));

TEST(Trajectory, RefusesWhatDoesNotFitTheCycle) {
  const std::string good = text_with(-1, "");
  EXPECT_EQ(refusal(good), "");  // negative control of the table above
  EXPECT_EQ(refusal(good, {4.0, {}, 0.0}), "");
  EXPECT_NE(refusal(good, {4.1, {}, 0.0}).find("column 1 (time_s)"), std::string::npos);
  EXPECT_NE(refusal(good, {0.0, {}, 0.0}).find("period"), std::string::npos);
  EXPECT_NE(refusal(good, {std::nan(""), {}, 0.0}).find("period"), std::string::npos);
  EXPECT_NE(refusal(good, {4.0, {0, 0, std::nan("")}, 0.0}).find("travel"), std::string::npos);
  EXPECT_NE(refusal(good, {4.0, {}, std::numeric_limits<double>::infinity()}).find("turn"),
            std::string::npos);
}

TEST(Trajectory, RefusesContactsThatAreNeitherZeroNorOne) {
  Trajectory t = toy_trajectory(1, 1, 4, 1.0, 3);
  t.at(2, t.contact_column(0)) = 0.5;
  try {
    write_trajectory(t);
    FAIL() << "written";
  } catch (const TrajectoryError& error) {
    EXPECT_NE(std::string(error.what()).find("row 3 (knot 2), column 19 (contact:A): got 0.5"),
              std::string::npos)
        << error.what();
  }
}

TEST(Trajectory, RefusesNamesThatCannotBeWrittenAndNamesUsedTwice) {
  EXPECT_NO_THROW(blank_trajectory({"hüfte"}, {"FL"}, 4, 1.0));
  for (const char* const name : {"front left", "a;b", "a,b", "a\tb", ""}) {
    EXPECT_THROW(blank_trajectory({name}, {}, 4, 1.0), TrajectoryError) << name;
    EXPECT_THROW(blank_trajectory({"a"}, {name}, 4, 1.0), TrajectoryError) << name;
  }
  EXPECT_THROW(blank_trajectory({"a", "a"}, {}, 4, 1.0), TrajectoryError);
  EXPECT_THROW(blank_trajectory({}, {"A"}, 4, 1.0), TrajectoryError);
  EXPECT_THROW(blank_trajectory({"a"}, {}, 3, 1.0), TrajectoryError);
  EXPECT_THROW(blank_trajectory({"a"}, {}, -1, 1.0), TrajectoryError);
}

TEST(Trajectory, RefusesAbsurdSizes) {
  EXPECT_THROW(blank_trajectory({"a"}, {}, 10001, 1.0), TrajectoryError);
  std::string wide = "time_s";
  for (int i = 0; i < 20000; ++i) wide.append(" q:j").append(std::to_string(i)).append("_rad");
  EXPECT_NE(refusal(wide).find("columns"), std::string::npos);
  std::string tall = kHeader;
  for (int i = 0; i < 10001; ++i)
    tall.append(";").append(std::to_string(i)).append(" 0 0 0 0 0 0 0 0 0 0 0");
  EXPECT_NE(refusal(tall).find("rows"), std::string::npos);
  EXPECT_NE(refusal(std::string((std::size_t{64} << 20) + 1, ' ')).find("bytes"),
            std::string::npos);
}

TEST(Trajectory, AnyMutationIsReadOrRefusedWithAMessage) {
  Trajectory t = toy_trajectory(3, 2, 8, 0.8, 5);
  const std::string good = write_trajectory(t);
  std::mt19937 random(20240501);
  int accepted = 0, refused = 0;
  TrajectorySample out;
  for (int i = 0; i < 4000; ++i) {
    const std::string text = mutate(good, random);
    try {
      const Trajectory read = parse_trajectory(text);
      ++accepted;
      for (const double time : {0.0, 0.33, -7.1, 1e5}) {
        sample(read, time, out);
        for (const double value : out.target) ASSERT_TRUE(std::isfinite(value)) << text;
        for (const double value : out.root) ASSERT_TRUE(std::isfinite(value)) << text;
      }
      ASSERT_EQ(parse_trajectory(write_trajectory(read)).table, read.table);
    } catch (const TrajectoryError& error) {
      ++refused;
      ASSERT_GT(std::string(error.what()).size(), 20u);
      ASSERT_LT(std::string(error.what()).size(), 400u) << error.what();
    }
  }
  EXPECT_GT(accepted, 200);  // both branches were really seen
  EXPECT_GT(refused, 2000);
}

TEST(Trajectory, ReadmesExampleNamesTheHeaderOfTheFormat) {
  std::ifstream file(test::source_dir() + "/plugin/README.md");
  std::stringstream readme;
  readme << file.rdbuf();
  std::string header = kHeader;
  for (std::size_t at; (at = header.find(":a_")) != std::string::npos;)
    header.replace(at, 3, ":elbow_");
  EXPECT_NE(readme.str().find(header), std::string::npos);
}

TEST(Trajectory, SlidesHaveMetresAndNewtons) {
  Trajectory t = toy_trajectory(3, 1, 5, 0.4, 2);
  t.joint_slides = {false, true, false};
  const std::string text = write_trajectory(t);
  EXPECT_TRUE(text.starts_with("time_s q:a_rad q:b_m q:c_rad tau:a_Nm tau:b_N tau:c_Nm root_x_m"));
  const Trajectory back = parse_trajectory(text);
  EXPECT_EQ(back.joint_names, t.joint_names);
  EXPECT_EQ(back.joint_slides, t.joint_slides);
  EXPECT_EQ(back.table, t.table);
  // Both columns of a joint tell the same kind.
  std::string mixed = text;
  mixed.replace(mixed.find("tau:b_N"), 7, "tau:b_Nm");
  try {
    parse_trajectory(mixed);
    ADD_FAILURE() << "read";
  } catch (const TrajectoryError& error) {
    EXPECT_STREQ(error.what(),
                 "trajectory: header, column 6: got \"tau:b_Nm\", expected \"tau:b_N\"");
  }
}

}  // namespace
}  // namespace legwright
