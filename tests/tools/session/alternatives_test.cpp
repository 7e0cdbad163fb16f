// SPDX-License-Identifier: Apache-2.0
#include "tools/session/alternatives.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <optional>

#include "mjcf/text/input_error.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/session/puppy.hpp"
#include "tools/session/session.hpp"

namespace legwright {
namespace {

using namespace std::chrono_literals;
using test::bits;
using test::kThigh;

constexpr const char* kFewest = "fewest";
constexpr const char* kFront = "front";
const std::filesystem::path kBoth = test::source_dir() + "/examples/quadruped/both.toml";

std::string refusal_of(SessionEngine& engine, const SessionCommand& command) {
  try {
    engine.apply(command);
  } catch (const InputError& error) {
    return error.what();
  }
  return "obeyed";
}

#ifdef LEGWRIGHT_SANITIZED
constexpr bool kTakesMinutes = true;  // searches and fronts, which the release build runs
#else
constexpr bool kTakesMinutes = false;
#endif

class FewestOfThePuppy : public testing::Test {
 protected:
  void SetUp() override {
    if (kTakesMinutes) GTEST_SKIP();
  }

  SessionEngine engine_{test::puppy(), read_file(test::kSideways), test::kSideways};

  int index(const char* name) const { return engine_.state()->problem->robot.space.find(name); }
  void search() {
    (void)engine_.search(0, {});
    ASSERT_TRUE(engine_.settle());
  }
  AlternativesPointer worked_out() {
    EXPECT_TRUE(engine_.work_out(AlternativeKind::fewest, {}));
    return engine_.worked_out(AlternativeKind::fewest);
  }
};

TEST_F(FewestOfThePuppy, HasEverFewerChangesAndTellsWhatEachIsWorth) {
  search();
  const StatePointer before = engine_.state();
  const AlternativesPointer found = worked_out();
  EXPECT_EQ(engine_.state(), before) << "the design stays";
  ASSERT_GT(found->designs.size(), 3u);
  EXPECT_NEAR(found->designs.front().value(), before->value(), 1e-3 * before->value());
  for (std::size_t k = 1; k < found->designs.size(); ++k)
    EXPECT_LT(found->designs[k].changed.size(), found->designs[k - 1].changed.size());
  const Alternative& few = found->designs[found->fewest];
  EXPECT_LE(few.changed.size(), 6u);
  const double fall = found->given_value - found->designs.front().value();
  EXPECT_GT(found->given_value - few.value(), Alternatives::kKept * fall);
  ASSERT_EQ(found->worths.size(), found->designs.front().changed.size());
  for (std::size_t k = 1; k < found->worths.size(); ++k)
    EXPECT_GE(found->worths[k - 1].worth, found->worths[k].worth);
}

TEST_F(FewestOfThePuppy, OneTakesThePlaceOfTheDesignAndIsUndoneAsOneStep) {
  search();
  const StatePointer before = engine_.state();
  const AlternativesPointer found = worked_out();
  const int last = static_cast<int>(found->designs.size()) - 1;
  for (int k = 0; k <= last; ++k) engine_.apply(session::Choose{kFewest, k, k > 0});
  EXPECT_EQ(engine_.state()->s(), found->designs.back().s);
  ASSERT_TRUE(engine_.settle());
  EXPECT_NEAR(engine_.state()->value(), found->designs.back().value(),
              0.05 * found->designs.back().value());
  engine_.apply(session::Undo{});
  EXPECT_EQ(engine_.state(), before);
}

TEST_F(FewestOfThePuppy, AReplayTakesWhatTheJournalHas) {
  search();
  const std::optional<Found> searched = found_in(*engine_.state());
  const AlternativesPointer found = worked_out();
  engine_.apply(session::Choose{kFewest, 2});
  SessionEngine again(test::puppy(), read_file(test::kSideways), test::kSideways);
  again.set_stop([] { return true; });  // nothing is worked out anew
  const auto kept = std::make_shared<const Alternatives>(*found);
  for (const SessionCommand& command :
       {SessionCommand(session::Searched{engine_.state()->iterations, searched}),
        SessionCommand(session::Settled{searched}),
        SessionCommand(session::WorkedOut{kFewest, kept}),
        SessionCommand(session::Choose{kFewest, 2})})
    again.apply(command_of(json_of(command), "session.jsonl", 2));
  EXPECT_EQ(bits(*again.state()), bits(*engine_.state()));
  EXPECT_EQ(again.worked_out(AlternativeKind::fewest)->designs.size(), found->designs.size());
  const std::vector<std::function<void(Alternatives&)>> spoils{
      [](Alternatives& all) { all.designs[0].motions.clear(); },
      [](Alternatives& all) { all.designs[1].values[0] *= 5.0; },
      [](Alternatives& all) { all.designs[1].motions[0].setConstant(1e200); },
      [](Alternatives& all) { all.designs.clear(); }};
  for (const auto& spoil : spoils) {
    auto spoilt = std::make_shared<Alternatives>(*found);
    spoil(*spoilt);
    again.apply(session::WorkedOut{kFewest, spoilt});
    EXPECT_FALSE(again.worked_out(AlternativeKind::fewest));
  }
}

TEST_F(FewestOfThePuppy, WhatIsLockedStaysAndRefusesDesignsOfBefore) {
  search();
  (void)worked_out();
  const double thigh = engine_.state()->s()[index(kThigh)];
  engine_.apply(session::Freeze{{kThigh}, true});
  const AlternativesPointer before = engine_.worked_out(AlternativeKind::fewest);
  const int last = static_cast<int>(before->designs.size()) - 1;
  ASSERT_NE(before->designs.back().s[index(kThigh)], thigh);
  EXPECT_NE(refusal_of(engine_, session::Choose{kFewest, last}).find("locked or bounded since"),
            std::string::npos);
  const AlternativesPointer found = worked_out();
  for (const Alternative& each : found->designs) EXPECT_EQ(each.s[index(kThigh)], thigh);
}

TEST_F(FewestOfThePuppy, IsRefusedWhereNothingIsToBePutBack) {
  EXPECT_THROW((void)engine_.work_out(AlternativeKind::fewest, {}), InputError) << "not solved";
  ASSERT_TRUE(engine_.settle());
  EXPECT_THROW((void)engine_.work_out(AlternativeKind::fewest, {}), InputError) << "as given";
  EXPECT_THROW((void)engine_.work_out(AlternativeKind::front, {}), InputError) << "one task";
  EXPECT_NE(refusal_of(engine_, session::Choose{kFewest, 0}).find("not worked out yet"),
            std::string::npos);
  EXPECT_NE(refusal_of(engine_, session::Choose{"best", 0}).find("expected \"fewest\""),
            std::string::npos);
}

TEST_F(FewestOfThePuppy, AStopLeavesWhatWasThere) {
  search();
  int questions = 0;
  engine_.set_stop([&] { return ++questions > 40; });
  EXPECT_FALSE(engine_.work_out(AlternativeKind::fewest, {}));
  EXPECT_TRUE(engine_.alternatives().empty());
}

TEST_F(FewestOfThePuppy, OtherTasksHaveOthers) {
  engine_.apply(session::Edit{{{kThigh, 0.062}}});
  ASSERT_TRUE(engine_.settle());
  const AlternativesPointer found = worked_out();
  EXPECT_NE(refusal_of(engine_, session::Choose{kFewest, 9}).find("expected 0 to 0"),
            std::string::npos);
  engine_.apply(session::Tasks{read_file(test::kSideways)});
  EXPECT_NE(refusal_of(engine_, session::Choose{kFewest, 0}).find("for other tasks"),
            std::string::npos);
}

TEST(FrontOfTwoTasks, FallsFromEndToEndAndIsMovedAlong) {
  if (kTakesMinutes) GTEST_SKIP();
  SessionEngine engine(read_robot(kBoth.parent_path() / "robot.xml"), read_file(kBoth), kBoth);
  (void)engine.search(30, {});
  ASSERT_TRUE(engine.settle());
  ASSERT_TRUE(engine.work_out(AlternativeKind::front, {}));
  const AlternativesPointer found = engine.worked_out(AlternativeKind::front);
  ASSERT_GE(found->designs.size(), 9u);
  EXPECT_EQ(found->designs.front().weights, (std::vector{0.0, 1.0}));
  EXPECT_EQ(found->designs.back().weights, (std::vector{1.0, 0.0}));
  for (std::size_t k = 1; k < found->designs.size(); ++k) {
    const Alternative &before = found->designs[k - 1], &each = found->designs[k];
    EXPECT_GT(each.weights[0], before.weights[0]);
    EXPECT_LE(each.values[0], before.values[0] * (1 + 1e-6)) << "more of its weight, less of its F";
    EXPECT_GE(each.values[1], before.values[1] * (1 - 1e-6));
  }
  engine.apply(session::Choose{kFront, 0});
  EXPECT_EQ(engine.state()->weights, (std::vector{0.01, 1.0}));
  EXPECT_EQ(engine.state()->s(), found->designs.front().s);
}

TEST(SessionAlternatives, AreWorkedOutInTheBackgroundAndLeadToTheSameBitsAgain) {
  const test::TemporaryFolder folder;
  const auto open = [&](const char* journal, std::vector<SessionCommand> commands) {
    Session::Options options;
    options.journal = folder.path() / journal;
    options.commands = std::move(commands);
    return std::make_unique<Session>(test::puppy(), test::sideways(), test::kSideways, options);
  };
  auto session = open("first.jsonl", {});
  session->start();
  ASSERT_TRUE(session->wait(60s));
  session->work_out(AlternativeKind::fewest);
  session->pause();  // a command drops it
  ASSERT_TRUE(session->wait(60s));
  EXPECT_TRUE(session->snapshot()->alternatives.empty());
  EXPECT_EQ(session->events(0, 0ms).back().words, "stopped");
  session->work_out(AlternativeKind::fewest);
  ASSERT_TRUE(session->wait(60s));
  ASSERT_EQ(session->snapshot()->alternatives.size(), 1u);
  EXPECT_EQ(session->events(0, 0ms).back().kind, SessionEvent::Kind::worked_out);
  const Alternatives& found = *session->snapshot()->alternatives.front();
  session->apply(session::Choose{kFewest, static_cast<int>(found.fewest)});
  ASSERT_TRUE(session->wait(60s));
  const std::vector<double> chosen = bits(*session->snapshot()->state);
  session.reset();
  const auto again = open("again.jsonl", read_journal(folder.path() / "first.jsonl").commands);
  EXPECT_EQ(bits(*again->snapshot()->state), chosen);
  EXPECT_EQ(again->snapshot()->alternatives.size(), 1u);
}

TEST(SessionAlternatives, WhatCannotBeWorkedOutIsRefusedAtOnce) {
  Session session(test::puppy(), test::sideways(), test::kSideways);
  EXPECT_THROW(session.work_out(AlternativeKind::front), InputError);
  EXPECT_THROW(session.work_out(AlternativeKind::fewest), InputError);
  ASSERT_TRUE(session.wait(60s));
  EXPECT_EQ(session.events(0, 0ms).back().kind, SessionEvent::Kind::solved);
}

}  // namespace
}  // namespace legwright
