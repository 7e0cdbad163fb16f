// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/summary.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace legwright {
namespace {

std::string parameter_lines(const Json& parameters) {
  std::size_t width = 0;
  for (const Json& p : parameters) width = std::max(width, p["name"].get<std::string>().size());
  std::string text;
  for (const Json& p : parameters) {
    const double initial = p["initial"], final = p["final"],
                 span = p["upper"].get<double>() - p["lower"].get<double>();
    const bool low = final - p["lower"].get<double>() < 1e-6 * span;
    const bool high = p["upper"].get<double>() - final < 1e-6 * span;
    text += fmt::format("    {:{}}  {:8.4f} -> {:8.4f} {}{}\n", p["name"].get<std::string>(), width,
                        initial, final, p["unit"].get<std::string>(),
                        span == 0.0 ? "  frozen"
                        : low       ? "  at its lower bound"
                        : high      ? "  at its upper bound"
                                    : "");
  }
  return text;
}

std::string in_words(const std::string& status, bool motion_only) {
  if (motion_only && status == "iteration_limit")
    return "motion not finished (F hardly falls any more: this body may have no good motion)";
  if (status == "stalled") return "settled (no step improves it any more)";
  if (status == "iteration_limit")
    return "stopped at the iteration limit (usable; a larger --max-iterations goes on)";
  return status;
}

}  // namespace

std::string shell_word(const std::string& text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("/._-+=,:@").find(c) != std::string_view::npos;
  });
  if (plain) return text;
  std::string quoted = "'";
  for (char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

namespace {

std::string start_lines(const Json& starts) {
  std::string text = "  starts   F at the start, at the end\n";
  for (const Json& start : starts)
    text += fmt::format(
        "    from {:12} {:9.5g} -> {:9.5g}  {}, {} design and {} Newton iterations, {:.2f} s\n",
        start["start"].get<std::string>(), start["F_start"].get<double>(), start["F"].get<double>(),
        start["status"].get<std::string>(), start["design_iterations"].get<int>(),
        start["newton_iterations"].get<int>(), start["seconds"].get<double>());
  return text;
}

}  // namespace

namespace {

/// What --physics-steps came to, or nothing.
std::string physics_lines(const Json& task, const std::string& indent) {
  const auto found = task.find("physics_steps");
  if (found == task.end()) return "";
  const Json& steps = *found;
  const double seconds = steps["seconds"];
  if (!steps["changed"].get<bool>())
    return fmt::format("{}physics  no step came closer to the task: the gait stays ({:.1f} s)\n",
                       indent, seconds);
  return fmt::format(
      "{0}physics  before: {1}\n{0}         after:  {2}\n"
      "{0}         the gait played: {3} of the task's ({4:.1f} s); F, speed and certificate "
      "are of the gait before\n",
      indent, steps["before"]["line"].get<std::string>(), steps["after"]["line"].get<std::string>(),
      steps["factors"].get<std::string>(), seconds);
}

}  // namespace

namespace {

/// The whole command as the user waits for it, then its parts, those of the solvers in brackets.
std::string time_line(const Json& seconds) {
  std::string parts;
  for (const char* part :
       {"reading", "search", "results", "certificate", "physics_steps", "front", "pictures"}) {
    const auto found = seconds.find(part);
    if (found == seconds.end()) continue;
    parts += fmt::format("{}{} {:.2f}", parts.empty() ? ": " : ", ",
                         part == std::string_view("physics_steps") ? "physics steps" : part,
                         found->get<double>());
    if (part == std::string_view("search"))
      parts += fmt::format(" (motion {:.2f}, adjoint {:.2f}, predictor {:.2f}, files {:.2f})",
                           seconds["motion"].get<double>(), seconds["adjoint"].get<double>(),
                           seconds["predictor"].get<double>(), seconds["files"].get<double>());
  }
  return fmt::format("  time     {:.2f} s{}\n", seconds["command"].get<double>(), parts);
}

}  // namespace

std::string joint_summary(const Json& run, const std::filesystem::path& root) {
  std::string text = fmt::format("{} {}: {}; best from '{}'\n", run["robot"].get<std::string>(),
                                 run["name"].get<std::string>(),
                                 in_words(run["status"], run["motion_only"].get<bool>()),
                                 run["best_start"].get<std::string>());
  std::size_t width = 8;
  for (const Json& task : run["tasks"])
    width = std::max(width, task["name"].get<std::string>().size());
  text += fmt::format("  F_joint  {:.5g} with the initial body, {:.5g} now\n",
                      run["motion_only_F"].get<double>(), run["final_F"].get<double>());
  for (const Json& task : run["tasks"])
    text += fmt::format("  {:{}} F {:.5g} -> {:.5g}, speed {:.4g} of {:.4g} planned\n",
                        task["name"].get<std::string>(), width, task["F_initial"].get<double>(),
                        task["F"].get<double>(), task["speed_reached"].get<double>(),
                        task["speed_wanted"].get<double>()) +
            physics_lines(task, "    ");
  text += start_lines(run["starts"]);
  for (const Json& start : run["alone"])
    text += fmt::format("    {} alone {:9.5g} -> {:9.5g}  {}, {:.2f} s\n",
                        start["tasks"][0].get<std::string>(), start["F_start"].get<double>(),
                        start["F"].get<double>(), start["status"].get<std::string>(),
                        start["seconds"].get<double>());
  text += time_line(run["seconds"]);
  text += "  body\n" + parameter_lines(run["parameters"]);
  for (const Json& reason : run["reasons"])
    text += "  INFEASIBLE: " + reason.get<std::string>() + "\n";
  const std::string folder = shell_word(root.string());
  text +=
      fmt::format("  written  {0}\nnext: legwright validate {0}   then: render, report\n", folder);
  return text;
}

std::string optimize_summary(const Json& run, const std::filesystem::path& root) {
  const double reached = run["speed_reached"], wanted = run["speed_wanted"];
  std::string text;
  text += fmt::format("{} {}: {} after {} design iterations and {} Newton iterations\n",
                      run["robot"].get<std::string>(), run["task"]["name"].get<std::string>(),
                      in_words(run["status"], run["motion_only"].get<bool>()),
                      run["design_iterations"].get<int>(), run["newton_iterations"].get<int>());
  text += fmt::format("  F        {:.5g} with the initial body, {:.5g} now\n",
                      run["motion_only_F"].get<double>(), run["final_F"].get<double>());
  if (run.contains("outer"))
    text += fmt::format("  J        {:.5g} = {} x {}; the body minimised F + J\n",
                        run["final_J"].get<double>(), run["outer"]["weight"].get<double>(),
                        run["outer"]["objective"].get<std::string>());
  if (run.contains("starts")) text += start_lines(run["starts"]);
  text += fmt::format("  speed    {:.4g} of {:.4g} planned{}\n", reached, wanted,
                      wanted > 0.0 ? fmt::format(" ({:.1f} %)", 100.0 * reached / wanted) : "");
  text += physics_lines(run, "  ");
  text += time_line(run["seconds"]);
  text += fmt::format("  memory   {:.0f} MiB\n", run["peak_rss_mib"].get<double>());
  if (!run["parameters"].empty()) text += "  body\n" + parameter_lines(run["parameters"]);
  for (const Json& reason : run["reasons"])
    text += "  INFEASIBLE: " + reason.get<std::string>() + "\n";
  if (!run["feasible"].get<bool>() && run["motion_only_F"] == run["final_F"])
    text +=
        "  the body is still the initial one: co-design it (without --motion-only), or ask for "
        "less speed\n";
  const std::string folder = shell_word(root.string());
  text += fmt::format("  written  {0}\nnext: legwright validate {0}   then: render, report, play\n",
                      folder);
  return text;
}

}  // namespace legwright
