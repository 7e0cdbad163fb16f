// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "mjcf/read/stretch.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/text_edits.hpp"

namespace legwright {

/// Writes the `mass` of capsules that grow with a body without <inertial>: they keep their density,
/// so the cylinder between the round ends keeps its mass per length (see read_printed()).
/// @param s the design that is written
void write_capsule_masses(const XmlFile& xml, const mjModel& model, const TreeElements& elements,
                          const StretchMap& stretches, const Eigen::VectorXd& s, TextEdits& edits);

}  // namespace legwright
