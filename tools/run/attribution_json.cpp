// SPDX-License-Identifier: Apache-2.0
#include "tools/run/attribution_json.hpp"

#include <cmath>

namespace legwright {
namespace {

PutBackRecord plain_record(const PutBack& row, const DesignSpace& space) {
  PutBackRecord record;
  record.parameter = space.parameters[row.parameter].name;
  record.status = to_string(row.motion_status);
  return record;
}

}  // namespace

std::vector<PutBackRecord> put_back_records(const std::vector<PutBack>& rows,
                                            const DesignSpace& space,
                                            const std::vector<WeightedCost>& tasks, int task) {
  const std::vector<std::string_view> names = tasks[task].cost->term_names();
  std::vector<PutBackRecord> records;
  for (const PutBack& row : rows) {
    PutBackRecord record = plain_record(row, space);
    record.F = row.decrease[task];
    if (tasks[task].outer != nullptr) record.J = row.outer_decrease[task];
    for (std::size_t t = 0; t < row.terms[task].size(); ++t)
      if (row.terms[task][t] != 0.0) record.terms.of(names[t]) = row.terms[task][t];
    records.push_back(std::move(record));
  }
  return records;
}

std::vector<PutBackRecord> joint_put_back_records(const std::vector<PutBack>& rows,
                                                  const DesignSpace& space,
                                                  const std::vector<WeightedCost>& tasks,
                                                  const std::vector<std::string>& names) {
  std::vector<PutBackRecord> records;
  for (const PutBack& row : rows) {
    PutBackRecord record = plain_record(row, space);
    for (std::size_t k = 0; k < tasks.size(); ++k) {
      record.F += tasks[k].weight * row.decrease[k];
      record.F_tasks.of(names[k]) = row.decrease[k];
      if (tasks[k].outer != nullptr)
        record.J = record.J.value_or(0.0) + tasks[k].weight * row.outer_decrease[k];
    }
    records.push_back(std::move(record));
  }
  return records;
}

std::vector<Attribution> attributions_of(const std::optional<std::vector<PutBackRecord>>& records,
                                         const std::string& task, double weight) {
  std::vector<Attribution> out;
  if (!records) return out;
  for (const PutBackRecord& record : *records) {
    Attribution one{record.parameter, {}};
    for (const auto& [term, value] : record.terms)
      if (std::isfinite(value)) one.shares.push_back({task, term, weight * value});
    sort_by_size(one.shares);
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace legwright
