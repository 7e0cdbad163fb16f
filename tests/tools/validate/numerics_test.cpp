// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/numerics.hpp"

#include <gtest/gtest.h>

#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/simulate/tiny_scene.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/json_file.hpp"
#include "tools/validate/records.hpp"

namespace legwright {
namespace {

class Numerics : public testing::Test {
 protected:
  Numerics() { write_file(folder_.path() / "tiny.xml", TinyScene{}.xml(), Durability::process); }

  SecondOpinion ask(std::vector<NumericalSetting> settings = {}, int threads = 2,
                    const std::vector<Measurements>& reference = {}) const {
    ValidationOptions options;
    options.cycles = 5;
    options.threads = threads;
    options.gain_scales = {0.5, 1.0};
    return second_opinion({folder_.path() / "tiny.xml", {}}, {}, "wag", options, reference,
                          std::move(settings));
  }

  test::TemporaryFolder folder_;
};

TEST_F(Numerics, StandingTableStandsHoweverItIsComputed) {
  const SecondOpinion opinion = ask();
  EXPECT_TRUE(opinion.agree);
  EXPECT_TRUE(opinion.reasons.empty());
  ASSERT_EQ(opinion.runs.size(), 10u);
  EXPECT_EQ(opinion.runs[0].label, "1 ms, implicitfast, elliptic cone");
  EXPECT_EQ(opinion.runs[1].label, "0.5 ms, implicitfast, elliptic cone");
  EXPECT_EQ(opinion.runs[2].label, "0.25 ms, implicitfast, elliptic cone");
  EXPECT_EQ(opinion.runs[3].label, "1 ms, implicit, elliptic cone");
  EXPECT_EQ(opinion.runs[4].label, "1 ms, implicitfast, pyramidal cone");
  for (std::size_t k = 0; k < 5; ++k) {  // at default gains first, then at half
    EXPECT_EQ(opinion.runs[k].gain_scale, 1.0);
    EXPECT_EQ(opinion.runs[5 + k].gain_scale, 0.5);
    EXPECT_EQ(opinion.runs[5 + k].label, opinion.runs[k].label);
    EXPECT_NE(opinion.runs[5 + k].measured.torque_rms, opinion.runs[k].measured.torque_rms);
  }
  for (const auto& run : opinion.runs) EXPECT_NEAR(run.measured.seconds, 2.0, 1e-9) << run.label;
  // They are other computations indeed.
  EXPECT_NE(opinion.runs[1].measured.torque_rms, opinion.runs[0].measured.torque_rms);
  EXPECT_NE(opinion.runs[4].measured.tilt_max, opinion.runs[0].measured.tilt_max);
  const std::string line = describe(opinion);
  EXPECT_NE(
      line.find("same verdict at 0.5 ms, at 0.25 ms, with implicit, with a pyramidal cone, at "
                "default and half gains"),
      std::string::npos)
      << line;
}

TEST_F(Numerics, AnotherVerdictIsNamed) {
  const SecondOpinion opinion = ask({{"huge", "with Euler", 0.05, mjINT_EULER, {}, {}},
                                     {"fine", "at 0.5 ms", 0.0005, {}, {}, {}}});
  EXPECT_FALSE(opinion.agree);
  ASSERT_EQ(opinion.reasons.size(), 2u);
  EXPECT_NE(
      opinion.reasons[0].find("with Euler at default gains (50 ms, Euler, elliptic cone): FAIL"),
      std::string::npos)
      << opinion.reasons[0];
  EXPECT_NE(opinion.reasons[1].find("with Euler at half gains"), std::string::npos);
  EXPECT_NE(
      describe(opinion).find("ANOTHER verdict with Euler at default gains, with Euler at half "
                             "gains; the same in 2 others"),
      std::string::npos)
      << describe(opinion);
}

TEST_F(Numerics, JsonHoldsDifferencesToTheReference) {
  const Json json = json_of(numerics_record(ask()));
  EXPECT_EQ(json["schema"], "legwright/numerics");
  EXPECT_TRUE(json["agree"].get<bool>());
  EXPECT_TRUE(json["runs"][0]["difference"].is_null());
  EXPECT_TRUE(json["runs"][0]["speed_ratio"].is_null());  // nothing is to travel
  const Json& half = json["runs"][1];
  EXPECT_EQ(half["timestep_s"], 0.0005);
  EXPECT_EQ(half["gains"], "default");
  EXPECT_EQ(json["runs"][6]["gains"], "half");  // against the reference of its own gains
  EXPECT_EQ(json["runs"][6]["difference"]["torque_rms_Nm"].get<double>(),
            json["runs"][6]["torque_rms_Nm"].get<double>() -
                json["runs"][5]["torque_rms_Nm"].get<double>());
  EXPECT_EQ(half["difference"]["tilt_max_rad"].get<double>(),
            half["tilt_max_rad"].get<double>() - json["runs"][0]["tilt_max_rad"].get<double>());
}

TEST_F(Numerics, BytesDoNotDependOnThreadsNorOnWhoPlayedTheReference) {
  const SecondOpinion alone = ask({}, 1);
  const std::string text = to_text(json_of(numerics_record(alone)));
  EXPECT_EQ(text, to_text(json_of(numerics_record(ask({}, 3)))));
  EXPECT_EQ(text, to_text(json_of(numerics_record(
                      ask({}, 2, {alone.runs[5].measured, alone.runs[0].measured})))));
}

}  // namespace
}  // namespace legwright
