// SPDX-License-Identifier: Apache-2.0
// A model with hulls for meshes has the shapes, masses and frames of the one with all triangles,
// and moves like it.
#include "mjcf/text/mesh_hulls.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>
#include <string>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/tools/files/temporary_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr int kRings = 40;

/// A closed surface with dents, longer than wide, and off the origin; most of its vertices are no
/// corners of its hull.
std::string dented_obj(double length) {
  std::string out;
  const auto vertex = [&](double polar, double turn) {
    const double radius = 1.0 - 0.15 * std::abs(std::sin(3.0 * turn) * std::sin(5.0 * polar));
    out += fmt::format("v {} {} {}\n", 0.03 + 0.05 * radius * std::sin(polar) * std::cos(turn),
                       0.03 * radius * std::sin(polar) * std::sin(turn),
                       -0.02 + length * radius * std::cos(polar));
  };
  vertex(0.0, 0.0);
  for (int ring = 1; ring < kRings; ++ring)
    for (int k = 0; k < kRings; ++k)
      vertex(std::numbers::pi * ring / kRings, 2.0 * std::numbers::pi * k / kRings);
  vertex(std::numbers::pi, 0.0);
  const auto id = [](int ring, int k) { return 2 + (ring - 1) * kRings + k % kRings; };
  for (int k = 0; k < kRings; ++k) {
    out += fmt::format("f 1 {} {}\n", id(1, k), id(1, k + 1));
    for (int ring = 1; ring + 1 < kRings; ++ring)
      out += fmt::format("f {0} {1} {2}\nf {0} {2} {3}\n", id(ring, k), id(ring + 1, k),
                         id(ring + 1, k + 1), id(ring, k + 1));
    out += fmt::format("f {} {} {}\n", id(kRings - 1, k), id(kRings, 0), id(kRings - 1, k + 1));
  }
  return out;
}

class MeshHulls : public testing::Test {
 protected:
  MeshHulls() { put("dented.obj", dented_obj(0.1)); }
  void put(const std::string& name, const std::string& bytes) const {
    test::put(folder_.path() / "meshes" / name, bytes);
  }
  static std::string model(const std::string& assets, const std::string& bodies) {
    return "<mujoco><compiler angle=\"radian\" meshdir=\"meshes\"/><asset>" + assets +
           "</asset><worldbody><geom type=\"plane\" size=\"1 1 1\"/>" + bodies +
           "</worldbody></mujoco>";
  }
  /// One mesh, also as a picture, on a body whose mass is given.
  static std::string one(const std::string& attributes) {
    return model("<mesh name=\"m\" file=\"dented.obj\" " + attributes + "/>",
                 R"(<body pos="0 0 0.3"><freejoint/>
      <inertial pos="0.02 0 0" mass="0.3" diaginertia="0.001 0.001 0.0004"/>
      <geom type="mesh" mesh="m" pos="0.01 0.02 0.03" quat="1 0.2 0.3 0.1"/>
      <geom type="mesh" mesh="m" pos="0.2 0 0" contype="0" conaffinity="0"/></body>)");
  }
  ModelPointer compiled(const std::string& xml, MeshDetail detail) const {
    return compile_mjcf(xml, folder_.path() / "robot.xml", detail);
  }
  test::TemporaryFolder folder_;
};

/// How far a geom's mesh reaches along a direction of its body.
double reach(const mjModel& model, int geom, const Vector3d& direction) {
  const int mesh = model.geom_dataid[geom];
  const Vector3d along = rotation_at(model.geom_quat, geom).transpose() * direction;
  double out = -1e9;
  for (int v = 0; v < model.mesh_vertnum[mesh]; ++v)
    out = std::max(out, along.dot(Eigen::Map<const Eigen::Vector3f>(
                                      model.mesh_vert + 3 * (model.mesh_vertadr[mesh] + v))
                                      .cast<double>()));
  return out + direction.dot(vector_at(model.geom_pos, geom));
}

TEST_F(MeshHulls, KeepShapesMassesAndFrames) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (const char* attributes :
       {"", "scale=\"1.3 1 0.8\"", "scale=\"1 -1 1\"", "scale=\"0.001 0.001 0.001\"",
        R"(refpos="0.1 0 0.02" refquat="1 0.1 0 0.4" scale="1 1.2 1")", "inertia=\"convex\"",
        "inertia=\"shell\"", "inertia=\"exact\" scale=\"1 1 1.25\""}) {
    SCOPED_TRACE(attributes);
    const ModelPointer whole = compiled(one(attributes), MeshDetail::triangles),
                       light = compiled(one(attributes), MeshDetail::hulls);
    EXPECT_EQ(whole->mesh_facenum[0], 2 * kRings * (kRings - 1));
    EXPECT_EQ(light->mesh_facenum[0], 12);
    EXPECT_LT(light->mesh_vertnum[0], whole->mesh_vertnum[0]);
    EXPECT_EQ(light->body_mass[1], whole->body_mass[1]);
    const double size = whole->geom_rbound[1];
    for (const int geom : {1, 2}) {
      EXPECT_NEAR(light->geom_rbound[geom], whole->geom_rbound[geom], 1e-5 * size);
      EXPECT_LT((vector_at(light->geom_pos, geom) - vector_at(whole->geom_pos, geom)).norm(),
                1e-6 * size);
      EXPECT_LT((rotation_at(light->geom_quat, geom) - rotation_at(whole->geom_quat, geom)).norm(),
                2e-5);
      for (int k = 0; k < 6; ++k)
        EXPECT_NEAR(light->geom_aabb[6 * geom + k], whole->geom_aabb[6 * geom + k], 1e-5 * size);
      for (int k = 0; k < 100; ++k) {
        const Vector3d direction =
            Vector3d(normal(random), normal(random), normal(random)).normalized();
        EXPECT_NEAR(reach(*light, geom, direction), reach(*whole, geom, direction), 1e-6 * size);
      }
    }
  }
}

TEST_F(MeshHulls, FallAndRollAlike) {
  const ModelPointer whole = compiled(one(""), MeshDetail::triangles),
                     light = compiled(one(""), MeshDetail::hulls);
  const DataPointer a(mj_makeData(whole.get())), b(mj_makeData(light.get()));
  bool touched = false;
  for (int step = 0; step < 250; ++step) {
    mj_step(whole.get(), a.get());
    mj_step(light.get(), b.get());
    touched = touched || b->ncon > 0;
  }
  EXPECT_TRUE(touched);
  for (int k = 0; k < whole->nq; ++k) EXPECT_NEAR(a->qpos[k], b->qpos[k], 1e-5);
}

TEST_F(MeshHulls, DoNotStandForWhatWeighs) {
  const std::string weighs = model("<mesh name=\"m\" file=\"dented.obj\"/>",
                                   R"(<body><freejoint/><geom type="mesh" mesh="m"/></body>)");
  const ModelPointer whole = compiled(weighs, MeshDetail::triangles),
                     light = compiled(weighs, MeshDetail::hulls);
  EXPECT_EQ(light->mesh_facenum[0], whole->mesh_facenum[0]);
  EXPECT_EQ(light->body_mass[1], whole->body_mass[1]);
  EXPECT_EQ(light->body_inertia[3], whole->body_inertia[3]);
  const ModelPointer fitted =
      compiled(model("<mesh name=\"m\" file=\"dented.obj\"/>",
                     R"(<body><freejoint/><geom type="capsule" mesh="m"/></body>)"),
               MeshDetail::hulls);
  EXPECT_EQ(fitted->geom_type[1], mjGEOM_CAPSULE);
}

TEST_F(MeshHulls, LeaveMeshesWithoutNameOrFileTheirs) {
  const ModelPointer light = compiled(
      model("<mesh file=\"dented.obj\"/><mesh name=\"own\" vertex=\"0 0 0 1 0 0 0 1 0 0 0 1\"/>",
            R"(<body><freejoint/><geom type="mesh" mesh="dented" mass="0"/>
               <geom type="mesh" mesh="own"/></body>)"),
      MeshDetail::hulls);
  EXPECT_EQ(name_of(*light, mjOBJ_MESH, 0), "dented");
  EXPECT_EQ(light->mesh_facenum[0], 12);
  EXPECT_EQ(light->mesh_facenum[1], 4);
}

TEST_F(MeshHulls, FollowTheFile) {
  const double before = compiled(one(""), MeshDetail::hulls)->geom_rbound[1];
  put("copy.obj", dented_obj(0.1));
  put("dented.obj", dented_obj(0.2));
  EXPECT_GT(compiled(one(""), MeshDetail::hulls)->geom_rbound[1], 1.5 * before);
  put("dented.obj", dented_obj(0.1));
  EXPECT_EQ(compiled(one(""), MeshDetail::hulls)->geom_rbound[1], before);
}

TEST_F(MeshHulls, LeaveRefusalsToTheCompiler) {
  const auto refusal = [&](MeshDetail detail) -> std::string {
    try {
      compiled(one(""), detail);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  put("dented.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n");  // flat
  EXPECT_NE(refusal(MeshDetail::triangles), "");
  EXPECT_EQ(refusal(MeshDetail::hulls), refusal(MeshDetail::triangles));
  put("dented.obj", "no mesh at all");
  EXPECT_NE(refusal(MeshDetail::triangles), "");
  EXPECT_EQ(refusal(MeshDetail::hulls), refusal(MeshDetail::triangles));
}

}  // namespace
}  // namespace legwright
