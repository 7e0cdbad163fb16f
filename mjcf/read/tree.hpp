// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <vector>

#include "mjcf/read/linear_actuators.hpp"
#include "mjcf/read/printed.hpp"
#include "mjcf/read/robot_model.hpp"
#include "mjcf/read/structure.hpp"
#include "mjcf/shape/affine.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// What a design moves besides axes.
struct MovedParts {
  StretchMap stretches;
  PlaceMap places;
  PrintedMap printed;
  std::vector<TurningPart> turning;
};

/// Builds the kinematic tree of the compiled robot with the stretches, turns and places of its
/// design parameters. Held joints are rigid, in their home pose.
/// @param connectors are told their link and where its masses stand for them
Morphology build_morphology(const XmlFile& xml, const mjModel& model, const Structure& structure,
                            const DesignSpace& space, const std::vector<Binding>& bindings,
                            const MovedParts& moved, const std::vector<TendonSpan>& tendons,
                            std::vector<Connector>& connectors);

/// How the home pose turns (hinge, ball) or shifts (slide) what a joint moves, against the pose
/// that the file draws: in the body's frame, about the joint's anchor.
Eigen::Isometry3d held_motion(const mjModel& model, int joint);
/// The same about the origin of the body's frame.
Eigen::Isometry3d held_displacement(const mjModel& model, int joint);

}  // namespace legwright
