// SPDX-License-Identifier: Apache-2.0
#include "tools/report/page_parts.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "tools/image/picture_origin.hpp"
#include "tools/report/judged_words.hpp"
#include "tools/report/page_template.hpp"

namespace legwright {

namespace fs = std::filesystem;

PageFrame frame_of(const RunData& data, const std::string& line) {
  PageFrame frame;
  frame.title = data.title;
  frame.line = line;
  frame.footer =
      "Made by legwright report from the files of this run; nothing is fetched from elsewhere.";
  frame.island = island_of(data);
  return frame;
}

Json island_of(const RunData& data) {
  Json island{{"schema", "legwright/report"}, {"version", 1}};
  const RunRecord& run = data.run;
  island["robot"] = run.robot;
  island["task"] = run.task ? json_of(*run.task) : Json();
  island["status"] = run.status;
  island["motion_only_F"] = or_null(run.motion_only_F);
  island["final_F"] = or_null(run.final_F);
  island["parameters"] = json_of(run.parameters);
  JudgedSums of = data.sums;
  if (data.verdict && data.verdict->of)
    if (const std::string* const limits = data.verdict->of->find(kLimitsSum))
      of.of(kLimitsSum) = *limits;
  island["of"] = json_of(of);
  return island;
}

void add_card(Html& page, const DesignVerdict* verdict, const std::string& title,
              const std::string& body, const std::string& more) {
  std::string outcome;
  if (verdict != nullptr && !verdict->reasons.empty()) {
    outcome = "<ul>\n" +
              each(verdict->reasons,
                   [](const std::string& reason) {
                     return fill("<li>{reason}</li>\n", {{"reason", with_degrees(reason)}});
                   }) +
              "</ul>";
  } else if (verdict != nullptr) {
    outcome = fill("<p>{line}</p>", {{"line", verdict_details(verdict->line)}});
  }
  if (!outcome.empty() && !more.empty()) outcome += '\n';
  page.raw(fill(R"(<div class="card{pass}"><h2>{title}</h2>
<p class="verdict">{mark}</p>
<p class="note">{body}</p>
{outcome}{more}</div>
)",
                {{"pass", verdict == nullptr ? ""
                          : verdict->pass    ? " pass"
                                             : " fail"},
                 {"title", title},
                 {"mark", verdict == nullptr ? "Not validated"
                          : verdict->pass    ? "✓ Pass"
                                             : "✗ Fail"},
                 {"body", body},
                 Hole::markup("outcome", outcome),
                 Hole::markup("more", more)}));
}

std::string command(const std::string& verb, const RunData& data) {
  return "legwright " + verb + " " + data.root.generic_string();
}

void add_notes(Html& page, const RunData& data) {
  for (const std::string& note : data.notes) page.note("Could not be used: " + note, "hint");
}

void add_pass(Html& page, bool pass) {
  page.element("span", pass ? "✓ pass" : "✗ fail", {{"class", pass ? "good" : "bad"}});
}

void add_hint(Html& page, const std::string& what, const std::string& verb, const RunData& data) {
  page.raw(fill("<p class=\"hint\">{what} Run <code>{command}</code>, then the report again.</p>\n",
                {{"what", what}, {"command", command(verb, data)}}));
}

std::string too_large(const fs::path& file) {
  return fmt::format("The picture is too large for this page: result/{}.",
                     file.filename().string());
}

namespace {

/// Whether a picture is there that is not of another. Throws as read_file() does.
bool shows(const fs::path& file, const fs::path& folder, const JudgedSums& here) {
  return fs::exists(file) &&
         standing_of_picture(picture_origin(file), folder, here) != Standing::of_another;
}

}  // namespace

bool shows_this(const RunData& data, const fs::path& picture) {
  return shows(data.root / picture, data.root, data.sums);
}

bool shows_iteration(const RunData& data, int index) {
  const fs::path folder = data.iteration(index);
  try {
    return shows(folder / "frame.png", folder, {});
  } catch (const std::runtime_error&) {
    return true;  // whoever shows it says why it cannot be
  }
}

bool add_of_another(Html& page, const RunData& data, const fs::path& picture,
                    const std::string& what) {
  if (!fs::exists(data.root / picture) || shows_this(data, picture)) return false;
  page.note(fmt::format("{} {} is {}.", what, picture.generic_string(), kPictureOfAnother));
  return true;
}

bool add_strip_if(Html& page, const RunData& data, const fs::path& picture,
                  const std::string& title, const std::string& explanation, PictureBudget& budget) {
  const fs::path file = data.root / picture;
  if (add_of_another(page, data, picture, title) || !fs::exists(file)) return false;
  if (budget.take(file)) {
    add_strip(page, file, title, explanation);
  } else {
    page.note(title + " " + too_large(file));
  }
  return true;
}

}  // namespace legwright
