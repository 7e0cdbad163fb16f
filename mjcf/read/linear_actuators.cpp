// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/linear_actuators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mjcf/read/checks.hpp"
#include "mjcf/read/couplings.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/elements.hpp"
#include "optimizer/design/actuator_length.hpp"

namespace legwright {
namespace {

TendonSpan read_tendon(const XmlFile& xml, const mjModel& model, const Structure& structure, int t,
                       const XmlElement& element) {
  const int first = model.tendon_adr[t];
  if (name_of(model, mjOBJ_TENDON, t).empty())
    throw xml.error(element, "has no name; give the linear actuator's tendon one");
  int upper = model.wrap_objid[first], lower = model.wrap_objid[first + 1];
  const auto moving_body_of = [&](int site) {
    return moving_body(model, structure, model.site_bodyid[site]);
  };
  const auto hangs_on = [&](int low, int up) {
    return low != structure.trunk && low > 0 && moving_joints(model, structure, low).size() == 1 &&
           moving_body(model, structure, model.body_parentid[low]) == up;
  };
  if (hangs_on(moving_body_of(upper), moving_body_of(lower))) std::swap(upper, lower);
  if (!hangs_on(moving_body_of(lower), moving_body_of(upper)))
    throw xml.error(
        element, fmt::format("must span exactly one hinge, but runs from site '{}' to site "
                             "'{}'; put them on two links with one hinge between them",
                             name_of(model, mjOBJ_SITE, upper), name_of(model, mjOBJ_SITE, lower)));
  return {t, upper, lower, moving_joints(model, structure, moving_body_of(lower)).front()};
}

}  // namespace

std::vector<TendonSpan> read_tendons(const XmlFile& xml, const mjModel& model,
                                     FoundStructure& found, Refusals& reasons) {
  const SectionElements elements(xml, "tendon");
  std::vector<TendonSpan> spans;
  std::vector<int> refused;
  for (int t = 0; t < static_cast<int>(model.ntendon); ++t)
    if (found.structure.reads_tendon[static_cast<std::size_t>(t)] && !reasons.collect([&] {
          spans.push_back(read_tendon(xml, model, found.structure, t, elements[t]));
        }))
      refused.push_back(t);
  found.is_whole = found.is_whole && refused.empty();
  for (const int t : refused) {
    found.structure.reads_tendon[static_cast<std::size_t>(t)] = false;
    for (const int joint : joints_under(model, t)) {
      found.structure.moves[static_cast<std::size_t>(joint)] = false;
      found.structure.frozen.push_back({joint, name_of(model, mjOBJ_JOINT, joint), "", "refused"});
    }
  }
  // One over a joint that another has turned into a held one: its actuator counts as held, too.
  std::erase_if(spans, [&](const TendonSpan& span) {
    const bool moves = found.structure.moves[static_cast<std::size_t>(span.joint)];
    if (!moves) found.structure.reads_tendon[static_cast<std::size_t>(span.tendon)] = false;
    return !moves;
  });
  return spans;
}

void check_arms(const XmlFile& xml, const std::vector<TendonSpan>& tendons,
                const Morphology& morphology, const DesignSpace& space, Refusals& reasons) {
  for (std::size_t k = 0; k < morphology.linear_actuators.size(); ++k) {
    const LinearActuator& actuator = morphology.linear_actuators[k];
    const Eigen::Vector3d shape = actuator_shape(morphology, actuator, space.initial()).value;
    const double home = morphology.links[actuator.joint + 1].joint.nominal;
    // Written so that NaN, of a length of zero, is a fault.
    if (!(std::abs(moment_arm(shape, home)) > 1e-9))
      reasons.add(xml.error(
          SectionElements(xml, "tendon")[tendons[k].tendon],
          "has no moment arm about its hinge in the home pose; move its sites off the line through "
          "the hinge, or change the keyframe 'home'"));
  }
}

bool is_tendon_end(const mjModel& model, int site) {
  for (int w = 0; w < static_cast<int>(model.nwrap); ++w)
    if (model.wrap_type[w] == mjWRAP_SITE && model.wrap_objid[w] == site) return true;
  return false;
}

PlaceMap collect_places(const DesignSpace& space, const std::vector<Binding>& bindings,
                        const std::filesystem::path& file, Refusals& reasons) {
  PlaceMap places;
  const auto add = [&](int k, const Binding::Target& target) {
    int axis = 0;
    while (target.direction[axis] == 0.0) ++axis;
    std::vector<Place>& own = places[target.name];
    for (const Place& other : own)
      if (other.axis == axis)
        throw InputError(
            file.string(), target.line,
            fmt::format("text 'legwright/{}'", space.parameters[k].name),
            fmt::format("site '{}' is already placed along {} by 'legwright/{}'; use another "
                        "direction",
                        target.name, "xyz"[axis], space.parameters[other.parameter].name));
    own.push_back({k, axis, target.factor});
  };
  for (int k = 0; k < space.size(); ++k)
    if (space.parameters[k].kind == ParameterKind::position)
      for (const Binding::Target& target : bindings[k].targets)
        reasons.collect([&] { add(k, target); });
  return places;
}

void check_places(const XmlFile& xml, const mjModel& model, const PlaceMap& places,
                  const StretchMap& stretches, Refusals& reasons) {
  for (const auto& [name, own] : places) {
    const int site = mj_name2id(&model, mjOBJ_SITE, name.c_str());
    const std::string body = name_of(model, mjOBJ_BODY, model.site_bodyid[site]);
    const auto found = stretches.find(body);
    if (found == stretches.end()) continue;
    for (const Place& place : own)
      for (const Stretch& stretch : found->second) {
        const double share = std::abs(stretch.direction[place.axis]);
        if (share > 1e-9 && share < 1.0 - 1e-9)
          reasons.add(
              xml.error(*find_named(xml.root(), "site", name),
                        fmt::format("is placed along {}, but body '{}' is stretched obliquely to "
                                    "it; put the site on a fixed body of its own, or build the "
                                    "body along its frame's axes",
                                    "xyz"[place.axis], body)));
      }
  }
}

}  // namespace legwright
