#include "app/window/judge_desk.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "app/window/window.h"
#include "pipeline/scene/settings_file.h"
#include "studies/reference/drawing.h"

namespace inkbench {
namespace {

/// Lines that took longer than this are not found anew while something is dragged.
constexpr double kLongMs = 25.0;
constexpr float kReferenceVeil = 0.55F, kMatchesVeil = 0.8F;

double ms_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

Texture upload_rgba(const char* label, const Picture& picture) {
  Image image(picture.width_px, picture.height_px, 4);
  std::transform(picture.samples.begin(), picture.samples.end(), image.samples.begin(),
                 [](uint8_t value) { return static_cast<float>(value) / 255.0F; });
  Texture texture(label, TextureFormat::rgba8, picture.width_px, picture.height_px);
  texture.upload(image);
  return texture;
}

/// The picture of the lines, clear where it is white.
Picture clear_reference(const ReferenceLines& lines) {
  const Picture drawn = draw_reference(lines);
  Picture clear(drawn.width_px, drawn.height_px, 4);
  for (int y = 0; y < drawn.height_px; ++y) {
    for (int x = 0; x < drawn.width_px; ++x) {
      const bool line = std::min({drawn.at(x, y, 0), drawn.at(x, y, 1), drawn.at(x, y, 2)}) < 255;
      for (int c = 0; c < 3; ++c) clear.at(x, y, c) = drawn.at(x, y, c);
      clear.at(x, y, 3) = line ? 255 : 0;
    }
  }
  return clear;
}

Key edges_key(Pipeline& pipeline, const Settings& settings, const Key& lines) {
  return KeyBuilder().add(pipeline.buffer_key(settings, BufferName::combined_edges)).add(lines).key();
}

JudgedView view_of(Pipeline& pipeline, const Settings& settings,
                   std::shared_ptr<const ReferenceLines> lines) {
  return {std::make_shared<Image>(pipeline.raw(settings, BufferName::combined_edges)), std::move(lines)};
}

}  // namespace

JudgeDesk::JudgeDesk()
    : lines_ms_(std::numeric_limits<double>::infinity()),
      judge_([this] {
        news_ = true;
        wake_window();
      }),
      pinned_judge_([this] {
        news_ = true;
        wake_window();
      }) {}

/// Returns whether the lines are those of the settings.
bool JudgeDesk::refresh_lines(BufferSource& source, const Settings& settings, bool hurry) {
  const Key key = source.reference_key(settings);
  late_ = false;
  if (lines_ && key == lines_key_) return true;
  late_ = hurry && lines_ms_ > kLongMs;
  if (late_) return false;
  const auto start = std::chrono::steady_clock::now();
  lines_ = std::make_shared<ReferenceLines>(source.reference(settings));
  lines_ms_ = ms_since(start);
  lines_key_ = key;
  return true;
}

void JudgeDesk::refresh_measures(Pipeline& pipeline, const Settings& settings) {
  const Key key = edges_key(pipeline, settings, lines_key_);
  if (key == asked_) {
    behind_ = !now_ || now_->id != last_id_;
    return;
  }
  behind_ = true;
  if (judge_.is_busy()) return;  // the newest settings are asked for when it is done
  judge_.submit({.id = ++last_id_, .view = view_of(pipeline, settings, lines_)});
  asked_ = key;
}

void JudgeDesk::refresh_pinned(Pictures& pictures) {
  if (!pictures.pinned_settings()) {
    pinned_.reset();
    pinned_key_ = {};
    return;
  }
  const Settings& settings = *pictures.pinned_settings();
  const Key key = KeyBuilder().add(settings_text(settings)).key();
  if (key == pinned_key_) return;
  pinned_key_ = key;
  pinned_.reset();
  auto lines = pictures.source().reference_key(settings) == lines_key_
                   ? lines_
                   : std::make_shared<const ReferenceLines>(pictures.source().reference(settings));
  pinned_judge_.submit({.view = view_of(pictures.pipeline(), settings, std::move(lines))});
}

void JudgeDesk::take_results() {
  if (std::optional<Judgement> result = judge_.poll()) now_ = std::move(result);
  if (std::optional<Judgement> result = pinned_judge_.poll()) pinned_ = std::move(result);
}

void JudgeDesk::refresh(Pictures& pictures, const Settings& settings, Wanted wanted, bool hurry) {
  take_results();
  late_ = false;  // also of what is no longer looked at: nothing waits for it
  if (!wanted.lines && !wanted.measures) return;
  const bool lines_are_new = refresh_lines(pictures.source(), settings, hurry);
  if (!wanted.measures) return;
  if (lines_are_new) refresh_measures(pictures.pipeline(), settings);
  behind_ |= !lines_are_new;
  if (!hurry) refresh_pinned(pictures);
}

TileOverlay JudgeDesk::overlay(Overlay kind) {
  if (kind == Overlay::reference && lines_) {
    const Key key = KeyBuilder().add("reference overlay").add(lines_key_).key();
    return {&reference_.get(key, [&] { return upload_rgba("reference overlay", clear_reference(*lines_)); }),
            key, kReferenceVeil};
  }
  if (kind == Overlay::matches && now_ && now_->error.empty()) {
    const Key key = KeyBuilder().add("matches").add(std::to_string(now_->id)).key();
    return {&matches_.get(key, [&] { return upload_rgba("matches overlay", match_overlay(now_->maps)); }),
            key, kMatchesVeil};
  }
  return {};
}

}  // namespace inkbench
