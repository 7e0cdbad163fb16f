// SPDX-License-Identifier: Apache-2.0
#include "tools/report/curves_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mjcf/text/input_error.hpp"
#include "optimizer/motion/faced_frame.hpp"
#include "optimizer/terms/registry.hpp"
#include "tools/report/number_words.hpp"
#include "tools/report/parameter_view.hpp"
#include "tools/report/run_data.hpp"
#include "tools/report/words.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const RunData& data, const std::string& where,
                         const std::string& message) {
  throw InputError((data.root / "run.json").string(), 0, where, message);
}

/// What the run was, by its command and by the terms that its task switched off.
std::string variant_name(const RunData& data) {
  const TaskFile task = read_task_file(ResultFolder::open(data.root).inputs() / "task.toml");
  std::string without;
  for (const TermEntry& term : term_registry()) {
    const auto weight = task.weights.find(std::string(term.name));
    if (weight == task.weights.end() || weight->second != 0.0 || term.default_weight == 0.0)
      continue;
    without += (without.empty() ? ", without " : " and ") + spaced(term.name);
  }
  return (motion_only(data) ? "motion only" : "co-designed") + without;
}

double wanted_speed(const RunData& data) {
  if (data.run.joint())
    refuse(data, "tasks",
           "a run of several tasks has no single speed; give the folders of its tasks, " +
               (data.root / "tasks" / "NAME").string());
  const auto& [x, y] = data.run.task->velocity;
  const double speed = std::hypot(x, y);
  if (!(speed > 0.0) || !std::isfinite(speed))
    refuse(data, "task.velocity", "expected a wanted speed above zero, to draw against");
  return speed;
}

/// The task but for its speed: runs of one page have it in common.
std::string way_of(const TaskRecord& task, double speed) {
  const Eigen::Vector2d way_of_it =
      as_faced({task.velocity[0], task.velocity[1]}, task.facing()) / speed;
  const double x = way_of_it.x(), y = way_of_it.y();
  std::string way = x > 0.99    ? "forward"
                    : x < -0.99 ? "backward"
                    : y > 0.99  ? "to the left"
                    : y < -0.99 ? "to the right"
                                : fmt::format("along ({:.2f}, {:.2f})", x, y);
  if (task.turn_rate != 0.0) way += ", turning";
  return task.gait + " " + way;
}

CurveSample sample_of(const GainMetrics& measured, double wanted) {
  CurveSample sample;
  if (measured.fall) {
    sample.fall_time = measured.fall->time;  // what it did before it fell is no walk
  } else {
    sample.speed_ratio = measured.speed_ratio;
  }
  if (sample.speed_ratio) sample.speed = *sample.speed_ratio * wanted;
  sample.tilt = finite(measured.tilt_max);
  sample.saturated_share = finite(measured.saturated_share);
  sample.touch_share = measured.self_contact.share;
  sample.touch_count = measured.self_contact.count;
  return sample;
}

CurvePoint point_of(const RunData& data) {
  CurvePoint point;
  point.run = data.root;
  point.wanted = wanted_speed(data);
  if (data.of_another)
    throw InputError(
        (data.root / "result/verdict.json").string(), 0, "",
        std::string(kOfAnother) + " with `legwright validate " + data.root.generic_string() + "`");
  if (!data.verdict || !data.metrics)
    throw InputError(
        data.root.string(), 0, "",
        "not validated yet; run `legwright validate " + data.root.generic_string() + "` first");
  point.pass = data.verdict->result.pass;
  point.reasons = data.verdict->result.reasons;
  if (!data.run.final_F)
    refuse(data, "final_F", "expected the cost of a finished run; run it to its end");
  point.cost = point.optimum = *data.run.final_F;
  if (data.run.choice && !data.run.choice->candidates.empty())
    point.optimum = data.run.choice->candidates.front().F;
  for (std::size_t g = 0; g < kGains.size(); ++g)
    if (const GainMetrics* measured = data.metrics->result.find(kGains[g]))
      point.at_gains[g] = sample_of(*measured, point.wanted);
  point.parameters = parameters_of(data.run);
  return point;
}

/// Checksums of all files of a run's robot.
std::string robot_sum(const RunRecord& run) {
  std::string sum;
  for (const auto& [file, own] : run.sha256)
    if (!file.ends_with("task.toml")) sum.append(file).append(" ").append(own).append("\n");
  return sum;
}

/// Collects runs, and sees to it that they belong together.
class Collector {
 public:
  void add(const fs::path& folder, const std::string& name) {
    const RunData data = read_run(folder);
    const std::string sum = robot_sum(data.run);
    const double speed = wanted_speed(data);
    const std::string way = way_of(*data.run.task, speed);
    if (!first_) {
      first_ = folder;
      sum_ = sum;
      curves_.robot = data.run.robot;
      curves_.way = way;
    }
    if (sum != sum_)
      refuse(data, "sha256.robot.xml",
             "another robot than that of " + first_->string() + "; curves are of one robot");
    if (way != curves_.way)
      refuse(data, "task",
             "asks for " + way + ", " + first_->string() + " for " + curves_.way +
                 "; curves are of tasks that differ in speed alone");
    CurveVariant& variant = named(name.empty() ? variant_name(data) : name);
    for (const CurvePoint& other : variant.points)
      if (other.wanted == speed)
        refuse(data, "task.velocity",
               fmt::format("'{}' has a run at {} m/s already, {}; tell them apart by --variant "
                           "NAME=RUN,RUN",
                           variant.name, speed, other.run.string()));
    variant.motion_only = motion_only(data);
    variant.points.push_back(point_of(data));
  }
  Curves finish() {
    for (CurveVariant& variant : curves_.variants)
      std::stable_sort(variant.points.begin(), variant.points.end(),
                       [](const auto& a, const auto& b) { return a.wanted < b.wanted; });
    // What was asked of the optimizer grows from one to the next: motion, all terms, body.
    const auto rank = [](const CurveVariant& v) {
      return (v.motion_only ? 0 : 2) + (v.name.find("without") == std::string::npos ? 1 : 0);
    };
    std::stable_sort(curves_.variants.begin(), curves_.variants.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    return std::move(curves_);
  }

 private:
  CurveVariant& named(const std::string& name) {
    for (CurveVariant& variant : curves_.variants)
      if (variant.name == name) return variant;
    return curves_.variants.emplace_back(CurveVariant{name, false, {}});
  }
  Curves curves_;
  std::optional<fs::path> first_;
  std::string sum_;
};

}  // namespace

std::optional<double> CurvePoint::worst(std::optional<double> CurveSample::*value) const {
  std::optional<double> most;
  for (const CurveSample& sample : at_gains)
    if (sample.*value && !(most && *most >= *(sample.*value))) most = sample.*value;
  return most;
}

bool CurvePoint::touches() const {
  return std::any_of(at_gains.begin(), at_gains.end(),
                     [](const CurveSample& sample) { return sample.touch_count > 0; });
}

bool CurvePoint::falls() const {
  return std::any_of(at_gains.begin(), at_gains.end(),
                     [](const CurveSample& sample) { return sample.fall_time.has_value(); });
}

Curves read_curves(const std::vector<fs::path>& loose, const std::vector<NamedRuns>& named) {
  Collector collector;
  for (const NamedRuns& variant : named)
    for (const fs::path& run : variant.runs) collector.add(run, variant.name);
  for (const fs::path& run : loose) collector.add(run, "");
  return collector.finish();
}

}  // namespace legwright
