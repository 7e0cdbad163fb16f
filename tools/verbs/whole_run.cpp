// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/whole_run.hpp"

#include <string>

#include "mjcf/read/connectors.hpp"
#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/assets.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/safe_path.hpp"
#include "mjcf/write/verify.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/checksum.hpp"
#include "tools/run/scene_sums.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

void check_sum(const RunRecord& run, const std::string& name, const std::string& bytes,
               const fs::path& file) {
  const std::string* const wanted = run.sha256.find(name);
  if (wanted != nullptr && *wanted != sha256_hex(bytes))
    throw InputError(file.string(), 0, "",
                     "is not what the run started from (its SHA-256 in run.json is another); run "
                     "`legwright optimize` again");
}

}  // namespace

void check_assets(const RunRecord& run, const RobotFiles& files) {
  for (const AssetFile& asset : files.assets())
    check_sum(run, asset.path.generic_string(), read_regular_file(asset.source, asset.bytes),
              asset.source);
}

void check_inputs(const fs::path& root, const RunRecord& run, const RobotFiles& robot) {
  const fs::path task = root / "inputs" / "task.toml";
  if (fs::is_regular_file(task)) check_sum(run, "inputs/task.toml", read_file(task), task);
  check_sum(run, "robot.xml", robot.main_text(), robot.file());
  for (const IncludedFile& part : robot.includes())
    check_sum(run, part.path.generic_string(), part.text, robot.folder() / part.path);
  check_assets(run, robot);
}

void check_design(const RobotModel& before, const RobotModel& after, const fs::path& result) {
  const Eigen::VectorXd s = after.space.initial();
  const std::string difference =
      s.size() != before.space.size()
          ? "other design parameters"
          : find_difference(with_hulls_at(before, s), s, after.morphology, s);
  if (!difference.empty())
    throw InputError(result.string(), 0, "",
                     "is not the robot of inputs/ at the design that it declares (" + difference +
                         "); run `legwright optimize` again");
}

void check_belongs_together(const fs::path& root, const RunRecord& run) {
  check_scene(root, run, "iterations/0000");
  check_scene(root, run, "result");
  const fs::path input = root / "inputs" / "robot.xml", result = root / "result" / "robot.xml";
  if (!fs::is_regular_file(input)) return;
  const RobotFiles given = RobotFiles::read(input);
  check_inputs(root, run, given);
  if (!fs::is_regular_file(result)) return;
  const RobotFiles files = RobotFiles::read(result);
  check_assets(run, files);
  RobotModel before, after;
  try {
    before = parse_robot(given);
    after = parse_robot(files, &before.structure);
  } catch (const InputError&) {
    return;  // of an older program, or weighed as it was printed: its scene alone is played
  }
  check_design(before, after, result);
}

}  // namespace legwright
