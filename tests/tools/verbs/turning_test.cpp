// SPDX-License-Identifier: Apache-2.0
// Curved paths from task file to verdict: the examples that walk along a circle and turn on the
// spot do so at half, default and double gains, by a plan that repeats up to the turn (eq (17)); so
// does the radius, speed over turn rate.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <sstream>

#include "tests/tools/verbs/judged_example.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct Curve {
  const char* name;
  const char* task;
  bool initial_does_it;  // the body as it is built
};

std::ostream& operator<<(std::ostream& out, const Curve& curve) { return out << curve.task; }

class Turning : public testing::TestWithParam<Curve> {
 protected:
  test::TemporaryFolder folder_;
};

/// One row of motion.csv, by the names of its columns.
using Row = std::map<std::string, double>;

std::vector<Row> read_rows(const fs::path& motion_csv) {
  std::istringstream text(read_file(motion_csv));
  std::vector<std::string> names;
  std::vector<Row> rows;
  std::string line, cell;
  std::getline(text, line);
  for (std::istringstream header(line); std::getline(header, cell, ',');) names.push_back(cell);
  while (std::getline(text, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::size_t k = 0; std::getline(cells, cell, ','); ++k)
      rows.back()[names.at(k)] = std::stod(cell);
  }
  return rows;
}

Eigen::Vector3d vector(const Row& row, const std::string& before, const std::string& after) {
  return {row.at(before + "x" + after), row.at(before + "y" + after), row.at(before + "z" + after)};
}

Eigen::Matrix3d trunk_rotation(const Row& row) {
  const Eigen::Vector3d o = vector(row, "root_r", "_rad");
  return Eigen::AngleAxisd(o.norm(), o.normalized()).toRotationMatrix();
}

/// Knot T is knot 0 one cycle's rigid motion of the plane later.
void expect_periodic_up_to_the_turn(const fs::path& motion_csv, double turn) {
  const std::vector<Row> rows = read_rows(motion_csv);
  ASSERT_GT(rows.size(), 8u);
  const Row &first = rows.front(), &last = rows.back();
  const Eigen::Matrix3d round = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).matrix();
  // The turn is added to the root's rotation vector, which is exact for a level trunk only.
  const Eigen::AngleAxisd missed(trunk_rotation(last).transpose() * round * trunk_rotation(first));
  EXPECT_LT(std::abs(missed.angle()), 1e-3);
  const Eigen::Vector3d travel = vector(last, "com_", "_m") - round * vector(first, "com_", "_m");
  int feet = 0;
  for (const auto& [name, value] : first) {
    if (name.starts_with("q:")) {
      EXPECT_NEAR(last.at(name), value, 2e-3) << name;
    }
    if (!name.starts_with("foot:") || !name.ends_with("_x_m")) continue;
    const std::string foot = name.substr(0, name.size() - 3);  // without x_m
    const Eigen::Vector3d place = round * vector(first, foot, "_m") + travel;
    EXPECT_LT((vector(last, foot, "_m") - place).norm(), 1e-3) << foot;
    const Eigen::Vector3d force = round * vector(first, foot + "f", "_N");
    EXPECT_LT((vector(last, foot + "f", "_N") - force).norm(), 0.05) << foot;
    ++feet;
  }
  EXPECT_GE(feet, 4);
}

TEST_P(Turning, ItsRadiusAndHeadingRateAreThoseOfTheTask) {
  const test::JudgedExample judged = test::judge_example(GetParam().task, folder_.path() / "run");
  ASSERT_EQ(judged.optimize, 0) << judged.told;
  EXPECT_EQ(judged.validate, 0) << judged.told;
  const fs::path run = folder_.path() / "run", result = run / "result";
  const Json task = Json::parse(read_file(run / "run.json"))["task"];
  const double turn_rate = task["turn_rate"], speed = task["velocity"][0];
  ASSERT_GT(turn_rate, 0.0);
  expect_periodic_up_to_the_turn(result / "motion.csv", turn_rate * task["period_s"].get<double>());
  EXPECT_EQ(Json::parse(read_file(result / "verdict.json"))["initial"]["pass"].get<bool>(),
            GetParam().initial_does_it);
  const Json metrics = Json::parse(read_file(result / "metrics.json"))["result"];
  for (const char* gains : {"half", "default", "double"}) {
    const Json& at_gains = metrics[gains];
    EXPECT_TRUE(at_gains["fall"].is_null()) << gains;
    EXPECT_NEAR(at_gains["turn_ratio"].get<double>(), 1.0, 0.05) << gains;
    const Json& velocity = at_gains["velocity_mps"];
    const double measured = std::hypot(velocity[0].get<double>(), velocity[1].get<double>());
    if (speed > 0.0) {
      EXPECT_NEAR(at_gains["speed_ratio"].get<double>(), 1.0, 0.05) << gains;
      const double radius = measured / at_gains["turn_rate_radps"].get<double>();
      EXPECT_NEAR(radius / (speed / turn_rate), 1.0, 0.05) << gains;
    } else {
      EXPECT_LT(measured, 0.005) << gains;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Examples, Turning,
    testing::Values(Curve{"PuppyOnACircle", "puppy/turning.toml", false},
                    Curve{"PuppyOnTheSpot", "puppy/turning_on_the_spot.toml", false},
                    Curve{"HexapodOnACircle", "hexapod/turning.toml", true},
                    Curve{"HexapodOnTheSpot", "hexapod/turning_on_the_spot.toml", true}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace legwright
