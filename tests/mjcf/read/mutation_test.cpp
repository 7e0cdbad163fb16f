// SPDX-License-Identifier: Apache-2.0
// Cut and mutated robots: refused with a reason or accepted, never a crash.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/scene/played_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/support/long_tests.hpp"
#include "tests/tools/files/temporary_folder.hpp"

namespace legwright {
namespace {

/// True if accepted; every refusal must be an InputError that names the file.
bool accepted(const std::string& text) {
  try {
    parse_robot(text, "mutant.xml");
    return true;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("mutant.xml", 0), 0u) << error.what();
    return false;
  }
}

/// Where in a refusal stands no line; empty where each reason has one.
std::string without_line(const std::string& text) {
  try {
    parse_robot(text, "mutant.xml");
  } catch (const InputError& error) {
    const std::vector<InputError> reasons =
        error.reasons().empty() ? std::vector<InputError>{error} : error.reasons();
    for (const InputError& reason : reasons)
      if (reason.line() <= 0) return reason.what();
  }
  return "";
}

/// More in a long run: LEGWRIGHT_MUTANTS=20000.
int trials(int usual) {
  const char* const wanted = std::getenv("LEGWRIGHT_MUTANTS");
  return wanted ? std::max(usual, std::atoi(wanted)) : usual;
}

/// @return trials(), which are told
int told_trials(int usual) {
  const int count = trials(usual);
  test::tell_tries("mutated robots, read", count);
  return count;
}

TEST(Mutation, EveryPrefixIsRefused) {
  const std::string text = test::read_file(test::puppy_file());
  ASSERT_TRUE(accepted(text));
  const std::size_t complete = text.rfind("</mujoco>") + 9;
  for (std::size_t n = 0; n < complete; n += 97)
    EXPECT_FALSE(accepted(text.substr(0, n))) << n << " bytes";
  EXPECT_FALSE(accepted(text.substr(0, complete - 1)));
}

std::string mutate(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  static const std::string pieces[] = {
      "nan",  "1e999",    "-1",   "0",    "\"",  "<", ">", "/>", "<body>",     "</body>", "1,5",
      "0x10", "99999999", "&#0;", "<!--", "]]>", " ", "|", "~",  "legwright/", "1e-300",  "FL_hip"};
  static const std::string numbers[] = {"0",    "1",   "-0.07", "0.013", "2e-5", "7",
                                        "3.14", "nan", "1e999", "1e300", "1,5"};
  const std::size_t edits = 1 + below(2);
  for (std::size_t e = 0; e < edits; ++e) {
    const std::size_t at = below(text.size()), length = std::min(text.size() - at, 1 + below(40));
    switch (below(7)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, pieces[below(std::size(pieces))]);
        break;
      case 2:
        text[at] = static_cast<char>(below(256));
        break;
      case 3:
        text.insert(below(text.size()), text.substr(at, length));
        break;
      default: {  // a number of some attribute becomes another
        const std::size_t digit = text.find_first_of("0123456789", at);
        if (digit == std::string::npos) break;
        const std::size_t end = text.find_first_not_of("0123456789.-e", digit);
        text.replace(digit, end - digit, numbers[below(std::size(numbers))]);
      }
    }
  }
  return text;
}

TEST(Mutation, SeededMutantsDoNotCrash) {
  const std::string puppy = test::read_file(test::puppy_file()), crooked = test::crooked_robot();
  std::mt19937 random(20240611);
  int count[2] = {0, 0};
  for (int trial = 0, most = told_trials(300); trial < most; ++trial)
    ++count[accepted(mutate(trial % 2 ? puppy : crooked, random))];
  EXPECT_GT(count[0], 30);
  EXPECT_GT(count[1], 20);
}

/// Of 4000 mutants none is without; keyframes that MuJoCo refuses without a line among them.
TEST(Mutation, RefusalsNameTheirLines) {
  const std::string robots[] = {test::read_file(test::puppy_file()), test::crooked_robot(),
                                test::armed_biped(), test::declared(test::classed_quadruped()),
                                test::named_robot("piston_puppy")};
  std::mt19937 random(20250117);
  for (int trial = 0, most = told_trials(500); trial < most; ++trial) {
    const std::string told = without_line(mutate(robots[trial % std::size(robots)], random));
    EXPECT_EQ(told, "");
  }
}

/// Whatever is accepted can be rewritten to its bounds.
TEST(Mutation, AcceptedMutantsCanBeRewritten) {
  const std::string crooked = test::crooked_robot();
  std::mt19937 random(99);
  int rewritten = 0;
  for (int trial = 0, most = told_trials(150); trial < most; ++trial) {
    const std::string text = mutate(crooked, random);
    if (!accepted(text)) continue;
    const RobotModel robot = parse_robot(text, "mutant.xml");
    EXPECT_NO_THROW(rewrite_robot(robot, 0.5 * (robot.space.lower() + robot.space.upper())))
        << text;
    ++rewritten;
  }
  EXPECT_GT(rewritten, 10);
}

/// A fault in any file of a robot: refused at one of its files, or accepted and taken apart again.
TEST(Mutation, MutantsOfIncludedFilesDoNotCrash) {
  const test::TemporaryFolder folder;
  const std::filesystem::path main = test::write_split_puppy(folder.path());
  const RobotFiles good = RobotFiles::read(main);
  std::mt19937 random(7);
  int count[2] = {0, 0};
  for (int trial = 0, most = told_trials(200); trial < most; ++trial) {
    const std::vector<IncludedFile> parts = good.includes();
    const std::size_t k = static_cast<std::size_t>(trial) % (parts.size() + 1);
    const bool is_main = k == parts.size();
    const std::filesystem::path file = is_main ? main : folder.path() / parts[k].path;
    const std::string& text = is_main ? good.main_text() : parts[k].text;
    test::put(file, mutate(text, random));
    try {
      const RobotModel robot = read_robot(main);
      const Eigen::VectorXd s = 0.5 * (robot.space.lower() + robot.space.upper());
      const std::string rewritten = rewrite_robot(robot, s);
      EXPECT_EQ(robot.files.with_text(rewritten).text(), rewritten);
      ++count[1];
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(folder.path().string(), 0), 0u) << error.what();
      ++count[0];
    }
    test::put(file, text);
  }
  EXPECT_GT(count[0], 20);
  EXPECT_GT(count[1], 20);
}

/// The same of robots of other construction, also as they are played.
TEST(Mutation, MutantsOfOtherConstructionsCanBeRewrittenAndPlayed) {
  const std::string robots[] = {test::armed_biped(), test::declared(test::classed_quadruped()),
                                test::declared(test::quadruped_with_arm())};
  std::mt19937 random(7);
  int played = 0, held = 0;
  for (int trial = 0, most = told_trials(300); trial < most; ++trial) {
    const std::string text = mutate(robots[trial % 3], random);
    if (!accepted(text)) continue;
    const RobotModel robot = parse_robot(text, "mutant.xml");
    std::string design;
    ASSERT_NO_THROW(design =
                        rewrite_robot(robot, 0.5 * (robot.space.lower() + robot.space.upper())))
        << text;
    ASSERT_NO_THROW(compile_mjcf(played_robot(robot, design), "played.xml")) << text;
    ++played;
    held += robot.structure.frozen.empty() ? 0 : 1;
  }
  EXPECT_GT(played, 20);
  EXPECT_GT(held, 10);
}

}  // namespace
}  // namespace legwright
