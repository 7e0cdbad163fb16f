// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "mjcf/read/structure.hpp"
#include "mjcf/shape/affine.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// Height of the lowest point of a geom in the pose that `data` holds [m].
double lowest_point(const mjModel& model, const mjData& data, int geom);
/// About where a geom would touch the ground in that pose: the lower end of a capsule's axis, or of
/// a cylinder's, a lower corner, edge or the middle of a face, the middle of what is lowest of a
/// mesh, at lowest_point() [m, world]. choose_foot() tells it exactly.
Eigen::Vector3d lowest_place(const mjModel& model, const mjData& data, int geom);
bool collides(const mjModel& model, int geom);

/// The foot among the parts of a leg's last link, in the pose that `data` holds: the colliding geom
/// that reaches lowest (a ball before others about as low; balls, or plates, of one size that reach
/// as low together), else the lowest site. Without name. Returns false where there is neither.
/// @param bodies those that make up the link.
bool choose_foot(const XmlFile& xml, const mjModel& model, const mjData& data,
                 const std::vector<int>& bodies, FootContact& foot);

/// Whether a geom is the foot's, or another of several alike in whose middle it is.
bool is_of_foot(const FootContact& foot, int geom);

/// Body that a foot belongs to.
int foot_body(const mjModel& model, const FootContact& foot);

/// Centre of a foot's ball, or the middle of its sole, in the frame of its body, as a function of
/// the design: a point of the body, which goes where the stretches take it.
/// @param stretches of its body; without any the point as it is in the file.
AffineVector foot_point(const XmlFile& xml, const TreeElements& elements, const mjModel& model,
                        const FootContact& foot, const std::vector<Stretch>& stretches);

/// How much farther than its own place the geom of a foot moves, so that where it touches is such a
/// point although the geom keeps its thickness: in its body's frame, as a function of the design.
/// Nothing for a ball, a mesh, a thickness that grows or lies across the stretches.
AffineVector foot_shift(const XmlFile& xml, const TreeElements& elements, const mjModel& model,
                        const FootContact& foot, const std::vector<Stretch>& stretches);

}  // namespace legwright
