// SPDX-License-Identifier: Apache-2.0
#include "mjcf/scene/emit_scene.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "mjcf/read/solver_options.hpp"
#include "mjcf/read/world_parts.hpp"
#include "mjcf/scene/plain_scene.hpp"
#include "mjcf/scene/played_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/xml.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/scene/standing_scene.hpp"
#include "tests/support/paths.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using test::compile_scene;
using test::settings_for;

TEST(EmitScene, ABodyMayBeNamedAsAFootElsewhere) {
  const RobotModel robot = parse_robot(
      test::with(test::named_robot("puppy"), "<body name=\"FL_hip_servo\"", "<body name=\"FL\""),
      "puppy.xml");
  const ModelPointer scene = compile_scene(emit_scene(robot, robot.xml, settings_for(robot)));
  EXPECT_GE(mj_name2id(scene.get(), mjOBJ_SENSOR, "gait:measured_contact"), 0);
}

TEST(EmitScene, TheRobotsOwnCamerasMakeRoomForItsViews) {
  const std::string own =
      "<camera name=\"track\" pos=\"0 0 9\" mode=\"fixed\"/><camera name=\"eye\"/>";
  const RobotModel robot =
      parse_robot(test::with(test::named_robot("puppy"), "<body name=\"FL_hip_servo\"",
                             own + "<body name=\"FL_hip_servo\""),
                  "puppy.xml");
  const ModelPointer scene = compile_scene(emit_scene(robot, robot.xml, settings_for(robot)));
  EXPECT_EQ(scene->ncam, 4);  // side, track, robot_track, eye
  const int track = mj_name2id(scene.get(), mjOBJ_CAMERA, "track");
  ASSERT_GE(track, 0);
  EXPECT_EQ(scene->cam_mode[track], mjCAMLIGHT_TRACKCOM);
  const int robots = mj_name2id(scene.get(), mjOBJ_CAMERA, "robot_track");
  ASSERT_GE(robots, 0);
  EXPECT_EQ(scene->cam_pos[3 * robots + 2], 9.0);
  EXPECT_GE(mj_name2id(scene.get(), mjOBJ_CAMERA, "eye"), 0);
}

/// The puppy with what published files bring around their robot.
std::string puppy_in_surroundings() {
  return test::with(
      test::with(test::named_robot("puppy"), "<worldbody>",
                 "<asset><hfield name=\"hills\" nrow=\"2\" ncol=\"2\" size=\"5 5 1 0.1\"/></asset>"
                 "<option iterations=\"1\" ls_iterations=\"4\" timestep=\"0.004\">"
                 "<flag eulerdamp=\"disable\" contact=\"disable\"/></option><worldbody>"
                 "<geom name=\"floor\" type=\"plane\" size=\"0 0 0.05\" contype=\"1\"/>"
                 "<geom type=\"hfield\" hfield=\"hills\"/>"
                 "<geom type=\"box\" size=\"1 1 1\" contype=\"1\"/><body name=\"step\">"
                 "<geom name=\"edge\" type=\"box\" size=\"1 1 0.1\" contype=\"1\"/></body>"
                 "<geom name=\"picture\" size=\"0.1\" contype=\"0\" conaffinity=\"0\"/>"
                 "<camera name=\"side\" pos=\"0 0 9\"/>"),
      "</worldbody>",
      "</worldbody><contact><exclude body1=\"world\" body2=\"step\"/>"
      "<pair geom1=\"edge\" geom2=\"FL\"/></contact>");
}

TEST(EmitScene, ALevelFloorComesInThePlaceOfTheFilesSurroundings) {
  const RobotModel robot = parse_robot(puppy_in_surroundings(), "puppy.xml");
  const ModelPointer file = compile_mjcf(robot.xml, robot.file);
  const std::vector<std::string> told = surroundings_of(*file);
  EXPECT_EQ(told,
            (std::vector<std::string>{"plane 'floor'", "box 'edge'", "a height field", "a box"}));
  EXPECT_NE(describe_surroundings(told).find("plane 'floor', box 'edge'"), std::string::npos);
  const ModelPointer scene = compile_scene(emit_scene(robot, robot.xml, settings_for(robot)));
  int in_world = 0;
  for (int g = 0; g < scene->ngeom; ++g) in_world += scene->body_weldid[scene->geom_bodyid[g]] == 0;
  EXPECT_EQ(in_world, 2);  // the floor and the picture, which nothing touches
  EXPECT_EQ(scene->npair, 0);
  const int floor = mj_name2id(scene.get(), mjOBJ_GEOM, "floor");
  ASSERT_GE(floor, 0);
  EXPECT_EQ(scene->geom_solref[floor * mjNREF], 0.005);  // the scene's own
}

TEST(EmitScene, OptionsThatStarveContactsAreOverriddenAndTold) {
  const RobotModel robot = parse_robot(puppy_in_surroundings(), "puppy.xml");
  const ModelPointer scene = compile_scene(emit_scene(robot, robot.xml, settings_for(robot)));
  mjOption defaults;
  mj_defaultOption(&defaults);
  EXPECT_EQ(scene->opt.iterations, defaults.iterations);
  EXPECT_EQ(scene->opt.ls_iterations, defaults.ls_iterations);
  EXPECT_EQ(scene->opt.timestep, 0.001);
  EXPECT_EQ(scene->opt.disableflags & mjDSBL_CONTACT, 0);
  const std::string told =
      describe_overridden(overridden_options(options_of_mjcf(robot.xml, robot.file), 0.001));
  for (const char* part : {"timestep 0.001 (its file has 0.004)", "(its file has 1)",
                           "(its file has 4)", "contact enable (its file has disable)"})
    EXPECT_NE(told.find(part), std::string::npos) << told;
  EXPECT_EQ(told.find("impratio"), std::string::npos) << told;
  const RobotModel plain = parse_robot(test::named_robot("puppy"), "puppy.xml");
  EXPECT_EQ(describe_overridden(overridden_options(options_of_mjcf(plain.xml, plain.file), 0.001)),
            "");
}

TEST(EmitScene, StepsAreShorterWhereServosDampLightLinks) {
  const auto with_damping = [](const char* kv) {
    return parse_robot(
        test::with(test::with(test::named_robot("puppy"), "armature=\"0.0005\"", "armature=\"0\""),
                   "kv=\"0.8\"", kv),
        "puppy.xml");
  };
  const RobotModel usual = with_damping("kv=\"0.1\""), damped = with_damping("kv=\"8\"");
  EXPECT_EQ(compile_scene(emit_scene(usual, usual.xml, settings_for(usual)))->opt.timestep, 0.001);
  for (const double gains : {0.5, 1.0, 2.0}) {  // one step, whatever gains it is played at
    SceneSettings settings = settings_for(damped);
    settings.gain_scale = gains;
    EXPECT_EQ(compile_scene(emit_scene(damped, damped.xml, settings))->opt.timestep, 0.00025);
  }
  EXPECT_NE(plain_scene(damped, damped.xml, "puppy.xml", 0.8).find("timestep=\"0.00025\""),
            std::string::npos);
}

/// There the robot's file is included as it is, with its names and its ground.
TEST(PlainScene, NamesAndFloorsOfTheFileAreNotDoubled) {
  const RobotModel robot = parse_robot(puppy_in_surroundings(), "puppy.xml");
  const std::string plain = plain_scene(robot, robot.xml, "puppy.xml", 0.8);
  EXPECT_NE(plain.find("name=\"side_2\""), std::string::npos) << plain;
  EXPECT_EQ(plain.find("name=\"side\""), std::string::npos) << plain;
  EXPECT_EQ(plain.find("name=\"floor\""), std::string::npos) << plain;
  // A plane that nothing touches is no ground, but keeps its name.
  const RobotModel drawn = parse_robot(test::with(robot.xml,
                                                  "size=\"0 0 0.05\" contype=\"1\"/>"
                                                  "<geom type=\"hfield\" hfield=\"hills\"/>",
                                                  "size=\"0 0 0.05\"/>"),
                                       "puppy.xml");
  EXPECT_NE(plain_scene(drawn, drawn.xml, "puppy.xml", 0.8).find("name=\"floor_2\""),
            std::string::npos);
  EXPECT_NE(plain_scene(parse_robot(test::named_robot("puppy"), "puppy.xml"),
                        test::named_robot("puppy"), "puppy.xml", 0.8)
                .find("name=\"floor\""),
            std::string::npos);
}

/// With the scene's light on top of the robot's own everything would be white.
TEST(EmitScene, BringsALightOnlyWhereTheRobotHasNone) {
  const auto lights = [](const std::string& own) {
    const RobotModel robot = parse_robot(
        test::with(test::named_robot("puppy"), "<worldbody>", "<worldbody>" + own), "puppy.xml");
    const std::string plain = plain_scene(robot, robot.xml, "puppy.xml", 0.8);
    const ModelPointer scene = compile_scene(emit_scene(robot, robot.xml, settings_for(robot)));
    EXPECT_EQ(scene->vis.headlight.ambient[0] > 0.3F,
              plain.find("<headlight") != std::string::npos);
    return std::tuple(static_cast<int>(scene->nlight), plain.find("<light") != std::string::npos,
                      scene->vis.headlight.ambient[0] > 0.3F);
  };
  EXPECT_EQ(lights(""), std::tuple(1, true, true));
  EXPECT_EQ(lights("<light name=\"lamp\" pos=\"0 0 3\" dir=\"0 0 -1\"/>"),
            std::tuple(1, false, false));
  EXPECT_EQ(lights("<light pos=\"0 0 3\" active=\"false\"/>"),
            std::tuple(2, true, true));  // it is dark
}

TEST(EmitScene, HoldsWhatRidesAndNamesFeet) {
  const RobotModel robot = parse_robot(test::armed_biped(), "biped.xml");
  const ModelPointer scene = compile_scene(emit_scene(robot, robot.xml, settings_for(robot)));
  EXPECT_EQ(scene->nq, 7 + 8);
  EXPECT_EQ(scene->nactuator, 8);
  EXPECT_GE(mj_name2id(scene.get(), mjOBJ_SENSOR, "contact:left_foot"), 0);
  EXPECT_LT(mj_name2id(scene.get(), mjOBJ_SENSOR, "shoulder_angle"), 0);
  EXPECT_GE(mj_name2id(scene.get(), mjOBJ_SENSOR, "knee_angle"), 0);
  EXPECT_NEAR(scene->body_subtreemass[0], robot.morphology.total_mass(), 1e-12);
  // Stands on its soles by its servos for a while, on the floor of the scene.
  mjData* const data = mj_makeData(scene.get());
  mj_resetDataKeyframe(scene.get(), data, mj_name2id(scene.get(), mjOBJ_KEY, "gait"));
  for (int step = 0; step < 200; ++step) mj_step(scene.get(), data);
  EXPECT_GT(data->qpos[2], 0.6);
  EXPECT_EQ(data->warning[mjWARN_BADQACC].number, 0);
  mj_deleteData(data);
}

TEST(EmitScene, ReplacesServosByThePluginUnderTheSameNames) {
  const RobotModel robot = read_robot(test::puppy_file());
  SceneSettings settings = settings_for(robot);
  settings.gain_scale = 4.0;
  const auto xml = load_xml(emit_scene(robot, robot.xml, settings), "scene.xml");
  int plugins = 0;
  for_each_element(xml->root(), [&](const XmlElement& element) {
    EXPECT_FALSE(is_tag(element, "position") && !is_tag(*element.Parent()->ToElement(), "default"));
    if (!is_tag(element, "plugin") || !is_tag(*element.Parent()->ToElement(), "actuator")) return;
    EXPECT_EQ(attribute(element, "name"), robot.servos[plugins].actuator);
    EXPECT_EQ(attribute(element, "joint"), robot.servos[plugins].joint);
    EXPECT_EQ(attribute(element, "forcerange"), "-3 3");
    ++plugins;
  });
  EXPECT_EQ(plugins, 12);
  const std::string text = xml->text;
  EXPECT_NE(text.find("biasprm=\"0 -320 -1.6\""), std::string::npos);  // kp·4, kd·2
  EXPECT_NE(text.find("key=\"travel\" value=\"0 0.1 0\""), std::string::npos);
}

TEST(EmitScene, PuppyStandsOnTheFloorInItsScene) {
  const RobotModel robot = read_robot(test::puppy_file());
  const ModelPointer model = compile_scene(emit_scene(robot, robot.xml, settings_for(robot)));
  EXPECT_EQ(model->nu, 12);
  EXPECT_EQ(model->opt.integrator, mjINT_IMPLICITFAST);
  EXPECT_EQ(model->opt.cone, mjCONE_ELLIPTIC);
  EXPECT_EQ(model->opt.timestep, 0.001);
  EXPECT_EQ(model->opt.impratio, 10.0);
  EXPECT_EQ(model->vis.global.offwidth, 1280);
  EXPECT_EQ(model->vis.quality.offsamples, 4);
  const DataPointer data(mj_makeData(model.get()));
  mj_resetDataKeyframe(model.get(), data.get(), mj_name2id(model.get(), mjOBJ_KEY, "gait"));
  const double height = data->qpos[2];
  for (int i = 0; i < 1000; ++i) mj_step(model.get(), data.get());
  EXPECT_NEAR(data->qpos[2], height, 0.01);
  double weight = 0.0;
  for (const char* foot : {"FL", "FR", "HL", "HR"}) {
    const int sensor =
        mj_name2id(model.get(), mjOBJ_SENSOR, (std::string("contact:") + foot).c_str());
    ASSERT_GE(sensor, 0);
    EXPECT_GE(data->sensordata[model->sensor_adr[sensor]], 1.0);
    weight += data->sensordata[model->sensor_adr[sensor] + 3];
  }
  EXPECT_NEAR(weight, 9.81 * robot.morphology.total_mass(), 0.5);
  for (int w = 0; w < mjNWARNING; ++w) EXPECT_EQ(data->warning[w].number, 0) << w;
  const int tracking = mj_name2id(model.get(), mjOBJ_SENSOR, "tracking");
  ASSERT_GE(tracking, 0);
  EXPECT_EQ(model->sensor_dim[tracking], 12);
  const auto values = [&](const char* name) {
    const int sensor = mj_name2id(model.get(), mjOBJ_SENSOR, name);
    if (sensor < 0) return std::vector<double>();
    const mjtNum* const first = data->sensordata + model->sensor_adr[sensor];
    return std::vector<double>(first, first + model->sensor_dim[sensor]);
  };
  EXPECT_EQ(values("gait:phase").size(), 1u);
  EXPECT_EQ(values("gait:planned_contact"), std::vector<double>(4, 1.0));
  EXPECT_EQ(values("gait:measured_contact"), std::vector<double>(4, 1.0));
  EXPECT_EQ(values("gait:base_error").size(), 6u);
  const std::vector<double> share = values("gait:torque_share");
  ASSERT_EQ(share.size(), 12u);
  EXPECT_GT(*std::max_element(share.begin(), share.end()), 0.02);  // it carries itself
}

TEST(EmitScene, EveryDesignOfThePuppyCompiles) {
  const RobotModel robot = read_robot(test::puppy_file());
  std::mt19937 random(2);
  for (int trial = 0; trial < 10; ++trial) {
    const std::string xml = rewrite_robot(robot, test::random_design(robot.space, random));
    EXPECT_NO_THROW(compile_scene(emit_scene(robot, xml, settings_for(robot))));
  }
}

TEST(EmitScene, TheFloorAloneSaysHowContactsBehave) {
  const RobotModel robot = read_robot(test::puppy_file());
  SceneSettings settings = settings_for(robot);
  settings.floor_friction = 0.55;
  const ModelPointer model = compile_scene(emit_scene(robot, robot.xml, settings));
  const DataPointer data(mj_makeData(model.get()));
  mj_resetDataKeyframe(model.get(), data.get(), mj_name2id(model.get(), mjOBJ_KEY, "gait"));
  data->qpos[2] -= 0.001;
  mj_forward(model.get(), data.get());
  ASSERT_EQ(data->ncon, 4);
  for (int c = 0; c < 4; ++c) {
    EXPECT_EQ(data->contact[c].friction[0], 0.55);
    EXPECT_EQ(data->contact[c].solref[0], 0.005);
    EXPECT_EQ(data->contact[c].dim, 3);
  }
}

TEST(EmitScene, KeepsTheRobotsKeysWithoutTheirControls) {
  const RobotModel robot = read_robot(test::puppy_file());
  const ModelPointer model = compile_scene(emit_scene(robot, robot.xml, settings_for(robot)));
  const int home = mj_name2id(model.get(), mjOBJ_KEY, "home"),
            gait = mj_name2id(model.get(), mjOBJ_KEY, "gait");
  ASSERT_GE(home, 0);
  ASSERT_GE(gait, 0);
  EXPECT_EQ(model->key_qpos[home * model->nq + 7], 0.5);
  EXPECT_EQ(model->key_ctrl[home * model->nu], 0.0);  // to the plugin it would be an offset
}

/// Angles of a point from a camera's axis, to the right and up [rad].
Eigen::Vector2d seen(const mjData& data, int camera, const Vector3d& point) {
  const Vector3d v =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data.cam_xmat + 9 * camera)
          .transpose() *
      (point - Vector3d::Map(data.cam_xpos + 3 * camera));
  EXPECT_LT(v.z(), 0.0);
  return {std::atan2(v.x(), -v.z()), std::atan2(v.y(), -v.z())};
}

TEST(EmitScene, CamerasFrameTheRobotAndTheTravelGoesToTheRight) {
  for (const std::string& text : {test::read_file(test::puppy_file()), test::crooked_robot()}) {
    const RobotModel robot = parse_robot(text, "robot.xml");
    const ModelPointer model = compile_scene(emit_scene(robot, robot.xml, settings_for(robot)));
    const DataPointer data(mj_makeData(model.get()));
    if (robot.morphology.name == "puppy") mj_resetDataKeyframe(model.get(), data.get(), 0);
    mj_forward(model.get(), data.get());
    const int side = mj_name2id(model.get(), mjOBJ_CAMERA, "side"),
              track = mj_name2id(model.get(), mjOBJ_CAMERA, "track");
    const double half = model->cam_fovy[side] / 2 * std::numbers::pi / 180;
    for (const int camera : {side, track}) {
      double low = 1, high = -1;
      for (int g = 0; g < model->ngeom; ++g) {
        if (model->geom_bodyid[g] == 0) continue;
        if (camera == side && robot.morphology.name != "puppy")
          continue;  // hangs in the air without a home pose
        const Eigen::Vector2d angle = seen(*data, camera, Vector3d::Map(data->geom_xpos + 3 * g));
        EXPECT_LT(angle.cwiseAbs().maxCoeff(), half);
        low = std::min(low, angle.y());
        high = std::max(high, angle.y());
      }
      const Eigen::Vector2d ahead = seen(*data, camera, Vector3d(0, 0.05, 0.1)) -
                                    seen(*data, camera, Vector3d(0, -0.05, 0.1));
      EXPECT_GT(ahead.x(), 0.05);
    }
    const auto axes = [&](int camera) {
      return Eigen::Matrix<double, 9, 1>::Map(data->cam_xmat + 9 * camera);
    };
    EXPECT_LT((axes(side) - axes(track)).norm(), 1e-6);  // also where the trunk is drawn turned
  }
}

TEST(EmitScene, OneClassForEachPairOfGains) {
  const RobotModel robot = parse_robot(test::crooked_robot(), "crooked.xml");
  const ModelPointer model = compile_scene(emit_scene(robot, robot.xml, settings_for(robot)));
  for (std::size_t a = 0; a < robot.servos.size(); ++a) {
    EXPECT_NEAR(model->actuator_biasprm[mjNBIAS * a + 1], -robot.servos[a].kp, 1e-12);
    EXPECT_NEAR(model->actuator_biasprm[mjNBIAS * a + 2], -robot.servos[a].kd, 1e-12);
    EXPECT_EQ(model->actuator_gear[6 * a], 1.0);
    EXPECT_EQ(model->actuator_forcelimited[a] != 0, std::isfinite(robot.servos[a].torque_limit));
  }
}

/// The plugin holds the knees through their pistons, with the stiffness of the tendon.
TEST(EmitScene, PistonPuppyStandsOnItsTendons) {
  const RobotModel robot = parse_robot(test::named_robot("piston_puppy"), "piston_puppy.xml");
  const ModelPointer model = compile_scene(emit_scene(robot, robot.xml, settings_for(robot)));
  const int piston = mj_name2id(model.get(), mjOBJ_ACTUATOR, "HL_piston");
  ASSERT_GE(piston, 0);
  EXPECT_EQ(model->actuator_trntype[piston], mjTRN_TENDON);
  EXPECT_EQ(model->actuator_biasprm[mjNBIAS * piston + 1], -90000.0);
  EXPECT_EQ(model->actuator_forcerange[2 * piston + 1], 120.0);
  const DataPointer data(mj_makeData(model.get()));
  mj_resetDataKeyframe(model.get(), data.get(), mj_name2id(model.get(), mjOBJ_KEY, "gait"));
  mj_forward(model.get(), data.get());
  const double height = data->qpos[2], length = data->ten_length[0];
  for (int i = 0; i < 1000; ++i) mj_step(model.get(), data.get());
  EXPECT_NEAR(data->qpos[2], height, 0.01);
  EXPECT_NEAR(data->ten_length[0], length, 1e-3);
  EXPECT_NEAR(data->qpos[8], -1.0, 0.05);
  for (int w = 0; w < mjNWARNING; ++w) EXPECT_EQ(data->warning[w].number, 0) << w;
}

TEST(EmitScene, RefusesSettingsThatDoNotFitAndRepeatsItself) {
  const RobotModel robot = read_robot(test::puppy_file());
  const SceneSettings good = settings_for(robot);
  EXPECT_EQ(emit_scene(robot, robot.xml, good), emit_scene(robot, robot.xml, good));
  SceneSettings bad = good;
  bad.start_qpos = bad.start_qpos.head(5).eval();
  EXPECT_THROW(emit_scene(robot, robot.xml, bad), std::invalid_argument);
  bad = good;
  bad.period = 0.0;
  EXPECT_THROW(emit_scene(robot, robot.xml, bad), std::invalid_argument);
  bad = good;
  bad.gain_scale = std::nan("");
  EXPECT_THROW(emit_scene(robot, robot.xml, bad), std::invalid_argument);
  EXPECT_THROW(emit_scene(robot, test::crooked_robot(), good), std::invalid_argument);
}

}  // namespace
}  // namespace legwright
