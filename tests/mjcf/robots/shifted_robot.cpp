// SPDX-License-Identifier: Apache-2.0
#include "tests/mjcf/robots/shifted_robot.hpp"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <memory>

namespace legwright::test {
namespace {

using Eigen::Vector3d;

void move(double* place, const Vector3d& by) {
  for (int k = 0; k < 3; ++k) place[k] += by[k];
}

/// Moves all that stands in a body; what stands in a frame moves with that.
void move_parts(mjsBody& body, const Vector3d& by) {
  const auto each = [&](mjtObj type, const auto& action) {
    for (mjsElement* part = mjs_firstChild(&body, type, 0); part != nullptr;
         part = mjs_nextChild(&body, part, 0))
      if (mjs_getFrame(part) == nullptr) action(part);
  };
  each(mjOBJ_BODY, [&](mjsElement* part) { move(mjs_asBody(part)->pos, by); });
  each(mjOBJ_FRAME, [&](mjsElement* part) { move(mjs_asFrame(part)->pos, by); });
  each(mjOBJ_JOINT, [&](mjsElement* part) { move(mjs_asJoint(part)->pos, by); });
  each(mjOBJ_SITE, [&](mjsElement* part) { move(mjs_asSite(part)->pos, by); });
  each(mjOBJ_CAMERA, [&](mjsElement* part) { move(mjs_asCamera(part)->pos, by); });
  each(mjOBJ_LIGHT, [&](mjsElement* part) { move(mjs_asLight(part)->pos, by); });
  each(mjOBJ_GEOM, [&](mjsElement* part) {
    mjsGeom& geom = *mjs_asGeom(part);
    if (std::isnan(geom.fromto[0])) return move(geom.pos, by);
    move(geom.fromto, by);
    move(geom.fromto + 3, by);
  });
  if (body.explicitinertial != 0) move(body.ipos, by);
}

/// The text of a robot after a change by `edit`, which gets MuJoCo's own reading of it, and its
/// model.
template <class Edit>
std::string edited(const std::string& text, const Edit& edit) {
  std::array<char, 1000> error{};
  const auto fault = [&] { return std::string(error.data()); };
  const std::unique_ptr<mjSpec, decltype(&mj_deleteSpec)> spec(
      mj_parseXMLString(text.c_str(), nullptr, error.data(), error.size()), mj_deleteSpec);
  if (!spec) return ADD_FAILURE() << fault(), "";
  const std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model(mj_compile(spec.get(), nullptr),
                                                                  mj_deleteModel);
  if (!model) return ADD_FAILURE() << mjs_getError(spec.get()), "";
  for (mjsElement* part = mjs_firstElement(spec.get(), mjOBJ_BODY); part != nullptr;
       part = mjs_nextElement(spec.get(), part))
    edit(*mjs_asBody(part), *model, mjs_getId(part));
  mj_deleteModel(mj_compile(spec.get(), nullptr));  // what is saved is what was compiled last
  std::string out(std::size_t{1} << 20, '\0');
  if (mj_saveXMLString(spec.get(), out.data(), static_cast<int>(out.size()), error.data(),
                       error.size()) != 0)
    return ADD_FAILURE() << fault(), "";
  out.resize(out.find('\0'));
  return out;
}

}  // namespace

std::string shifted_robot(const std::string& text) {
  return edited(text, [](mjsBody& body, const mjModel& model, int id) {
    const int joint = model.body_jntadr[id];
    if (joint < 0 || model.jnt_type[joint] != mjJNT_HINGE || mjs_getFrame(body.element) != nullptr)
      return;
    const Vector3d by(0.03, -0.01 - 0.002 * id, 0.02);
    const mjtNum* const q = model.body_quat + 4 * id;
    move(body.pos, Eigen::Quaterniond(q[0], q[1], q[2], q[3]) * by);
    move_parts(body, -by);
  });
}

std::string with_trunk_frame_at(const std::string& text, const Vector3d& place) {
  return edited(text, [&](mjsBody& body, const mjModel& model, int id) {
    const int joint = model.body_jntadr[id];
    if (joint < 0 || model.jnt_type[joint] != mjJNT_FREE) return;
    move_parts(body, -place);
    for (mjsElement* part = mjs_firstChild(&body, mjOBJ_JOINT, 0); part != nullptr;
         part = mjs_nextChild(&body, part, 0))
      move(mjs_asJoint(part)->pos, place);  // a free joint stays at the frame
  });
}

}  // namespace legwright::test
