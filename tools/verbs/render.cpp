// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/render/gl_context.hpp"
#include "tools/render/run_pictures.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/scene_sums.hpp"
#include "tools/run/task_folders.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/verbs/number_options.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

struct RenderOptions : ReadingOptions {
  std::string run;
  std::vector<double> phases;
  bool all = false, still = false, small = false, json = false;
};

/// The run itself; of a joint run each of its tasks, where the designs are.
std::vector<std::filesystem::path> runs_to_draw(const std::filesystem::path& root) {
  std::vector<std::filesystem::path> runs;
  for (const TaskFolder& task : task_folders_of(root)) runs.push_back(root / task.relative);
  if (runs.empty()) runs.push_back(root);
  return runs;
}

int render(const RenderOptions& options) {
  pin_rasteriser();
  load_gait_plugin();
  const MujocoMessages messages;  // an error of the engine becomes an exception
  RunPictureOptions how;
  how.all = options.all;
  how.phases = options.phases;
  how.only_phases = options.still;
  how.only_small = options.small;
  if (options.still && how.phases.empty()) how.phases = {0.0};
  if (!options.json) {
    how.on_picture = [](const MadePicture& made) {
      fmt::print(stderr, "{}  {:.0f} ms\n", made.file.string(), made.milliseconds);
    };
  }
  const ResultFolder locked = ResultFolder::open_to_write(options.run);
  options.check_run(options.run);
  RunPictures pictures;
  const std::vector<std::filesystem::path> runs = runs_to_draw(options.run);
  for (const std::filesystem::path& run : runs) check_scenes(run);
  try {
    for (const std::filesystem::path& run : runs) {
      RunPictures drawn = draw_run(run, how);
      pictures.made.insert(pictures.made.end(), drawn.made.begin(), drawn.made.end());
      pictures.left_out.insert(pictures.left_out.end(), drawn.left_out.begin(),
                               drawn.left_out.end());
    }
  } catch (const GlError& error) {
    throw IoError(error.what());  // exit 3: pictures cannot be made on this machine
  }
  double total = 0.0;
  Json files = Json::array();
  for (const MadePicture& made : pictures.made) {
    total += made.milliseconds;
    files.push_back({{"file", made.file.string()}, {"milliseconds", made.milliseconds}});
  }
  for (const std::string& missing : pictures.left_out)
    fmt::print(stderr, "left out: {}\n", missing);
  if (options.json) {
    Json document{{"schema", "legwright/render"}, {"version", 1}, {"run", options.run}};
    document["files"] = files;
    document["left_out"] = pictures.left_out;
    fmt::print("{}", to_text(document));
  } else {
    fmt::print("{} pictures in {:.1f} s\n", pictures.made.size(), total / 1000.0);
  }
  return kOk;
}

}  // namespace

void add_render(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "render", "Draw the pictures of a run, off-screen", render);
  verb->add_option("run", options->run, "Folder that legwright optimize wrote")->required();
  verb->add_option("--phase", options->phases,
                   "Also a still of the gait at this phase; may be given several times")
      ->allow_extra_args(false)
      ->check(number_between(0.0, 1.0));
  verb->add_flag("--still", options->still,
                 "Nothing but the stills of --phase (without it: of phase 0)");
  verb->add_flag("--small", options->small, "Nothing but result/small.webp, for overviews");
  verb->add_flag("--all", options->all, "Draw frame.png of iterations again that exist already");
  verb->add_flag("--json", options->json, "One JSON document on stdout: files and milliseconds");
  verb->footer(
      "Into each folder of iterations/: frame.png. Into result/:\n"
      "  strip_before_after.png         planned gait by phase, before over after\n"
      "  strip_initial.png, strip_result.png   the same, one at a time\n"
      "  strip_physics.png              what the simulation did (after legwright validate)\n"
      "  overlay.png                    the plan's ghost over the simulated robot (after "
      "validate)\n"
      "  contact_timeline.png           planned and simulated stance of each foot (after "
      "validate)\n"
      "  gait.webp                      the gait in real time, as a loop\n"
      "  still_P.png, still_before_after_P.png   at each --phase P\n"
      "Of a joint run: into the folders of its tasks. Of a motion-only run there is nothing "
      "before.\n"
      "Needs no display: OSMesa draws, or EGL where that is missing; LEGWRIGHT_GL=osmesa or egl "
      "takes\n"
      "one of them. The same bytes on every run on one machine. Exit code 3 without either.");
}

}  // namespace legwright
