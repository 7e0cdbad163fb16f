// SPDX-License-Identifier: Apache-2.0
#include "tools/report/joint_data.hpp"

#include <fmt/format.h>

#include <utility>

#include "tools/run/task_folders.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

MatrixDesign design_of(const RunRecord& run, std::string name, double ParameterRecord::*value,
                       std::optional<double> TaskRecord::*cost) {
  MatrixDesign design{std::move(name), {}, {}, {}};
  for (const ParameterRecord& p : run.parameters) design.s.of(p.name) = p.*value;
  for (const TaskRecord& task : *run.tasks) design.cost.push_back(task.*cost);
  return design;
}

/// The designs of the matrix in validate's order, from run.json: known before validate has run.
std::vector<MatrixDesign> designs_of(const JointData& data) {
  const RunRecord& run = data.whole.run;
  std::vector<MatrixDesign> designs{
      design_of(run, "initial body", &ParameterRecord::initial, &TaskRecord::initial_F)};
  for (std::size_t k = 0; run.alone && k < run.alone->size(); ++k) {
    const StartRecord& alone = (*run.alone)[k];
    const std::string name = alone.tasks.empty() ? "" : alone.tasks.front();
    MatrixDesign design{"for " + name + " alone", alone.s, {}, {}};
    const bool tried = run.starts && k + 1 < run.starts->size();
    const ByName<double>& costs = tried ? (*run.starts)[k + 1].start_F_of_tasks : alone.F_of_tasks;
    for (const JointTaskData& task : data.tasks) {
      const double* const cost = costs.find(task.name);
      design.cost.push_back(cost != nullptr ? std::optional(*cost) : std::nullopt);
    }
    designs.push_back(std::move(design));
  }
  designs.push_back(design_of(run, data.tasks.size() == 2 ? "for both tasks" : "for all tasks",
                              &ParameterRecord::final, &TaskRecord::F));
  return designs;
}

void add_cells(JointData& data) {
  const std::optional<MatrixRecord>& matrix = data.whole.matrix;
  for (std::size_t d = 0; d < data.designs.size(); ++d) {
    MatrixDesign& design = data.designs[d];
    for (std::size_t t = 0; t < data.tasks.size(); ++t) {
      const auto* const column = matrix ? matrix->cells.find(data.tasks[t].name) : nullptr;
      const bool there = column != nullptr && column->size() == data.designs.size();
      design.cells.push_back(there ? std::optional((*column)[d]) : std::nullopt);
      if (there) design.cost[t] = (*column)[d].F;
    }
  }
}

}  // namespace

JointData joint_data_of(RunData whole) {
  JointData data{std::move(whole), {}, {}};
  std::size_t index = 0;
  for (const TaskFolder& folder : task_folders(data.whole.run)) {
    JointTaskData& task = data.tasks.emplace_back();
    task.name = folder.name;
    task.relative = folder.relative;
    task.task = (*data.whole.run.tasks)[index++];
    try {
      task.run = read_run(data.whole.root / folder.relative);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      data.whole.notes.push_back(error.what());
    }
  }
  data.designs = designs_of(data);
  add_cells(data);
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
