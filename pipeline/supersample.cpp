// SPDX-License-Identifier: MIT
#include "pipeline/supersample.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/base/error.h"
#include "pipeline/gl/context.h"
#include "pipeline/passes/gbuffer/lens_block.h"
#include "pipeline/passes/ink/drawn_ink.h"
#include "pipeline/passes/ink/line_widths.h"
#include "pipeline/passes/placing/connect.h"
#include "pipeline/passes/placing/placed_lines.h"
#include "pipeline/passes/strokes/stroke_colours.h"
#include "pipeline/passes/strokes/strokes.h"

namespace inkbench {
namespace {

/// No detector looks farther, the steps to placed lines counted in.
constexpr int kOperatorReachPx = 16;

/// Does it show what a filter has found in the large image?
bool shows_found_lines(const Settings& settings, BufferName buffer) {
  if (buffer == BufferName::curves || buffer == BufferName::strokes) return false;
  const bool shows_ink = buffer != BufferName::shaded && buffer != BufferName::blinn_phong;
  return shows_ink && draws_filter(settings);
}

/// How far strokes look for the surface whose colour they have.
int reach_of_colours(const Settings& settings, BufferName buffer) {
  const bool shows_strokes = buffer == BufferName::strokes || draws_strokes(settings);
  const StrokeColour colour = settings.stroke.colour;
  const bool is_of_surface = colour == StrokeColour::material || colour == StrokeColour::shading;
  return shows_strokes && is_of_surface ? kMostColourReachPx : 0;
}

/// What of the lines is found from the whole image; empty: nothing.
std::string needs_whole(const Settings& large) {
  if (!places_lines(large)) return "";
  if (!ConnectPass::hands_on(large))
    return "edges.weak, edges.min_length and line.taper look at lines as a whole";
  return PlacedLines::chosen(large) == 0 ? "the detector's lines are thinned as a whole" : "";
}

/// How far from a pixel what decides it can lie.
int margin_of(const Settings& large, const glm::vec2& visible) {
  if (!places_lines(large)) return kOperatorReachPx;
  const LensBlock lens = lens_of(large.camera, large.image.height);
  const double half_px = widest_half_px(widths_of(large), lens, visible);
  const double side = std::max(large.image.width, large.image.height);
  // The steps of a flood sum up to less than twice a line's reach.
  return kOperatorReachPx + 2 * static_cast<int>(std::ceil(std::min(half_px, side) + 1.0));
}

int tile_side(int picture_px, const TilePlan& plan, int most_px) {
  const int large_px = picture_px * plan.times;
  if (!plan.why_whole.empty() || large_px <= std::max(most_px, 2 * plan.margin_px)) return picture_px;
  const int inner_px = std::max(most_px - 2 * plan.margin_px, most_px / 4);
  const int count = (large_px + inner_px - 1) / inner_px;
  return std::max((picture_px + count - 1) / count, 1);
}

/// Forgets what is larger than an ordinary tile, whatever happens.
class LargePartGuard {
 public:
  LargePartGuard(Pipeline& pipeline, const ImageWindow& part, int most_px)
      : pipeline_(int64_t{part.width} * part.height > int64_t{most_px} * most_px ? &pipeline : nullptr) {}
  LargePartGuard(const LargePartGuard&) = delete;
  LargePartGuard& operator=(const LargePartGuard&) = delete;
  ~LargePartGuard() {
    if (pipeline_ != nullptr) pipeline_->forget_results();
  }

 private:
  Pipeline* pipeline_;
};

}  // namespace

Settings enlarged(const Settings& settings, int times) {
  const auto factor = static_cast<float>(times);
  Settings large = settings;
  large.image.width *= times;
  large.image.height *= times;
  large.image.supersample = 1;
  large.edges.min_length *= factor;
  large.line.taper *= factor;
  if (large.line.unit == WidthUnit::px) large.line.width *= factor;
  large.stroke.brush_length *= factor;
  return large;
}

std::vector<ImageWindow> TilePlan::tiles(const ImageParams& picture) const {
  std::vector<ImageWindow> tiles;
  for (int bottom = 0; bottom < picture.height; bottom += tile_height) {
    for (int left = 0; left < picture.width; left += tile_width) {
      tiles.push_back({left, bottom, std::min(tile_width, picture.width - left),
                       std::min(tile_height, picture.height - bottom), picture.width, picture.height,
                       std::nullopt});
    }
  }
  return tiles;
}

/// Of one size for all tiles, so that each finds the textures that the last one left.
ImageWindow TilePlan::drawn_for(const ImageWindow& tile) const {
  ImageWindow drawn;
  drawn.whole_width = tile.whole_width * times;
  drawn.whole_height = tile.whole_height * times;
  drawn.width = std::min(tile_width * times + 2 * margin_px, drawn.whole_width);
  drawn.height = std::min(tile_height * times + 2 * margin_px, drawn.whole_height);
  drawn.left = std::clamp(tile.left * times - margin_px, 0, drawn.whole_width - drawn.width);
  drawn.bottom = std::clamp(tile.bottom * times - margin_px, 0, drawn.whole_height - drawn.height);
  return drawn;
}

TilePlan plan_tiles(const Settings& settings, BufferName buffer, const glm::vec2& visible, int most_px) {
  TilePlan plan{.times = settings.image.supersample};
  plan.margin_px = reach_of_colours(settings, buffer);
  if (shows_found_lines(settings, buffer)) {
    const Settings large = enlarged(settings, plan.times);
    plan.margin_px = std::max(plan.margin_px, margin_of(large, visible));
    plan.why_whole = needs_whole(large);
  }
  plan.tile_width = tile_side(settings.image.width, plan, most_px);
  plan.tile_height = tile_side(settings.image.height, plan, most_px);
  return plan;
}

Supersampler::Supersampler(std::shared_ptr<LineFinder> finder, std::shared_ptr<MeshStore> meshes)
    : pipeline_(std::move(finder), std::move(meshes)) {}

void Supersampler::check_part(const ImageWindow& window, const TilePlan& plan) {
  const int most_px = renderer_info().max_side_px;
  if (std::max(window.width, window.height) > most_px) {
    const std::string why = plan.why_whole.empty() ? "lines are so wide" : plan.why_whole;
    throw input_error(
        "image.supersample",
        fmt::format("= {} has {} x {} px drawn at once, since {}; this renderer draws at most {} "
                    "a side",
                    plan.times, window.width, window.height, why, most_px),
        "choose a smaller one, or a smaller image");
  }
  ImageParams drawn;
  drawn.width = window.width;
  drawn.height = window.height;
  pipeline_.check_room(drawn, "image.supersample", "choose a smaller one");
}

Texture Supersampler::draw(const Settings& settings, const glm::vec2& visible,
                           const std::vector<GivenValue>& given, BufferName buffer, const PictureView& view,
                           const BoxFilterPass& filter, int most_tile_px) {
  const TilePlan plan = plan_tiles(settings, buffer, visible, most_tile_px);
  const Settings large = enlarged(settings, plan.times);
  const std::vector<ImageWindow> tiles = plan.tiles(settings.image);
  Texture picture("supersampled picture", TextureFormat::rgba8, settings.image.width, settings.image.height);
  const LargePartGuard guard(pipeline_, plan.drawn_for(tiles.front()), most_tile_px);
  for (const ImageWindow& tile : tiles) {
    ImageWindow window = plan.drawn_for(tile);
    window.visible_range = visible;
    check_part(window, plan);
    const Shown shown = pipeline_.at(large, window, given).show(buffer);
    filter.run(view, *shown.texture, window, plan.times, tile, picture);
  }
  return picture;
}

}  // namespace inkbench
