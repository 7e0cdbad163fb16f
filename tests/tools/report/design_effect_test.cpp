// SPDX-License-Identifier: Apache-2.0
#include "tools/report/design_effect.hpp"
#include "tools/report/outer_words.hpp"

#include "tests/support/text.hpp"
#include "tests/tools/report/hostile_names.hpp"
#include "tests/tools/report/run_fixture.hpp"
#include "tools/files/clean_text.hpp"

namespace legwright {
namespace {

/// The fixture's run with figures for both bodies: the first walks as well unless a test says
/// otherwise.
class DesignEffect : public RunFixture {
 protected:
  void SetUp() override {
    RunFixture::SetUp();
    edit("result/metrics.json", [](Json& metrics) {
      metrics["initial"] = metrics["result"];
      set_power(metrics["initial"], 4.0, 2.0);
      set_power(metrics["result"], 3.0, 1.5);
    });
    edit("result/verdict.json",
         [](Json& verdict) { verdict["initial"]["pass"] = verdict["result"]["pass"] = true; });
    edit_run([](Json& run) {
      run["motion_only"] = false;
      run["body"] = {{"initial", {{"mass_kg", 2.0}, {"printed_volume_m3", 1e-4}}},
                     {"final", {{"mass_kg", 1.98}, {"printed_volume_m3", 8e-5}}}};
    });
  }
  static void set_power(Json& side, double power, double torque) {
    for (auto& [gain, measured] : side.items()) {
      measured["power_mean_W"] = power;
      GainMetrics metrics = record_of<GainMetrics>(measured, gain);
      metrics.joints = {{"a", 0.0, 0.5 * torque, 3.0, 0.0, 0.0}, {"b", 0.0, torque, 3.0, 0.0, 0.0}};
      metrics.feet.resize(2);
      metrics.feet[0].clearance_min = 0.02;
      metrics.feet[1].clearance_min = 0.01 * torque;
      measured = json_of(metrics);
    }
  }
  const EffectRow& row(const std::string& what) {
    rows_ = effect_rows(read_run(run_));
    for (const EffectRow& each : rows_)
      if (each.what == what) return each;
    ADD_FAILURE() << "no row: " << what;
    static const EffectRow none;
    return none;
  }
  bool has_row(const std::string& what) {
    for (const EffectRow& each : effect_rows(read_run(run_)))
      if (each.what == what) return true;
    return false;
  }
  std::vector<EffectRow> rows_;
};

TEST_F(DesignEffect, FiguresStandBesideEachOther) {
  EXPECT_EQ(row("mechanical power").before, "4 W");
  EXPECT_EQ(row("mechanical power").after, "3 W");
  EXPECT_NEAR(*row("mechanical power").effect.change, -0.25, 1e-12);
  EXPECT_EQ(row("peak torque of a servo").before, "2 N·m");  // of the servo that needs most
  EXPECT_EQ(row("steps over a bar of").after, "15 mm");      // by the foot that lifts least
  EXPECT_EQ(row("printed volume").after, "80 cm³");
  EXPECT_NEAR(*row("mass of the robot").effect.change, -0.01, 1e-12);
  EXPECT_EQ(row("in MuJoCo").before, "✓ passes");
}

TEST_F(DesignEffect, WhatGrewManyfoldIsToldInTimes) {
  const auto power_before = [&](double power) {
    edit("result/metrics.json", [&](Json& metrics) { set_power(metrics["initial"], power, 2.0); });
    return page();
  };
  EXPECT_TRUE(has(power_before(0.5), "+500 %"));
  EXPECT_TRUE(has(power_before(0.3), ">10 times<"));
  const std::string last = power_before(0.003);
  EXPECT_TRUE(has(last, "from next to nothing"));
  EXPECT_FALSE(has(last, "1000 times"));
  EXPECT_NEAR(*row("mechanical power").effect.change, 999.0, 1e-9);
}

TEST_F(DesignEffect, WordsNameWhatIsWorthTelling) {
  const std::string words = effect_words(read_run(run_));
  EXPECT_TRUE(in_order(words, {"Both", "25 % less peak torque of a servo",
                               "25 % less mechanical power", "20 % less printed volume"}));
  EXPECT_FALSE(has(words, "but"));
  EXPECT_EQ(count_of(words, "%"), 3U) << "mass, 1 % less, is not worth telling";
}

TEST_F(DesignEffect, ABodyThatStaysIsToldAsSuch) {
  edit_run([](Json& run) {
    for (Json& parameter : run["parameters"]) parameter["final"] = parameter["initial"];
    run["choice"] = {{"chosen", "initial, tightened motion: larger margins"},
                     {"pass", true},
                     {"candidates", Json::array()},
                     {"rollouts", 0},
                     {"seconds", 0.0}};
  });
  edit("result/verdict.json", [](Json& verdict) { verdict["initial"]["pass"] = false; });
  const RunData data = read_run(run_);
  EXPECT_TRUE(has(effect_words(data), "The body stays as it is: it does the task in MuJoCo once"));
  const std::string text = page();
  EXPECT_TRUE(has(text, "Why the body did not change"));
  EXPECT_TRUE(has(text, "the same body, its gait tightened"));
  EXPECT_FALSE(has(text, "What changed in the body"));
  EXPECT_TRUE(has(text, "so the difference is the gait’s."));
  EXPECT_TRUE(in_order(text, {"Why the body did not change", "What it does", "mechanical power"}));
  EXPECT_FALSE(has(text, "buys most"));
  EXPECT_TRUE(has(report_summary(data), "after: the same body, its gait tightened"));
}

TEST_F(DesignEffect, NothingIsSaidToStayBeforeTheEnd) {
  edit_run([](Json& run) {
    for (Json& parameter : run["parameters"]) parameter["final"] = parameter["initial"];
    run["status"] = "running";
  });
  EXPECT_FALSE(read_run(run_).run.body_kept());
  EXPECT_FALSE(has(page(), "did not change"));
  EXPECT_FALSE(has(report_summary(read_run(run_)), "the same body"));
}

/// The order and its words are those of "What changed in the body": by what each buys.
TEST_F(DesignEffect, TheBodyIsToldByWhatBuysMost) {
  const std::string words = body_words(read_run(run_));
  EXPECT_TRUE(in_order(words, {"buys most", "front hip axis roll from 0° to 80.2°", "4 parameters",
                               "1 stands", "Printed parts"}));
  EXPECT_EQ(count_of(words, " from "), 1U) << "one is worth a sentence";
  const std::string text = page();
  EXPECT_TRUE(has(text, "The changes that buy most"));
  EXPECT_TRUE(has(text, "at its upper bound; put back alone, F rises by 10.5"));
  EXPECT_LT(text.find("front hip axis roll +80.2°"), text.find("front thigh length +6.6 mm"));
  EXPECT_TRUE(has(report_summary(read_run(run_)), "| buys most (F, put back alone) |"));
}

TEST_F(DesignEffect, WithoutRowsTheBodyIsToldByShareOfTheRange) {
  edit_run([](Json& run) {
    run.erase("put_back");
    run["body"]["initial"].erase("printed_volume_m3");
    run["parameters"][2]["final"] = 1.3;
  });
  const std::string words = body_words(read_run(run_));
  EXPECT_TRUE(in_order(
      words, {"front hip axis roll from 0° to 74.5°", "body width from 140.0 mm to 115.3 mm",
              "front thigh length from 60.0 mm to 66.6 mm", "No part is printed"}));
  EXPECT_FALSE(has(words, "cost"));
  EXPECT_FALSE(has(words, "bound"));
  EXPECT_TRUE(has(page(), "by share of the allowed range"));
  edit_run([](Json& run) {  // twin: without a length nothing is said of masses
    for (const int k : {0, 3}) run["parameters"][k]["final"] = run["parameters"][k]["initial"];
  });
  EXPECT_FALSE(has(body_words(read_run(run_)), "mass"));
}

TEST_F(DesignEffect, TheHeadlineNamesWhatGotWorseMostOfAll) {
  edit_run([](Json& run) {
    run["body"]["final"]["printed_volume_m3"] = 1.22e-4;
    run["body"]["final"]["mass_kg"] = 2.2;
  });
  const std::string words = effect_words(read_run(run_));
  EXPECT_TRUE(in_order(words, {"25 % less peak torque of a servo", "25 % less mechanical power",
                               "but 22 % more printed volume"}));
  EXPECT_EQ(count_of(words, "%"), 3U);
  edit("result/metrics.json", [](Json& metrics) {
    for (auto& [gain, measured] : metrics["initial"].items()) measured["tilt_max_rad"] = 0.03;
    for (auto& [gain, measured] : metrics["result"].items()) measured["tilt_max_rad"] = 0.05;
  });
  EXPECT_TRUE(has(effect_words(read_run(run_)), "but largest tilt 2.86° instead of 1.72°"));
  edit("result/metrics.json", [](Json& metrics) {  // twin: too little to be worth a word
    for (auto& [gain, measured] : metrics["result"].items()) measured["tilt_max_rad"] = 0.038;
  });
  EXPECT_TRUE(has(effect_words(read_run(run_)), "but 22 % more printed volume"));
}

TEST_F(DesignEffect, AStepThatIsLowerIsWorseWhereTheTaskAsksForOne) {
  EXPECT_FALSE(has(effect_words(read_run(run_)), "steps over"));
  edit_run([](Json& run) { run["task"]["step_over_m"] = 0.01; });
  EXPECT_TRUE(in_order(effect_words(read_run(run_)),
                       {"printed volume", "but steps over a bar of 15 mm instead of 20 mm"}));
}

TEST_F(DesignEffect, ABodyThatFallsHasNoFigures) {
  edit("result/metrics.json", [](Json& metrics) {
    metrics["initial"]["half"]["fall"] = {{"time_s", 1.0}, {"cause", "trunk on the ground"}};
    metrics["initial"]["default"]["fall"] = metrics["initial"]["half"]["fall"];
  });
  edit("result/verdict.json", [](Json& verdict) { verdict["initial"]["pass"] = false; });
  EXPECT_EQ(row("mechanical power").before, "–");
  EXPECT_EQ(row("mechanical power").after, "3 W");
  EXPECT_FALSE(row("mechanical power").effect.change);
  EXPECT_EQ(row("in MuJoCo").before, "✗ falls at 2 of the gains");
  EXPECT_EQ(row("steps over a bar of").before, "–");
  EXPECT_TRUE(in_order(effect_words(read_run(run_)), {"co-designed", "20 % less printed volume"}));
}

TEST_F(DesignEffect, SaysSoWhereNothingWasBought) {
  edit("result/verdict.json", [](Json& verdict) { verdict["result"]["pass"] = false; });
  EXPECT_TRUE(has(effect_words(read_run(run_)), "nothing was bought"));
  edit("result/verdict.json", [](Json& verdict) { verdict["initial"]["pass"] = false; });
  EXPECT_EQ(effect_words(read_run(run_)), "Neither body does the task in MuJoCo.");
}

TEST_F(DesignEffect, WithoutPhysicsThereAreMassesAndCosts) {
  for (const char* file : {"metrics.json", "verdict.json"})
    std::filesystem::remove(run_ / "result" / file);
  EXPECT_FALSE(has_row("mechanical power"));
  EXPECT_TRUE(has_row("printed volume"));
  EXPECT_TRUE(has_row("cost of the gait, F"));
  EXPECT_EQ(effect_words(read_run(run_)), "");
  EXPECT_TRUE(has(page(), "has not been measured yet"));
  expect_well_formed(page());
}

TEST_F(DesignEffect, ThePageAndTheSummaryAnswer) {
  const std::string text = page();
  EXPECT_TRUE(has(text, "<h2>Why the body changed</h2>"));
  EXPECT_TRUE(has(text, "−25 %"));
  EXPECT_TRUE(has(text, "+11 %"));  // front thigh, 60 to 66.6 mm
  expect_well_formed(text);
  const std::string summary = report_summary(read_run(run_));
  EXPECT_TRUE(has(summary, "**What the body bought.** Both bodies"));
  EXPECT_TRUE(has(summary, "| mechanical power | 4 W | 3 W | −25 % |"));
}

TEST_F(DesignEffect, AnOuterObjectiveIsToldByWhatIsMeasured) {
  const auto words = [&] { return outer_words(read_run(run_)); };
  EXPECT_EQ(words(), "");
  edit_run([](Json& run) {
    run["outer"] = {{"objective", "peak_torque"}, {"weight", 5.0},       {"unit", "N m"},
                    {"reference", 2.5},           {"plan_initial", 2.5}, {"plan_final", 1.5}};
  });
  EXPECT_TRUE(has(words(),
                  "The body was to lower peak torque. In the plan: 2.5 N·m before, 1.5 "
                  "N·m after (−40 %). Measured: at half gains 2 N·m before, "))
      << words();
  EXPECT_TRUE(has(words(), "; at double gains 2 N·m before, ")) << words();
  EXPECT_FALSE(has(words(), "did not fall"));
  EXPECT_EQ(row("in the plan: peak torque").after, "1.5 N·m");
  EXPECT_TRUE(has(page(), "times peak torque over 2.5 N·m"));
  EXPECT_TRUE(has(page(), "The body was to lower peak torque."));
  EXPECT_TRUE(has(report_summary(read_run(run_)), "The body was to lower peak torque."));
  edit("result/metrics.json", [](Json& metrics) {
    Json half = metrics["result"]["half"];
    set_power(metrics["result"], 3.0, 2.5);
    metrics["result"]["half"] = half;
  });
  EXPECT_TRUE(has(words(), "(+25 %). It did not fall at default and double gains.")) << words();
  edit_run([](Json& run) { run["outer"] = {{"objective", "beauty"}, {"weight", 1.0}}; });
  EXPECT_EQ(words(), "The body was to lower beauty. What came of it in MuJoCo is not measured.");
}

TEST_F(DesignEffect, OfARunThatKeptItsBodyNothingIsSaid) {
  edit_run([](Json& run) { run["motion_only"] = true; });
  EXPECT_EQ(body_words(read_run(run_)), "");
  EXPECT_EQ(effect_words(read_run(run_)), "");
  EXPECT_FALSE(has(page(), "Why the body changed"));
}

TEST_F(DesignEffect, HostileTextStaysText) {
  const std::size_t plain = tags_of(page());
  for (const std::string& raw : hostile_names()) {
    edit_run([&](Json& run) {
      run["parameters"][0]["name"] = clean_utf8(raw);
      run["outer"] = {{"objective", clean_utf8(raw)}, {"weight", 1.0}};
    });
    const std::string text = page();
    expect_well_formed(text);
    EXPECT_LE(tags_of(text), plain + 20) << raw;  // a row for the outer objective
  }
}

TEST(ChangeWords, AreShort) {
  EXPECT_EQ(change_words(-0.314), "−31 %");
  EXPECT_EQ(change_words(0.042), "+4.2 %");
  EXPECT_EQ(change_words(1e-5), "as before");
  EXPECT_EQ(change_words(8.9), "+890 %");
  EXPECT_EQ(change_words(100.6), "102 times");
  EXPECT_EQ(change_words(1e8), "from next to nothing");
}

}  // namespace
}  // namespace legwright
