// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/mujoco_host.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <functional>

#include "plugin/spline.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/simulate/tiny_scene.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/simulate/scene.hpp"

namespace legwright {
namespace {

constexpr const char* kPlain = "<mujoco><worldbody><geom size='0.1'/></worldbody></mujoco>";

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const MujocoError& error) {
    return error.what();
  }
  return "";
}

void expect_words(const std::string& message, std::initializer_list<const char*> words) {
  for (const char* word : words)
    EXPECT_NE(message.find(word), std::string::npos) << word << " in: " << message;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(MujocoHost, LeavesTrianglesToWhoLooksAtThem) {
  const test::TemporaryFolder folder;
  // A tetrahedron, and in it a vertex that is no corner of its hull.
  write_file(folder.path() / "m.obj",
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv .3 .3 .1\n"
             "f 1 2 4\nf 1 4 3\nf 2 3 4\nf 1 3 5\nf 3 2 5\nf 2 1 5\n");
  const std::string xml =
      "<mujoco><asset><mesh name=\"m\" file=\"m.obj\"/></asset><worldbody>"
      "<geom type=\"mesh\" mesh=\"m\"/></worldbody></mujoco>";
  EXPECT_EQ(compile_model(xml, "m", folder.path(), MeshDetail::triangles)->mesh_facenum[0], 6);
  EXPECT_EQ(compile_model(xml, "m", folder.path())->mesh_facenum[0], 12);
}

TEST(MujocoHost, CompilesAModel) { EXPECT_EQ(compile_model(kPlain, "plain")->ngeom, 1); }

/// Nobody looks at a model that is only played: what is only to be seen is not in it, painted
/// textures of the others are two pixels wide, and the physics is the same.
TEST(MujocoHost, WhatIsOnlySeenIsLeftOutAndThePhysicsIsTheSame) {
  const std::string painted =
      "<mujoco><asset>"
      "<texture name='floor' type='2d' builtin='checker' width='300' height='200' rgb1='1 1 1'/>"
      "<texture name='ball' type='cube' builtin='flat' mark='random' width='64' height='64'/>"
      "<texture type='skybox' builtin='gradient' width='128' height='768'/>"
      "<mesh name='m' vertex='0 0 0 1 0 0 0 1 0 0 0 1'/>"
      "<material name='floor' texture='floor'/><material name='ball' texture='ball'/></asset>"
      "<worldbody><geom type='plane' size='1 1 0.1' material='floor'/>"
      "<body pos='0 0 0.5'><freejoint/><geom size='0.1' material='ball'/>"
      "<geom name='shell' type='mesh' mesh='m' contype='0' conaffinity='0'/>"
      "<geom name='paired' size='0.05' pos='0 0.2 0' contype='0' conaffinity='0'/>"
      "<geom type='box' size='0.1 0.05 0.02' pos='0.1 0 0'/></body>"
      "<geom name='step' type='box' size='0.3 0.3 0.05' contype='0' conaffinity='0'/></worldbody>"
      "<contact><pair geom1='paired' geom2='step'/></contact></mujoco>";
  const auto end_of = [](const mjModel& model) {
    const DataPointer data = make_data(model);
    for (int step = 0; step < 400; ++step) mj_step(&model, data.get());
    return std::vector<double>(data->qpos, data->qpos + model.nq);
  };
  const ModelPointer played = compile_model(painted, "painted"),
                     seen = compile_model(painted, "painted", {}, MeshDetail::triangles);
  const SpecPointer spec(mj_parseXMLString(painted.c_str(), nullptr, nullptr, 0));
  const ModelPointer whole(mj_compile(spec.get(), nullptr));
  ASSERT_TRUE(whole);
  EXPECT_LT(100 * seen->ntexdata, whole->ntexdata);
  EXPECT_EQ(seen->ntex, whole->ntex);
  EXPECT_EQ(seen->nmat, whole->nmat);
  EXPECT_EQ(end_of(*seen), end_of(*whole));
  EXPECT_EQ(played->nmesh + played->ntex + played->nmat, 0);
  EXPECT_EQ(mj_name2id(played.get(), mjOBJ_GEOM, "shell"), -1);
  EXPECT_GE(mj_name2id(played.get(), mjOBJ_GEOM, "paired"), 0);
  EXPECT_EQ(end_of(*played), end_of(*whole));
}

TEST(MujocoHost, SaysWhatMujocoRefuses) {
  expect_words(message_of([] { compile_model("<mujoco><worldbody>", "cut.xml"); }),
               {"cut.xml", "cannot read"});
  const auto no_size = "<mujoco><worldbody><geom type='box'/></worldbody></mujoco>";
  expect_words(message_of([&] { compile_model(no_size, "box.xml"); }),
               {"box.xml", "cannot compile", "size"});
}

TEST(MujocoHost, EngineErrorIsAnExceptionWhereMessagesAreKept) {
  const MujocoMessages messages;
  EXPECT_THROW(mju_error("on purpose"), MujocoError);
}

TEST(MujocoHost, KeepsWarningsAndWritesNoLog) {
  std::filesystem::remove("MUJOCO_LOG.TXT");
  const MujocoMessages outer;
  {
    const MujocoMessages inner;
    mju_warning("watch out");
    ASSERT_EQ(inner.warnings().size(), 1U);
    expect_words(inner.warnings()[0], {"watch out"});
  }
  EXPECT_TRUE(outer.warnings().empty());
  EXPECT_FALSE(std::filesystem::exists("MUJOCO_LOG.TXT"));
}

TEST(GaitPlugin, LoadsOnceHoweverOftenItIsAskedFor) {
  load_gait_plugin();
  const int count = mjp_pluginCount();
  load_gait_plugin();
  EXPECT_EQ(mjp_pluginCount(), count);
  EXPECT_NE(mjp_getPlugin("legwright.gait", nullptr), nullptr);
}

// In a process of its own, in which the plugin is not loaded yet.
int exit_code_with_plugin(const std::string& file) {
  setenv("LEGWRIGHT_PLUGIN", file.c_str(), 1);
  try {
    load_gait_plugin();
  } catch (const IoError& error) {  // exit code 3, as for every file that is not there
    fprintf(stderr, "%s", error.what());
    return 7;
  }
  return 0;
}

TEST(GaitPluginDeathTest, MissingPluginIsReportedWithThePlaces) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(std::exit(exit_code_with_plugin("/nonexistent/gait.so")), testing::ExitedWithCode(7),
              "LEGWRIGHT_PLUGIN[^$]*/nonexistent/gait.so");
}

TEST(GaitPluginDeathTest, FileThatIsNoLibraryIsReportedAndDoesNotEndTheProcess) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(std::exit(exit_code_with_plugin(test::source_dir() + "/README.md")),
              testing::ExitedWithCode(7), "cannot be loaded");
}

TEST(GaitPluginDeathTest, APluginForAnotherMujocoIsNotLoaded) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "gait.so").string();
  write_file(file, "legwright.gait for MuJoCo 9.8.7");
  EXPECT_EXIT(std::exit(exit_code_with_plugin(file.c_str())), testing::ExitedWithCode(7),
              "unset LEGWRIGHT_PLUGIN[^$]*gait.so, which serves MuJoCo 9.8.7");
}

TEST(Scene, FindsWhatIsMeasured) {
  const Scene scene = parse_scene(TinyScene{}.xml(), "tiny");
  EXPECT_EQ(scene.trajectory.foot_count(), 4);
  EXPECT_EQ(scene.foot_geom.size(), 4U);
  ASSERT_EQ(scene.torque_limit.size(), 1U);
  EXPECT_DOUBLE_EQ(scene.torque_limit[0], 1.0);
}

/// Clock attributes that someone has put into the scene: the plan that is measured is the one
/// played.
TEST(Scene, SpeedAndPhaseOfTheClockAreInThePlan) {
  const std::string config = "<config key=\"kp\"";
  const Scene plain = parse_scene(TinyScene{}.xml(), "tiny");
  const Scene fast = parse_scene(
      replaced(TinyScene{}.xml(), config,
               "<config key='speed' value='2'/><config key='phase' value='0.25'/>" + config),
      "fast");
  EXPECT_DOUBLE_EQ(plain.trajectory.period, 0.4);
  EXPECT_DOUBLE_EQ(fast.trajectory.period, 0.2);
  EXPECT_DOUBLE_EQ(fast.t0, 0.05);
  for (const double time : {0.0, 0.03, 0.19, 1.01}) {
    const int column = plain.trajectory.target_column(0);
    const SplinePoint slow =
        spline_point(plain.trajectory, phase_at(plain.trajectory, 0.1 + 2 * time), column);
    const SplinePoint point =
        spline_point(fast.trajectory, phase_at(fast.trajectory, fast.t0 + time), column);
    EXPECT_NEAR(point.value, slow.value, 1e-12);
    EXPECT_NEAR(point.rate, 2 * slow.rate, 1e-10);
  }
  expect_words(message_of([&] {
                 parse_scene(replaced(TinyScene{}.xml(), config,
                                      "<config key='speed' value='-1'/>" + config),
                             "a.xml");
               }),
               {"a.xml", "speed", "more than 0"});
}

TEST(Scene, WithoutPluginIsRefusedWithAWayOut) {
  expect_words(message_of([] { parse_scene(kPlain, "plain.xml"); }),
               {"plain.xml", "legwright.gait", "optimize"});
}

TEST(Scene, WithoutStartOrFootIsRefused) {
  const std::string xml = TinyScene{}.xml();
  expect_words(message_of([&] {
                 parse_scene(replaced(xml, "key name=\"gait\"", "key name=\"other\""), "a.xml");
               }),
               {"a.xml", "keyframe", "gait"});
  expect_words(
      message_of([&] { parse_scene(replaced(xml, "geom name='FL'", "geom name='X'"), "a.xml"); }),
      {"a.xml", "FL"});
}

TEST(Scene, FaultOfThePluginsDataReachesTheMessage) {
  expect_words(message_of([&] {
                 parse_scene(replaced(TinyScene{}.xml(), "tail_rad", "tail_deg"), "a.xml");
               }),
               {"a.xml", "tail_deg"});
}

TEST(Gains, ScaleInConfigurationAndClassAlike) {
  const std::string xml = TinyScene{}.xml();
  const std::string scaled = scale_gains(xml, 4.0, "tiny");
  expect_words(scaled,
               {"key=\"kp\" value=\"8\"", "key=\"kd\" value=\"0.1\"", "biasprm=\"0 -8 -0.1\""});
  EXPECT_EQ(scale_gains(xml, 1.0, "tiny"), xml);
  const Scene scene = parse_scene(xml, "tiny", 0.5);  // the plugin itself compares both places
  EXPECT_DOUBLE_EQ(scene.model->actuator_biasprm[1], -1.0);
  EXPECT_DOUBLE_EQ(scene.gain_scale, 0.5);
}

TEST(Gains, SceneOfAnotherShapeIsRefused) {
  const std::string xml = TinyScene{}.xml();
  expect_words(message_of([&] { scale_gains(kPlain, 2.0, "a.xml"); }), {"a.xml", "kp"});
  expect_words(
      message_of([&] { scale_gains(replaced(xml, "value=\"2\"", "value=\"2x\""), 2.0, "a.xml"); }),
      {"a.xml", "2x"});
  expect_words(message_of([&] { scale_gains("<mujoco", 2.0, "a.xml"); }), {"a.xml"});
}

}  // namespace
}  // namespace legwright
