// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/promises.hpp"
#include "tests/fuzz/targets.hpp"
#include "tools/task/task_file.hpp"
#include "tools/task/task_text.hpp"

namespace legwright::test {
namespace {

const std::filesystem::path kTask = "fuzz.toml";

std::vector<double> weights_of(const TaskSet& set) {
  std::vector<double> weights;
  for (const TaskFile& task : set.tasks) weights.push_back(task.weight);
  return weights;
}

}  // namespace

bool fuzz_toml(std::string_view bytes) {
  const std::string text(bytes);
  TaskSet set;
  if (!accepted(kTask, [&] { set = parse_task_tables(text, kTask); })) return false;
  promise(!set.tasks.empty(), "a task file without tasks was read");
  const TaskSet beside = parse_task_tables(text_beside_robot(text), kTask);
  promise(beside.robot == "robot.xml" && beside.tasks.size() == set.tasks.size(),
          "a task is another beside its robot");
  if (!set.joint()) return true;
  std::vector<double> weights = weights_of(set);
  weights[0] *= 0.5;
  promise(weights_of(parse_task_tables(with_weights(text, weights), kTask)) == weights,
          "weights that were written are read otherwise");
  return true;
}

}  // namespace legwright::test
