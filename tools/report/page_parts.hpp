// SPDX-License-Identifier: Apache-2.0
// Parts that several sections have in common.
#pragma once

#include <filesystem>
#include <string>

#include "tools/report/html.hpp"
#include "tools/report/page.hpp"
#include "tools/report/page_pictures.hpp"
#include "tools/report/run_data.hpp"

namespace legwright {

/// What the page of a run has around its sections. @param line below the title
PageFrame frame_of(const RunData& data, const std::string& line);
/// The main numbers of any run, for programs.
Json island_of(const RunData& data);
/// A verdict's card. @param verdict null without @param title of the card @param body what was
/// judged @param more markup below the outcome
void add_card(Html& page, const DesignVerdict* verdict, const std::string& title,
              const std::string& body, const std::string& more = "");
/// A paragraph for each file of the run that could not be used.
void add_notes(Html& page, const RunData& data);
/// "✓ pass" or "✗ fail".
void add_pass(Html& page, bool pass);
/// That a picture is too large for the page.
std::string too_large(const std::filesystem::path& file);
/// Whether a picture below the run's folder is there, and not of another result.
bool shows_this(const RunData& data, const std::filesystem::path& picture);
/// Whether the picture of an iteration is there, and not of another design.
bool shows_iteration(const RunData& data, int index);
/// Says that a picture is of another result, where one is there. @param what it shows
/// @return whether it is
bool add_of_another(Html& page, const RunData& data, const std::filesystem::path& picture,
                    const std::string& what);
/// Adds a strip where it is there, of this result, and fits; says so where it is not or does not
/// fit. Whether it is there. @param picture below the run's folder
bool add_strip_if(Html& page, const RunData& data, const std::filesystem::path& picture,
                  const std::string& title, const std::string& explanation, PictureBudget& budget);
/// "legwright VERB RUN", as one would type it.
std::string command(const std::string& verb, const RunData& data);
/// A paragraph that names what is missing and the command for it.
void add_hint(Html& page, const std::string& what, const std::string& verb, const RunData& data);

}  // namespace legwright
