// SPDX-License-Identifier: Apache-2.0
// Printed parts between modules: where they are, how near they come to the servo that turns them,
// and that they follow a design. Distances are MuJoCo's own.
#include "mjcf/assembly/link_hulls.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mjcf/assembly/assembly_xml.hpp"
#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/assembly/cable_notes.hpp"
#include "mjcf/assembly/limb_hulls.hpp"
#include "mjcf/assembly/overlap_words.hpp"
#include "mjcf/read/connectors.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/assembly/boxy_dog.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using test::hulled_dog;

int id_of(const mjModel& model, mjtObj type, const std::string& name) {
  const int id = mj_name2id(&model, type, name.c_str());
  EXPECT_GE(id, 0) << name;
  return id;
}

/// Least distance of two geoms over a joint's range, where `others` are 1 mm apart [m].
double least_distance(const mjModel& model, int joint, int a, int b, std::pair<int, int> others) {
  double least = 1.0;
  std::vector<double> qpos(model.qpos0, model.qpos0 + model.nq);
  for (int k = 0; k <= 90; ++k) {
    const double* range = model.jnt_range + std::ptrdiff_t{2} * joint;
    qpos[static_cast<std::size_t>(model.jnt_qposadr[joint])] =
        range[0] + (range[1] - range[0]) * k / 90.0;
    const DataPointer data = kinematics_at(model, qpos.data(), "dog.xml");
    if (mj_geomDistance(&model, data.get(), others.first, others.second, 1.0, nullptr) < 1e-3)
      continue;
    least = std::min(least, mj_geomDistance(&model, data.get(), a, b, 1.0, nullptr));
  }
  return least;
}

int only_geom(const mjModel& model, const std::string& body) {
  const int id = id_of(model, mjOBJ_BODY, body);
  EXPECT_EQ(model.body_geomnum[id], 1) << body;
  return model.body_geomadr[id];
}

TEST(LinkHulls, KeepClearOfTheServoThatTurnsThem) {
  const ModelPointer model =
      compile_mjcf(assembly_xml(hulled_dog(), 0.2), "dog.xml", MeshDetail::triangles);
  for (const char* leg : {"FL", "FR", "HL", "HR"})
    for (const char* link : {"hip", "knee"}) {
      const std::string name = std::string(leg) + "_" + link;
      const int servo = only_geom(*model, name + "_servo");
      const int next = std::string(link) == "hip"
                           ? only_geom(*model, std::string(leg) + "_knee_servo")
                           : id_of(*model, mjOBJ_GEOM, leg);
      const int joint = id_of(*model, mjOBJ_JOINT, name);
      for (const char* role : {"_link_arm", "_link_boss"}) {
        if (mj_name2id(model.get(), mjOBJ_BODY, (name + role).c_str()) < 0) continue;
        const int hull = only_geom(*model, name + role);
        EXPECT_GE(least_distance(*model, joint, hull, servo, {servo, next}), 1e-3 - 1e-6)
            << name << role;
      }
      // It reaches the next module.
      EXPECT_LE(
          least_distance(*model, joint, only_geom(*model, name + "_link_arm"), next, {servo, next}),
          1e-6);
    }
}

TEST(LinkHulls, AreSeenAndDoNotTouchWhileCapsulesDo) {
  const ModelPointer model = compile_mjcf(assembly_xml(hulled_dog(), 0.2), "dog.xml");
  const int arm = only_geom(*model, "FL_hip_link_arm");
  EXPECT_EQ(model->geom_type[arm], mjGEOM_MESH);
  EXPECT_EQ(model->geom_contype[arm] + model->geom_conaffinity[arm], 0);
  EXPECT_LT(model->geom_group[arm], 3);
  const int capsule = only_geom(*model, "FL_hip_link");
  EXPECT_EQ(model->geom_type[capsule], mjGEOM_CAPSULE);
  EXPECT_EQ(model->geom_contype[capsule], 1);
  EXPECT_EQ(model->geom_group[capsule], 3) << "which viewers do not show";
  EXPECT_EQ(model->body_mass[id_of(*model, mjOBJ_BODY, "FL_hip_link")], 0.0);
}

TEST(LinkHulls, MirrorEachOther) {
  const ModelPointer model = compile_mjcf(assembly_xml(hulled_dog(), 0.2), "dog.xml");
  const int left = id_of(*model, mjOBJ_BODY, "HL_hip_link_arm"),
            right = id_of(*model, mjOBJ_BODY, "HR_hip_link_arm");
  EXPECT_NEAR(model->body_mass[left], model->body_mass[right], 1e-12);
  EXPECT_GT(model->body_mass[left], 1e-3);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(model->body_ipos[3 * left + k],
                (k == 1 ? -1.0 : 1.0) * model->body_ipos[3 * right + k], 1e-12);
}

TEST(LinkHulls, FollowTheDesign) {
  const BuiltRobot built = build_robot(hulled_dog(), "dog.xml");
  EXPECT_TRUE(built.notes.empty());
  const RobotModel& robot = built.found.model;
  EXPECT_GE(robot.connectors.size(), 8u);
  Eigen::VectorXd s = robot.space.initial();
  for (int k = 0; k < robot.space.size(); ++k)
    s[k] = 0.2 * robot.space.parameters[k].lower + 0.8 * robot.space.parameters[k].upper;
  const RobotModel longer = parse_robot(rewrite_robot(robot, s), "dog.xml");
  EXPECT_GT(longer.morphology.total_mass(), robot.morphology.total_mass());
  EXPECT_EQ(build_robot(hulled_dog(), "dog.xml").xml, built.xml) << "same input, same bytes";
}

TEST(LinkHulls, AreNoneWhereNothingFacesTheHorn) {
  Assembly assembly = hulled_dog();
  assembly.limbs[0].foot.attachments.clear();
  const BuiltRobot built = build_robot(assembly, "dog.xml");
  ASSERT_EQ(built.notes.size(), 1u);
  EXPECT_NE(built.notes[0].find("faces the horn of FL_knee_link, FR_knee_link"), std::string::npos)
      << built.notes[0];
  const ModelPointer model = compile_mjcf(built.xml, "dog.xml");
  EXPECT_LT(mj_name2id(model.get(), mjOBJ_BODY, "FL_knee_link_arm"), 0);
  const int link = id_of(*model, mjOBJ_BODY, "FL_knee_link");
  EXPECT_GT(model->body_mass[link], 0.011) << "a capsule is printed instead";
}

/// Of a module of one's own: its cable leaves where the link would be fixed.
Assembly dog_with_cables(const std::vector<std::string>& cable) {
  Assembly assembly = hulled_dog();
  Module& knee = assembly.limbs[0].joints[1].servo;
  // As far from the horn's way as the end, 17 degrees aside.
  knee.attachments.push_back(
      test::attachment("slant", {0.0, -0.023, 0.0}, Vector3d(0.3, -1.0, 0.0).normalized()));
  knee.cable = cable;
  return assembly;
}

double lowest_end(const Assembly& assembly) {
  const std::vector<PlacedLimb> limbs = placed_limbs(assembly);
  const LinkHulls hulls = hulls_of_link(assembly, limbs[0], 0);
  EXPECT_TRUE(hulls.cable_at.empty());
  double spread = 0.0;
  for (const Vector3d& point : hulls.hulls.back().far) spread = std::max(spread, point.z());
  return spread;
}

TEST(LinkHulls, LeaveOutWhereCablesLeave) {
  const double at_end = lowest_end(dog_with_cables({})),
               beside = lowest_end(dog_with_cables({"end"}));
  EXPECT_GT(beside, at_end + 1e-3) << "a pad that slants reaches higher";
  EXPECT_EQ(lowest_end(dog_with_cables({"slant"})), at_end) << "another side changes nothing";
}

TEST(LinkHulls, TellWhereACableLeavesAndNothingElseFacesTheHorn) {
  Assembly assembly = hulled_dog();
  EXPECT_TRUE(notes_on_cables(assembly).empty());
  AssemblyJoint& knee = assembly.limbs[0].joints[1];
  knee.servo.cable = {"end"};
  knee.line = 24;
  const std::vector<std::string> notes = notes_on_cables(assembly);
  ASSERT_EQ(notes.size(), 1u) << "once for all four legs";
  EXPECT_TRUE(notes[0].starts_with(
      "the connector of FL_hip_link lies on \"end\" of S (knee, line 24), where a cable leaves"))
      << notes[0];
  EXPECT_EQ(notes[0].find("roll"), std::string::npos) << "no other side would face it";
  knee.servo.attachments.push_back(test::attachment("side", {0.014, 0.0, 0.0}, {1.0, 0.0, 0.0}));
  const std::string with_side = notes_on_cables(assembly).at(0);
  const std::size_t at = with_side.find("give knee roll = ");
  ASSERT_NE(at, std::string::npos) << with_side;
  knee.roll = std::stod(with_side.substr(at + std::string("give knee roll = ").size()));
  EXPECT_TRUE(notes_on_cables(assembly).empty()) << "the cure cures";
}

/// The next servo lies within the reach of the one that turns it: the part's end stays before the
/// horn's plane, or what it misses is told.
TEST(LinkHulls, TellWhereThereIsNoRoom) {
  Assembly assembly = hulled_dog();
  assembly.limbs[0].joints[1].offset = {0.0, 0.0, -0.045};
  assembly.link_clearance = 0.004;
  const BuiltRobot built = build_robot(assembly, "dog.xml");
  const std::vector<std::string> of_overlaps = overlap_notes(assembly, built.overlaps);
  for (const std::string& note : built.notes)
    if (std::find(of_overlaps.begin(), of_overlaps.end(), note) == of_overlaps.end()) {
      EXPECT_NE(note.find("nearer to the servo that turns them than 4 mm"), std::string::npos)
          << note;
    }
  EXPECT_GE(built.found.model.connectors.size(), 8u);
}

}  // namespace
}  // namespace legwright
