// SPDX-License-Identifier: MIT
#include "studies/report/thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "pipeline/image/webp_file.h"
#include "studies/report/html_text.h"
#include "studies/report/scaling.h"

namespace inkbench {
namespace {

/// A side, and the characters that cartoon pictures of 1024 px take at it (measured: detailed ones).
struct Step {
  int side_px;
  size_t usual_chars;
};
constexpr std::array<Step, 9> kSteps{{{240, 9200},
                                      {180, 6000},
                                      {128, 3600},
                                      {96, 1900},
                                      {64, 1050},
                                      {48, 720},
                                      {40, 580},
                                      {32, 440},
                                      {24, 320}}};

int quality(int side_px) {
  return side_px >= 128 ? 82 : 70;  // no one sees the difference on a small one
}

Averaging averaging_of(const Picture& picture) {
  const uint64_t sum = std::accumulate(picture.samples.begin(), picture.samples.end(), uint64_t{0});
  return sum < 64 * picture.samples.size() ? Averaging::light : Averaging::codes;
}

Picture fitted(const Picture& picture, int side_px, Averaging averaging) {
  const double scale = std::min(1.0, 1.0 * side_px / std::max(picture.width_px, picture.height_px));
  const auto side = [&](int px) { return std::max(1, static_cast<int>(std::lround(px * scale))); };
  return scaled(picture, side(picture.width_px), side(picture.height_px), averaging);
}

size_t base64_chars(size_t bytes) {
  return (bytes + 2) / 3 * 4;
}

/// The longest side worth its time: the more pictures a page shows, the smaller each of them stands there.
int useful_side_px(size_t pictures) {
  return pictures <= 100 ? 240 : pictures <= 250 ? 180 : 128;
}

ThumbnailPlan plan_for(size_t cells, size_t per_cell, size_t room_chars) {
  const size_t pictures = std::max<size_t>(cells * per_cell, 1);
  const size_t share = room_chars / pictures;
  for (const Step& step : kSteps) {
    if (step.side_px <= useful_side_px(pictures) && step.usual_chars * 4 <= share * 3)
      return {step.side_px, share, per_cell};
  }
  return {};
}

}  // namespace

ThumbnailPlan plan_thumbnails(size_t cells, size_t pictures_per_cell, size_t room_chars) {
  constexpr int kTinyPx = 48;
  const ThumbnailPlan all = plan_for(cells, pictures_per_cell, room_chars);
  return all.side_px < kTinyPx ? plan_for(cells, 1, room_chars) : all;
}

std::vector<Thumbnail> make_thumbnails(const Picture& picture, const ThumbnailPlan& most,
                                       const ThumbnailPlan& least) {
  const Averaging averaging = averaging_of(picture);
  std::vector<Thumbnail> made;
  for (const Step& step : kSteps) {
    if (step.side_px > most.side_px) continue;
    made.push_back(
        {step.side_px, encode_webp(fitted(picture, step.side_px, averaging), quality(step.side_px))});
    if (step.side_px <= least.side_px && base64_chars(made.back().webp.size()) <= least.max_chars) break;
  }
  return made;
}

std::optional<std::string> chosen_thumbnail(const std::vector<Thumbnail>& made, const ThumbnailPlan& plan) {
  if (!made.empty() && made.front().side_px < plan.side_px) return std::nullopt;
  for (const Thumbnail& one : made) {
    if (one.side_px <= plan.side_px && base64_chars(one.webp.size()) <= plan.max_chars)
      return base64(one.webp);
  }
  const bool all_were_tried =
      plan.side_px == 0 || (!made.empty() && made.back().side_px == kSteps.back().side_px);
  return all_were_tried ? std::optional<std::string>("") : std::nullopt;
}

std::string thumbnail(const Picture& picture, const ThumbnailPlan& plan) {
  return chosen_thumbnail(make_thumbnails(picture, plan, plan), plan).value();
}

}  // namespace inkbench
