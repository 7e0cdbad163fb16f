// SPDX-License-Identifier: Apache-2.0
#include "mjcf/scene/surroundings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mjcf/read/world_parts.hpp"
#include "mjcf/scene/played_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "optimizer/design/inertia.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

Task with_payload() {
  Task task;
  task.payload = Payload{0.7, {0.02, -0.01, 0.05}, {0.06, 0.04, 0.1}};
  return task;
}

RobotModel robot_named(const std::string& name) {
  return parse_robot(test::named_robot(name), name + ".xml");
}

TEST(Surroundings, WithoutAnyTheTextIsTheVerySame) {
  const RobotModel robot = robot_named("puppy");
  EXPECT_EQ(in_surroundings(robot, robot.xml, Task{}), robot.xml);
}

TEST(Surroundings, PlanAndSceneWeighTheSame) {
  for (const char* name : {"puppy", "piston_puppy", "crooked", "crooked_printed"}) {
    const RobotModel robot = robot_named(name);
    const Task task = with_payload();
    const ModelPointer scene = compile_mjcf(in_surroundings(robot, robot.xml, task), robot.file);
    const ModelPointer bare = compile_mjcf(robot.xml, robot.file);
    const GeometryAtDesign plan(as_in_task(robot.morphology, task), robot.space.initial());
    const int trunk = mj_name2id(scene.get(), mjOBJ_BODY, robot.root_body.c_str());
    EXPECT_NEAR(scene->body_subtreemass[trunk], plan.total_mass, 1e-9) << name;
    EXPECT_NEAR(scene->body_subtreemass[trunk], bare->body_subtreemass[trunk] + 0.7, 1e-9) << name;
  }
}

TEST(Surroundings, ThePayloadWeighsWhatItShallUnderAnyCompiler) {
  const auto with_compiler = [](const std::string& words) {
    std::string xml = test::named_robot("puppy");
    return xml.insert(xml.find('>', xml.find("<mujoco")) + 1, "<compiler " + words + "/>");
  };
  const RobotModel robot = robot_named("puppy");
  for (const char* words : {"inertiagrouprange=\"1 5\"", "inertiafromgeom=\"auto\""}) {
    const ModelPointer scene =
        compile_mjcf(in_surroundings(robot, with_compiler(words), with_payload()), robot.file);
    const int body = mj_name2id(scene.get(), mjOBJ_BODY, "payload");
    EXPECT_NEAR(scene->body_mass[body], 0.7, 1e-12) << words;
  }
  EXPECT_THROW(in_surroundings(robot, with_compiler("settotalmass=\"2\""), with_payload()),
               InputError);
}

TEST(Surroundings, ThePayloadIsSeenAndTouchesNothing) {
  const RobotModel robot = robot_named("puppy");
  const ModelPointer scene =
      compile_mjcf(in_surroundings(robot, robot.xml, with_payload()), robot.file);
  const int body = mj_name2id(scene.get(), mjOBJ_BODY, "payload");
  ASSERT_GE(body, 0);
  EXPECT_EQ(scene->body_parentid[body],
            mj_name2id(scene.get(), mjOBJ_BODY, robot.root_body.c_str()));
  const int geom = scene->body_geomadr[body];
  EXPECT_EQ(scene->geom_contype[geom] | scene->geom_conaffinity[geom], 0);
  EXPECT_LE(scene->geom_group[geom], 2);
  EXPECT_GT(scene->geom_rgba[4 * geom + 3], 0.5F);
  EXPECT_NEAR(scene->geom_size[3 * geom + 2], 0.05, 1e-12);
  EXPECT_LT((Vector3d::Map(scene->body_pos + 3 * body) - Vector3d(0.02, -0.01, 0.05)).norm(),
            1e-12);
  const Vector3d inertia = Vector3d::Map(scene->body_inertia + 3 * body);
  EXPECT_NEAR(inertia.sum(), 2 * 0.7 / 12 * Vector3d(0.06, 0.04, 0.1).squaredNorm(), 1e-12);
}

TEST(Surroundings, ASlopeTurnsGravity) {
  const RobotModel robot = robot_named("puppy");
  Task task;
  task.up = up_on_slope({0.1, 0.0}, 0.25, 0.1);
  const ModelPointer scene = compile_mjcf(in_surroundings(robot, robot.xml, task), robot.file);
  EXPECT_LT((Vector3d::Map(scene->opt.gravity) + kGravity * task.up).norm(), 1e-12);
  EXPECT_LT((up_of(*scene) - task.up).norm(), 1e-12);
  EXPECT_LT(scene->opt.gravity[0], -2.0);  // downhill is backward
  EXPECT_EQ(up_of(*compile_mjcf(robot.xml, robot.file)), Vector3d::UnitZ());
}

TEST(Surroundings, ServosAreNoStrongerThanTheTaskAllows) {
  const RobotModel robot = robot_named("piston_puppy");
  Task task;
  task.torque_limit = 1.0;
  const RobotModel weaker = with_task_servos(robot, task);
  int rotary = 0;
  for (std::size_t a = 0; a < robot.servos.size(); ++a) {
    const bool linear = !robot.servos[a].tendon.empty();
    rotary += linear ? 0 : 1;
    EXPECT_EQ(weaker.servos[a].torque_limit, linear ? robot.servos[a].torque_limit : 1.0);
    EXPECT_EQ(weaker.servos[a].kp, robot.servos[a].kp);  // what a motor holds on with stays
  }
  EXPECT_EQ(rotary, 8);
  task.torque_limit = 100.0;
  EXPECT_EQ(with_task_servos(robot, task).servos[0].torque_limit, robot.servos[0].torque_limit);
}

TEST(Surroundings, SoftServosArePlayedAsStiffAsTheTaskSaysAndTheMotorBears) {
  const RobotModel robot = robot_named("piston_puppy");  // kp 80, 3 N m
  Task task;
  EXPECT_EQ(with_task_servos(robot, task).servos[0].kp, robot.servos[0].kp);
  const auto rotary = [&](const RobotModel& of) {
    return *std::find_if(of.servos.begin(), of.servos.end(),
                         [](const Servo& servo) { return servo.tendon.empty(); });
  };
  const Servo own = rotary(robot);
  const auto played = [&](double limit, double kp, std::optional<double> kd) {
    RobotModel changed = robot;
    for (Servo& servo : changed.servos) servo.torque_limit = limit;
    task.servo_kp = kp;
    task.servo_kd = kd;
    return with_task_servos(changed, task);
  };
  const Servo stiff = rotary(played(30.0, 2.0 * own.kp, std::nullopt));
  EXPECT_EQ(stiff.kp, 2.0 * own.kp);
  EXPECT_NEAR(stiff.kd, std::max(own.kd, kDampingTime * stiff.kp), 1e-12);
  EXPECT_EQ(rotary(played(30.0, 2.0 * own.kp, 7.0)).kd, 7.0);
  EXPECT_EQ(rotary(played(30.0, 0.5 * own.kp, 7.0)).kp, own.kp) << "none gets softer";
  EXPECT_EQ(rotary(played(30.0, 0.5 * own.kp, std::nullopt)).kd, own.kd);
  EXPECT_EQ(rotary(played(30.0, 0.5 * own.kp, 7.0)).kd, 7.0) << "damping is asked for by itself";
  EXPECT_NEAR(rotary(played(0.0375 * 1.5 * own.kp, 1e4, std::nullopt)).kp, 1.5 * own.kp, 1e-9)
      << "full torque at 0.0375 rad";
  for (std::size_t a = 0; a < robot.servos.size(); ++a) {
    if (robot.servos[a].tendon.empty()) continue;
    EXPECT_EQ(played(30.0, 1e4, 7.0).servos[a].kp, robot.servos[a].kp) << "pistons stay";
  }
}

TEST(Surroundings, ServosAreDampedAtLeastAsTheTaskSays) {
  const RobotModel robot = robot_named("piston_puppy");
  const auto rotary = [&](const Task& task) {
    const RobotModel played = with_task_servos(robot, task);
    for (std::size_t a = 0; a < robot.servos.size(); ++a)
      if (!robot.servos[a].tendon.empty()) {
        EXPECT_EQ(played.servos[a].kd, robot.servos[a].kd) << "linear actuators stay";
      }
    return played.servos[0];
  };
  ASSERT_TRUE(robot.servos[0].tendon.empty());
  const Servo own = robot.servos[0];
  Task task;
  task.servo_kp = 0.5 * own.kp;  // no stiffer than it is
  EXPECT_EQ(rotary(task).kd, own.kd);
  task.servo_kd = 3.0 * own.kd + 1.0;
  EXPECT_EQ(rotary(task).kp, own.kp);
  EXPECT_EQ(rotary(task).kd, 3.0 * own.kd + 1.0) << "also where its kp is kept";
  task.servo_kd = 0.5 * own.kd;
  EXPECT_EQ(rotary(task).kd, own.kd) << "never less than the file has";
  task.servo_kp.reset();
  task.servo_kd = own.kd + 2.0;
  EXPECT_EQ(rotary(task).kd, own.kd + 2.0);
}

/// A ball to play with and a stand-in for a joint that the robot does not have, as published files
/// bring them, with a camera, a servo, sensors and numbers in the keyframe.
std::string puppy_with_company() {
  std::string xml = test::named_robot("puppy");
  xml = test::with(xml, "<worldbody>",
                   "<worldbody><body name=\"ball\" pos=\"0 0 3\"><freejoint name=\"ball_root\"/>"
                   "<geom name=\"ball\" size=\"0.1\" mass=\"1\" contype=\"1\"/></body>"
                   "<camera name=\"watch\" mode=\"targetbody\" target=\"ball\"/>");
  xml = test::with(xml, "</worldbody>",
                   "<body name=\"not_used\" pos=\"0 0 20\"><inertial pos=\"0 0 0\" mass=\"0.1\" "
                   "diaginertia=\"0.1 0.1 0.1\"/><joint name=\"not_used\"/></body></worldbody>"
                   "<sensor><jointpos joint=\"not_used\"/><framepos objtype=\"body\" "
                   "objname=\"ball\"/><framequat objtype=\"xbody\" "
                   "objname=\"ball\"/></sensor><contact><exclude body1=\"ball\" "
                   "body2=\"not_used\"/></contact>");
  xml = test::with(xml, "</actuator>", "<motor joint=\"not_used\" ctrlrange=\"-1 1\"/></actuator>");
  xml.replace(xml.find("qpos=\"") + 6, 0, "0 0 3 1 0 0 0 ");
  return xml.insert(xml.find('"', xml.find("qpos=\"") + 6), " 0");
}

TEST(Surroundings, WhatMovesBesideTheRobotIsToldAndLeftOutOfScenes) {
  const RobotModel robot = parse_robot(puppy_with_company(), "puppy.xml");
  const RobotModel alone = robot_named("puppy");
  EXPECT_EQ(robot.morphology.joint_count(), alone.morphology.joint_count());
  EXPECT_EQ(robot.root_body, alone.root_body);
  EXPECT_EQ(surroundings_of(*compile_mjcf(robot.xml, robot.file)),
            (std::vector<std::string>{"body 'ball', which moves by itself",
                                      "body 'not_used', which moves by itself"}));
  const ModelPointer scene = compile_mjcf(played_robot(robot, robot.xml), robot.file),
                     plain = compile_mjcf(played_robot(alone, alone.xml), alone.file);
  EXPECT_EQ(scene->nbody, plain->nbody);
  EXPECT_EQ(scene->nq, plain->nq);
  EXPECT_EQ(scene->nu, plain->nu);
  EXPECT_EQ(scene->nsensor, plain->nsensor);
  EXPECT_EQ(scene->ncam, plain->ncam);
  EXPECT_EQ(scene->nexclude, plain->nexclude);
  ASSERT_EQ(scene->nkey, plain->nkey);
  for (int k = 0; k < scene->nq; ++k) EXPECT_EQ(scene->key_qpos[k], plain->key_qpos[k]) << k;
}

/// Tendons are known by their places in the file: one that goes shifts no other.
TEST(Surroundings, ATendonOverAStandInTakesNoPistonWithIt) {
  std::string xml = test::named_robot("piston_puppy");
  xml = test::with(xml, "</worldbody>",
                   "<body name=\"not_used\" pos=\"0 0 20\"><inertial pos=\"0 0 0\" mass=\"0.1\" "
                   "diaginertia=\"0.1 0.1 0.1\"/><joint name=\"not_used\"/></body></worldbody>");
  xml = test::with(xml, "<tendon>",
                   "<tendon><fixed name=\"other\"><joint joint=\"not_used\" coef=\"1\"/></fixed>");
  xml = test::with(xml, "</actuator>", "<motor joint=\"not_used\" ctrlrange=\"-1 1\"/></actuator>");
  xml.insert(xml.find('"', xml.find("qpos=\"") + 6), " 0");
  const RobotModel robot = parse_robot(xml, "puppy.xml"), alone = robot_named("piston_puppy");
  const ModelPointer scene = compile_mjcf(played_robot(robot, robot.xml), robot.file);
  EXPECT_EQ(scene->ntendon, compile_mjcf(alone.xml, alone.file)->ntendon);
  EXPECT_LT(mj_name2id(scene.get(), mjOBJ_TENDON, "other"), 0);
}

TEST(Surroundings, ALegThatHangsOnTheWorldIsNoCompany) {
  std::string xml = puppy_with_company();
  xml = test::with(xml, "<joint name=\"not_used\"/>",
                   "<joint name=\"not_used\"/><geom size=\".1\"/>");
  EXPECT_THROW(parse_robot(xml, "puppy.xml"), InputError);
}

}  // namespace
}  // namespace legwright
