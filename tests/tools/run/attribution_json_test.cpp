// SPDX-License-Identifier: Apache-2.0
#include "tools/run/attribution_json.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

/// Only its names are asked for.
class NamedCost final : public CostFunction {
 public:
  void evaluate(const Eigen::VectorXd&, const Eigen::VectorXd&, Order, Evaluation&) override {}
  const Eigen::VectorXd& motion_units() const override { return units_; }
  std::vector<std::string_view> term_names() const override { return {"travel", "smoothness"}; }

 private:
  Eigen::VectorXd units_;
};

DesignSpace space_of(const char* name) {
  DesignSpace space;
  space.parameters.resize(1);
  space.parameters[0].name = name;
  return space;
}

PutBack row_of(std::vector<double> decrease, std::vector<std::vector<double>> terms) {
  PutBack row;
  row.decrease = std::move(decrease);
  row.outer_decrease = {0.5, 0.25};
  row.terms = std::move(terms);
  row.motion_status = SolveStatus::converged;
  return row;
}

TEST(AttributionJson, RowsOfATaskAndOfAllTasks) {
  NamedCost cost;
  std::vector<WeightedCost> tasks(2);
  tasks[0].cost = tasks[1].cost = &cost;
  tasks[0].weight = 0.75;
  tasks[1].weight = 0.25;
  std::vector<PutBack> rows{row_of({3.0, -1.0}, {{2.0, 1.0}, {-1.0, 0.0}})};
  const auto single = put_back_records(rows, space_of("yaw"), tasks, 1);
  EXPECT_EQ(json_of(single[0]).dump(),
            R"({"parameter":"yaw","F":-1.0,"terms":{"travel":-1.0},"F_tasks":{},)"
            R"("status":"converged"})");
  tasks[0].outer = tasks[1].outer = &cost;
  EXPECT_EQ(put_back_records(rows, space_of("yaw"), tasks, 0)[0].J, 0.5);
  EXPECT_EQ(json_of(joint_put_back_records(rows, space_of("yaw"), tasks, {"a", "b"})[0]).dump(),
            R"({"parameter":"yaw","F":2.0,"J":0.4375,"terms":{},"F_tasks":{"a":3.0,"b":-1.0},)"
            R"("status":"converged"})");
  rows[0] = row_of({INFINITY, INFINITY}, {{}, {}});
  const auto none = put_back_records(rows, space_of("yaw"), tasks, 0);
  EXPECT_NE(json_of(none[0]).dump().find("\"F\":null"), std::string::npos);
}

TEST(AttributionJson, LargestFirstAndWithoutWhatIsNoNumber) {
  EXPECT_TRUE(attributions_of(std::nullopt).empty());
  std::vector<PutBackRecord> rows(2);
  rows[0] = {"broken", NAN, {}, {{"stance_foot", NAN}}, {}, "not_finite", {}};
  rows[1] = {"small", -0.1, {}, {{"a", 0.1}, {"b", -0.2}}, {}, "converged", {}};
  const std::vector<Attribution> read = attributions_of(rows, "pace", 0.5);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].parameter, "broken");
  EXPECT_TRUE(read[0].shares.empty());
  EXPECT_EQ(read[1].shares[0].term, "b") << "the largest comes first";
  EXPECT_EQ(read[1].shares[0].task, "pace");
  EXPECT_EQ(read[1].shares[0].decrease, -0.1) << "weighted";
}

}  // namespace
}  // namespace legwright
