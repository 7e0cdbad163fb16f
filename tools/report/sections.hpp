// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/report/html.hpp"
#include "tools/report/joint_data.hpp"
#include "tools/report/page_parts.hpp"
#include "tools/report/page_pictures.hpp"
#include "tools/report/run_data.hpp"
#include "tools/report/svg_plot.hpp"

namespace legwright {

// One part of the report each, in the order of the page. What is not there yet is said, with the
// command that makes it.
void add_verdicts(Html& page, const RunData& data);
void add_pictures(Html& page, const RunData& data, PictureBudget& budget);
void add_design_effect(Html& page, const RunData& data);
void add_attribution(Html& page, const RunData& data);    // part of the one before
void add_fewest(Html& page, const RunRecord& run);        // part of the same
void add_choice(Html& page, const RunRecord& run);        // nothing where the optimum passes
void add_other_starts(Html& page, const RunRecord& run);  // nothing with one start
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
void add_strength(Html& page, const RunData& data);  // nothing where no parts were made
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

/// "3 of 20 changes buy 96 % of the fall of F …: a, b and c."; empty where it is not known.
std::string fewest_words(const RunRecord& run);
/// Of all parts whether they are strong enough, and which is nearest to its limit.
std::string strength_words(const StrengthRecord& strength);
/// Which design was handed back instead of the optimum of F, and why; empty where that passes.
std::string choice_words(const RunRecord& run);
/// "5 other starts end within 6 % of the least F; …"; empty where there were none.
std::string other_starts_words(const RunRecord& run);
/// What the events of a run's iterations hold, as a line of a chart.
PlotSeries by_iteration(const RunData& data, double IterationEvent::*value, const std::string& name,
                        int colour = 1);
/// Of which tasks of a joint run the gait was changed after the optimisation, in a sentence; empty
/// where it was of none.
std::string stepped_words(const JointData& data);
/// Says of a run whose gait was changed that something is of the gait before.
/// @param what "This chart is": what is of the gait before
void add_gap_note(Html& page, const RunRecord& run, const std::string& what);

}  // namespace legwright
