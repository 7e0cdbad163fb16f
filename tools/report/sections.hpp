// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/report/html.hpp"
#include "tools/report/joint_data.hpp"
#include "tools/report/page_pictures.hpp"
#include "tools/report/run_data.hpp"
#include "tools/report/words.hpp"

namespace legwright {

/// The page's style sheet: system fonts, light and dark, print.
std::string_view report_style();

// One part of the report each, in the order of the page. What is not there yet is said, with the
// command that makes it.
void add_verdicts(Html& page, const RunData& data);
void add_pictures(Html& page, const RunData& data, PictureBudget& budget);
void add_design_effect(Html& page, const RunData& data);
void add_attribution(Html& page, const RunData& data);  // part of the one before
void add_gap(Html& page, const RunData& data);
void add_progress(Html& page, const RunData& data);
void add_gallery(Html& page, const RunData& data);
void add_terms(Html& page, const RunData& data);
void add_certificate(Html& page, const RunData& data);
void add_limits(Html& page, const RunData& data);
void add_physics(Html& page, const RunData& data);
void add_comparison(Html& page, const RunData& data, PictureBudget& budget);
void add_robustness(Html& page, const RunData& data);
void add_numerics(Html& page, const RunData& data);
void add_plan(Html& page, const RunData& data);
void add_origin(Html& page, const RunData& data);

// The parts of the page of a joint run, likewise.
void add_task_cards(Html& page, const JointData& data);
void add_matrix(Html& page, const JointData& data);
void add_task_pictures(Html& page, const JointData& data);
void add_bodies(Html& page, const JointData& data);
void add_task_attributions(Html& page, const JointData& data);
void add_front(Html& page, const JointData& data);
void add_starts(Html& page, const JointData& data);

inline constexpr double kSmallTerm = 0.01;  // of F: smaller terms are folded away

// Words that the page, the summary and the page of two runs share.
/// "All 12 limits are kept."
std::string limits_kept(const std::vector<LimitRow>& rows);
/// What was measured against a limit: "98.2 %", "0.6°", "not measured".
std::string measured_words(const LimitRow& row);
/// "95 % … 105 %", "at most 20°", "none"
std::string bound_words(const LimitRow& row);
/// The unit in which a factor's values are told.
ShownUnit unit_of(const RobustnessFactor& factor);
/// "survives from 0.3 to 1.6"
std::string margin_words(const RobustnessFactor& factor);
/// "187 of 200 draws survived: 93.5 % (95 % interval 89.2 % … 96.2 %)."; empty without numbers.
std::string survival_words(const MonteCarlo& drawn);
/// Why there are no margins, if the gait fails undisturbed; empty otherwise.
std::string no_margins_words(const JudgedData& data);
/// One sentence on numerics.json; empty without.
std::string numerics_words(const NumericsRecord& numerics);
/// What inverse dynamics says of the plan, in words.
std::string inverse_dynamics_words(const InverseDynamics& plan);

/// What MuJoCo said of a gait before or after the physics steps.
struct GapSide {
  bool pass = false;
  std::string words;
};
/// What `optimize --physics-steps` did, in words.
struct GapView {
  bool changed = false;  // else no step was confirmed
  std::string factors;   // "speed × 1.012, swing height × 1.05"
  GapSide before, after;
  std::size_t steps = 0, confirmed = 0;
};
/// Nothing where there were no such steps.
std::optional<GapView> gap_of(const RunRecord& run);
/// Whether the result of a run, or of one of its tasks, is another gait than that of its F, terms
/// and certificate, which belong to the last iteration.
bool gait_was_stepped(const TaskRecord& task);
bool gait_was_stepped(const RunRecord& run);
/// The same of a joint run in a sentence; empty where no task's gait was changed.
std::string stepped_words(const JointData& data);
/// Says so, where it is so. @param what "This chart is": what is of the gait before
void add_gap_note(Html& page, const RunRecord& run, const std::string& what);

/// A verdict's card. @param verdict null without @param title of the card @param body what was
/// judged @param more markup below the outcome
void add_card(Html& page, const DesignVerdict* verdict, const std::string& title,
              const std::string& body, const std::string& more = "");
/// "✓ pass" or "✗ fail".
void add_pass(Html& page, bool pass);
/// Adds a strip where it is there and fits; says so where it does not fit. Whether it is there.
bool add_strip_if(Html& page, const std::filesystem::path& file, const std::string& title,
                  const std::string& explanation, PictureBudget& budget);
/// "legwright VERB RUN", as one would type it.
std::string command(const std::string& verb, const RunData& data);
/// A paragraph that names what is missing and the command for it.
void add_hint(Html& page, const std::string& what, const std::string& verb, const RunData& data);

}  // namespace legwright
