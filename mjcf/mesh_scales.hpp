// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include "mjcf/affine.hpp"
#include "mjcf/elements.hpp"
#include "mjcf/text_edits.hpp"
#include "mjcf/xml.hpp"

namespace legwright {

/// Whether a geom weighs nothing by its own words: mass or density zero.
bool is_weightless(const XmlFile& xml, const XmlElement& geom);

/// Scales the mesh assets that are only drawn, in bodies that are stretched along an axis of the
/// mesh: all geoms that show an asset must want the same scale. Other meshes keep their size.
void write_mesh_scales(const XmlFile& xml, const mjModel& model, const TreeElements& elements,
                       const StretchMap& stretches, const Eigen::VectorXd& s, TextEdits& edits);

}  // namespace legwright
