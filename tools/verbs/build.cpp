// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>

#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/assembly/overlap_words.hpp"
#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/new_files.hpp"
#include "tools/files/shell_word.hpp"
#include "tools/modules/assembly_file.hpp"
#include "tools/modules/doubtful_assembly.hpp"
#include "tools/task/starter_task.hpp"
#include "tools/verbs/init_text.hpp"
#include "tools/verbs/key_words.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct BuildOptions {
  std::string assembly, output, task, gait;
  std::vector<std::string> library;
  bool json = false, keys = false;
};

int print_assembly_keys(bool json) {
  if (json)
    fmt::print("{}", to_text({{"schema", "legwright/assembly_keys"},
                              {"version", 1},
                              {"keys", key_list_json(assembly_keys())}}));
  else
    fmt::print("Keys of an assembly file (TOML, SI units).\n{}",
               key_list_text(assembly_keys(), false));
  return kOk;
}

/// What is written goes beside the assembly and each other. Throws InputError for one path twice,
/// IoError for what is there already.
void check_places(const BuildOptions& options) {
  const auto refuse = [&](const std::string& file, const std::string& other, const char* what) {
    if (!file.empty() && same_place(file, other))
      throw InputError(fmt::format("{} is {}; name another file", file, what));
  };
  refuse(options.output, options.assembly, "the assembly, which -o would replace with its robot");
  refuse(options.task, options.assembly, "the assembly, which --task would replace");
  refuse(options.task, options.output, "where -o writes the robot, which --task would replace");
  refuse_existing(options.output);
  if (!options.task.empty()) refuse_existing(options.task);
}

/// The first task of the robot, and what it asks for in words.
std::pair<std::string, std::string> first_task_of(const BuildOptions& options,
                                                  const RobotModel& model) {
  const std::optional<std::string> gait =
      options.gait.empty() ? std::nullopt : std::optional(options.gait);
  const std::string none = gait ? "" : no_task_text(model);
  if (!none.empty())
    throw InputError(
        options.assembly, 0, "",
        "no task is written: " + none + "; without --task the robot is written by itself");
  const StarterTask task = starter_task(model, gait);
  const fs::path folder = fs::absolute(options.task).lexically_normal().parent_path();
  const fs::path robot = fs::absolute(options.output).lexically_normal();
  return {starter_text(task, robot.lexically_proximate(folder).generic_string()),
          fmt::format("{} at {:.2g} m/s, a cycle of {:.2g} s", task.gait, task.speed, task.period)};
}

/// The robot; what is wrong with it is told of the assembly, from which it comes.
BuiltRobot robot_of(const Assembly& assembly, const BuildOptions& options) {
  try {
    return build_robot(assembly, options.output);
  } catch (const InputError& error) {
    throw InputError(options.assembly, 0, "",
                     fmt::format("its robot is refused and not written; of {}", error.what()));
  }
}

Json to_json(const BuiltRobot& built, const std::vector<std::string>& warnings,
             const BuildOptions& options) {
  const Morphology& morphology = built.found.model.morphology;
  Json declared = Json::array();
  for (const DesignParameter& parameter : built.found.model.space.parameters)
    declared.push_back(parameter.name);
  return {{"schema", "legwright/build"},
          {"version", 1},
          {"robot", morphology.name},
          {"mass_kg", morphology.total_mass()},
          {"joints", morphology.joint_count()},
          {"feet", morphology.foot_count()},
          {"declared", declared},
          {"left_out", built.found.left_out},
          {"standing_pose", built.pose.empty() ? Json(nullptr) : Json(built.pose)},
          {"warnings", warnings},
          {"notes", built.notes},
          {"written", options.output},
          {"task", options.task.empty() ? Json(nullptr) : Json(options.task)}};
}

/// The robot. Where it is refused, what is doubtful about the files may be the cause, and is told.
BuiltRobot accepted_robot(const Assembly& assembly, const std::vector<std::string>& warnings,
                          const BuildOptions& options) {
  try {
    BuiltRobot built = robot_of(assembly, options);
    refuse_overlaps(assembly, built.overlaps, options.assembly);
    return built;
  } catch (const InputError&) {
    for (const std::string& warning : warnings)
      fmt::print(stderr, "warning  {}\n", terminal_text(warning));
    throw;
  }
}

int build(const BuildOptions& options) {
  if (options.keys) return print_assembly_keys(options.json);
  if (options.assembly.empty())
    throw InputError(
        "build needs an assembly: legwright build assembly.toml -o robot.xml; --keys "
        "tells what one says");
  if (options.output.empty())
    throw InputError("build needs to know where the robot goes: -o robot.xml");
  if (!options.gait.empty() && options.task.empty())
    throw InputError("--gait is for the task file that --task FILE writes; give both");
  check_places(options);
  const ModuleLibrary library = library_with(options.library);
  const std::string read = read_file(options.assembly);
  const Assembly assembly = parse_assembly(read, options.assembly, library);
  const std::vector<std::string> warnings =
      doubts_on_assembly(assembly, read, options.assembly, library);
  const BuiltRobot built = accepted_robot(assembly, warnings, options);
  const auto [task, words] = options.task.empty() ? std::pair<std::string, std::string>{}
                                                  : first_task_of(options, built.found.model);
  std::vector<NewFile> files{{options.output, built.xml}};
  if (!task.empty()) files.push_back({options.task, task});
  write_new_files(files);
  if (options.json) {
    fmt::print("{}", to_text(to_json(built, warnings, options)));
    return kOk;
  }
  std::string text;
  for (const std::string& warning : warnings) text += "warning  " + warning + "\n";
  for (const std::string& note : built.notes) text += "note     " + note + "\n";
  if (!built.pose.empty()) text += "stands   " + built.pose + "\n";
  text += robot_summary(built.found);
  text += fmt::format("written  {}: {} design parameters\n", shell_word(options.output),
                      built.found.model.space.size());
  if (!task.empty()) text += fmt::format("written  {}: {}\n", shell_word(options.task), words);
  text += task.empty()
              ? fmt::format("next: legwright init {} --task task.toml   writes a first task\n",
                            shell_word(options.output))
              : fmt::format("next: legwright optimize {} -o {}\n", shell_word(options.task),
                            shell_word("runs/" + fs::path(options.task).stem().string()));
  fmt::print("{}", terminal_text(text));
  return kOk;
}

}  // namespace

void add_build(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "build",
               "Build a robot (MJCF) of modules: trunk, servos, feet, as an assembly says", build);
  verb->add_option("ASSEMBLY", options->assembly, "assembly file (TOML)");
  verb->add_option("-o,--output", options->output, "write the robot to this new file");
  verb->add_option("--task", options->task,
                   "write a first task for the robot, by its size, to this new file");
  verb->add_option("--gait", options->gait, "of that task; default: as of legwright init");
  verb->add_option("--library", options->library,
                   "a folder of modules of your own (*.toml); may be given several times")
      ->allow_extra_args(false);
  verb->add_flag("--keys", options->keys, "tell every key of an assembly file");
  verb->add_flag("--json", options->json, "print one JSON document");
  verb->footer(
      "The robot declares what may change (lengths of links, length and width of the trunk; axes, "
      "with [print] in the\nassembly those that its turn lets) and has a home pose in which it "
      "stands: `legwright optimize` takes it as it is.");
}

}  // namespace legwright
