// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/report/html.hpp"
#include "tools/report/joint_data.hpp"
#include "tools/report/run_data.hpp"

namespace legwright {

/// The page's style sheet: system fonts, light and dark, print.
std::string_view report_style();

// One part of the report each, in the order of the page. What is not there yet is said, with the
// command that makes it.
void add_verdicts(Html& page, const RunData& data);
void add_pictures(Html& page, const RunData& data);
void add_design_change(Html& page, const RunData& data);
void add_progress(Html& page, const RunData& data);
void add_gallery(Html& page, const RunData& data);
void add_terms(Html& page, const RunData& data);
void add_certificate(Html& page, const RunData& data);
void add_physics(Html& page, const RunData& data);
void add_plan(Html& page, const RunData& data);
void add_origin(Html& page, const RunData& data);

// The parts of the page of a joint run, likewise.
void add_task_cards(Html& page, const JointData& data);
void add_matrix(Html& page, const JointData& data);
void add_task_pictures(Html& page, const JointData& data);
void add_bodies(Html& page, const JointData& data);
void add_task_pulls(Html& page, const JointData& data);
void add_front(Html& page, const JointData& data);
void add_starts(Html& page, const JointData& data);

/// A strip of pictures with its explanation.
void add_strip(Html& page, const std::filesystem::path& file, const std::string& title,
               const std::string& explanation);
/// "legwright VERB RUN", as one would type it.
std::string command(const std::string& verb, const RunData& data);
/// A paragraph that names what is missing and the command for it.
void add_hint(Html& page, const std::string& what, const std::string& verb, const RunData& data);

}  // namespace legwright
