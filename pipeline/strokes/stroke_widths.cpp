// SPDX-License-Identifier: MIT
#include "pipeline/strokes/stroke_widths.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/strokes/smooth_path.h"

namespace inkbench {
namespace {

/// Classes go over into each other this far to both sides of where they meet.
constexpr float kBlendPx = 4.0F;
/// So far beside the stroke's edge the shading is looked at.
constexpr float kBesidePx = 2.0F;
/// Along the stroke the light that it sees is evened by this deviation.
constexpr float kLightPx = 6.0F;
constexpr float kHalfPi = 1.57079633F;

/// Pixels of one width at a distance; 0 where that is not known.
float width_at(float depth, const StrokeParams& params, const StrokeSurroundings& around) {
  switch (params.unit) {
    case WidthUnit::px:
      return params.width;
    case WidthUnit::percent:
      return params.width * static_cast<float>(around.height_px) / 100.0F;
    case WidthUnit::world: {
      const float distance = around.is_orthographic ? 1.0F : depth > 0.0F ? depth : around.visible.x;
      const float pixel = around.pixel_size * distance;
      return pixel > 0.0F ? params.width / pixel : 0.0F;
    }
  }
  return 0.0F;
}

float depth_share(float depth, const StrokeParams& params, const StrokeSurroundings& around) {
  const float range = around.visible.y - around.visible.x;
  if (params.depth_taper <= 0.0F || depth <= 0.0F || !(range > 0.0F)) return 1.0F;
  return 1.0F - params.depth_taper * std::clamp((depth - around.visible.x) / range, 0.0F, 1.0F);
}

/// Where the class changes half of both widths is drawn.
std::vector<float> class_shares(const StrokePath& path, const StrokeClasses& classes) {
  const auto share = [&](size_t i) { return classes[static_cast<size_t>(path.points[i].curve_class)].width; };
  std::vector<float> shares;
  for (size_t i = 0; i < path.points.size(); ++i) shares.push_back(share(i));
  const std::vector<float> plain = shares;
  for (size_t border = 1; border < path.points.size(); ++border) {
    const float before = plain[border - 1], after = plain[border];
    if (before == after) continue;
    for (size_t i = 0; i < path.points.size(); ++i) {
      const float away = path.points[i].along_px - path.points[border].along_px;
      if (std::abs(away) >= kBlendPx) continue;
      shares[i] = glm::mix(before, after, glm::smoothstep(-kBlendPx, kBlendPx, away));
    }
  }
  return shares;
}

/// By how much the path turns in a pixel, as the chords over `span_px` to both sides say.
float curvature_at(const StrokePath& path, size_t i, float span_px) {
  const float along = path.points[i].along_px;
  const float start = path.points.front().along_px, end = path.points.back().along_px;
  if (!path.is_closed && (along - start < 0.5F * span_px || end - along < 0.5F * span_px)) return 0.0F;
  const glm::vec2 before = direction_at(path, along - 0.5F * span_px, 0.5F * span_px);
  const glm::vec2 after = direction_at(path, along + 0.5F * span_px, 0.5F * span_px);
  return std::acos(std::clamp(glm::dot(before, after), -1.0F, 1.0F)) / span_px;
}

void follow_curvature(std::vector<float>& widths, const StrokePath& path, const StrokeParams& params) {
  if (params.curvature_width == 0.0F) return;
  std::vector<float> bends;
  for (size_t i = 0; i < widths.size(); ++i) {
    const float span_px = std::max(2.0F * widths[i], 4.0F);
    bends.push_back(std::min(10.0F * widths[i] * curvature_at(path, i, span_px), 1.0F));
  }
  const float widest = *std::max_element(widths.begin(), widths.end());
  bends = smoothed_values(bends, path, std::max(widest, 2.0F));
  for (size_t i = 0; i < widths.size(); ++i)
    widths[i] *= std::max(1.0F + params.curvature_width * bends[i], 0.0F);
}

bool is_inside(const Image& image, const glm::vec2& at) {
  return at.x >= 0.0F && at.y >= 0.0F && at.x < static_cast<float>(image.width_px) &&
         at.y < static_cast<float>(image.height_px);
}

float value_at(const Image& image, const glm::vec2& at) {
  const int x = std::clamp(static_cast<int>(at.x), 0, image.width_px - 1);
  const int y = std::clamp(static_cast<int>(at.y), 0, image.height_px - 1);
  return image.at(x, y);
}

/// The light beside the stroke on its own object; where that is on no side, on both.
float light_at(const StrokePath& path, size_t i, float away_px, const StrokeSurroundings& around) {
  const PathPoint& point = path.points[i];
  const glm::vec2 direction = direction_at(path, point.along_px, 2.0F);
  const glm::vec2 aside = away_px * glm::vec2(-direction.y, direction.x);
  float own = 0.0F, any = 0.0F;
  int owned = 0;
  for (const glm::vec2& at : {point.at + aside, point.at - aside}) {
    const float light = value_at(*around.luminance, at);
    any += light;
    const bool is_own = around.object_id != nullptr && is_inside(*around.object_id, at) &&
                        std::lround(value_at(*around.object_id, at)) == path.object_id;
    if (!is_own) continue;
    own += light;
    ++owned;
  }
  return owned > 0 ? own / static_cast<float>(owned) : 0.5F * any;
}

void follow_light(std::vector<float>& widths, const StrokePath& path, const StrokeParams& params,
                  const StrokeSurroundings& around) {
  if (params.shadow_width == 0.0F || around.luminance == nullptr) return;
  std::vector<float> dark;
  for (size_t i = 0; i < widths.size(); ++i)
    dark.push_back(1.0F - std::clamp(light_at(path, i, 0.5F * widths[i] + kBesidePx, around), 0.0F, 1.0F));
  dark = smoothed_values(dark, path, kLightPx);
  for (size_t i = 0; i < widths.size(); ++i)
    widths[i] *= std::max(1.0F + params.shadow_width * dark[i], 0.0F);
}

/// Swells quickly, then slowly, as a pen that is pressed down.
float taper_share(float from_end_px, float taper_px, float tip) {
  if (!(from_end_px < taper_px)) return 1.0F;
  return tip + (1.0F - tip) * std::sin(kHalfPi * std::max(from_end_px, 0.0F) / taper_px);
}

/// The tapers of a stroke, shortened where it is shorter than both; the view's end is none of the stroke's.
struct Tapers {
  float in_px = 0.0F, out_px = 0.0F;
};
Tapers tapers_of(const StrokePath& path, const StrokeParams& params) {
  if (path.is_closed) return {};
  Tapers tapers{path.start == CurveEnd::frame ? 0.0F : params.taper_in,
                path.end == CurveEnd::frame ? 0.0F : params.taper_out};
  const float both = tapers.in_px + tapers.out_px, length = length_px(path);
  if (both > length) {
    tapers.in_px *= length / both;
    tapers.out_px *= length / both;
  }
  return tapers;
}

void shape_ends(std::vector<float>& widths, const StrokePath& path, const StrokeParams& params,
                const WidthProfile& profile) {
  const Tapers tapers = tapers_of(path, params);
  const float start = path.points.front().along_px, end = path.points.back().along_px;
  for (size_t i = 0; i < widths.size(); ++i) {
    const float along = path.points[i].along_px;
    widths[i] *= taper_share(along - start, tapers.in_px, params.tip);
    widths[i] *= taper_share(end - along, tapers.out_px, params.tip);
    if (end > start) widths[i] *= share_of(profile, (along - start) / (end - start));
  }
}

}  // namespace

std::vector<float> stroke_radii(const StrokePath& path, const StrokeParams& params,
                                const StrokeClasses& classes, const WidthProfile& profile,
                                const StrokeSurroundings& around) {
  std::vector<float> widths = class_shares(path, classes);
  const float of_all =
      (path.is_outline ? params.outline : 1.0F) * (path.covered > 0 ? params.hidden_width : 1.0F);
  for (size_t i = 0; i < widths.size(); ++i) {
    const float depth = path.points[i].depth;
    widths[i] *= of_all * width_at(depth, params, around) * depth_share(depth, params, around);
  }
  follow_curvature(widths, path, params);
  follow_light(widths, path, params, around);
  shape_ends(widths, path, params, profile);
  for (float& width : widths) width *= 0.5F;
  return widths;
}

float share_of(const WidthProfile& profile, float along) {
  if (profile.empty()) return 1.0F;
  if (along <= profile.front().along) return profile.front().share;
  for (size_t i = 1; i < profile.size(); ++i) {
    const ProfilePoint &a = profile[i - 1], &b = profile[i];
    if (along > b.along) continue;
    const float step = b.along - a.along;
    return step > 0.0F ? glm::mix(a.share, b.share, (along - a.along) / step) : b.share;
  }
  return profile.back().share;
}

float luminance_of(float red, float green, float blue) {
  return 0.2126F * red + 0.7152F * green + 0.0722F * blue;
}

}  // namespace inkbench
