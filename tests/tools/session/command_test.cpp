// SPDX-License-Identifier: Apache-2.0
#include "tools/session/command.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

SessionCommand read(const std::string& text) {
  return command_of(Json::parse(text), "session.jsonl", 7);
}

TEST(SessionCommand, EveryKindComesBackAsItWasWritten) {
  const std::vector<SessionCommand> all{session::Edit{{{"thigh", 0.1}, {"body", 1.0 / 3.0}}, true},
                                        session::Freeze{{"thigh", "body"}, false},
                                        session::Bounds{"thigh", 0.05, 0.15},
                                        session::Tasks{"[gait]\nname = \"walk\"\n", "other.toml"},
                                        session::Weights{{0.3, 0.7}},
                                        session::Reset{},
                                        session::Undo{},
                                        session::Redo{},
                                        session::Snapshot{"first"},
                                        session::Branch{"first"},
                                        session::Step{},
                                        session::Settled{},
                                        session::Searched{17},
                                        session::WorkedOut{"fewest"},
                                        session::Choose{"front", 3, true}};
  ASSERT_EQ(all.size(), std::variant_size_v<SessionCommand>);
  for (const SessionCommand& command : all) {
    const std::string text = json_of(command).dump();
    EXPECT_EQ(json_of(read(text)).dump(), text);
    EXPECT_EQ(read(text).index(), command.index()) << text;
  }
  const auto edit = std::get<session::Edit>(read(json_of(all[0]).dump()));
  EXPECT_EQ(edit.values.at("body"), 1.0 / 3.0);  // the same bits
}

TEST(SessionCommand, WhatWasFoundComesBackToTheBitAndMayBeMissing) {
  const Found found{Eigen::Vector2d(0.1, 1.0 / 3.0),
                    {Eigen::Vector3d(1e-300, -0.0, 7.0)},
                    {2.0 / 7.0},
                    {SolveStatus::stalled}};
  const SessionCommand command = session::Searched{3, found};
  const auto back = std::get<session::Searched>(read(json_of(command).dump()));
  ASSERT_TRUE(back.found);
  EXPECT_EQ(back.points, 3);
  EXPECT_EQ(back.found->s, found.s);
  EXPECT_EQ(back.found->motions, found.motions);
  EXPECT_TRUE(std::signbit(back.found->motions[0][1]));
  EXPECT_EQ(back.found->values, found.values);
  EXPECT_EQ(back.found->status, found.status);
  EXPECT_EQ(json_of(without_found(command)).dump(), json_of(session::Searched{3}).dump());
  EXPECT_FALSE(std::get<session::Searched>(read(R"({"do": "searched", "points": 3})")).found);

  Alternatives all;
  all.kind = AlternativeKind::front;
  all.designs.push_back({found.s, found.motions, {0.25}, {1.5}, {1}});
  all.worths.push_back({1, 0.3, std::numeric_limits<double>::infinity()});
  const SessionCommand worked =
      session::WorkedOut{"front", std::make_shared<const Alternatives>(all)};
  const std::string text = json_of(worked).dump();
  EXPECT_EQ(json_of(read(text)).dump(), text);
  EXPECT_TRUE(std::isinf(std::get<session::WorkedOut>(read(text)).found->worths[0].worth));
}

/// What was found can be found again.
TEST(SessionCommand, WhatWasFoundAndCannotBeReadIsMissing) {
  for (const char* found : {"3", "null", R"({"s": "!", "motions": [], "values": [], "status": []})",
                            R"({"s": "AAAA", "motions": [], "values": [], "status": []})",
                            R"({"s": "", "motions": [], "values": [null], "status": []})",
                            R"({"s": "", "motions": [], "values": [], "status": ["good"]})"}) {
    const std::string line = std::string(R"({"do": "settled", "found": )") + found + "}";
    EXPECT_FALSE(std::get<session::Settled>(read(line)).found) << found;
  }
  for (const char* changed : {"4294967296", "1e300", "-1", "0.5"}) {
    const std::string line =
        std::string(R"({"do": "worked_out", "what": "front", "found": )") +
        R"({"kind": "front", "given_value": 1, "fewest": 0, "worths": [],)" +
        R"("designs": [{"s": "", "motions": [], "weights": [], "values": [],)" + R"("changed": [)" +
        changed + "]}]}}";
    EXPECT_FALSE(std::get<session::WorkedOut>(read(line)).found) << changed;
  }
}

TEST(SessionCommand, WhatIsNoCommandIsToldByLine) {
  for (const char* text :
       {"[]", "{}", R"({"do": "dance"})", R"({"do": "edit"})", R"({"do": "undo", "times": 2})",
        R"({"do": "edit", "values": {"thigh": "long"}, "goes_on": false})",
        R"({"do": "searched", "points": 0})", R"({"do": "searched", "points": 1e300})",
        R"({"do": "choose", "what": "front", "design": -1, "goes_on": false})",
        R"({"do": "worked_out"})", R"({"do": "searched", "points": 4294967297})",
        R"({"do": "searched", "points": 2.5})",
        R"({"do": "undo", "found": {"s": "", "motions": [], "values": [], "status": []}})"}) {
    try {
      (void)read(text);
      FAIL() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.line(), 7) << text;
      EXPECT_NE(std::string(error.what()).find("session.jsonl:7: "), std::string::npos);
    }
  }
}

TEST(SessionCommand, AByteOfZeroDoesNotCutTheReason) {
  try {
    (void)read(R"({"do": "un\u0000do"})");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("do' is no command"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace legwright
