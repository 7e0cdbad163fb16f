// SPDX-License-Identifier: Apache-2.0
// The program: picks the verb, runs it, turns what went wrong into a message and an exit code.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/nearest_word.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/io_error.hpp"
#include "tools/run/install.hpp"
#include "tools/verbs/clean_end.hpp"
#include "tools/verbs/parent_death.hpp"
#include "tools/verbs/start_of_process.hpp"
#include "tools/verbs/verbs.hpp"

namespace {

using legwright::Action;

constexpr void (*kVerbs[])(CLI::App&, Action&) = {
    legwright::add_init,     legwright::add_check,  legwright::add_optimize, legwright::add_pick,
    legwright::add_validate, legwright::add_render, legwright::add_report,   legwright::add_curves,
    legwright::add_play,     legwright::add_studio, legwright::add_study,    legwright::add_parts,
    legwright::add_export,   legwright::add_gaits,  legwright::add_modules,  legwright::add_build,
    legwright::add_diff,     legwright::add_doctor,
};

int complain(const char* message, int code) {
  std::fprintf(stderr, "legwright: %s\n", legwright::terminal_text(message).c_str());
  return code;
}

/// The first word, where it is neither an option nor a verb, as a complaint; else nothing.
std::string unknown_verb(const CLI::App& program, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  std::vector<std::string> names;
  for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (verb->get_name() == argv[1]) return "";
    names.push_back(verb->get_name());
  }
  const std::string guess = legwright::nearest(argv[1], names);
  return fmt::format("unknown verb '{}'; {}the verbs are {}", argv[1],
                     guess.empty() ? "" : fmt::format("did you mean {}? ", guess),
                     fmt::join(names, ", "));
}

int run(const Action& action) {
  try {
    return action();
  } catch (const legwright::InputError& error) {
    return complain(error.what(), legwright::kBadInput);
  } catch (const legwright::IoError& error) {
    return complain(error.what(), legwright::kIoError);
  } catch (const std::filesystem::filesystem_error& error) {
    if (error.code() == std::errc::not_enough_memory)
      return complain("out of memory", legwright::kInternal);
    const std::string to = error.path2().empty() ? "" : " -> " + error.path2().string();
    return complain((error.path1().string() + to + ": " + error.code().message()).c_str(),
                    legwright::kIoError);
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::broken_pipe && std::ferror(stdout) != 0)
      return legwright::kIoError;  // who reads has seen enough: `| head`
    if (error.code() == std::errc::not_enough_memory)
      return complain("out of memory", legwright::kInternal);
    return complain(error.what(), legwright::kIoError);
  } catch (const std::bad_alloc&) {
    return complain("out of memory", legwright::kInternal);
  } catch (const std::exception& error) {
    const std::string message = std::string("internal error: ") + error.what();
    return complain(message.c_str(), legwright::kInternal);
  }
}

int run_program(int argc, char** argv) {
  CLI::App program{"Legwright designs body and gait of a legged robot together, for MuJoCo.",
                   "legwright"};
  program.set_version_flag("--version", legwright::program_version());
  program.require_subcommand(1);
  program.footer(
      "Start with:  legwright check examples/puppy/sideways.toml\n"
      "Exit codes:  0 ok, 1 infeasible or verdict fail, 2 bad input, 3 files, 4 internal, "
      "75 stopped, 130 interrupted");
  Action action;
  for (const auto add_verb : kVerbs) add_verb(program, action);
  if (const std::string complaint = unknown_verb(program, argc, argv); !complaint.empty())
    return complain(complaint.c_str(), legwright::kBadInput);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {  // --help, --version
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    program.exit(error);
    return legwright::kBadInput;
  }
  return run(action);
}

/// The code of the program; 3 where what it had to say on stdout did not get there.
int with_output(int code) {
  if (legwright::flush_stdout() || code > legwright::kInfeasible) return code;
  if (errno == EPIPE) return legwright::kIoError;  // who reads has seen enough: `| head`
  return complain(
      fmt::format("cannot write to stdout: {}", std::generic_category().message(errno)).c_str(),
      legwright::kIoError);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    legwright::start_of_process();
    legwright::end_with_caller();
    const legwright::CleanEnd clean_end;
    return with_output(run_program(argc, argv));
  } catch (const std::bad_alloc&) {
    std::fputs("legwright: out of memory\n", stderr);
    return legwright::kInternal;
  } catch (...) {  // of the parser, or no memory to say what went wrong
    std::fputs("legwright: internal error\n", stderr);
    return legwright::kInternal;
  }
}
