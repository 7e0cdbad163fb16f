// SPDX-License-Identifier: Apache-2.0
#include "tools/render/film_strip.hpp"

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

constexpr int kTitleHeight = 40, kCaptionHeight = 30, kBottom = 8;
constexpr Rgb kFootDown{31, 35, 40}, kFootUp{150, 156, 164};

/// Where the root's x axis points on the ground at a knot [rad].
double heading_of(const Trajectory& plan, int knot) {
  double axis[3];
  for (int c = 0; c < 3; ++c) axis[c] = plan.at(knot, plan.root_column(3 + c));
  const double angle = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  if (angle < 1e-12) return 0.0;
  for (double& part : axis) part /= angle;
  const double c = std::cos(angle), s = std::sin(angle);  // first column of Rodrigues' formula
  return std::atan2(s * axis[2] + (1 - c) * axis[0] * axis[1], c + (1 - c) * axis[0] * axis[0]);
}

void draw_contact(Image& strip, const ContactMark& mark, int right, int bottom) {
  constexpr double kSize = 11.0, kRadius = 4.5;
  constexpr int kPlaque = 40;
  if (mark.feet.empty()) return;
  const Mask plaque{kPlaque, kPlaque, std::vector<std::uint8_t>(kPlaque * kPlaque, 190)};
  stamp(strip, plaque, right - kPlaque, bottom - kPlaque, kPaper);
  for (const auto& foot : mark.feet) {  // forward is up, left is left
    const double x = right - 20.0 - kSize * foot.left, y = bottom - 20.0 - kSize * foot.forward;
    if (foot.down) {
      draw_dot(strip, x, y, kRadius, kFootDown);
    } else {
      draw_dot(strip, x, y, kRadius, kFootUp, 1.5);
    }
  }
}

/// Moves feet that are near to each other apart, so that each dot can be seen.
void spread(std::vector<ContactMark::Foot>& feet) {
  constexpr double kApart = 0.95;
  for (int round = 0; round < 60; ++round) {
    for (std::size_t a = 0; a < feet.size(); ++a) {
      for (std::size_t b = a + 1; b < feet.size(); ++b) {
        double x = feet[b].forward - feet[a].forward, y = feet[b].left - feet[a].left;
        const double distance = std::hypot(x, y);
        if (distance >= kApart) continue;
        if (distance < 1e-6) x = 1e-6;  // one on the other: forward and back
        const double push = 0.25 * (kApart - distance) / std::max(distance, 1e-6);
        feet[a].forward -= push * x;
        feet[a].left -= push * y;
        feet[b].forward += push * x;
        feet[b].left += push * y;
      }
    }
  }
  for (auto& foot : feet) {
    foot.forward = std::clamp(foot.forward, -1.15, 1.15);
    foot.left = std::clamp(foot.left, -1.15, 1.15);
  }
}

}  // namespace

std::vector<ContactMark> contact_marks(const Trajectory& plan, int count) {
  std::vector<ContactMark> marks(static_cast<std::size_t>(count));
  double reach = 1e-9;
  std::vector<ContactMark::Foot> feet;
  for (int f = 0; f < plan.foot_count(); ++f) {  // where the foot is about the root, on average
    ContactMark::Foot foot;
    for (int k = 0; k < plan.knot_count; ++k) {
      const double x = plan.at(k, plan.foot_column(f, 0)) - plan.at(k, plan.root_column(0));
      const double y = plan.at(k, plan.foot_column(f, 1)) - plan.at(k, plan.root_column(1));
      const double heading = heading_of(plan, k);
      foot.forward += std::cos(heading) * x + std::sin(heading) * y;
      foot.left += std::cos(heading) * y - std::sin(heading) * x;
    }
    reach = std::max({reach, std::abs(foot.forward), std::abs(foot.left)});
    feet.push_back(foot);
  }
  for (auto& foot : feet) {
    foot.forward /= reach;
    foot.left /= reach;
  }
  spread(feet);
  for (int i = 0; i < count; ++i) {
    const int knot =
        static_cast<int>(std::lround(static_cast<double>(i) * plan.knot_count / count)) %
        plan.knot_count;
    auto& mark = marks[static_cast<std::size_t>(i)];
    mark.feet = feet;
    for (int f = 0; f < plan.foot_count(); ++f) {
      mark.feet[static_cast<std::size_t>(f)].down = plan.at(knot, plan.contact_column(f)) > 0.5;
    }
  }
  return marks;
}

Image compose_strip(const StripLayout& layout, const std::vector<StripRow>& rows,
                    const std::vector<std::string>& captions, Renderer& letters) {
  const int gap = (kStripWidth - layout.cells * layout.cell_width) / (layout.cells + 1);
  const int margin =
      (kStripWidth - layout.cells * layout.cell_width - (layout.cells - 1) * gap) / 2;
  const int row_height = kTitleHeight + layout.cell_height;
  const int height = static_cast<int>(rows.size()) * row_height + kCaptionHeight + kBottom;
  Image strip(kStripWidth, height, kPaper);
  int top = 0;
  for (const StripRow& row : rows) {
    const Mask title = letters.text(row.title, true);
    const int baseline = top + (kTitleHeight - title.height) / 2;
    const int left = margin + (row.good ? 24 : 2);
    if (row.good)
      draw_dot(strip, margin + 8.0, top + 0.5 * kTitleHeight, 6.0, *row.good ? kGood : kBad);
    stamp(strip, title, left, baseline, kInk);
    if (!row.note.empty()) {
      stamp(strip, letters.text(row.note), left + title.width + 16, baseline + 1, kPale);
    }
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const int x = margin + static_cast<int>(i) * (layout.cell_width + gap),
                y = top + kTitleHeight;
      copy_into(strip, row.cells[i], x, y);
      if (i < row.contact.size()) {
        draw_contact(strip, row.contact[i], x + layout.cell_width, y + layout.cell_height);
      }
    }
    top += row_height;
  }
  for (std::size_t i = 0; i < captions.size(); ++i) {
    const Mask caption = letters.text(captions[i]);
    const int middle =
        margin + static_cast<int>(i) * (layout.cell_width + gap) + layout.cell_width / 2;
    stamp(strip, caption, middle - caption.width / 2,
          top + (kCaptionHeight - caption.height) / 2 + 1, kPale);
  }
  return strip;
}

}  // namespace legwright
