// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/report/html.hpp"
#include "tools/report/joint_data.hpp"
#include "tools/report/run_data.hpp"

namespace legwright {

/// What the viewer of a page shows: scenes as viewed_scenes_json() has them, in text, empty where
/// the run has none; and why a scene could not be used.
struct PageViewer {
  std::string scenes;
  std::vector<std::string> notes;
};

/// The given body with the gait that is best for it, and the result.
PageViewer viewer_of(const RunData& data);
/// The same of each task of a joint run.
PageViewer viewer_of(const JointData& data);

/// The place for the viewer, with a sentence of how it is used; hidden where a browser runs no
/// script or draws nothing in three dimensions.
void add_viewer(Html& page, const PageViewer& viewer);

/// The scripts of a page with a viewer, as elements at its end, and what the content policy must
/// allow of them: script-src with the hash of each, nothing else.
struct ViewerScripts {
  std::string markup, policy;
};
ViewerScripts viewer_scripts(const std::string& scenes);

/// Script text that ends no element and no CDATA section.
std::string harmless_script(std::string text);

}  // namespace legwright
