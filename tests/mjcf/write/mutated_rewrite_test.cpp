// SPDX-License-Identifier: Apache-2.0
// A thousand robots that somebody changed carelessly, in a process of their own: each is refused
// with a reason, or every design within its bounds can be written, MuJoCo takes what was written,
// and it is the intended design. Nothing crashes, and nothing hangs.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <new>

#include "mjcf/propose/declare.hpp"
#include "mjcf/propose/proposals.hpp"
#include "mjcf/propose/standing_pose.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/robot_files.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/mutate_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/support/long_tests.hpp"

namespace legwright {
namespace {

#ifdef LEGWRIGHT_SANITIZED
constexpr int kUsual = 120;  // the sanitizers make each some ten times as dear
#else
constexpr int kUsual = 1200;
#endif
constexpr int kMost = 100000;
constexpr unsigned kPatience = 30;  // [s] that a case may take

/// More in a long run: LEGWRIGHT_MUTANTS=20000.
int case_count() {
  const char* const wanted = std::getenv("LEGWRIGHT_MUTANTS");
  return std::clamp(wanted ? std::atoi(wanted) : 0, kUsual, kMost);
}

enum class Outcome : char { none, refused, written, broken };

/// What the child tells its parent while it runs: the outcome of each case and what broke it; after
/// a crash the first case without an outcome is to blame.
struct Board {
  Outcome outcome[kMost];
  char what[kMost][200];
};

/// The robots that are changed, in a fixed order.
const std::vector<std::pair<std::string, std::string>>& bases() {
  static const auto all = [] {
    std::vector<std::pair<std::string, std::string>> out;
    for (const char* name : {"puppy", "piston_puppy", "quadruped", "hexapod", "biped"})
      out.emplace_back(name, test::example_robot(name));
    out.emplace_back("crooked_piston", test::crooked_piston_robot());
    out.emplace_back("crooked_printed", test::crooked_printed_robot());
    for (const auto& file :
         test::taken_robots()) {  // they declare nothing: what init proposes is put in
      std::string text = RobotFiles::read(file).text();  // with what it includes
      if (const auto pose = find_standing_pose(text, file)) text = with_keyframe(text, file, *pose);
      out.emplace_back(file.parent_path().filename(),
                       with_declarations(text, file, propose_parameters(text, file).proposals));
    }
    return out;
  }();
  return all;
}

/// The robot of a case; depends on its number only.
std::string robot_of(int number) {
  std::mt19937 random(static_cast<unsigned>(7000 + number));
  return test::mutated_robot(bases()[static_cast<std::size_t>(number) % bases().size()].second,
                             random);
}

Outcome fail(char* what, const std::string& why) {
  std::strncpy(what, why.c_str(), 199);
  return Outcome::broken;
}

/// Every tenth accepted robot is also studied, as `init --write` would.
Outcome study(const std::string& xml, char* what) {
  const ProposedParameters found = propose_parameters(xml, "mutant.xml");
  const std::string declared = with_declarations(xml, "mutant.xml", found.proposals);
  const RobotModel again = parse_robot(declared, "mutant.xml");
  if (again.space.size() != found.model.space.size() + static_cast<int>(found.proposals.size()))
    return fail(what, "proposals were written that are not read again");
  return Outcome::written;
}

/// Reads, writes random designs and the corners of the bounds, reads them again.
Outcome read_and_write(const std::string& xml, int number, char* what) {
  RobotModel robot;
  try {
    robot = parse_robot(xml, "mutant.xml");
  } catch (const InputError& error) {
    const std::string message = error.what();
    if (message.rfind("mutant.xml", 0) != 0 || message.size() < 30)
      return fail(what, "refused without file or reason: " + message);
    return Outcome::refused;
  }
  // Those that are held in the plan count too.
  const auto joints = compile_mjcf(xml, "mutant.xml")->nq - 7;
  std::mt19937 random(static_cast<unsigned>(number));
  const Eigen::VectorXd s = test::random_design(robot.space, random);
  for (const Eigen::VectorXd& design :
       {s, number % 2 ? robot.space.lower() : robot.space.upper()}) {
    const std::string text = rewrite_robot(robot, design);
    const ModelPointer model = compile_mjcf(text, "written.xml");
    if (model->nq != joints + 7 || joints < robot.morphology.joint_count())
      return fail(what, "joints are lost");
    // With the robot's own structure: what a mutant's leg is may hang on how far down it reaches.
    if (rewrite_robot(parse_robot(text, "written.xml", &robot.structure), design) != text)
      return fail(what, "what was written is not given back byte for byte");
  }
  if (rewrite_robot(robot, robot.space.initial()) != xml)
    return fail(what, "the initial design is not given back byte for byte");
  return number % 10 == 0 ? study(xml, what) : Outcome::written;
}

Outcome try_case(int number, char* what) {
  ::alarm(kPatience);
  try {
    return read_and_write(robot_of(number), number, what);
  } catch (const std::exception& error) {
    return fail(what, error.what());
  } catch (...) {
    return fail(what, "an exception of no kind");
  }
}

using Case = std::function<Outcome(int number, char* what)>;

class MutatedRewrite : public testing::Test {
 protected:
  void SetUp() override {
    void* const memory =
        mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(memory, MAP_FAILED);
    board_ = new (memory) Board{};
  }
  void TearDown() override { munmap(board_, sizeof(Board)); }

  /// Runs cases first, first + step … in a child. @return the case at which it died, else `count`.
  int run_in_child(int first, int count, const Case& run) {
    const pid_t child = ::fork();
    if (child == 0) {
      for (int i = first; i < count; ++i) board_->outcome[i] = run(i, board_->what[i]);
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    int reached = first;
    while (reached < count && board_->outcome[reached] != Outcome::none) ++reached;
    return reached;
  }

  Board* board_ = nullptr;
};

TEST_F(MutatedRewrite, WhatIsAcceptedCanBeWritten) {
  ASSERT_GE(bases().size(), 7u);
  const int count = case_count();
  for (int first = 0; first < count;) {
    const int died = run_in_child(first, count, try_case);
    if (died < count)
      ADD_FAILURE() << "the process ended in case " << died << " ("
                    << bases()[static_cast<std::size_t>(died) % bases().size()].first << ")";
    first = died + 1;
  }
  int refused = 0, written = 0;
  for (int i = 0; i < count; ++i) {
    refused += board_->outcome[i] == Outcome::refused;
    written += board_->outcome[i] == Outcome::written;
    EXPECT_NE(board_->outcome[i], Outcome::broken)
        << "case " << i << " (" << bases()[static_cast<std::size_t>(i) % bases().size()].first
        << "): " << board_->what[i];
  }
  test::tell_tries("mutated robots, read and written", count);
  RecordProperty("refused", refused);
  RecordProperty("written", written);
  EXPECT_GT(refused, count / 5);
  EXPECT_GT(written, count / 5);
}

/// Prints a mutant, for whoever mends what broke: LEGWRIGHT_MUTANT=17.
TEST_F(MutatedRewrite, AMutantDependsOnItsNumberOnly) {
  const char* const wanted = std::getenv("LEGWRIGHT_MUTANT");
  const int number = wanted ? std::atoi(wanted) : 17;
  const std::string robot = robot_of(number);
  EXPECT_EQ(robot, robot_of(number));
  EXPECT_NE(robot, robot_of(number + static_cast<int>(bases().size())));
  if (wanted) fmt::print("{}", robot);
}

/// Negative control: a child that dies, hangs or breaks is noticed, and the case is named.
TEST_F(MutatedRewrite, HarnessNoticesDeathHangsAndFaults) {
  const Case fragile = [](int i, char* what) {
    ::alarm(1);
    if (i == 3) ::_exit(1);
    if (i == 5) ::raise(SIGKILL);
    if (i == 7)
      for (volatile bool forever = true; forever;) {
      }
    if (i == 9) return fail(what, "provoked");
    return Outcome::written;
  };
  EXPECT_EQ(run_in_child(0, 12, fragile), 3);
  EXPECT_EQ(run_in_child(4, 12, fragile), 5);
  EXPECT_EQ(run_in_child(6, 12, fragile), 7);
  EXPECT_EQ(run_in_child(8, 12, fragile), 12);
  EXPECT_EQ(board_->outcome[9], Outcome::broken);
  EXPECT_STREQ(board_->what[9], "provoked");
}

/// Negative control: a robot that cannot be written as intended counts as broken.
TEST_F(MutatedRewrite, AWriterThatFailsIsNoticed) {
  char what[200] = "";
  EXPECT_EQ(read_and_write(bases()[0].second, 1, what), Outcome::written);
  EXPECT_EQ(read_and_write("<mujoco/>", 1, what), Outcome::refused);
  const RobotModel puppy = read_robot(test::puppy_file());
  EXPECT_THROW(
      {
        RobotModel other = puppy;  // as if the text meant another robot
        other.morphology.links[1].origin.constant.x() += 1e-6;
        rewrite_robot(other, puppy.space.upper());
      },
      std::logic_error);
}

}  // namespace
}  // namespace legwright
