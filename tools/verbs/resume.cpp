// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/resume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "optimizer/factor/hessian_factor.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/files/parse_json.hpp"
#include "tools/files/shell_word.hpp"
#include "tools/run/install.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/run_build.hpp"
#include "tools/run/run_record.hpp"

namespace legwright {

namespace fs = std::filesystem;

namespace {

/// Each member of an object as JSON.
ByName<std::string> texts_of(const Json& object) {
  ByName<std::string> out;
  for (const auto& [name, value] : object.items()) out.of(name) = value.dump();
  return out;
}

std::string words_of(const ByName<std::string>& versions) {
  std::string out;
  for (const auto& [name, version] : versions)
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", name, version);
  return out;
}

/// Of a run without a state.
std::string why_nothing_goes_on(const fs::path& run) {
  if (!is_run(run))
    return "holds no search that could go on; give the folder that `legwright optimize` wrote";
  if (read_record_file<RunRecord>(run / "run.json").ended())
    return "its search came to its end; there is nothing to go on with";
  return "its search was broken off before it had a state to go on from; begin anew: `legwright "
         "optimize TASK -o " +
         shell_word(run.string()) + "`, with --force where it asks for that";
}

}  // namespace

CheckpointBegin begin_of(const OptimizeOptions& options) {
  CheckpointBegin begin{fs::current_path().string(), texts_of(json_of(options)), {}, "", {}};
  const Json known = versions();  // must outlive the loop over its items
  for (const auto& [name, version] : known.items()) begin.versions.of(name) = version;
  begin.factor = factor_name();
  return begin;
}

ReadCheckpoint unfinished_search(const fs::path& run, bool anyway) {
  rescue_checkpoint(run);
  std::optional<ReadCheckpoint> found = read_checkpoint(run);
  if (!found) throw IoError(run.string() + ": " + why_nothing_goes_on(run));
  const CheckpointBegin now = begin_of({});
  if (!anyway && (found->begin.versions != now.versions || found->begin.factor != now.factor))
    throw InputError(fmt::format(
        "{}: its search was begun with other versions ({}; factors: {}) than these ({}; factors: "
        "{}), so last bits may differ; `legwright optimize --resume … --anyway` goes on all the "
        "same",
        run.string(), words_of(found->begin.versions), found->begin.factor, words_of(now.versions),
        now.factor));
  return std::move(*found);
}

void check_alone(const OptimizeOptions& asked) {
  const ByName<std::string> usual = texts_of(json_of(OptimizeOptions{}));
  std::string others;
  const auto add = [&](std::string name) {
    std::replace(name.begin(), name.end(), '_', '-');
    others +=
        fmt::format("{}{}", others.empty() ? "" : ", ", name == "task" ? "TASK" : "--" + name);
  };
  for (const auto& [name, text] : texts_of(json_of(asked))) {
    const std::string* const same = usual.find(name);
    if (name != "threads" && (same == nullptr || *same != text)) add(name);
  }
  if (!asked.run.empty()) add("output");
  if (asked.force) add("force");
  if (!others.empty())
    throw InputError(
        "--resume goes on with the options that the search was begun with; leave out " + others);
}

OptimizeOptions options_of(const ReadCheckpoint& search, const fs::path& run) {
  const CheckpointBegin& begin = search.begin;
  Json given = Json::object();
  for (const auto& [name, text] : begin.options) given[name] = parse_json(text);
  auto options =
      record_of<OptimizeOptions>(given, (checkpoint_folder(run) / "begin.json").string());
  if (options.task.empty())
    throw InputError(run.string() +
                     ": its search was begun in Python; call codesign() again, with the same "
                     "arguments and resume=True");
  if (begin.folder == fs::current_path().string()) return options;
  for (std::string* path : {&options.task, &options.robot})
    if (!path->empty()) *path = (fs::path(begin.folder) / *path).lexically_normal().string();
  return options;
}

void check_same_inputs(const fs::path& run, const ByName<std::string>& begun,
                       const ByName<std::string>& now) {
  std::vector<std::string> changed;
  for (const auto& [name, sum] : now)
    if (const std::string* const before = begun.find(name); !before || *before != sum)
      changed.push_back(name);
  for (const auto& [name, sum] : begun)
    if (!now.find(name)) changed.push_back(name);
  if (changed.empty()) return;
  throw InputError(fmt::format(
      "{}: {} not what the search was begun with, so nothing that it came to holds; begin anew "
      "with `legwright optimize TASK -o {} --force`",
      run.string(),
      changed.size() == 1 ? changed[0] + " is" : fmt::format("{} are", fmt::join(changed, ", ")),
      run.string()));
}

void check_same_options(const ReadCheckpoint& search, const OptimizeOptions& options,
                        const fs::path& run) {
  const ByName<std::string> now = texts_of(json_of(options));
  std::string others;
  for (const auto& [name, text] : search.begin.options) {
    const std::string* const here = now.find(name);
    if (name != "threads" && (here == nullptr || *here != text))
      others += fmt::format("{}{} = {}", others.empty() ? "" : ", ", name, text);
  }
  if (others.empty() && search.begin.options.size() == now.size()) return;
  throw InputError(fmt::format(
      "{}: its search was begun with other options{}{}; give the same, or begin anew with force",
      run.string(), others.empty() ? "" : ": ", others));
}

}  // namespace legwright
