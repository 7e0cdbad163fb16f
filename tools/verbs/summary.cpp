// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tools/files/shell_word.hpp"

namespace legwright {
namespace {

std::string parameter_lines(const std::vector<ParameterRecord>& parameters) {
  std::size_t width = 0;
  for (const ParameterRecord& p : parameters) width = std::max(width, p.name.size());
  std::string text;
  for (const ParameterRecord& p : parameters) {
    const double span = p.upper - p.lower;
    const bool low = p.final - p.lower < 1e-6 * span;
    const bool high = p.upper - p.final < 1e-6 * span;
    text += fmt::format("    {:{}}  {:8.4f} -> {:8.4f} {}{}\n", p.name, width, p.initial, p.final,
                        p.unit,
                        span == 0.0 ? "  frozen"
                        : low       ? "  at its lower bound"
                        : high      ? "  at its upper bound"
                                    : "");
  }
  return text;
}

/// One of the parts of the run's time; zero where it was not taken.
double seconds_of(const RunRecord& run, const char* part) {
  const double* const found = run.seconds ? run.seconds->find(part) : nullptr;
  return found != nullptr ? *found : 0.0;
}

std::string in_words(const std::string& status, bool motion_only) {
  if (motion_only && status == "iteration_limit")
    return "motion not finished (F hardly falls any more: this body may have no good motion)";
  if (status == "stalled") return "settled (no step improves it any more)";
  if (status == "iteration_limit")
    return "stopped at the iteration limit (usable; a larger --max-iterations goes on)";
  return status;
}

/// Why the result does not do. What was stopped may come to do.
std::string reason_lines(const RunRecord& run) {
  std::string text;
  for (const std::string& reason : *run.reasons)
    text += fmt::format("  {}: {}\n", run.stopped_early() ? "not yet" : "INFEASIBLE", reason);
  return text;
}

/// Where the run is and what comes next. @param folder as a shell's word
std::string last_lines(const RunRecord& run, const std::string& folder, const char* then) {
  if (run.stopped_early())
    return fmt::format(
        "  written  {0}, as far as it came\nnext: legwright optimize --resume {0}   goes on\n",
        folder);
  return fmt::format("  written  {0}\nnext: legwright validate {0}   then: {1}\n", folder, then);
}

std::string start_lines(const std::vector<StartRecord>& starts) {
  std::string text = "  starts   F at the start, at the end\n";
  for (const StartRecord& start : starts)
    text += fmt::format(
        "    from {:12} {:9.5g} -> {:9.5g}  {}, {} design and {} Newton iterations, {:.2f} s\n",
        start.start, start.start_F, start.F, start.status, start.design_iterations,
        start.newton_iterations, start.seconds);
  return text;
}

}  // namespace

namespace {

/// What --physics-steps came to, or nothing.
std::string physics_lines(const std::optional<PhysicsStepsRecord>& steps,
                          const std::string& indent) {
  if (!steps) return "";
  if (!steps->changed)
    return fmt::format("{}physics  no step came closer to the task: the gait stays ({:.1f} s)\n",
                       indent, steps->seconds);
  return fmt::format(
      "{0}physics  before: {1}\n{0}         after:  {2}\n"
      "{0}         the gait played: {3} of the task's ({4:.1f} s); F, speed and certificate "
      "are of the gait before\n",
      indent, steps->before.line, steps->after.line, steps->factors, steps->seconds);
}

/// What MuJoCo said of the optimum of F, and which design is the result instead of it.
std::string choice_lines(const std::optional<ChoiceRecord>& choice) {
  if (!choice || choice->candidates.empty()) return "";
  const CandidateRecord& optimum = choice->candidates.front();
  std::string text = fmt::format("  physics  optimum of F: {}\n", optimum.played.line);
  for (const CandidateRecord& candidate : choice->candidates)
    if (candidate.name == choice->chosen && candidate.name != optimum.name)
      text += fmt::format("           so the result is '{}', F {:.5g}: {}\n", candidate.name,
                          candidate.F, candidate.played.line);
  if (choice->candidates.size() > 1)
    text += fmt::format("           of {} designs played the one {} ({:.1f} s)\n",
                        choice->candidates.size(),
                        choice->by_stability() ? "with the least F that passes with a stable cycle"
                        : choice->pass         ? "with the least F that passes"
                                               : "nearest to passing",
                        choice->seconds);
  return text;
}

/// How few changes of the body would do: for F, and for MuJoCo within a few cycles.
std::string changes_line(const RunRecord& run) {
  const std::optional<FewestChangesRecord>& fewest = run.fewest_changes;
  if (!fewest || fewest->fewest >= fewest->designs.size()) return "";
  const FewerChangesRecord& few = fewest->designs[fewest->fewest];
  std::string text = fmt::format("  changes  {} of {} keep {:.0f} % of the fall of F (F {:.5g})",
                                 few.changed.size(), fewest->designs.front().changed.size(),
                                 100.0 * fewest->share, few.F);
  if (run.tightened()) text += " of the tightened search";
  if (const FewerChangesRecord* const least = least_that_passes(*fewest))
    text += fmt::format(
        "; of these bodies the least changed that MuJoCo passes, for some cycles: {} (F {:.5g})",
        least->changed.size(), least->F);
  return text + "\n";
}

std::string body_lines(const RunRecord& run) {
  if (run.parameters.empty()) return "";
  return run.body_kept() ? "  body     stays as it is\n"
                         : "  body\n" + parameter_lines(run.parameters);
}

/// The whole command as the user waits for it, then its parts, those of the solvers in brackets.
std::string time_line(const RunRecord& run) {
  std::string parts;
  for (const std::string_view part : {"reading", "search", "physics", "results", "reasons",
                                      "certificate", "physics_steps", "front", "pictures"}) {
    const double* const seconds = run.seconds ? run.seconds->find(part) : nullptr;
    if (seconds == nullptr) continue;
    parts += fmt::format("{}{} {:.2f}", parts.empty() ? ": " : ", ",
                         part == "physics_steps" ? "physics steps" : part, *seconds);
    if (part == "search")
      parts += fmt::format(" (motion {:.2f}, adjoint {:.2f}, predictor {:.2f}, files {:.2f})",
                           seconds_of(run, "motion"), seconds_of(run, "adjoint"),
                           seconds_of(run, "predictor"), seconds_of(run, "files"));
  }
  return fmt::format("  time     {:.2f} s{}\n", seconds_of(run, "command"), parts);
}

/// J, and the quantity in it as the plans have it.
std::string outer_lines(const OuterRecord& outer, double J) {
  const bool volume = outer.unit == "m^3";
  const double size = volume ? 1e6 : 1.0;
  const std::string unit = volume ? "cm^3" : outer.unit.value_or("");
  std::string text = fmt::format("  J        {:.5g} = {} x {}", J, outer.weight, outer.objective);
  if (outer.reference) text += fmt::format(" / {:.4g} {}", size * *outer.reference, unit);
  text += "; the body minimised F + J\n";
  if (outer.plan_initial && outer.plan_final)
    text += fmt::format("           planned: {:.4g} {} with the initial body, {:.4g} now\n",
                        size * *outer.plan_initial, unit, size * *outer.plan_final);
  return text;
}

}  // namespace

std::string joint_summary(const RunRecord& run, const std::filesystem::path& root) {
  std::string text = fmt::format("{} {}: {}; best from '{}'\n", run.robot, *run.name,
                                 in_words(run.status, run.motion_only), *run.best_start);
  std::size_t width = 8;
  for (const TaskRecord& task : *run.tasks) width = std::max(width, task.name.size());
  text += fmt::format("  F_joint  {:.5g} with the initial body, {:.5g} now\n", *run.motion_only_F,
                      *run.final_F);
  for (const TaskRecord& task : *run.tasks)
    text += fmt::format("  {:{}} F {:.5g} -> {:.5g}, speed {:.4g} of {:.4g} planned\n", task.name,
                        width, *task.initial_F, *task.F, *task.speed_reached, *task.speed_wanted) +
            physics_lines(task.physics_steps, "    ");
  text += start_lines(*run.starts);
  text += choice_lines(run.choice);
  for (const StartRecord& start : *run.alone)
    text += fmt::format("    {} alone {:9.5g} -> {:9.5g}  {}, {:.2f} s\n", start.tasks.front(),
                        start.start_F, start.F, start.status, start.seconds);
  text += changes_line(run);
  text += time_line(run);
  text += body_lines(run);
  text += reason_lines(run);
  text += last_lines(run, shell_word(root.string()), "render, report");
  return text;
}

std::string optimize_summary(const RunRecord& run, const std::filesystem::path& root) {
  const double reached = *run.speed_reached, wanted = *run.speed_wanted;
  std::string text;
  text += fmt::format("{} {}: {} after {} design iterations and {} Newton iterations\n", run.robot,
                      run.task->name, in_words(run.status, run.motion_only), *run.design_iterations,
                      *run.newton_iterations);
  text += fmt::format("  F        {:.5g} with the initial body, {:.5g} now\n", *run.motion_only_F,
                      *run.final_F);
  if (run.outer) text += outer_lines(*run.outer, *run.final_J);
  if (run.starts) text += start_lines(*run.starts);
  text += fmt::format("  speed    {:.4g} of {:.4g} planned{}\n", reached, wanted,
                      wanted > 0.0 ? fmt::format(" ({:.1f} %)", 100.0 * reached / wanted) : "");
  text += choice_lines(run.choice);
  text += physics_lines(run.physics_steps, "  ");
  text += changes_line(run);
  text += time_line(run);
  text += fmt::format("  memory   {:.0f} MiB\n", *run.peak_rss_mib);
  text += body_lines(run);
  text += reason_lines(run);
  if (!run.stopped_early() && !*run.feasible && *run.motion_only_F == *run.final_F)
    text +=
        "  the body is still the initial one: co-design it (without --motion-only), or ask for "
        "less speed\n";
  text += last_lines(run, shell_word(root.string()), "render, report, play");
  return text;
}

}  // namespace legwright
