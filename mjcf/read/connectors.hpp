// SPDX-License-Identifier: Apache-2.0
// Printed parts that follow the design: convex hulls between modules.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mjcf/read/printed.hpp"
#include "mjcf/read/robot_model.hpp"
#include "mjcf/read/structure.hpp"
#include "mjcf/shape/affine.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// A <text> that declares a connector is called so, and then like the mesh that shows it.
inline constexpr std::string_view kConnectorPrefix = "legwright_connector/";

/// Reads the <text name="legwright_connector/MESH" data="DENSITY kg/m3 | joint NAME: x y z … | body
/// NAME: x y z … | geom NAME: x y z …"/> of a robot: of a mesh that is the convex hull of points,
/// each of which goes with a joint's anchor, a body or a geom. The mesh is shown by one geom, at
/// the origin of a body of its own with an <inertial> and without joint; the bodies and geoms stand
/// beside that, and the joint is of the body that holds it. Points are from their origins [m], in
/// the axes of the mesh; those of a joint, and of a body that turns with one, turn with its axis.
/// One that is anything else, or whose mesh or <inertial> in the file is not that of the hull, is
/// left out with a reason.
/// @param initial the design that the file holds
std::vector<Connector> read_connectors(const XmlFile& xml, const mjModel& model,
                                       const Structure& structure, const StretchMap& stretches,
                                       const std::vector<TurningPart>& turning,
                                       const Eigen::VectorXd& initial, Refusals& reasons);

/// Their point masses (masses_of_solid()), by the names of their bodies, in whose frames they are.
void add_connector_masses(const std::vector<Connector>& connectors, const Eigen::VectorXd& initial,
                          PrintedMap& printed);

/// The <mesh> elements that have names.
using MeshElements = std::map<std::string, const XmlElement*, std::less<>>;
MeshElements find_mesh_elements(const XmlFile& xml);

/// The points of a connector at a design, in its body's frame.
std::vector<Eigen::Vector3d> points_at(const std::vector<AffineVector>& points,
                                       const Eigen::VectorXd& s);

/// Their hull at a design: the triangles of the file's design where these still are one.
std::vector<Facet> facets_at(const Connector& connector,
                             const std::vector<Eigen::Vector3d>& points);

/// Whether a design turns points of a connector against others.
bool turns(const RobotModel& robot, const Connector& connector, const Eigen::VectorXd& s);
/// Its points in its body's frame, turned as a design turns axes: affine in all else.
std::vector<AffineVector> turned_points(const RobotModel& robot, const Connector& connector,
                                        const Eigen::VectorXd& s);
/// The same of one end's, from what they go with.
std::vector<Eigen::Vector3d> turned_end(const RobotModel& robot, const Connector::End& end,
                                        const Eigen::VectorXd& s);

/// The robot whose connectors weigh at design s what their hulls do there: where triangles change
/// or points turn on the way, what the file at s will weigh differs from what F takes them to.
Morphology with_hulls_at(const RobotModel& robot, const Eigen::VectorXd& s);

}  // namespace legwright
