// SPDX-License-Identifier: Apache-2.0
#include "tools/report/run_data.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tools/run/motion_csv.hpp"
#include "tools/run/result_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Runs `read` if the file is there; what it throws becomes a note.
template <class Read>
void if_present(const fs::path& file, std::vector<std::string>& notes, const Read& read) {
  if (!fs::exists(file)) return;
  try {
    read(file);
  } catch (const std::exception& error) {
    notes.push_back(error.what());
  }
}

}  // namespace

fs::path RunData::iteration(int index) const {
  return root / "iterations" / fmt::format("{:04}", index);
}

RunData read_run(const fs::path& root) {
  RunData data;
  data.root = root;
  data.run = read_record_file<RunRecord>(ResultFolder::open(root).run_json());
  if_present(root / "events.jsonl", data.notes, [&](const fs::path& file) {
    Iterations found = read_iterations(file);
    data.iterations = std::move(found.single);
    data.joint_iterations = std::move(found.joint);
  });
  const fs::path result = root / "result";
  if_present(result / "metrics.json", data.notes, [&](const fs::path& file) {
    const Json metrics = read_json(file);
    if (text_at(metrics, {"schema"}) == "legwright/validation")
      data.metrics = metrics;  // else not validated yet
  });
  if_present(result / "verdict.json", data.notes,
             [&](const fs::path& file) { data.verdict = read_json(file); });
  if_present(result / "certificate.json", data.notes, [&](const fs::path& file) {
    data.certificate = read_record_file<CertificateRecord>(file);
  });
  for (const auto& [name, target] : {std::pair{"comparison", &data.comparison},
                                     {"numerics", &data.numerics},
                                     {"robustness", &data.robustness}}) {
    if_present(result / fmt::format("{}.json", name), data.notes, [&](const fs::path& file) {
      Json document = read_json(file);
      if (text_at(document, {"schema"}) != fmt::format("legwright/{}", name) ||
          number_at(document, {"version"}) != 1.0)
        throw std::runtime_error(fmt::format("{}: expected schema legwright/{}, version 1",
                                             file.generic_string(), name));
      *target = std::move(document);
    });
  }
  data.compared_initial = comparison_of(data.comparison, "initial", data.notes);
  data.compared_result = comparison_of(data.comparison, "result", data.notes);
  data.factors = factors_of(data.robustness, data.notes);
  data.limits_initial = limits_of(data.verdict, "initial", data.notes);
  data.limits_result = limits_of(data.verdict, "result", data.notes);
  if_present(data.iteration(0) / "motion.csv", data.notes,
             [&](const fs::path& file) { data.initial_plan = read_motion_csv(file); });
  if_present(result / "motion.csv", data.notes,
             [&](const fs::path& file) { data.result_plan = read_motion_csv(file); });
  return data;
}

bool motion_only(const RunData& data) { return data.run.motion_only; }

const Json& value_at(const Json& json, std::initializer_list<const char*> path) {
  static const Json nothing;
  const Json* at = &json;
  for (const char* key : path) {
    if (!at->is_object()) return nothing;
    const auto found = at->find(key);
    if (found == at->end()) return nothing;
    at = &*found;
  }
  return *at;
}

std::optional<double> number_at(const Json& json, std::initializer_list<const char*> path) {
  const Json& value = value_at(json, path);
  if (!value.is_number()) return std::nullopt;
  const double number = value.get<double>();
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::string text_at(const Json& json, std::initializer_list<const char*> path) {
  const Json& value = value_at(json, path);
  return value.is_string() ? value.get<std::string>() : std::string();
}

}  // namespace legwright
