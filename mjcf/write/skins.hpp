// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>

#include "mjcf/read/stretch.hpp"
#include "mjcf/text/text_edits.hpp"

namespace legwright {

/// Puts skins out of sight (`group` 5) in a design whose links change their lengths: a skin is
/// bound to its bodies as they were drawn, each vertex stays where it is beside its body, and the
/// skin does not grow. A robot of which nothing else is drawn keeps its skin in sight.
/// @param s the design that is written
void hide_skins(const XmlFile& xml, const mjModel& model, const StretchMap& stretches,
                const Eigen::VectorXd& s, TextEdits& edits);

/// "skin 'fur' is drawn over the links; …", what becomes of it in a design; empty without one.
std::string describe_skins(const mjModel& model);

}  // namespace legwright
