// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/module.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

OutlineShape shape_of(OutlineShape::Type type, const Vector3d& size, const Vector3d& position,
                      const Vector3d& axis = Vector3d::UnitZ()) {
  return {type, size, position, axis.normalized()};
}

/// Of a box, a cylinder askew and a ball; nothing about it is symmetric.
Module lopsided() {
  Module module;
  module.name = "lopsided";
  module.outline = {
      shape_of(OutlineShape::Type::box, {0.02, 0.05, 0.03}, {0.0, 0.01, 0.0}),
      shape_of(OutlineShape::Type::cylinder, {0.01, 0.03, 0.0}, {0.01, -0.02, 0.01}, {1, 2, 3}),
      shape_of(OutlineShape::Type::sphere, {0.008, 0.0, 0.0}, {-0.01, 0.0, 0.03})};
  for (const OutlineShape& shape : module.outline) module.mass += 1200.0 * shape.volume();
  return module;
}

/// The body of a model with these lines in its one free body.
ModelPointer body_with(const std::string& lines) {
  return compile_mjcf(
      "<mujoco><worldbody><body><freejoint/>" + lines + "</body></worldbody></mujoco>", "x.xml");
}

Eigen::Matrix3d inertia_in_body(const mjModel& model) {
  const double* q = model.body_iquat + 4;
  const Eigen::Matrix3d turn = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  return turn * Vector3d(model.body_inertia + 3).asDiagonal() * turn.transpose();
}

ModulePlace askew(bool mirrored) {
  ModulePlace place;
  place.pose = Eigen::Translation3d(0.1, 0.04, -0.02) *
               Eigen::AngleAxisd(0.7, Vector3d(1, -2, 0.5).normalized());
  place.mirrored = mirrored;
  return place;
}

/// MuJoCo weighs the outline's geoms as the module's <inertial> says.
TEST(ModuleInertia, IsThatOfItsOutlineFilledEvenly) {
  const Module module = lopsided();
  for (const bool mirrored : {false, true}) {
    const ModulePlace place = askew(mirrored);
    std::string geoms;
    for (const std::string& geom : outline_geoms(module, place, " density=\"1200\"")) geoms += geom;
    const ModelPointer weighed = body_with(geoms),
                       told = body_with(inertial_element(module, place));
    EXPECT_NEAR(weighed->body_mass[1], told->body_mass[1], 1e-12);
    for (int k = 3; k < 6; ++k)
      EXPECT_NEAR(weighed->body_ipos[k], told->body_ipos[k], 1e-11) << mirrored;
    EXPECT_LT((inertia_in_body(*weighed) - inertia_in_body(*told)).norm(), 1e-13) << mirrored;
  }
}

TEST(ModulePlaces, MirrorInTheMedianPlane) {
  const ModulePlace left = askew(false), right = askew(true);
  const Vector3d p(0.01, 0.02, 0.03);
  EXPECT_NEAR(left.point(p).y(), -right.point(p).y(), 1e-15);
  EXPECT_NEAR(left.point(p).x(), right.point(p).x(), 1e-15);
  EXPECT_NEAR(left.direction(p).y(), -right.direction(p).y(), 1e-15);
  const Module module = lopsided();
  const ModelPointer a = body_with(inertial_element(module, left)),
                     b = body_with(inertial_element(module, right));
  EXPECT_NEAR(a->body_ipos[4], -b->body_ipos[4], 1e-12);
  for (int k = 3; k < 6; ++k) EXPECT_NEAR(a->body_inertia[k], b->body_inertia[k], 1e-14);
}

TEST(ModuleScene, ShowsOutlineAxisAndAttachments) {
  Module module = lopsided();
  module.joint = ModuleJoint{};
  module.attachments = {Attachment{}};
  const ModelPointer model = compile_mjcf(module_scene(module), "x.xml");
  EXPECT_EQ(model->ngeom, 5);
  EXPECT_EQ(model->geom_type[3], mjGEOM_CAPSULE);
}

TEST(OutlineShapes, HaveTheirVolumes) {
  EXPECT_NEAR(shape_of(OutlineShape::Type::box, {1, 2, 3}, Vector3d::Zero()).volume(), 6.0, 1e-12);
  EXPECT_NEAR(shape_of(OutlineShape::Type::cylinder, {1, 2, 0}, Vector3d::Zero()).volume(),
              2.0 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(shape_of(OutlineShape::Type::sphere, {1, 0, 0}, Vector3d::Zero()).volume(),
              4.0 / 3.0 * std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace legwright
