// SPDX-License-Identifier: Apache-2.0
#include "tools/render/run_pictures.hpp"
#include "tests/support/paths.hpp"

#include <filesystem>
#include <map>

#include "mjcf/text/input_error.hpp"
#include "plugin/trajectory.hpp"
#include "tests/tools/render/toy_scene.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/image/picture_origin.hpp"
#include "tools/image/png.hpp"
#include "tools/image/webp.hpp"
#include "tools/render/gait_clip.hpp"
#include "tools/run/judged_sums.hpp"
#include "tools/run/metrics_record.hpp"
#include "tools/run/run_record.hpp"
#include "tools/run/verdict_record.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

void write_run_json(const fs::path& run, bool motion_only) {
  auto record = read_record_file<RunRecord>(fs::path(test::source_dir()) /
                                            "tests/tools/report/data/run.json");
  record.motion_only = motion_only;
  write_json(run / "run.json", json_of(record));
}

/// A run folder of toys: two iterations and a result.
fs::path toy_run(const std::string& name, bool validated) {
  const fs::path run = fs::path(testing::TempDir()) / name;
  fs::remove_all(run);
  Trajectory plan = blank_trajectory({"left", "right"}, {"L", "R"}, 4, 0.4);
  plan.travel = {0.0, 0.04, 0.0};
  for (int k = 0; k < 4; ++k) {
    plan.at(k, plan.root_column(1)) = 0.01 * k;
    plan.at(k, plan.root_column(2)) = 0.28;
    plan.at(k, plan.target_column(0)) = 0.2 * (k % 2);
  }
  for (const char* folder :
       {"iterations/0000", "iterations/0001", "iterations/.0002.tmp", "result"}) {
    fs::create_directories(run / folder);
    write_file(run / folder / "scene.xml", kToyScene);
    write_file(run / folder / "motion.csv", write_motion_csv(plan));
  }
  write_run_json(run, false);
  if (validated) {
    for (const char* who : {"initial", "result"}) {
      write_file(
          run / "result" / (std::string("playback_") + who + ".csv"),
          "time_s,x,y,z,qw,qx,qy,qz,l,r\n0,0,0,0.28,1,0,0,0,0,0\n2,0,0.1,0.28,1,0,0,0,0.2,0\n"
          "4,0,0.2,0.28,1,0,0,0,0,0.2\n");
    }
    MetricsRecord metrics;
    metrics.initial.of("default").feet.resize(1);
    FootMetrics& foot = metrics.initial.of("default").feet[0];
    foot.name = "L";
    foot.planned = {{0.0, 0.2}};
    foot.contacts = {{0.0, 0.3}, {0.4, 2.0}};
    metrics.result = metrics.initial;
    write_json(run / "result" / "metrics.json", json_of(metrics));
    VerdictRecord verdict;
    verdict.result.pass = verdict.pass = true;
    write_json(run / "result" / "verdict.json", json_of(verdict));
  }
  return run;
}

std::map<std::string, std::string> pictures(const fs::path& run) {
  std::map<std::string, std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(run)) {
    if (entry.path().extension() == ".png" || entry.path().extension() == ".webp")
      found[fs::relative(entry.path(), run).string()] = read_file(entry.path());
  }
  return found;
}

TEST(RunPictures, AreCompleteAndTheSameEachTime) {
  LEGWRIGHT_NEEDS_GL();
  const fs::path run = toy_run("pictures_complete", true);
  const RunPictures first = draw_run(run);
  EXPECT_TRUE(first.left_out.empty());
  const auto before = pictures(run);
  EXPECT_EQ(before.size(), 9U);
  EXPECT_EQ(first.made.size(), 9U);
  for (const char* name :
       {"iterations/0000/frame.png", "iterations/0001/frame.png", "result/strip_initial.png",
        "result/strip_result.png", "result/strip_before_after.png", "result/strip_physics.png",
        "result/overlay.png", "result/contact_timeline.png", "result/gait.webp"}) {
    EXPECT_TRUE(before.contains(name)) << name;
  }
  EXPECT_EQ(draw_run(run).made.size(), 7U);  // stills of iterations are there already
  EXPECT_EQ(pictures(run), before);
  fs::remove(run / "result" / "metrics.json");  // as an older version left it
  const RunPictures again = draw_run(run, {.all = true});
  EXPECT_EQ(again.made.size(), 8U);
  ASSERT_EQ(again.left_out.size(), 1U);
  EXPECT_NE(again.left_out[0].find("contact_timeline.png"), std::string::npos);
}

TEST(RunPictures, CarryTheSumsOfWhatTheyShow) {
  LEGWRIGHT_NEEDS_GL();
  const fs::path run = toy_run("pictures_with_sums", true);
  draw_run(run, {.phases = {0.5}});
  const JudgedSums here = sums_of_run(run);
  const auto standing = [&](const std::string& name) {
    const bool frame = name.ends_with("frame.png");
    const fs::path folder = frame ? (run / name).parent_path() : run;
    return standing_of_picture(picture_origin(run / name), folder, frame ? JudgedSums() : here);
  };
  const auto made = pictures(run);
  ASSERT_EQ(made.size(), 11U);
  for (const auto& [name, bytes] : made) EXPECT_EQ(standing(name), Standing::of_this) << name;
  // Another verdict: what shows physics is of another. Another design: its frame is drawn anew.
  auto verdict = read_record_file<VerdictRecord>(run / "result/verdict.json");
  verdict.result.line += " once more";
  write_json(run / "result/verdict.json", json_of(verdict));
  write_file(run / "iterations/0001/scene.xml", std::string(kToyScene) + "<!-- other -->");
  for (const auto& [name, bytes] : made) {
    const bool other = name == "iterations/0001/frame.png" || name == "result/strip_physics.png" ||
                       name == "result/overlay.png" || name == "result/contact_timeline.png" ||
                       name == "result/gait.webp";
    EXPECT_EQ(standing(name), other ? Standing::of_another : Standing::of_this) << name;
  }
  EXPECT_EQ(draw_run(run).made.front().file, run / "iterations/0001/frame.png");
  EXPECT_EQ(standing("iterations/0001/frame.png"), Standing::of_this);
}

TEST(RunPictures, StillsAtPhasesAlone) {
  LEGWRIGHT_NEEDS_GL();
  const fs::path run = toy_run("pictures_phases", false);
  EXPECT_EQ(draw_run(run, {.phases = {0.0, 0.25}, .only_phases = true}).made.size(), 4U);
  const auto made = pictures(run);
  EXPECT_EQ(made.size(), 4U);
  for (const char* name : {"result/still_0.png", "result/still_before_after_0.png",
                           "result/still_0.25.png", "result/still_before_after_0.25.png"})
    EXPECT_TRUE(made.contains(name)) << name;
  EXPECT_NE(made.at("result/still_0.png"), made.at("result/still_0.25.png"));
}

TEST(RunPictures, SmallIsOneSmallPictureOfTheResultAlone) {
  LEGWRIGHT_NEEDS_GL();
  const fs::path run = toy_run("pictures_small", false);
  ASSERT_EQ(draw_run(run, {.only_small = true}).made.size(), 1U);
  const auto made = pictures(run);
  ASSERT_EQ(made.size(), 1U);
  const std::string& bytes = made.at("result/small.webp");
  const Animation small = decode_webp({bytes.begin(), bytes.end()});
  ASSERT_EQ(small.frames.size(), 1U);
  EXPECT_EQ(small.frames[0].width, 213);
  EXPECT_EQ(small.frames[0].height, 160);
  EXPECT_LT(bytes.size(), 10'000U);
  draw_run(run, {.only_small = true});
  EXPECT_EQ(pictures(run), made);
}

TEST(RunPictures, MotionOnlyHasOneRobot) {
  LEGWRIGHT_NEEDS_GL();
  const fs::path run = toy_run("pictures_motion_only", false);
  draw_run(run);
  const Image two_rows = read_png(run / "result" / "strip_before_after.png");
  write_run_json(run, true);
  draw_run(run, {.phases = {0.5}});
  const Image one_row = read_png(run / "result" / "strip_before_after.png");
  EXPECT_LT(one_row.height, two_rows.height);
  EXPECT_EQ(one_row, read_png(run / "result" / "strip_result.png"));
  EXPECT_FALSE(fs::exists(run / "result" / "still_before_after_0.5.png"));
  EXPECT_EQ(load_clips(run).front().title.find("co-designed"), std::string::npos);
}

TEST(RunPictures, TellWhatTheyLeaveOut) {
  LEGWRIGHT_NEEDS_GL();
  const fs::path run = toy_run("pictures_not_validated", false);
  const RunPictures drawn = draw_run(run);
  EXPECT_EQ(drawn.made.size(), 6U);
  ASSERT_EQ(drawn.left_out.size(), 3U);
  for (const std::string& missing : drawn.left_out)
    EXPECT_NE(missing.find("validate"), std::string::npos) << missing;
  fs::remove_all(run / "result");
  const RunPictures stopped = draw_run(run);
  EXPECT_TRUE(stopped.made.empty());
  EXPECT_EQ(stopped.left_out.size(), 1U);
}

TEST(RunPictures, NeedARun) {
  EXPECT_THROW(draw_run(fs::path(testing::TempDir()) / "no_such_run"), IoError);
  const fs::path run = toy_run("pictures_of_another_program", false);
  write_file(run / "run.json", R"({"schema":"other/run"})");
  EXPECT_THROW(draw_run(run), IoError);
}

TEST(RunPictures, AFileThatIsNotAsItsRecordSaysIsToldByItsKey) {
  const fs::path run = toy_run("pictures_no_verdict", true);
  EXPECT_EQ(load_clips(run).back().passed, true);
  for (const char* name : {"verdict.json", "metrics.json"}) {
    for (const char* damaged : {"[1]", "null", "\"PASS\""}) {
      toy_run("pictures_no_verdict", true);
      write_file(run / "result" / name, damaged);
      try {
        load_clips(run);
        FAIL() << name << " " << damaged;
      } catch (const InputError& error) {
        for (const std::string& part :
             {(run / "result" / name).string(), std::string("run `legwright validate` again")})
          EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      }
    }
  }
  const auto refused = [&](const char* name, const Json& damaged, const std::string& key) {
    toy_run("pictures_no_verdict", true);
    write_json(run / name, damaged);
    try {
      load_clips(run);
      ADD_FAILURE() << name << " " << key;
    } catch (const InputError& error) {
      const std::string told = (run / name).string() + ": " + key + ": expected ";
      EXPECT_EQ(std::string(error.what()).substr(0, told.size()), told);
    }
  };
  Json verdict = json_of(VerdictRecord()), metrics = json_of(MetricsRecord()),
       whole = read_json(run / "run.json");
  verdict["result"]["pass"] = "yes";
  refused("result/verdict.json", verdict, "result.pass");
  verdict["result"] = nullptr;
  refused("result/verdict.json", verdict, "result");
  metrics["result"] = Json::array();
  refused("result/metrics.json", metrics, "result");
  whole["motion_only"] = "no";
  refused("run.json", whole, "motion_only");
  toy_run("pictures_no_verdict", true);
  fs::remove(run / "result" / "verdict.json");
  EXPECT_EQ(load_clips(run).size(), 2U);
  EXPECT_FALSE(load_clips(run).back().passed);
}

/// The verdict of a toy run, with what it is of.
void add_sums(const fs::path& run) {
  auto verdict = read_record_file<VerdictRecord>(run / "result" / "verdict.json");
  verdict.of = sums_of_run(run);
  verdict.with.emplace();
  for (const char* name : {"metrics.json", "playback_initial.csv", "playback_result.csv"})
    verdict.with->of(name) = sha256_hex(read_file(run / "result" / name));
  write_json(run / "result" / "verdict.json", json_of(verdict));
}

TEST(RunPictures, ShowNothingThatIsOfAnotherResult) {
  const fs::path run = toy_run("pictures_of_another_result", true);
  add_sums(run);
  EXPECT_EQ(load_clips(run).back().passed, true);
  EXPECT_TRUE(load_clips(run).back().playback);
  write_file(run / "result/playback_result.csv",
             read_file(run / "result/playback_result.csv") + "6,0,0.3,0.28,1,0,0,0,0,0\n");
  EXPECT_EQ(load_clips(run).back().passed, true);
  EXPECT_FALSE(load_clips(run).back().playback) << "of another judgement";
  fs::create_directories(run / "inputs");
  write_file(run / "inputs/task.toml", "another task");
  EXPECT_FALSE(load_clips(run).back().passed);
  EXPECT_FALSE(load_clips(run).front().playback);
  LEGWRIGHT_NEEDS_GL();
  const RunPictures drawn = draw_run(run);
  ASSERT_FALSE(drawn.left_out.empty());
  EXPECT_NE(drawn.left_out[0].find("not of this result: judge again"), std::string::npos);
  EXPECT_FALSE(fs::exists(run / "result/strip_physics.png"));
}

TEST(RunPictures, AreNotPutIntoARunThatWasReplacedMeanwhile) {
  LEGWRIGHT_NEEDS_GL();
  const fs::path run = toy_run("pictures_replaced", true);
  RunPictureOptions options;
  options.on_picture = [&](const MadePicture& made) {
    if (made.file.filename() == "strip_initial.png")
      write_file(run / "result/motion.csv", read_file(run / "result/motion.csv") + "\n");
  };
  EXPECT_THROW(draw_run(run, options), IoError);
  EXPECT_TRUE(fs::exists(run / "result/strip_initial.png"));
  EXPECT_FALSE(fs::exists(run / "result/strip_result.png"));
}

TEST(RunPictures, DamagedFilesAreReportedWithTheirPathAndAWayOut) {
  LEGWRIGHT_NEEDS_GL();
  const std::pair<const char*, const char*> files[] = {{"iterations/0000/scene.xml", "optimize"},
                                                       {"result/scene.xml", "optimize"},
                                                       {"result/motion.csv", "optimize"},
                                                       {"result/playback_result.csv", "validate"}};
  for (const auto& [name, verb] : files) {
    const fs::path run = toy_run("pictures_damaged", true);
    write_file(run / name, "<mujoco");
    try {
      draw_run(run);
      FAIL() << name;
    } catch (const InputError& error) {
      for (const std::string& part :
           {(run / name).string(), "run `legwright " + std::string(verb) + "` again"})
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace legwright
