// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "tools/io/io_error.hpp"
#include "tools/io/json_file.hpp"
#include "tools/io/task_folders.hpp"
#include "tools/render/gl_context.hpp"
#include "tools/render/run_pictures.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

struct Options {
  std::string run;
  bool all = false, json = false;
};

/// The run itself; of a joint run each of its tasks, where the designs are.
std::vector<std::filesystem::path> runs_to_draw(const std::filesystem::path& root) {
  std::vector<std::filesystem::path> runs;
  for (const TaskFolder& task : task_folders_of(root)) runs.push_back(root / task.relative);
  if (runs.empty()) runs.push_back(root);
  return runs;
}

int render(const Options& options) {
  pin_rasteriser();
  load_gait_plugin();
  const MujocoMessages messages;  // an error of the engine becomes an exception
  RunPictureOptions how;
  how.all = options.all;
  if (!options.json) {
    how.on_picture = [](const MadePicture& made) {
      fmt::print(stderr, "{}  {:.0f} ms\n", made.file.string(), made.milliseconds);
    };
  }
  RunPictures pictures;
  try {
    for (const std::filesystem::path& run : runs_to_draw(options.run)) {
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
  auto options = std::make_shared<Options>();
  CLI::App* verb = program.add_subcommand("render", "Draw the pictures of a run, off-screen");
  verb->add_option("run", options->run, "Folder that legwright optimize wrote")->required();
  verb->add_flag("--all", options->all, "Draw stills of iterations again that exist already");
  verb->add_flag("--json", options->json, "One JSON document on stdout: files and milliseconds");
  verb->footer(
      "Writes frame.png into each folder of iterations/, and strip_initial.png, strip_result.png,\n"
      "strip_before_after.png (planned) and strip_physics.png (after legwright validate) into "
      "result/. Of a joint run: into the folders of its tasks.\n"
      "Needs no display: OSMesa draws. The same bytes on every run on one machine.");
  verb->callback([options, &action] { action = [options] { return render(*options); }; });
}

}  // namespace legwright
