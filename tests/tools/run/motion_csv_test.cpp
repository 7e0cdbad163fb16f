// SPDX-License-Identifier: Apache-2.0
#include "tools/run/motion_csv.hpp"
#include "tools/files/csv_table.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"
#include "plugin/trajectory.hpp"
#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

TEST(CsvTable, ReadsNumbersByColumn) {
  const CsvTable table = parse_csv_table("time_s, a_m\n0,1\n0.5,-2e-3\r\n", "d/x.csv", "validate");
  ASSERT_EQ(table.columns.size(), 2U);
  EXPECT_EQ(table.columns[1], "a_m");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[1][1], -2e-3);
}

TEST(CsvTable, RefusesWhatIsNoNumberAndNamesTheLine) {
  for (const char* cell : {"nan", "inf", "1x", "", "0x10", "1 2"}) {
    try {
      parse_csv_table(std::string("a,b\n1,2\n3,") + cell + "\n", "d/x.csv", "validate");
      FAIL() << cell;
    } catch (const InputError& error) {
      for (const char* part : {"d/x.csv:3: ", "run `legwright validate` again"})
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(parse_csv_table("a,b\n1\n", "d/x.csv", "validate"), InputError);
  EXPECT_THROW(parse_csv_table("a,b\n", "d/x.csv", "validate"), InputError);
  EXPECT_THROW(parse_csv_table("", "d/x.csv", "validate"), InputError);
}

TEST(MotionCsv, ComesBackAsWritten) {
  Trajectory plan = blank_trajectory({"hip", "knee"}, {"left"}, 6, 0.6);
  plan.travel = {0.0, 0.04, 0.0};
  for (int k = 0; k < 6; ++k) {
    plan.at(k, plan.target_column(1)) = 0.1 * k;
    plan.at(k, plan.root_column(1)) = 0.04 * k / 6;
    plan.at(k, plan.contact_column(0)) = k < 3 ? 1 : 0;
  }
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "motion.csv";
  write_file(file, write_motion_csv(plan));
  const Trajectory read = read_motion_csv(file);
  EXPECT_EQ(read.knot_count, 6);
  EXPECT_NEAR(read.period, 0.6, 1e-12);
  EXPECT_NEAR(read.travel[1], 0.04, 1e-12);
  EXPECT_EQ(read.table, plan.table);
  EXPECT_EQ(read.foot_names, plan.foot_names);
}

TEST(MotionCsv, DamagedIsRefusedWithItsPathAndAWayOut) {
  const auto file = std::filesystem::path(testing::TempDir()) / "damaged_motion.csv";
  for (const char* text : {"", "time_s\n0\n", "time_s\n0\n1\n", "time_s,q:a_rad\n0,0\n1,nan\n"}) {
    write_file(file, text);
    try {
      read_motion_csv(file);
      FAIL() << text;
    } catch (const InputError& error) {
      for (const std::string& part : {file.string(), std::string("`legwright optimize` again")})
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace legwright
