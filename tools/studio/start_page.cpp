// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/start_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// First sentence of the comment that a file begins with.
std::string first_words(const std::string& text) {
  std::string words;
  std::size_t at = 0;
  while (at < text.size() && text[at] == '#') {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at + 1, end - at - 1);
    at = end + 1;
    if (line.find("SPDX") == std::string::npos) words += line;
    if (const std::size_t stop = words.find(". "); stop != std::string::npos) {
      words.resize(stop + 1);
      break;
    }
  }
  words.erase(0, words.find_first_not_of(' '));
  return words;
}

bool is_example(const fs::path& file) {
  if (file.extension() != ".toml") return false;
  const std::string text = read_file(file);
  return text.find("robot = ") != std::string::npos && text.find("[study]") == std::string::npos;
}

/// Task files of one robot, in the folder beside it: ROBOT/TASK.toml.
std::vector<fs::path> tasks_below(const fs::path& examples) {
  std::vector<fs::path> found;
  std::error_code none;
  for (const auto& folder : fs::directory_iterator(examples, none)) {
    if (!fs::is_regular_file(folder.path() / "robot.xml", none)) continue;
    for (const auto& file : fs::directory_iterator(folder.path(), none))
      if (is_example(file.path())) found.push_back(file.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Robots that are made of modules.
std::vector<fs::path> assemblies_below(const fs::path& examples) {
  std::vector<fs::path> found;
  std::error_code none;
  for (const auto& file : fs::directory_iterator(examples / "assemblies", none))
    if (file.path().extension() == ".toml") found.push_back(file.path());
  std::sort(found.begin(), found.end());
  return found;
}

std::string name_of_example(const fs::path& file) {
  return (file.parent_path().filename() / file.stem()).generic_string();
}

}  // namespace

Json start_json(const fs::path& examples, const KeptSessions& kept,
                const std::vector<fs::path>& roots) {
  Json told = Json::array(), unsaved = Json::array(), folders = Json::array();
  if (!examples.empty())
    for (const fs::path& file : tasks_below(examples))
      told.push_back({{"name", name_of_example(file)},
                      {"path", file.string()},
                      {"words", first_words(read_file(file))}});
  Json assemblies = Json::array();
  if (!examples.empty())
    for (const fs::path& file : assemblies_below(examples))
      assemblies.push_back({{"name", file.stem().string()},
                            {"path", file.string()},
                            {"words", first_words(read_file(file))}});
  for (const KeptSession& session : kept.left_behind())
    unsaved.push_back({{"path", session.folder.string()},
                       {"name", session.name},
                       {"origin", session.origin},
                       {"begun", session.begun}});
  for (const fs::path& root : roots) folders.push_back(root.string());
  return {{"examples", told},
          {"assemblies", assemblies},
          {"recent", kept.recent()},
          {"unsaved", unsaved},
          {"roots", folders}};
}

fs::path example_file(const fs::path& examples, const std::string& name) {
  if (!examples.empty())
    for (const fs::path& file : tasks_below(examples))
      if (name_of_example(file) == name) return file;
  throw InputError("'" + name + "' is no example; /api/start lists them");
}

Json example_picture(const fs::path& file, MeshStore& meshes) {
  const RobotModel robot = read_robot(read_task_set(file).robot);
  const ModelPointer model = drawn_model(robot, robot.space.initial());
  const mjtNum* home = nullptr;
  for (int key = 0; key < model->nkey && !home; ++key)
    if (key == 0 || name_of(*model, mjOBJ_KEY, key) == "home")
      home = model->key_qpos + static_cast<std::ptrdiff_t>(key) * model->nq;
  const DataPointer data = kinematics_at(*model, home, robot.file);
  return posed_drawables_json(*model, *data, meshes);
}

}  // namespace legwright
