// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

/// A verb's option that may be given several times, with two values for it, and what may follow.
struct Repeated {
  void (*add)(CLI::App&, Action&);
  std::string verb, option, one, other, positional;
};

class RepeatedOptions : public testing::TestWithParam<Repeated> {};

TEST_P(RepeatedOptions, TakeOneValueEachAndLeaveTheRest) {
  const Repeated& of = GetParam();
  CLI::App program;
  Action action;
  of.add(program, action);
  program.parse(of.verb + " " + of.option + " " + of.one + " the_rest " + of.option + " " +
                of.other);
  const CLI::App* verb = program.get_subcommand(of.verb);
  EXPECT_EQ(verb->get_option(of.option)->results(), (std::vector{of.one, of.other}));
  EXPECT_EQ(verb->get_option(of.positional)->as<std::string>(), "the_rest");
}

INSTANTIATE_TEST_SUITE_P(
    Verbs, RepeatedOptions,
    testing::Values(Repeated{add_modules, "modules", "--library", "a", "b", "NAME"},
                    Repeated{add_build, "build", "--library", "a", "b", "ASSEMBLY"},
                    Repeated{add_studio, "studio", "--library", "a", "b", "PATH"},
                    Repeated{add_studio, "studio", "--roots", "a", "b", "PATH"},
                    Repeated{add_render, "render", "--phase", "0.25", "0.5", "run"}),
    [](const auto& of) { return of.param.verb + of.param.option.substr(2); });

}  // namespace
}  // namespace legwright
