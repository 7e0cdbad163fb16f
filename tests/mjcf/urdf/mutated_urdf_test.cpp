// SPDX-License-Identifier: Apache-2.0
// URDFs that somebody changed carelessly: refused with a reason, or MJCF that is read or refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/urdf/read_urdf.hpp"
#include "mjcf/urdf/write_urdf.hpp"
#include "tests/mjcf/robots/mutate_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/support/long_tests.hpp"

namespace legwright {
namespace {

enum class UrdfFate { refused, made, read };

UrdfFate fate_of(const std::string& urdf) {
  UrdfFate out = UrdfFate::refused;
  try {
    const MjcfOfUrdf made = mjcf_of_urdf(urdf, "mutant.urdf");
    out = UrdfFate::made;
    const RobotModel robot = parse_robot(made.text, "mutant.urdf");
    out = UrdfFate::read;
    mjcf_of_urdf(urdf, "mutant.urdf", mending_of(robot, made.without_moments));
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("mutant.urdf", 0), 0u) << error.what();
  }
  return out;
}

TEST(MutatedUrdf, IsRefusedOrRead) {
  const char* const wanted = std::getenv("LEGWRIGHT_MUTANTS");
  const int trials = wanted ? std::max(150, std::atoi(wanted)) : 150;
  for (const char* name : {"puppy", "crooked"}) {
    const RobotModel robot = parse_robot(test::named_robot(name), name);
    const std::string urdf = urdf_of(robot, *compile_mjcf(robot.xml, robot.file), "").text;
    ASSERT_EQ(fate_of(urdf), UrdfFate::read);
    std::mt19937 random(8);
    int counts[3] = {0, 0, 0};
    for (int trial = 0; trial < trials; ++trial)
      ++counts[static_cast<int>(fate_of(test::mutated_robot(urdf, random)))];
    test::tell_tries("mutated URDFs", trials);
    EXPECT_GT(counts[0], trials / 20) << name;  // mutants that are none would prove nothing
    EXPECT_GT(counts[2], trials / 20) << name;
  }
}

TEST(MutatedUrdf, EveryPrefixIsRefused) {
  const RobotModel robot = parse_robot(test::named_robot("puppy"), "puppy");
  const std::string urdf = urdf_of(robot, *compile_mjcf(robot.xml, robot.file), "").text;
  for (std::size_t n = 0; n < urdf.rfind("</robot>"); n += 61)
    EXPECT_EQ(fate_of(urdf.substr(0, n)), UrdfFate::refused) << n << " bytes";
}

}  // namespace
}  // namespace legwright
