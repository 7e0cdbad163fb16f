// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/turned_bodies.hpp"

#include <Eigen/Geometry>

#include "mjcf/read/turning_parts.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {

void write_turned_bodies(const RobotModel& robot, const mjModel& model,
                         const TreeElements& elements, const Eigen::VectorXd& s, TextEdits& edits) {
  const Eigen::VectorXd initial = robot.space.initial();
  for (const TurningPart& part : robot.turning_parts) {
    const Eigen::Matrix3d turn = axis_turn(robot.morphology, part.joint, initial, s);
    if (turn == Eigen::Matrix3d::Identity()) continue;
    const int body = mj_name2id(&model, mjOBJ_BODY, part.body.c_str());
    const XmlElement& element = *elements.bodies[static_cast<std::size_t>(body)];
    Eigen::Quaterniond now(part.frame * turn * part.frame.transpose() *
                           rotation_at(model.body_quat, body));
    if (now.w() < 0.0) now.coeffs() *= -1.0;
    for (const char* const name : {"axisangle", "xyaxes", "zaxis", "euler"})
      edits.remove(element, name);
    edits.set_numbers(element, "quat", Eigen::Vector4d(now.w(), now.x(), now.y(), now.z()));
  }
}

}  // namespace legwright
