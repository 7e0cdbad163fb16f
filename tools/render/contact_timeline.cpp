// SPDX-License-Identifier: Apache-2.0
#include "tools/render/contact_timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

constexpr int kTitle = 40, kFoot = 38, kAxis = 34, kBar = 12, kRight = 24;
constexpr int kLeastLeft = 96, kBesideName = 14, kEdge = 7;
constexpr Rgb kBand{244, 246, 248}, kRule{208, 213, 219}, kPlanned{150, 178, 214},
    kStands{31, 35, 40}, kTouches{221, 110, 20};

using Intervals = std::vector<std::pair<double, double>>;

/// Where times lie in the picture.
struct TimeAxis {
  double end = 1.0;       // [s]
  int left = kLeastLeft;  // of the picture's edge; names of feet stand there
  int x(double time) const {
    return left + static_cast<int>(std::lround(time / end * (kStripWidth - left - kRight)));
  }
  double time(int x) const {
    return static_cast<double>(x - left) / (kStripWidth - left - kRight) * end;
  }
};

void blend_column(Image& image, int x, int top, Rgb colour, double cover) {
  if (cover <= 0.0) return;
  const Mask column{
      1, kBar,
      std::vector<std::uint8_t>(kBar, static_cast<std::uint8_t>(std::lround(255.0 * cover)))};
  stamp(image, column, x, top, colour);
}

/// The bars of one foot; what lasts less than a pixel is paler.
void draw_foot(Image& image, const TimeAxis& axis, const FootBars& foot, double period,
               double until, int top) {
  const Intervals planned = repeated(foot.planned, period, axis.end);
  for (int x = axis.x(0.0); x < axis.x(axis.end); ++x) {
    const double from = axis.time(x), to = axis.time(x + 1);
    const double plan = covered(planned, from, to);
    blend_column(image, x, top + 6, kPlanned, plan);
    if (from >= until) continue;
    blend_column(image, x, top + 7 + kBar, plan > 0.5 ? kStands : kTouches,
                 covered(foot.measured, from, to));
  }
}

/// Lines and numbers at round times.
void draw_axis(Image& image, const TimeAxis& axis, int top, int bottom, Renderer& letters) {
  const double steps[] = {0.1, 0.2, 0.5, 1.0, 2.0, 5.0};
  double step = steps[0];
  for (const double candidate : steps)
    if (axis.end / step > 10.0) step = candidate;
  for (int k = 0; k * step <= axis.end + 1e-9; ++k) {
    const int x = axis.x(k * step);
    fill(image, x, top, 1, bottom - top, kRule);
    const Mask label = letters.text(fmt::format("{:.1f} s", k * step));
    stamp(image, label, std::min(x - label.width / 2, kStripWidth - 2 - label.width), bottom + 6,
          kPale);
  }
}

int draw_legend(Image& image, int x, int top, Renderer& letters) {
  const std::pair<Rgb, const char*> entries[] = {
      {kPlanned, "planned to bear"},
      {kStands, "touches, as planned"},
      {kTouches, "touches otherwise; a while before and after bearing is planned"}};
  for (const auto& [colour, text] : entries) {
    const Mask label = letters.text(text);
    fill(image, x, top + kTitle / 2 - kBar / 2, 22, kBar, colour);
    stamp(image, label, x + 30, top + (kTitle - label.height) / 2 + 1, kPale);
    x += 30 + label.width + 26;
  }
  return x;
}

void draw_block(Image& image, const TimeAxis& axis, const GaitClip& clip, int top,
                Renderer& letters) {
  const Mask title = letters.text(clip.title, true);
  if (clip.passed) draw_dot(image, 13.0, top + 0.5 * kTitle, 6.0, *clip.passed ? kGood : kBad);
  const int after_dot = clip.passed ? 29 : 7;
  stamp(image, title, after_dot, top + (kTitle - title.height) / 2, kInk);
  std::string note = "contacts of the feet, simulated by MuJoCo";
  if (clip.fell) note += fmt::format(": falls after {:.2f} s", *clip.fell);
  const Mask paler = letters.text(note);
  stamp(image, paler, after_dot + title.width + 16, top + (kTitle - paler.height) / 2 + 1, kPale);
  const int first = top + kTitle, bottom = first + kFoot * static_cast<int>(clip.feet.size());
  const double until = clip.playback->time.back();
  for (std::size_t f = 0; f < clip.feet.size(); ++f) {
    const int y = first + kFoot * static_cast<int>(f);
    if (f % 2 == 0) fill(image, axis.left, y, axis.x(axis.end) - axis.left, kFoot, kBand);
  }
  draw_axis(image, axis, first, bottom, letters);
  for (std::size_t f = 0; f < clip.feet.size(); ++f) {
    const int y = first + kFoot * static_cast<int>(f);
    const Mask name = letters.text(clip.feet[f].name);
    stamp(image, name, axis.left - kBesideName - name.width, y + (kFoot - name.height) / 2, kInk);
    draw_foot(image, axis, clip.feet[f], clip.plan.period, until, y);
  }
  if (until < axis.end - 1e-6) fill(image, axis.x(until), first, 3, bottom - first, kBad);
}

}  // namespace

double covered(const Intervals& intervals, double from, double to) {
  double sum = 0.0;
  for (const auto& [start, end] : intervals)
    sum += std::max(0.0, std::min(end, to) - std::max(start, from));
  return to > from ? std::min(1.0, sum / (to - from)) : 0.0;
}

Intervals repeated(const Intervals& of_one_cycle, double period, double end) {
  Intervals all;
  for (int cycle = -1; cycle * period < end; ++cycle)  // a stance may end in the next cycle
    for (const auto& [start, stop] : of_one_cycle)
      all.emplace_back(start + cycle * period, stop + cycle * period);
  return all;
}

Image contact_timeline(const std::vector<GaitClip>& clips, Renderer& letters) {
  TimeAxis axis{0.0};
  int height = kTitle;
  for (const GaitClip& clip : clips) {
    axis.end = std::max(axis.end, clip.playback->time.back());
    height += kTitle + kFoot * static_cast<int>(clip.feet.size()) + kAxis;
    for (const FootBars& foot : clip.feet)
      axis.left = std::max(axis.left, letters.text(foot.name).width + kBesideName + kEdge);
  }
  axis.left = std::min(axis.left, kStripWidth / 3);  // the bars have the most of it
  Image image(kStripWidth, height, kPaper);
  int top = 0;
  for (const GaitClip& clip : clips) {
    draw_block(image, axis, clip, top, letters);
    top += kTitle + kFoot * static_cast<int>(clip.feet.size()) + kAxis;
  }
  draw_legend(image, axis.left, top, letters);
  return image;
}

}  // namespace legwright
