// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tools/verbs/number_options.hpp"
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

/// An option, a value of it that passes, and one that is no number there.
struct Number {
  void (*add)(CLI::App&, Action&);
  std::string verb, option, good, bad;
};

class NumberOptions : public testing::TestWithParam<Number> {};

TEST_P(NumberOptions, TakeNumbersAlone) {
  const Number& of = GetParam();
  const auto parsed = [&](const std::string& value) {
    CLI::App program;
    Action action;
    of.add(program, action);
    program.parse(of.verb + " " + of.option + " " + value + " a b");
  };
  EXPECT_NO_THROW(parsed(of.good));
  EXPECT_THROW(parsed(of.bad), CLI::ValidationError) << of.bad;
}

INSTANTIATE_TEST_SUITE_P(Verbs, NumberOptions,
                         testing::Values(Number{add_diff, "diff", "--tolerance", "1e-6", "nan"},
                                         Number{add_diff, "diff", "--tolerance", "0", "inf"},
                                         Number{add_diff, "diff", "--tolerance", "0.5", "-1"},
                                         Number{add_diff, "diff", "--tolerance", "0.5", "0,5"}));

TEST(NumberOptions, TellTheirRangesInTheHelp) {
  const auto help = [](void (*add)(CLI::App&, Action&), const char* verb) {
    CLI::App program;
    Action action;
    add(program, action);
    return program.get_subcommand(verb)->help();
  };
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(has(help(add_diff, "diff"), "--tolerance FLOAT:from 0 on=1e-09"))
      << help(add_diff, "diff");
  EXPECT_TRUE(has(help(add_render, "render"), "--phase FLOAT:0 to 1"));
  EXPECT_TRUE(has(help(add_optimize, "optimize"), "--few-keeps FLOAT:1 to 100=95"));
}

TEST(NumberChecks, KeepTheirBounds) {
  const auto passes = [](const CLI::Validator& check, std::string text) {
    return check(text).empty();
  };
  EXPECT_TRUE(passes(number_between(1.0, 100.0), "100"));
  EXPECT_FALSE(passes(number_between(1.0, 100.0), "nan"));
  EXPECT_FALSE(passes(number_between(1.0, 100.0), "100.1"));
  EXPECT_TRUE(passes(finite_number(), "-2.5"));
  EXPECT_FALSE(passes(finite_number(), "-inf"));
  EXPECT_TRUE(passes(seed_number(), "18446744073709551615"));
  EXPECT_FALSE(passes(seed_number(), "18446744073709551616"));
  EXPECT_FALSE(passes(seed_number(), "-1"));
}

}  // namespace
}  // namespace legwright
