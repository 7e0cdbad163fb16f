// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/skins.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "mjcf/read/world_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/listed.hpp"

namespace legwright {
namespace {

constexpr int kHighestGroupInSight = 2;  // unless a viewer is told otherwise
constexpr const char* kGroupOutOfSight = "5";

/// Whether something of the robot is drawn besides its skin.
bool shows_geoms(const mjModel& model) {
  const int trunk = trunk_of(model);
  for (int g = 0; g < model.ngeom; ++g)
    if (model.body_rootid[model.geom_bodyid[g]] == trunk &&
        model.geom_group[g] <= kHighestGroupInSight)
      return true;
  return false;
}

}  // namespace

void hide_skins(const XmlFile& xml, const mjModel& model, const StretchMap& stretches,
                const Eigen::VectorXd& s, TextEdits& edits) {
  const bool any_moves = std::any_of(stretches.begin(), stretches.end(), [&](const auto& body) {
    return std::any_of(body.second.begin(), body.second.end(), [&](const Stretch& stretch) {
      return s[stretch.parameter] != stretch.initial;
    });
  });
  if (!any_moves || !shows_geoms(model)) return;
  for_each_element(xml.root(), [&](const XmlElement& element) {
    if (is_tag(element, "skin")) edits.set(element, "group", kGroupOutOfSight);
  });
}

std::string describe_skins(const mjModel& model) {
  if (model.nskin == 0) return "";
  std::vector<std::string> names;
  for (int k = 0; k < model.nskin; ++k)
    names.push_back(fmt::format("'{}'", name_of(model, mjOBJ_SKIN, k)));
  constexpr std::size_t kNamed = 3;
  const char* const fate =
      shows_geoms(model)
          ? "designs with other lengths have it in group 5, out of sight"
          : "nothing else of the robot is drawn, so it stays, also where it no longer fits";
  return fmt::format("skin {}: only to be seen, and does not grow with the links; {}",
                     listed(names, kNamed), fate);
}

}  // namespace legwright
