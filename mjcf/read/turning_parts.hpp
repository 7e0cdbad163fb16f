// SPDX-License-Identifier: Apache-2.0
// Bodies that turn with a joint's axis: servos, whose horn looks along it.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "mjcf/read/structure.hpp"
#include "mjcf/shape/affine.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"
#include "optimizer/design/morphology.hpp"

namespace legwright {

/// A <text> that declares such a body is called so, and then like the body.
inline constexpr std::string_view kTurnsPrefix = "legwright_turns/";

/// A body at a hinge, beside the body that this moves, which a design turns as it does the axis.
struct TurningPart {
  std::string body, joint;
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();  // body around both ← body of the joint
};

/// Reads <text name="legwright_turns/BODY" data="joint JOINT"/>; those of joints that are held are
/// passed over. A body that has a joint, bodies in it, a foot, a site or a stretch, is in a frame,
/// or does not stand at the joint beside the body that this alone moves is left out, with a reason.
std::vector<TurningPart> read_turning_parts(const XmlFile& xml, const mjModel& model,
                                            const Structure& structure, const StretchMap& stretches,
                                            Refusals& reasons);

/// The one of that body; nullptr where there is none.
const TurningPart* find_turning_part(const std::vector<TurningPart>& parts, std::string_view body);

/// Whether with the axis of each of these joints one of them turns.
bool turn_with_axes(const std::vector<TurningPart>& parts,
                    const std::vector<std::string_view>& joints);

/// How the axis of a joint at design `to` is turned against that at `from`, in the frame of the
/// joint's body. The identity, exactly, where none of its parameters differs.
Eigen::Matrix3d axis_turn(const Morphology& morphology, std::string_view joint,
                          const Eigen::VectorXd& from, const Eigen::VectorXd& to);

}  // namespace legwright
