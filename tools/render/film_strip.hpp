// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plugin/trajectory.hpp"
#include "tools/render/renderer.hpp"

namespace legwright {

inline constexpr int kStripWidth = 1600;  // [pixels] of a whole strip
// Colours of a strip: behind it, of titles, of what is less important, of rows that passed and not.
inline constexpr Rgb kPaper{255, 255, 255}, kInk{31, 35, 40}, kPale{110, 118, 129},
    kGood{26, 127, 55}, kBad{207, 34, 46};

/// How a strip is divided: cells side by side.
struct StripLayout {
  int cells = 8;
  int cell_width = 196, cell_height = 176;  // [pixels]
};

/// Feet as seen from above, and which of them bear: drawn as dots in a corner of a cell.
struct ContactMark {
  struct Foot {
    double forward = 0.0, left = 0.0;  // −1 … 1
    bool down = false;
  };
  std::vector<Foot> feet;
};

/// Contact marks of the plan at `count` equally spaced phases.
std::vector<ContactMark> contact_marks(const Trajectory& plan, int count);

/// One line of pictures.
struct StripRow {
  std::string title;
  std::string note;                  // right of the title, paler; may be empty
  std::optional<bool> good;          // a green or red dot before the title; none: no dot
  std::vector<Image> cells;          // of the layout's size
  std::vector<ContactMark> contact;  // one per cell, or none
};

/// Rows over each other, cells side by side, a caption under each column. `letters` draws the text.
Image compose_strip(const StripLayout& layout, const std::vector<StripRow>& rows,
                    const std::vector<std::string>& captions, Renderer& letters);

}  // namespace legwright
