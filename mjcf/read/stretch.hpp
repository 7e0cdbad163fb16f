// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include "mjcf/read/robot_model.hpp"
#include "mjcf/read/structure.hpp"
#include "mjcf/shape/affine.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// Direction and length that a stretch has in the compiled model.
struct StretchMeasure {
  Eigen::Vector3d direction;  // unit, body frame
  double length;              // [m]
  double still;               // [m] along the direction: the hinge of the body, which stays
};

/// Measures a body along a direction word: `link` from its last hinge to the joint below or the
/// foot, `x y z` the same along an axis, for the trunk the spread of its limbs along it. Throws
/// InputError at `place`.
StretchMeasure measure_stretch(const XmlFile& xml, const mjModel& model, const XmlElement& place,
                               int body, const std::string& direction, const Structure& structure);

/// Checks that a body can be stretched by rewriting it: plain parts; an explicit inertial, if there
/// is one, that MuJoCo uses as written.
void check_stretchable(const XmlFile& xml, const mjModel& model, const XmlElement& body);

/// Inertia about the centre of mass in the body's frame, and the centre, exactly as the file says
/// them.
struct BodyInertia {
  Eigen::Vector3d centre;
  Eigen::Matrix3d inertia;
  bool diagonal;  // told by diaginertia without orientation
};
BodyInertia inertia_of(const XmlElement& inertial, const mjModel& model, int body);

/// All stretches of a robot by body. Those that are not perpendicular to others of their body are
/// left out, each with a reason.
StretchMap collect_stretches(const DesignSpace& space, const std::vector<Binding>& bindings,
                             const std::filesystem::path& file, Refusals& reasons);

}  // namespace legwright
