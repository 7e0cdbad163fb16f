// SPDX-License-Identifier: Apache-2.0
#include "tools/report/joint_data.hpp"

#include <fmt/format.h>

#include "tools/run/task_folders.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

Json read_noted(const fs::path& file, RunData& data) {
  if (!fs::exists(file)) return {};
  try {
    return read_json(file);
  } catch (const std::exception& error) {
    data.notes.push_back(error.what());
    return {};
  }
}

std::vector<std::optional<double>> costs_of(const JointData& data, const Json& values) {
  std::vector<std::optional<double>> costs;
  for (const JointTaskData& task : data.tasks)
    costs.push_back(number_at(values, {task.name.c_str()}));
  return costs;
}

MatrixDesign design_of(const JointData& data, const char* which) {
  MatrixDesign design;
  design.s = Json::object();
  for (const ParameterView& p : parameters_of(data.whole.run))
    design.s[p.name] = std::string_view(which) == "initial" ? p.initial : p.final;
  return design;
}

/// The designs of the matrix in validate's order, from run.json: known before validate has run.
std::vector<MatrixDesign> designs_of(const JointData& data) {
  const Json& run = data.whole.run;
  const Json &starts = value_at(run, {"starts"}), &alone = value_at(run, {"alone"});
  std::vector<MatrixDesign> designs{design_of(data, "initial")};
  designs.back().name = "initial body";
  for (const JointTaskData& task : data.tasks)
    designs.back().cost.push_back(number_at(task.task, {"F_initial"}));
  for (std::size_t k = 0; alone.is_array() && k < alone.size(); ++k) {
    const Json& tasks = value_at(alone[k], {"tasks"});
    const std::string name = tasks.is_array() && !tasks.empty() && tasks[0].is_string()
                                 ? tasks[0].get<std::string>()
                                 : "";
    MatrixDesign design;
    design.name = "for " + name + " alone";
    design.s = value_at(alone[k], {"s"});
    const bool tried = starts.is_array() && k + 1 < starts.size();
    design.cost = costs_of(
        data, tried ? value_at(starts[k + 1], {"F_tasks_start"}) : value_at(alone[k], {"F_tasks"}));
    designs.push_back(std::move(design));
  }
  designs.push_back(design_of(data, "final"));
  designs.back().name = data.tasks.size() == 2 ? "for both tasks" : "for all tasks";
  for (const JointTaskData& task : data.tasks)
    designs.back().cost.push_back(number_at(task.task, {"F"}));
  return designs;
}

void add_cells(JointData& data, const Json& matrix) {
  data.judged = value_at(matrix, {"cells"}).is_object();
  for (std::size_t d = 0; d < data.designs.size(); ++d) {
    MatrixDesign& design = data.designs[d];
    for (std::size_t t = 0; t < data.tasks.size(); ++t) {
      const Json& column = value_at(matrix, {"cells", data.tasks[t].name.c_str()});
      const bool there = column.is_array() && column.size() == data.designs.size();
      design.cells.push_back(there ? column[d] : Json());
      if (!there) continue;
      if (const auto cost = number_at(column[d], {"F"})) design.cost[t] = cost;
    }
  }
}

}  // namespace

bool is_joint(const Json& run) { return value_at(run, {"tasks"}).is_array(); }

JointData read_joint_run(const fs::path& root) {
  JointData data{read_run(root), {}, {}, {}, false};
  const Json& tasks = value_at(data.whole.run, {"tasks"});
  std::size_t index = 0;
  for (const TaskFolder& folder : task_folders(data.whole.run)) {
    JointTaskData& task = data.tasks.emplace_back();
    task.name = folder.name;
    task.relative = folder.relative;
    task.task = tasks[index++];
    try {
      task.run = read_run(root / folder.relative);
    } catch (const std::exception& error) {
      data.whole.notes.push_back(error.what());
    }
  }
  data.designs = designs_of(data);
  add_cells(data, read_noted(root / "result" / "matrix.json", data.whole));
  data.front = value_at(read_noted(root / "result" / "front.json", data.whole), {"points"});
  return data;
}

std::string href_of(const fs::path& relative) {
  std::string out;
  for (const char c : relative.generic_string()) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '/' || c == '.' || c == '-' || c == '_';
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

}  // namespace legwright
