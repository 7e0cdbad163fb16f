// SPDX-License-Identifier: Apache-2.0
#include "mjcf/scene/make_room.hpp"

#include <gtest/gtest.h>

#include "mjcf/scene/plain_scene.hpp"
#include "mjcf/scene/surroundings.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/scene/standing_scene.hpp"

namespace legwright {
namespace {

/// The puppy with an element of every name that a scene adds.
std::string crowded() {
  std::string xml = test::with(
      test::named_robot("puppy"), "<inertial",
      "<geom name=\"floor\" size=\"0.01\" contype=\"0\" conaffinity=\"0\" mass=\"0\" "
      "material=\"legwright_floor\"/><site name=\"foot:FL\"/><camera name=\"side\" "
      "resolution=\"64 48\"/>"
      "<body name=\"payload\"><inertial pos=\"0 0 0\" mass=\"0.01\" diaginertia=\"1e-5 1e-5 "
      "1e-5\"/></body><inertial");
  return test::with(
      xml, "</mujoco>",
      "<asset><texture name=\"legwright_floor\" type=\"2d\" builtin=\"flat\" width=\"4\" "
      "height=\"4\"/><material name=\"legwright_floor\" texture=\"legwright_floor\"/></asset>"
      "<default><default class=\"legwright_pd_0\"><geom rgba=\"1 0 0 1\"/></default></default>"
      "<sensor><framepos name=\"tracking\" objtype=\"site\" objname=\"foot:FL\"/>"
      "<gyro name=\"gait:phase\" site=\"foot:FL\"/>"
      "<camprojection name=\"seen\" site=\"foot:FL\" camera=\"side\"/>"
      "<gyro name=\"robot_gait:phase\" site=\"foot:FL\"/>"
      "<accelerometer name=\"contact:FL\" site=\"foot:FL\"/></sensor>"
      "<keyframe><key name=\"gait\"/></keyframe>"
      "<custom><tuple name=\"all\"><element objtype=\"sensor\" objname=\"tracking\" "
      "prm=\"0\"/></tuple></custom></mujoco>");
}

RobotModel crowded_robot() { return parse_robot(crowded(), "puppy.xml"); }

int id(const ModelPointer& model, mjtObj type, const char* name) {
  return mj_name2id(model.get(), type, name);
}

TEST(MakeRoom, WhereNothingStandsInTheWayTheTextIsTheVerySame) {
  const std::string xml = test::named_robot("puppy");
  EXPECT_EQ(make_room(xml, "puppy.xml"), xml);
}

TEST(MakeRoom, NamesInOtherQuotesOrByReferencesAreNamesToo) {
  for (const char* key : {"<key name='gait'/>", "<key name=\"g&#97;it\"/>"}) {
    const std::string xml = test::with(test::named_robot("puppy"), "</mujoco>",
                                       std::string("<keyframe>") + key + "</keyframe></mujoco>");
    const ModelPointer model = compile_mjcf(make_room(xml, "puppy.xml"), "puppy.xml");
    EXPECT_LT(id(model, mjOBJ_KEY, "gait"), 0) << key;
    EXPECT_GE(id(model, mjOBJ_KEY, "robot_gait"), 0) << key;
  }
}

TEST(MakeRoom, WhatRefersToARenamedElementFollowsIt) {
  const ModelPointer model = compile_mjcf(make_room(crowded(), "puppy.xml"), "puppy.xml");
  for (const char* name : {"tracking", "gait:phase", "contact:FL"})
    EXPECT_LT(id(model, mjOBJ_SENSOR, name), 0) << name;
  EXPECT_LT(id(model, mjOBJ_SITE, "foot:FL"), 0);
  EXPECT_LT(id(model, mjOBJ_KEY, "gait"), 0);
  const int site = id(model, mjOBJ_SITE, "robot_foot:FL");
  const int tracking = id(model, mjOBJ_SENSOR, "robot_tracking");
  ASSERT_GE(site, 0);
  ASSERT_GE(tracking, 0);
  EXPECT_EQ(model->sensor_objid[tracking], site);
  EXPECT_EQ(model->sensor_objid[id(model, mjOBJ_SENSOR, "robot_gait:phase_2")], site);
  EXPECT_EQ(model->tuple_objid[0], tracking);
  const int camera = id(model, mjOBJ_CAMERA, "robot_side");
  ASSERT_GE(camera, 0);
  EXPECT_EQ(model->sensor_refid[id(model, mjOBJ_SENSOR, "seen")], camera);
}

TEST(MakeRoom, ASceneHasItsNamesWhateverARobotHas) {
  const RobotModel robot = crowded_robot();
  const ModelPointer scene =
      test::compile_scene(emit_scene(robot, robot.xml, test::settings_for(robot)));
  const int floor = id(scene, mjOBJ_GEOM, "floor_2");
  ASSERT_GE(floor, 0);
  EXPECT_EQ(scene->geom_type[floor], mjGEOM_PLANE);
  EXPECT_EQ(scene->geom_matid[floor], id(scene, mjOBJ_MATERIAL, "legwright_floor_2"));
  const int contact = id(scene, mjOBJ_SENSOR, "contact:FL");
  ASSERT_GE(contact, 0);
  EXPECT_EQ(scene->sensor_type[contact], mjSENS_CONTACT);
  EXPECT_EQ(scene->sensor_objid[contact], floor);
  EXPECT_EQ(scene->sensor_type[id(scene, mjOBJ_SENSOR, "gait:phase")], mjSENS_PLUGIN);
  EXPECT_EQ(scene->cam_bodyid[id(scene, mjOBJ_CAMERA, "side")], 0);
  EXPECT_GT(scene->cam_bodyid[id(scene, mjOBJ_CAMERA, "robot_side")], 0);
  const int start = id(scene, mjOBJ_KEY, "gait");
  EXPECT_EQ(scene->key_qpos[start * scene->nq + 2], test::settings_for(robot).start_qpos[2]);
}

TEST(MakeRoom, APlainSceneStandsBesideTheRobotAsItIs) {
  const RobotModel robot = crowded_robot();
  const std::string scene = plain_scene(robot, robot.xml, "puppy.xml", 0.8);
  for (const char* name :
       {"name=\"floor_2\"", "name=\"legwright_floor_2\"", "material=\"legwright_floor_2\""})
    EXPECT_NE(scene.find(name), std::string::npos) << name << '\n' << scene;
}

TEST(MakeRoom, APayloadTakesANameThatIsFree) {
  const RobotModel robot = crowded_robot();
  Task task;
  task.payload = Payload{0.7, {0.02, -0.01, 0.05}, {0.06, 0.04, 0.1}};
  const ModelPointer model = compile_mjcf(in_surroundings(robot, robot.xml, task), robot.file);
  EXPECT_NEAR(model->body_mass[id(model, mjOBJ_BODY, "payload_2")], 0.7, 1e-12);
  EXPECT_NEAR(model->body_mass[id(model, mjOBJ_BODY, "payload")], 0.01, 1e-12);
}

}  // namespace
}  // namespace legwright
