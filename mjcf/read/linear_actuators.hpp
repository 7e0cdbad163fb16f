// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include "mjcf/read/legs.hpp"
#include "mjcf/read/robot_model.hpp"
#include "mjcf/read/structure.hpp"
#include "mjcf/shape/affine.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// A tendon as a linear actuator: its two sites by their id in the model, the one on the upper link
/// first, and the hinge between them.
struct TendonSpan {
  int tendon, upper_site, lower_site, joint;
};

/// The linear actuators among the tendons: those of `structure`. One that is not over exactly one
/// hinge is a reason, and left out: afterwards it and what it is over count as held.
std::vector<TendonSpan> read_tendons(const XmlFile& xml, const mjModel& model,
                                     FoundStructure& found, Refusals& reasons);

/// Checks that each actuator has a moment arm in the home pose; its stroke is the planner's
/// concern.
void check_arms(const XmlFile& xml, const std::vector<TendonSpan>& tendons,
                const Morphology& morphology, const DesignSpace& space, Refusals& reasons);

/// Whether a site is an end of a tendon.
bool is_tendon_end(const mjModel& model, int site);

/// All placed coordinates by site. One that is placed before is left out, with a reason.
PlaceMap collect_places(const DesignSpace& space, const std::vector<Binding>& bindings,
                        const std::filesystem::path& file, Refusals& reasons);
/// A placed coordinate that a stretch of its body moves obliquely is a reason: the site's place
/// would not be told by its numbers alone.
void check_places(const XmlFile& xml, const mjModel& model, const PlaceMap& places,
                  const StretchMap& stretches, Refusals& reasons);

}  // namespace legwright
