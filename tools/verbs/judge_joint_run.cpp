// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/input_error.hpp"
#include "tools/run/task_folders.hpp"
#include "tools/validate/records.hpp"
#include "tools/verbs/judge_run.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// The best body of one task alone, as the joint run from it found it.
struct AloneBody {
  std::string task;
  Json start;  // of run.json's "starts"
};

/// Those whose joint run was reached: a run that was stopped may lack some.
std::vector<AloneBody> bodies_alone(const ResultFolder& folder, const Json& run) {
  std::vector<AloneBody> bodies;
  for (const TaskFolder& task : task_folders(run))
    for (const Json& start : run.at("starts"))
      if (start.at("start") == task.name &&
          fs::is_directory(folder.root() / "starts" / ("from-" + task.name)))
        bodies.push_back({task.name, start});
  return bodies;
}

Json judge_bodies(const ResultFolder& folder, const Json& run, const JudgeOptions& options,
                  std::vector<JudgedRun>& judged) {
  // Designs, in the order of the matrix: the initial body, the best body of each task alone where
  // the run has looked for them, the joint result.
  const std::vector<AloneBody> bodies = bodies_alone(folder, run);
  const std::vector<TaskFolder> tasks = task_folders(run);  // checked: nothing outside the run
  Json designs = Json::array({{{"name", "initial body"}, {"start", "initial"}}});
  for (const AloneBody& body : bodies)
    designs.push_back({{"name", "for " + body.task + " alone"}, {"start", body.task}});
  designs.push_back({{"name", "for all tasks"}, {"start", run.at("best_start")}});
  Json cells = Json::object();
  bool pass = true;
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    const std::string& name = tasks[t].name;
    std::vector<fs::path> others;
    for (const AloneBody& body : bodies)
      others.push_back(folder.root() / "starts" / ("from-" + body.task) / name / "iterations" /
                       "0000");
    const ResultFolder own = ResultFolder::open(folder.root() / tasks[t].relative);
    judged.push_back(judge_run(own, others, options));
    std::vector<const SceneValidation*> order{&judged.back().designs[0]};
    for (std::size_t k = 2; k < judged.back().designs.size(); ++k)
      order.push_back(&judged.back().designs[k]);
    order.push_back(&judged.back().designs[1]);
    cells[name] = Json::array();
    for (std::size_t k = 0; k < order.size(); ++k) {
      const bool last = k + 1 == order.size();
      const Json& at_start = k == 0 ? run.at("starts").at(0) : bodies[last ? 0 : k - 1].start;
      const Json F = last ? run.at("tasks").at(t).at("F") : at_start.at("F_tasks_start").at(name);
      cells[name].push_back({{"F", F},
                             {"pass", order[k]->verdict.pass},
                             {"line", order[k]->verdict.line},
                             {"gains", json_of(metrics_by_gain(*order[k]))}});
    }
    pass = pass && judged.back().designs[1].verdict.pass;
  }
  const Json matrix{{"schema", "legwright/matrix"},
                    {"version", 1},
                    {"designs", designs},
                    {"cells", cells},
                    {"pass", pass}};
  write_json(folder.result() / "matrix.json", matrix);
  return matrix;
}

}  // namespace

Json judge_joint_run(const ResultFolder& folder, const Json& run, const JudgeOptions& options,
                     std::vector<JudgedRun>& judged) {
  try {
    return judge_bodies(folder, run, options, judged);
  } catch (const Json::exception& error) {
    throw InputError(
        folder.run_json().string(), 0, "",
        std::string(
            "not the run.json of a joint run that came to its end; run `legwright optimize` "
            "again: ") +
            error.what());
  }
}

}  // namespace legwright
