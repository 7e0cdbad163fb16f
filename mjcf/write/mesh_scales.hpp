// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <map>

#include "mjcf/read/structure.hpp"
#include "mjcf/shape/affine.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/text_edits.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// The meshes of stretched bodies that keep their shape, as they are a foot or its picture in the
/// same place: by their geoms, how far they move in the body's frame [m], which is as far as the
/// point does where the foot touches. A foot longer than half of the link is the link itself and
/// none of these.
std::map<const XmlElement*, Eigen::Vector3d> rigid_feet(const XmlFile& xml, const mjModel& model,
                                                        const TreeElements& elements,
                                                        const Structure& structure,
                                                        const StretchMap& stretches,
                                                        const Eigen::VectorXd& s);

/// Stretches the mesh geoms of stretched bodies (mesh_grows) by their assets: each vertex goes
/// where the body's point there goes. Geoms that want an asset alike share it; where others show it
/// otherwise, they get a copy of its element, of another name, behind it. What keeps the asset as
/// it is keeps the element, else those that are most. Where the stretch runs along no axis of the
/// mesh, asset and geom are turned against each other (refquat, quat) until it does.
/// @param rigid meshes that keep their shape
void write_mesh_scales(const XmlFile& xml, const mjModel& model, const TreeElements& elements,
                       const StretchMap& stretches,
                       const std::map<const XmlElement*, Eigen::Vector3d>& rigid,
                       const Eigen::VectorXd& s, TextEdits& edits);

}  // namespace legwright
