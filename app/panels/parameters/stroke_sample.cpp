// SPDX-License-Identifier: MIT
#include "app/panels/parameters/stroke_sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/panels/widgets/widgets.h"
#include "app/window/theme.h"
#include "app/workbench/sample_stroke.h"
#include "pipeline/base/error.h"

namespace inkbench {
namespace {

constexpr float kWidestShare = 0.16F;  ///< Of the height, of what is shown larger.
constexpr float kMostTimes = 4;

ImU32 as_ink(const glm::vec3& c, float alpha = 1.0F) {
  return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, alpha});
}

float widest_px(const Strokes& strokes) {
  float widest = 0;
  for (const Stroke& stroke : strokes.strokes) {
    for (const StrokePoint& point : stroke.points) widest = std::max(widest, 2 * point.radius_px);
  }
  return widest;
}

/// The discs along a segment, but for their round ends, which the next segments have.
void draw_segment(ImDrawList& list, const StrokePoint& from, const StrokePoint& to, ImVec2 low, float times,
                  ImU32 ink) {
  const ImVec2 a{low.x + from.at.x * times, low.y + from.at.y * times};
  const ImVec2 b{low.x + to.at.x * times, low.y + to.at.y * times};
  const float length = std::max(std::hypot(b.x - a.x, b.y - a.y), 1e-3F);
  const ImVec2 across{-(b.y - a.y) / length, (b.x - a.x) / length};
  const float r = from.radius_px * times, s = to.radius_px * times;
  list.AddQuadFilled({a.x + across.x * r, a.y + across.y * r}, {b.x + across.x * s, b.y + across.y * s},
                     {b.x - across.x * s, b.y - across.y * s}, {a.x - across.x * r, a.y - across.y * r}, ink);
  if (s > 1) list.AddCircleFilled(b, s, ink);
}

}  // namespace

void StrokeSample::make(const Settings& settings, ImVec2 size) {
  problem_.clear();
  try {
    const float widest = widest_px(sample_stroke(settings, size.x, size.y));
    times_ = std::clamp(std::floor(kWidestShare * size.y / std::max(widest, 1e-3F)), 1.0F, kMostTimes);
    strokes_ = sample_stroke(settings, size.x / times_, size.y / times_);
  } catch (const Error& error) {
    strokes_ = {};
    problem_ = error.what();
  }
}

void StrokeSample::draw(const Document& document, ImVec2 size) {
  const bool same_size = size.x == size_.x && size.y == size_.y;
  if (revision_ != document.revision() || !same_size) make(document.settings(), size);
  revision_ = document.revision();
  size_ = size;
  const Settings& settings = document.settings();
  const bool by_class = settings.stroke.colour == StrokeColour::by_class;
  const ImU32 ink = as_ink(by_class ? settings.stroke_classes.front().colour : settings.ink.colour);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 high{low.x + size.x, low.y + size.y};
  ImGui::Dummy(size);
  list.PushClipRect(low, high, true);
  list.AddRectFilled(low, high, as_ink(settings.ink.paper));
  for (const Stroke& stroke : strokes_.strokes) {
    for (size_t i = 1; i < stroke.points.size(); ++i)
      draw_segment(list, stroke.points[i - 1], stroke.points[i], low, times_, ink);
  }
  const std::string note = times_ > 1 ? fmt::format("{} ×", times_) : "";
  list.AddText({low.x + scaled(6), low.y + scaled(4)}, as_ink(settings.ink.colour, 0.6F), note.c_str());
  list.PopClipRect();
  if (!problem_.empty())
    draw_fitted_text(list, {low.x + scaled(6), low.y + scaled(4)}, size.x - scaled(12), theme().error,
                     problem_);
}

}  // namespace inkbench
