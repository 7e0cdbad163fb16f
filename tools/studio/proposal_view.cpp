// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/proposal_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "mjcf/text/input_error.hpp"
#include "mjcf/urdf/read_urdf.hpp"
#include "optimizer/motion/faced_frame.hpp"
#include "tools/files/base64.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Robots before what they include, which is no model by itself; a task before its robot.
int rank_of(const fs::path& file) {
  if (file.extension() == ".toml") return 0;
  if (file.extension() != ".xml" && file.extension() != ".urdf") return 3;
  const std::string text = read_file(file);
  if (is_urdf(text)) return 1;
  return text.find("<mujoco") != std::string::npos && text.find("<worldbody") != std::string::npos
             ? 1
             : 2;
}

}  // namespace

Json proposal_json(const StudiedRobot& robot) {
  const ProposedParameters& found = robot.found;
  const Morphology& morphology = found.model.morphology;
  Json limbs = Json::array(), parameters = Json::array(), left_out = Json::array();
  for (const Limb& limb : found.limbs) {
    Json joints = Json::array();
    for (const int k : limb.links)
      joints.push_back(morphology.links[static_cast<std::size_t>(k)].joint.name);
    const std::string& foot = morphology.feet[static_cast<std::size_t>(limb.foot)].name;
    limbs.push_back({{"name", foot}, {"foot", foot}, {"joints", joints}, {"row", limb.row}});
  }
  for (const Proposal& one : found.proposals)
    parameters.push_back({{"name", one.name},
                          {"sentence", one.sentence},
                          {"unit", one.unit},
                          {"value", one.value},
                          {"lower", one.lower},
                          {"upper", one.upper},
                          {"reason", one.binding},
                          {"ticked", true}});
  for (const std::string& one : found.left_out) left_out.push_back(one);
  return {{"name", morphology.name},
          {"words", fmt::format("{}: {:.3g} kg on {} feet{}", morphology.name,
                                morphology.total_mass(), morphology.foot_count(),
                                found.not_standing.empty() ? "" : "; " + found.not_standing)},
          {"ahead", facing_text(found.facing.ahead)},
          {"told", told_of(robot)},
          {"trunk", found.model.root_body},
          {"limbs", limbs},
          {"parameters", parameters},
          {"left_out", left_out}};
}

RobotModel with_proposals(const StudiedRobot& robot, const std::vector<std::string>& names) {
  const ProposedParameters& found = robot.found;
  const std::string file = robot.files.file().string();
  if (!found.not_standing.empty())
    throw InputError(file, 0, "", "it would fall at once: " + found.not_standing);
  std::vector<Proposal> chosen;
  for (const std::string& name : names) {
    const auto one = std::find_if(found.proposals.begin(), found.proposals.end(),
                                  [&](const Proposal& p) { return p.name == name; });
    if (one == found.proposals.end())
      throw InputError(file, 0, name, "is not proposed; GET /api/proposal lists what is");
    chosen.push_back(*one);
  }
  if (chosen.empty()) throw InputError(file, 0, "", "nothing is ticked; tick what may change");
  return parse_robot(with_declared(robot, chosen));
}

fs::path write_sent_files(const fs::path& folder, const Json& files) {
  if (!files.is_array() || files.empty()) throw InputError("'files' is no list of files");
  std::vector<std::pair<int, fs::path>> ranked;
  for (const Json& file : files) {
    if (!file.is_object() || !file.contains("name") || !file["name"].is_string() ||
        !file.contains("base64") || !file["base64"].is_string())
      throw InputError("'files' holds something else than {name, base64}");
    const fs::path name = fs::path(file["name"].get<std::string>()).lexically_normal();
    const bool leads_out = name.empty() || name.is_absolute() || *name.begin() == ".." ||
                           !name.has_filename() || name.string().find('\0') != std::string::npos;
    if (leads_out) throw InputError(name.string() + ": is no name of a file in a folder");
    const auto bytes = from_base64(file["base64"].get<std::string>());
    if (!bytes) throw InputError(name.string() + ": its base64 is damaged");
    fs::create_directories((folder / name).parent_path());
    write_file(folder / name, *bytes, Durability::process);
    ranked.emplace_back(rank_of(folder / name), folder / name);
  }
  const auto best = std::min_element(ranked.begin(), ranked.end());
  if (best->first > 2)
    throw InputError(
        "none of these files is a robot (MJCF, .xml, or URDF) or a task (.toml); drop the "
        "robot's file, with its meshes beside it");
  return best->second;
}

}  // namespace legwright
