// SPDX-License-Identifier: Apache-2.0
// legwright._core: what the package needs of the project, as few functions as do. Everything that
// is for people stands in python/legwright.
#include <mujoco/mujoco.h>
#include <nanobind/eigen/dense.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <map>
#include <memory>
#include <tuple>

#include "mjcf/read/read_robot.hpp"
#include "optimizer/motion/faced_frame.hpp"
#include "optimizer/motion/gait.hpp"
#include "python/core/assembly_binding.hpp"
#include "python/core/calls.hpp"
#include "python/core/followed_run.hpp"
#include "python/core/iteration.hpp"
#include "python/core/python_errors.hpp"
#include "python/core/second_engine.hpp"
#include "python/core/session_binding.hpp"
#include "tools/adopt/studied_robot.hpp"
#include "tools/report/page.hpp"
#include "tools/run/install.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/robot_folder.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/task/design_table.hpp"
#include "tools/task/starter_task.hpp"
#include "tools/task/task_file.hpp"
#include "tools/task/toml_text.hpp"
#include "tools/verbs/checked_task.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace legwright {
namespace {

namespace fs = std::filesystem;
using BoundsByName = std::map<std::string, std::pair<double, double>>;

void bind_robot(nb::module_& module) {
  nb::class_<DesignParameter>(module, "DeclaredParameter",
                              "One entry of s as the robot's file declares it.")
      .def_ro("name", &DesignParameter::name)
      .def_ro("unit", &DesignParameter::unit)
      .def_ro("sentence", &DesignParameter::sentence)
      .def_prop_ro("kind", [](const DesignParameter& p) { return std::string(to_string(p.kind)); })
      .def_ro("value", &DesignParameter::initial)
      .def_ro("lower", &DesignParameter::lower)
      .def_ro("upper", &DesignParameter::upper)
      .def_ro("ties", &DesignParameter::tied_count);

  nb::class_<RobotModel>(module, "RobotModel", "A robot that has been read.")
      .def_prop_ro("name", [](const RobotModel& robot) { return robot.morphology.name; })
      .def_prop_ro("feet", [](const RobotModel& robot) { return foot_names(robot.morphology); })
      .def_prop_ro("parameters", [](const RobotModel& robot) { return robot.space.parameters; })
      .def(
          "check_bounds",
          [](const RobotModel& robot, const BoundsByName& bounds) {
            DesignTable table;
            for (const auto& [name, pair] : bounds) table.bounds[name] = {pair.first, pair.second};
            (void)restricted(robot.space, table, robot.file.string(), {});
          },
          "bounds"_a, "Raises InputError for bounds that the robot does not allow.")
      .def(
          "starter_text",
          [](const RobotModel& robot, const std::optional<std::string>& gait) {
            return starter_text(starter_task(robot, gait), "robot.xml");
          },
          "gait"_a.none(), nb::call_guard<Released>(),
          "The task file that `legwright init` writes for this robot.");
}

/// Names of the joints of each leg by its foot, front to hind.
std::vector<std::pair<std::string, std::vector<std::string>>> legs_of(const StudiedRobot& robot) {
  const Morphology& morphology = robot.found.model.morphology;
  std::vector<std::pair<std::string, std::vector<std::string>>> legs;
  for (const Limb& limb : robot.found.limbs) {
    std::vector<std::string> joints;
    for (const int k : limb.links)
      joints.push_back(morphology.links[static_cast<std::size_t>(k)].joint.name);
    legs.emplace_back(morphology.feet[static_cast<std::size_t>(limb.foot)].name, joints);
  }
  return legs;
}

void bind_proposals(nb::module_& module) {
  nb::class_<Proposal>(module, "DeclarableParameter",
                       "A design parameter that a robot's file could declare.")
      .def_ro("name", &Proposal::name)
      .def_ro("value", &Proposal::value)
      .def_ro("lower", &Proposal::lower)
      .def_ro("upper", &Proposal::upper)
      .def_ro("unit", &Proposal::unit)
      .def_ro("binding", &Proposal::binding)
      .def_ro("sentence", &Proposal::sentence);

  nb::class_<StudiedRobot>(module, "StudiedRobot", "A robot as `legwright init` studies it.")
      .def_prop_ro("legs", legs_of)
      .def_prop_ro("proposals", [](const StudiedRobot& robot) { return robot.found.proposals; })
      .def_prop_ro("left_out", [](const StudiedRobot& robot) { return robot.found.left_out; })
      .def_prop_ro("not_standing",
                   [](const StudiedRobot& robot) { return robot.found.not_standing; })
      .def_prop_ro("mended", changes_besides)
      .def_prop_ro("declared",
                   [](const StudiedRobot& robot) {
                     std::vector<std::string> names;
                     for (const DesignParameter& parameter : robot.found.model.space.parameters)
                       names.push_back(parameter.name);
                     return names;
                   })
      .def(
          "write",
          [](const StudiedRobot& robot, const std::string& output) {
            (void)write_proposals(robot, output);
            return output.empty() ? robot.files.file() : fs::path(output);
          },
          "output"_a, nb::call_guard<Released>(),
          "Declares the proposals in the robot's file, or in a new one. Raises InputError, "
          "IoError.");

  module.def(
      "study_robot",
      [](const fs::path& file, const std::string& forward) {
        return study_robot(file, {}, facing_axis(forward));
      },
      "file"_a, "forward"_a, nb::call_guard<Released>(),
      "What a designer may change in a robot that faces along +x, -x, +y or -y; where that is "
      "empty, as it seems to. Raises InputError.");
}

void bind_run(nb::module_& module) {
  nb::class_<PythonIteration>(
      module, "Iteration", "An accepted iterate of the search: what on_iteration is called with.")
      .def_ro("index", &PythonIteration::index, "From 0, the given body with its best motion.")
      .def_ro("start", &PythonIteration::start,
              "Where its search set out from: \"initial\", the name of a task, \"perturbed-1\".")
      .def_ro("tasks", &PythonIteration::tasks, "Names of the tasks of its search.")
      .def_ro("F", &PythonIteration::value,
              "The cost, of several tasks the weighted sum, with the outer objective.")
      .def_ro("s", &PythonIteration::s, "The body, in the order of robot.parameters [m, rad].")
      .def_ro("terms", &PythonIteration::terms, "What F consists of, by term.")
      .def_ro("projected_gradient_norm", &PythonIteration::projected_gradient_norm,
              "How far the body is from a minimum.")
      .def_ro("seconds", &PythonIteration::seconds, "Wall time that it took.")
      .def("__repr__", [](const PythonIteration& each) {
        return nb::str("<Iteration {} from {}: F = {:g}>")
            .format(each.index, each.start, each.value);
      });

  nb::class_<OptimizeOptions>(module, "Options", "The options of `legwright optimize`.")
      .def(nb::init<>())
      .def_rw("max_iterations", &OptimizeOptions::max_iterations)
      .def_rw("motion_only", &OptimizeOptions::motion_only)
      .def_rw("plan_only", &OptimizeOptions::plan_only)
      .def_rw("one_start", &OptimizeOptions::one_start)
      .def_rw("starts", &OptimizeOptions::starts)
      .def_rw("seed", &OptimizeOptions::seed)
      .def_rw("threads", &OptimizeOptions::threads)
      .def_rw("few", &OptimizeOptions::few)
      .def_rw("few_keeps", &OptimizeOptions::few_keeps)
      .def_rw("front", &OptimizeOptions::front)
      .def_rw("physics_steps", &OptimizeOptions::physics_steps)
      .def_rw("no_reasons", &OptimizeOptions::no_reasons)
      .def_rw("no_certificate", &OptimizeOptions::no_certificate)
      .def_rw("no_pictures", &OptimizeOptions::no_pictures)
      .def_rw("force", &OptimizeOptions::force)
      .def_prop_rw(
          "stop_at", [](const OptimizeOptions& options) { return options.stop_at; },
          [](OptimizeOptions& options, std::optional<double> F) { options.stop_at = F; },
          nb::for_setter(nb::arg("F").none()));

  module.def(
      "codesign",
      [](const RobotModel& robot, std::string text, fs::path file, fs::path folder,
         OptimizeOptions options, nb::object on_iteration, nb::object objective, bool resume,
         nb::object warn) {
        options.quiet = true;
        if (resume) {
          options.resume = folder.string();
          options.force = true;
        }
        run_followed(robot,
                     {std::move(text), std::move(file), std::move(folder), std::move(options),
                      std::move(on_iteration), std::move(objective), std::move(warn)});
      },
      "robot"_a, "text"_a, "file"_a, "folder"_a, "options"_a, "on_iteration"_a.none(),
      "objective"_a.none(), "resume"_a, "warn"_a,
      "Runs `legwright optimize` into a new folder. Calls `warn` with what looks doubtful.");
}

void bind_check(nb::module_& module) {
  module.def(
      "check",
      [](const RobotModel& robot, const std::string& text, const fs::path& file) {
        const std::vector<CheckedTask> all = checked_tasks(problem_of(robot, text, file));
        std::vector<std::string> names;
        for (const CheckedTask& each : all) names.push_back(each.task.name);
        return std::tuple(names, to_text(to_json(all)), to_text(all));
      },
      "robot"_a, "text"_a, "file"_a, nb::call_guard<Released>(),
      "What `legwright check` finds: names of the tasks, its JSON document, and its words. Raises "
      "InputError.");
}

void bind_files(nb::module_& module) {
  module.def(
      "read_robot", [](const fs::path& file) { return read_robot(file); }, "file"_a,
      nb::call_guard<Released>(), "Reads an MJCF. Raises InputError, IoError.");
  module.def(
      "check_task",
      [](const std::string& text, const fs::path& file) { (void)parse_task_tables(text, file); },
      "text"_a, "file"_a,
      "Reads the text of a task file strictly. Raises InputError with all that is wrong.");
  module.def(
      "open_run", [](const fs::path& folder) { (void)ResultFolder::open(folder); }, "folder"_a,
      "Raises IoError where there is no run.");
  nb::class_<ResultFolder>(module, "RunFolder",
                           "The folder of a run: while it lives, no other process writes there.")
      .def_prop_ro("path", &ResultFolder::root, "Where its files are to be written.")
      .def("stand", &ResultFolder::stand, "Takes the place of the run that was there.");
  module.def(
      "create_run", &ResultFolder::create, "folder"_a, "force"_a,
      "Makes the folder of a run, a RunFolder. Raises IoError where one is there, or somebody "
      "writes there.");
}

void bind_study(nb::module_& module) {
  module.def(
      "gait_library",
      [](int feet) {
        std::vector<std::pair<std::string, std::string>> out;
        for (const GaitPattern& gait : gait_library(feet)) out.emplace_back(gait.name, gait.about);
        return out;
      },
      "feet"_a, "Names of the gaits for so many feet, and what each is.");
  module.def("key_lines", &key_lines, "text"_a, "file"_a,
             "Where the keys of a TOML text stand: their names from the root on, entries of arrays "
             "by number, and the line. Raises InputError where it is no TOML.");
  module.def(
      "copy_robot",
      [](const RobotModel& robot, const fs::path& folder) {
        write_robot_files(folder, robot.files);
      },
      "robot"_a, "folder"_a,
      "Writes a robot's files as they are into a folder that is there: the main one as robot.xml.");
  module.def(
      "report_style", [] { return std::string(report_style()); },
      "The style sheet of the report's pages.");
}

}  // namespace
}  // namespace legwright

NB_MODULE(_core, module) {
  using namespace legwright;
  if (mj_version() != mjVERSION_HEADER)
    throw nb::import_error(
        "legwright was built for another version of MuJoCo than the one that "
        "this process has loaded; start anew, or rebuild legwright for it");
  nb::set_leak_warnings(false);  // threads that outlive the interpreter hold on to what they use
  leave_others_their_messages();
  translate_errors();
  bind_calls(module);
  bind_robot(module);
  bind_proposals(module);
  bind_assembly(module);
  bind_run(module);
  bind_check(module);
  bind_engine(module);
  bind_files(module);
  bind_session(module);
  bind_study(module);
  module.attr("__version__") = program_version();
  module.attr("mujoco_version") = mj_versionString();
}
