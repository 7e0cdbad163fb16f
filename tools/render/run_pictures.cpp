// SPDX-License-Identifier: Apache-2.0
#include "tools/render/run_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <span>

#include "tools/files/atomic_file.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/io_error.hpp"
#include "tools/image/picture_origin.hpp"
#include "tools/image/png.hpp"
#include "tools/image/webp.hpp"
#include "tools/render/contact_timeline.hpp"
#include "tools/render/gait_animation.hpp"
#include "tools/render/iteration_painter.hpp"
#include "tools/render/strips.hpp"
#include "tools/run/judged_sums.hpp"
#include "tools/run/result_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kSmaller = 3;            // small.webp is a third of the painter's width and height
constexpr float kSmallQuality = 70.0;  // of WebP, 0 … 100

/// What is drawn of physics is what the verdict, if there is one, judged.
JudgedSums with_verdict(const fs::path& run, JudgedSums sums) {
  const char* const verdict = "result/verdict.json";
  if (fs::is_regular_file(run / verdict)) sums.of(verdict) = sha256_hex(read_file(run / verdict));
  return sums;
}

/// Whether an iteration has its picture, not that of another design.
bool is_drawn(const fs::path& iteration) {
  const fs::path file = iteration / "frame.png";
  return fs::exists(file) &&
         standing_of_picture(picture_origin(file), iteration, {}) != Standing::of_another;
}

class RunDrawing {
 public:
  RunDrawing(const fs::path& run, const RunPictureOptions& options)
      : run_(run),
        options_(options),
        sums_(sums_of_run(run)),
        planned_(origin_text(sums_)),
        judged_(origin_text(with_verdict(run, sums_))),
        painter_(run / "iterations" / "0000" / "scene.xml") {}

  RunPictures draw() {
    if (!options_.only_phases && !options_.only_small) draw_iterations();
    const fs::path result = run_ / "result";
    if (!fs::exists(result / "scene.xml") || !fs::exists(result / "motion.csv")) {
      out_.left_out.push_back(
          "pictures of the result: the run has none yet; finish legwright optimize");
      return std::move(out_);
    }
    if (options_.only_small) {
      draw_small(result / "scene.xml");
      return std::move(out_);
    }
    const std::vector<GaitClip> clips = load_clips(run_);
    if (fs::exists(result / "verdict.json") && !clips.back().passed)
      out_.left_out.push_back(std::string("what result/verdict.json says: ") + kOfAnother +
                              " (legwright validate)");
    draw_phases(clips);
    if (options_.only_phases) return std::move(out_);
    draw_planned(clips);
    draw_simulated(clips);
    finish("gait.webp", [&] {
      return encode_webp_within(animate_gait(context(), clips.back()), kAnimationBytes, judged_);
    });
    return std::move(out_);
  }

 private:
  const GlContext& context() const { return painter_.context(); }

  /// Times and tells the making of one file, which `make` writes.
  template <class Make>
  void finish_at(const fs::path& file, const Make& make) {
    const auto start = Clock::now();
    make(file);
    const std::chrono::duration<double, std::milli> spent = Clock::now() - start;
    out_.made.push_back({file, spent.count()});
    if (options_.on_picture) options_.on_picture(out_.made.back());
  }
  /// A picture of the result, as bytes, unless another result stands there by now.
  template <class Make>
  void finish(const std::string& name, const Make& make) {
    finish_at(run_ / "result" / name, [&](const fs::path& file) {
      const std::vector<std::uint8_t> bytes = make();
      check_unchanged(run_, sums_, sums_of_run(run_), "render");
      write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    });
  }

  void draw_iterations() {
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(run_ / "iterations")) {
      const bool hidden = entry.path().filename().string().starts_with('.');  // half-written
      if (!hidden && fs::exists(entry.path() / "scene.xml")) folders.push_back(entry.path());
    }
    std::sort(folders.begin(), folders.end());
    for (const fs::path& folder : folders) {
      if (!options_.all && is_drawn(folder)) continue;
      finish_at(folder / "frame.png",
                [&](const fs::path& file) { painter_.paint(folder / "scene.xml", file); });
    }
  }

  void draw_small(const fs::path& scene) {
    finish("small.webp", [&] {
      const Image picture = downsample(painter_.draw(scene), kSmaller);
      return encode_webp({{picture}, {1000}}, kSmallQuality, planned_);
    });
  }

  void draw_phases(const std::vector<GaitClip>& clips) {
    for (const double phase : options_.phases) {
      finish(fmt::format("still_{}.png", phase),
             [&] { return encode_png(still(context(), clips.back(), phase), planned_); });
      if (clips.size() < 2) continue;  // nothing before
      finish(fmt::format("still_before_after_{}.png", phase),
             [&] { return encode_png(still_side_by_side(context(), clips, phase), planned_); });
    }
  }

  void draw_planned(const std::vector<GaitClip>& clips) {
    PlannedStrip strip;
    const auto compose = [&](std::span<const StripRow> rows) {
      Renderer letters = cell_renderer(context(), *clips[0].model, strip.layout);
      return compose_strip(strip.layout, {rows.begin(), rows.end()}, strip.captions, letters);
    };
    finish("strip_initial.png", [&] {
      strip = planned_strip(context(), clips);
      return encode_png(compose(std::span(strip.rows).first(1)), planned_);
    });
    finish("strip_result.png",
           [&] { return encode_png(compose(std::span(strip.rows).last(1)), planned_); });
    finish("strip_before_after.png", [&] { return encode_png(compose(strip.rows), planned_); });
  }

  void draw_simulated(const std::vector<GaitClip>& clips) {
    const auto every = [&](auto has) { return std::all_of(clips.begin(), clips.end(), has); };
    if (!every([](const GaitClip& clip) { return clip.playback.has_value(); })) {
      for (const char* name : {"strip_physics.png", "overlay.png", "contact_timeline.png"})
        out_.left_out.push_back(std::string(name) + ": run legwright validate first");
      return;
    }
    finish("strip_physics.png",
           [&] { return encode_png(physics_strip(context(), clips), judged_); });
    finish("overlay.png", [&] { return encode_png(overlay_strip(context(), clips), judged_); });
    if (!every([](const GaitClip& clip) { return !clip.feet.empty(); })) {
      out_.left_out.push_back(
          "contact_timeline.png: metrics.json does not tell of the feet; run legwright validate "
          "again");
      return;
    }
    finish("contact_timeline.png", [&] {
      Renderer letters(context(), *clips[0].model, 64, 48, RenderStyle::cheap);
      return encode_png(contact_timeline(clips, letters), judged_);
    });
  }

  fs::path run_;
  RunPictureOptions options_;
  JudgedSums sums_;               // of what is drawn
  std::string planned_, judged_;  // what pictures of the plan, and of physics carry of it
  IterationPainter painter_;
  RunPictures out_;
};

}  // namespace

RunPictures draw_run(const fs::path& run, const RunPictureOptions& options) {
  const fs::path first = ResultFolder::open(run).iteration(0) / "scene.xml";
  if (!fs::exists(first)) {
    throw IoError(first.string() + ": no such file; the run was stopped before its first design: " +
                  "run `legwright optimize` again, with --force");
  }
  return RunDrawing(run, options).draw();
}

}  // namespace legwright
