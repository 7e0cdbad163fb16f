// SPDX-License-Identifier: Apache-2.0
// The page of a run of one task.
#include "tools/report/page_viewer.hpp"
#include "tools/report/report.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {

std::string report_page(const RunData& data) {
  PageFrame frame = frame_of(data, task_words(data.run));
  frame.island["verdict"] = data.verdict ? json_of(*data.verdict) : Json();
  const PageViewer viewer = viewer_of(data);
  frame.scenes = viewer.scenes;
  return framed_page(frame, [&](Html& page) {
    if (data.run.joint_run == "../..") {
      page.open("p", {{"class", "note"}}).text("One task of a joint run: ");
      page.element("a", "report of the whole", {{"href", "../../report.html"}}).text(".").close();
    }
    add_notes(page, data);  // and once more at the end
    add_verdicts(page, data);
    add_viewer(page, viewer);
    PictureBudget budget;
    add_pictures(page, data, budget);
    add_design_effect(page, data);
    add_limits(page, data);
    add_physics(page, data);
    add_comparison(page, data, budget);
    add_plan(page, data);
    add_robustness(page, data);
    add_numerics(page, data);
    add_strength(page, data);
    add_choice(page, data.run);
    add_gap(page, data);
    add_other_starts(page, data.run);
    add_progress(page, data);
    add_gallery(page, data);
    add_terms(page, data);
    add_certificate(page, data);
    add_origin(page, data);
  });
}

}  // namespace legwright
