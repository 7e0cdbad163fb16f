// SPDX-License-Identifier: Apache-2.0
// The part of a page in which one turns the robot and scrubs its gait.
#include "tools/report/page_viewer.hpp"

#include <fmt/format.h>

#include <array>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "tools/drawables/viewed_scene.hpp"
#include "tools/files/base64.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/escape.hpp"
#include "tools/report/words.hpp"
#include "tools/studio/page/page_bundle.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Starts the viewer where a browser can draw it; else its place stays hidden.
constexpr std::string_view kStart = R"(
if (document.createElement("canvas").getContext("webgl2")) {
  const figure = document.querySelector(".turned");
  figure.hidden = false;
  const text = document.getElementById("legwright-scenes").textContent;
  legwrightViewer(figure.querySelector(".stage3d"), {designs: JSON.parse(text)});
}
)";

void add_scene(const fs::path& file, const std::string& name, std::vector<NamedScene>& scenes,
               std::vector<std::string>& notes) {
  if (!fs::exists(file)) return;
  try {
    scenes.push_back({name, load_scene(file, 1.0, MeshDetail::triangles)});
  } catch (const std::exception& error) {
    notes.push_back(fmt::format("the 3-D view leaves out {}: {}", name, error.what()));
  }
}

void add_scenes(const RunData& data, const std::string& prefix, PageViewer& viewer,
                std::vector<NamedScene>& scenes) {
  const bool both = !motion_only(data);
  if (both) add_scene(data.iteration(0) / "scene.xml", prefix + "before", scenes, viewer.notes);
  add_scene(data.root / "result" / "scene.xml", prefix + (both ? "after" : "result"), scenes,
            viewer.notes);
}

void finish(PageViewer& viewer, const std::vector<NamedScene>& scenes) {
  if (!scenes.empty()) viewer.scenes = viewed_scenes_json(scenes).dump();
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

/// "'sha256-…'" of a script's text.
std::string source_of(const std::string& text) {
  return fmt::format("'sha256-{}'", base64_of(sha256_bytes(text)));
}

}  // namespace

PageViewer viewer_of(const RunData& data) {
  PageViewer out;
  std::vector<NamedScene> scenes;
  add_scenes(data, "", out, scenes);
  finish(out, scenes);
  return out;
}

PageViewer viewer_of(const JointData& data) {
  PageViewer out;
  std::vector<NamedScene> scenes;
  for (const JointTaskData& task : data.tasks)
    if (task.run) add_scenes(*task.run, spaced(task.name) + ", ", out, scenes);
  finish(out, scenes);
  return out;
}

void add_viewer(Html& page, const PageViewer& viewer) {
  for (const std::string& note : viewer.notes) page.note(note, "hint");
  if (viewer.scenes.empty()) return;
  page.open("figure", {{"class", "turned"}, {"hidden", "hidden"}});
  page.open("figcaption").element("b", "As planned, to be turned.");
  page.text(" Drag turns it, the wheel comes nearer, the bar below scrubs through the cycle.")
      .close();
  page.open("div", {{"class", "stage3d"}}).close().close();
}

std::string harmless_script(std::string text) {
  replace_all(text, "]]>", "]] >");
  replace_all(text, "</script", "<\\/script");
  replace_all(text, "<!--", "<\\!--");
  return text;
}

ViewerScripts viewer_scripts(const std::string& scenes) {
  const auto script = page_file("viewer.js"), licences = page_file("LICENSES.txt");
  if (!script || !licences) throw std::logic_error("the viewer's bundle is not in this program");
  ViewerScripts out;
  out.markup = fmt::format("<script type=\"application/json\" id=\"legwright-scenes\">{}</script>",
                           escape_json_island(scenes));
  const std::array<std::string, 2> texts{
      fmt::format("/*\n{}*/\n{}", licences->bytes, script->bytes), std::string(kStart)};
  for (const std::string& each : texts) {
    const std::string text = fmt::format("//<![CDATA[\n{}\n//]]>", harmless_script(each));
    out.markup += fmt::format("<script>{}</script>", text);
    out.policy += (out.policy.empty() ? "" : " ") + source_of(text);
  }
  return out;
}

}  // namespace legwright
