// SPDX-License-Identifier: Apache-2.0
// The viewers as people meet them: programs with a window, on a screen that only a test looks at.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "tests/support/paths.hpp"
#include "tests/tools/viewer/display.hpp"
#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::Colour;
using test::Program;
using test::Screenshot;
using test::TemporaryFolder;
using test::VirtualDisplay;
using test::wait_until;

const std::string kLegwright = test::program();
const std::string kSimulate = LEGWRIGHT_SIMULATE;
const std::string kViewer = LEGWRIGHT_VIEWER_PROGRAM;
const fs::path kTask = fs::path(test::source_dir()) / "examples" / "puppy" / "sideways.toml";

#define SKIP_WITHOUT_DISPLAY()      \
  if (!VirtualDisplay::available()) \
  GTEST_SKIP() << "NO VIEWER TESTED: Xvfb is missing, run tools/setup"

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The puppy's trunk, lit or in shadow. Nothing else of a window is orange.
bool orange(const Colour& c) {
  return c[0] > 120 && c[1] > c[0] / 3 && c[1] < c[0] * 4 / 5 && c[2] < c[0] / 3;
}

bool has_title(const VirtualDisplay& display, const std::string& title) {
  const auto titles = display.titles();
  return std::find(titles.begin(), titles.end(), title) != titles.end();
}

/// A run of the puppy, of a second: the motion of the initial design.
fs::path make_run(const VirtualDisplay& display, const fs::path& folder) {
  Program optimize(display,
                   {kLegwright, "optimize", kTask.string(), "--plan-only", "--max-iterations", "0",
                    "--no-pictures", "-o", (folder / "run").string()});
  const int code = optimize.wait();
  EXPECT_TRUE(code == 0 || code == 1) << optimize.output();
  return folder / "run";
}

/// The scene without shadows: software draws them, and these tests do not look at them.
std::string light_scene(const fs::path& run) {
  std::string scene = read_file(run / "result" / "scene.xml");
  const std::string dear = "shadowsize=\"2048\" offsamples=\"4\"";
  const std::size_t at = scene.find(dear);
  EXPECT_NE(at, std::string::npos) << "the scene's quality is written in another way";
  return at == std::string::npos
             ? scene
             : scene.replace(at, dear.size(), "shadowsize=\"0\" offsamples=\"0\"");
}

/// Lands as designs of a run do: whole, by a rename.
void land(const fs::path& run, int index, const std::string& scene) {
  std::string name = std::to_string(index);
  name.insert(0, 4 - name.size(), '0');
  const fs::path temporary = run / "iterations" / ("." + name + ".tmp");
  fs::create_directories(temporary);
  write_file(temporary / "scene.xml", scene);
  fs::rename(temporary, run / "iterations" / name);
}

TEST(Simulate, ListsThePluginAndLoadsAScene) {
  SKIP_WITHOUT_DISPLAY();
  const VirtualDisplay display(480, 360);
  const TemporaryFolder folder;
  const fs::path run = make_run(display, folder.path());
  Program play(display, {kLegwright, "play", "--viewer", "simulate", run.string()});
  ASSERT_TRUE(wait_until([&] { return has_title(display, "MuJoCo : puppy") || !play.running(); }));
  ASSERT_TRUE(display.close_window("MuJoCo : puppy")) << play.output();
  EXPECT_EQ(play.wait(), 0);
  const std::string output = play.output();
  EXPECT_TRUE(contains(output, kSimulate + " " + run.string())) << output;  // the plain command
  EXPECT_TRUE(contains(output, "liblegwright.so':")) << output;
  EXPECT_TRUE(contains(output, "\n    legwright.gait\n")) << output;
  EXPECT_FALSE(contains(output, "rror")) << output;
}

TEST(Viewer, PlaysTheResultFromItsFirstPose) {
  SKIP_WITHOUT_DISPLAY();
  const VirtualDisplay display(480, 360);
  const TemporaryFolder folder;
  const fs::path run = make_run(display, folder.path());
  Program play(display, {kLegwright, "play", run.string()});
  const std::string title = "Legwright: puppy, result";
  EXPECT_TRUE(wait_until([&] { return has_title(display, title) || !play.running(); }));
  ASSERT_TRUE(display.close_window(title)) << play.output();
  EXPECT_EQ(play.wait(), 0) << play.output();
  EXPECT_TRUE(contains(play.output(), kViewer + " " + run.string())) << play.output();
}

/// What the display shows once it has shown the same for a while.
Screenshot settled(const VirtualDisplay& display) {
  Screenshot last = display.screenshot();
  for (int same = 0; same < 8;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    Screenshot next = display.screenshot();
    same = next.pixels == last.pixels ? same + 1 : 0;
    last = std::move(next);
  }
  return last;
}

TEST(Viewer, ShowsTheRobotAndItsGhostAndStartsItAnew) {
  SKIP_WITHOUT_DISPLAY();
  const VirtualDisplay display(720, 540);
  const TemporaryFolder folder;
  const fs::path scene = folder.path() / "scene.xml";
  write_file(scene, light_scene(make_run(display, folder.path())));
  EXPECT_EQ(display.screenshot().count(orange), 0);
  Program viewer(display, {kViewer, "--paused", scene.string()});
  const std::string title = "Legwright: puppy";
  ASSERT_TRUE(wait_until([&] { return display.screenshot().count(orange) > 1000; }))
      << viewer.output();
  const Screenshot first_pose = settled(display);
  const auto differs = [&] { return display.screenshot().differing(first_pose) > 1000; };
  const auto same = [&] { return display.screenshot().pixels == first_pose.pixels; };

  ASSERT_TRUE(display.press(title, "5"));  // the ghost, in the same place: it covers the trunk
  EXPECT_TRUE(wait_until(differs));
  EXPECT_TRUE(wait_until(
      [&] { return 2 * display.screenshot().count(orange) < first_pose.count(orange); }));
  ASSERT_TRUE(display.press(title, "5"));
  EXPECT_TRUE(wait_until(same)) << "the ghost does not go away";

  ASSERT_TRUE(display.press(title, "space"));
  EXPECT_TRUE(wait_until(differs)) << "it does not walk";
  ASSERT_TRUE(display.press(title, "space"));
  // MuJoCo's own Reset would put it at qpos0, with all legs stretched.
  ASSERT_TRUE(display.press(title, "BackSpace"));
  EXPECT_TRUE(wait_until(same)) << "Reset does not lead back to the first pose";
  ASSERT_TRUE(display.close_window(title));
  EXPECT_EQ(viewer.wait(), 0) << viewer.output();
}

TEST(Viewer, StaysOpenWithTheReasonWhereASceneIsBroken) {
  SKIP_WITHOUT_DISPLAY();
  const VirtualDisplay display(480, 360);
  const TemporaryFolder folder;
  write_file(folder.path() / "scene.xml", "<mujoco>\n<worldbody>\n<geom size='1'/>\n<nonsense/>");
  Program viewer(display, {kViewer, (folder.path() / "scene.xml").string()});
  EXPECT_TRUE(wait_until([&] {
    return contains(viewer.output(), "scene.xml: XML") || !viewer.running();
  })) << viewer.output();
  EXPECT_TRUE(viewer.running());
  // The text in the window: white on a dark box over the blue of an empty view.
  const auto white = [](const Colour& c) { return c == Colour{255, 255, 255}; };
  EXPECT_TRUE(wait_until([&] { return display.screenshot().count(white) > 100; }));
  ASSERT_TRUE(display.close_window("MuJoCo"));
  EXPECT_EQ(viewer.wait(), 0) << viewer.output();
}

TEST(Live, WaitsForARunShowsItsDesignsAndItsResult) {
  SKIP_WITHOUT_DISPLAY();
  const VirtualDisplay display(480, 360);
  const TemporaryFolder folder;
  Program play(display, {kLegwright, "play", "--live", (folder.path() / "run").string()});
  EXPECT_TRUE(wait_until([&] { return contains(play.output(), "waiting for the first design"); }))
      << play.output();
  make_run(display, folder.path());
  EXPECT_TRUE(wait_until([&] {
    return contains(play.output(), "the run has ended; this is its result");
  })) << play.output();
  EXPECT_TRUE(wait_until([&] { return has_title(display, "Legwright: puppy, result"); }));
  ASSERT_TRUE(display.close_window("Legwright: puppy"));
  EXPECT_EQ(play.wait(), 0) << play.output();
}

TEST(Live, TwentyDesignsLeaveMemoryFlatAndABrokenOneIsPassedOver) {
  SKIP_WITHOUT_DISPLAY();
  const VirtualDisplay display(240, 180);
  const TemporaryFolder folder;
  const std::string scene = light_scene(make_run(display, folder.path()));
  const fs::path run = folder.path() / "live";
  Program viewer(display, {kViewer, "--live", run.string()}, "softpipe");
  std::vector<double> memory;
  const auto land_and_wait = [&](const std::string& xml, const std::string& answer) {
    const int index = static_cast<int>(memory.size());
    land(run, index, xml);
    const std::string wanted = answer + "iterations/" + std::string(index < 10 ? "000" : "00") +
                               std::to_string(index) + "/scene.xml";
    const bool answered =
        wait_until([&] { return contains(viewer.output(), wanted) || !viewer.running(); });
    memory.push_back(viewer.memory());
    return answered && viewer.running();
  };
  constexpr int kWarmUp = 5, kReloads = 20, kSome = 5;
  for (int index = 0; index < kWarmUp + kReloads; ++index)
    ASSERT_TRUE(land_and_wait(
        scene, "loaded iteration " + std::to_string(index) + ", " + run.string() + "/"))
        << viewer.output();
  const auto least = [&](int first) {
    return *std::min_element(memory.begin() + first, memory.begin() + first + kSome);
  };
  const double growth = least(kWarmUp + kReloads - kSome) - least(kWarmUp);
  RecordProperty("growth_MiB", std::to_string(growth));
#ifndef LEGWRIGHT_SANITIZED  // which keeps what is freed
  EXPECT_LT(growth, 3.0);    // the data of each design, kept, would be 4
#endif
  EXPECT_GT(memory.back(), 50.0);  // of a program that does run and draw

  ASSERT_TRUE(land_and_wait("<mujoco><worldbody/></broken>", run.string() + "/"))
      << viewer.output();
  EXPECT_TRUE(has_title(display, "Legwright: puppy, iteration 24"));  // the one before stays
  ASSERT_TRUE(land_and_wait(scene, "loaded iteration 26, " + run.string() + "/"))
      << viewer.output();
  ASSERT_TRUE(display.close_window("Legwright: puppy"));
  EXPECT_EQ(viewer.wait(), 0) << viewer.output();
}

}  // namespace
}  // namespace legwright
