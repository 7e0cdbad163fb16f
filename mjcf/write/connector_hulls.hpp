// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <vector>

#include "mjcf/read/robot_model.hpp"
#include "mjcf/shape/polyhedron.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/text_edits.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// Mass, centre and moments of a solid as <inertial> has them [kg, m, kg m2]: xx, yy, zz, xy, xz,
/// yz.
struct SolidInertial {
  double mass = 0.0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 6, 1> full = Eigen::Matrix<double, 6, 1>::Zero();
};
SolidInertial inertial_of(const SolidMoments& solid, double density);

/// The corners of a hull, three numbers each, as a <mesh vertex> lists them [m].
Eigen::VectorXd vertices_of(const std::vector<Facet>& facets,
                            const std::vector<Eigen::Vector3d>& points);

/// Writes the hulls of a robot's connectors at design s into their meshes, and what they weigh into
/// the <inertial> of their bodies; and where points turn with an axis, into their declarations.
/// What does not move keeps its bytes.
void write_connectors(const RobotModel& robot, const XmlFile& xml, const mjModel& model,
                      const TreeElements& elements, const Eigen::VectorXd& s, TextEdits& edits);

}  // namespace legwright
