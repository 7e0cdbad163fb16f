// SPDX-License-Identifier: Apache-2.0
// Curved paths from task file to verdict: a puppy that cannot turn is co-designed to walk along a circle and to turn on
// the spot, at half, default and double gains, with a plan that repeats up to the turn (eq (17)).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <sstream>

#include "tests/tools/verbs/program.hpp"
#include "tools/io/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct Curve {
  const char* name;
  double speed, turn_rate;
};

std::ostream& operator<<(std::ostream& out, const Curve& curve) {
  return out << curve.speed << " m/s, " << curve.turn_rate << " rad/s";
}

class Turning : public testing::TestWithParam<Curve> {
 protected:
  test::Outcome call(const std::vector<std::string>& words) const {
    return test::wait_for(test::start(words, folder_.path()), folder_.path());
  }
  /// The example with this speed and turn rate, beside a copy of its robot.
  std::string write_task() const {
    const fs::path puppy = test::kExamples / "puppy";
    fs::copy_file(puppy / "robot.xml", folder_.path() / "robot.xml");
    std::string text = read_file(puppy / "turning.toml");
    const auto replace = [&](const std::string& key, const std::string& value) {
      const std::size_t at = text.find("\n" + key + " = ");
      ASSERT_NE(at, std::string::npos) << key;
      text.replace(at, text.find('#', at) - at, "\n" + key + " = " + value + "  ");
    };
    std::string velocity = std::to_string(GetParam().speed);
    replace("velocity", velocity.insert(0, 1, '[').append(", 0.0]"));
    replace("turn_rate", std::to_string(GetParam().turn_rate));
    write_file(folder_.path() / "task.toml", text);
    return "task.toml";
  }
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
  ASSERT_EQ(rows.size(), 25u);
  const Row &first = rows.front(), &last = rows.back();
  const Eigen::Matrix3d round = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).matrix();
  // The turn is added to the root's rotation vector, which is exact for a level trunk only.
  const Eigen::AngleAxisd missed(trunk_rotation(last).transpose() * round * trunk_rotation(first));
  EXPECT_LT(std::abs(missed.angle()), 1e-3);
  const Eigen::Vector3d travel = vector(last, "com_", "_m") - round * vector(first, "com_", "_m");
  for (const std::string foot : {"foot:FL_", "foot:FR_", "foot:HL_", "foot:HR_"}) {
    const Eigen::Vector3d place = round * vector(first, foot, "_m") + travel;
    EXPECT_LT((vector(last, foot, "_m") - place).norm(), 1e-3) << foot;
    const Eigen::Vector3d force = round * vector(first, foot + "f", "_N");
    EXPECT_LT((vector(last, foot + "f", "_N") - force).norm(), 0.05) << foot;
  }
  for (const auto& [name, value] : first)
    if (name.starts_with("q:")) {
      EXPECT_NEAR(last.at(name), value, 2e-3) << name;
    }
}

TEST_P(Turning, CoDesignedPuppyDoesWhatTheInitialOneDoesNot) {
  const test::Outcome optimize = call({"optimize", write_task(), "--no-pictures", "-o", "run"});
  ASSERT_EQ(optimize.code, 0) << optimize.err;
  const test::Outcome validate = call({"validate", "run"});
  EXPECT_EQ(validate.code, 0) << validate.out << validate.err;
  const fs::path result = folder_.path() / "run" / "result";
  expect_periodic_up_to_the_turn(result / "motion.csv", GetParam().turn_rate * 1.0);
  EXPECT_FALSE(Json::parse(read_file(result / "verdict.json"))["initial"]["pass"].get<bool>());
  const Json metrics = Json::parse(read_file(result / "metrics.json"))["result"];
  for (const char* gains : {"half", "default", "double"}) {
    const Json& run = metrics[gains];
    EXPECT_TRUE(run["fall"].is_null()) << gains;
    EXPECT_NEAR(run["turn_ratio"].get<double>(), 1.0, 0.05) << gains;
    if (GetParam().speed > 0.0) {
      EXPECT_NEAR(run["speed_ratio"].get<double>(), 1.0, 0.05) << gains;
    } else {
      EXPECT_LT(
          std::hypot(run["velocity_mps"][0].get<double>(), run["velocity_mps"][1].get<double>()),
          0.005)
          << gains;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Puppy, Turning,
                         testing::Values(Curve{"circle", 0.08, 0.3}, Curve{"spot", 0.0, 0.4}),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace legwright
