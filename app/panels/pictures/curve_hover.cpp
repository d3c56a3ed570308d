// SPDX-License-Identifier: MIT
#include "app/panels/pictures/curve_hover.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "app/window/gui.h"
#include "app/window/theme.h"
#include "app/workbench/curve_words.h"
#include "app/workbench/nearest_curve.h"
#include "pipeline/base/text.h"
#include "pipeline/passes/strokes/strokes.h"

namespace inkbench {
namespace {

constexpr float kCurveReach = 6;  ///< How near the mouse must be.
constexpr float kBeside = 16;     ///< From the mouse to what is said.
constexpr float kClearance = 4;   ///< From that to the curve.

bool shows_curves(const Settings& settings, BufferName buffer) {
  if (buffer == BufferName::final) return draws_strokes(settings);
  return buffer == BufferName::curves || buffer == BufferName::strokes;
}

/// Its points in the window.
std::vector<ImVec2> in_window(const Curve& curve, const ViewState& view, const TileFrame& frame) {
  std::vector<ImVec2> places;
  for (const glm::vec2& at : curve.points) {
    const PicturePoint place = point_over(view, frame, at.x, at.y);
    places.emplace_back(static_cast<float>(place.x), static_cast<float>(place.y));
  }
  return places;
}

/// How much of the line lies in the rectangle, in steps of some pixels.
int steps_inside(const std::vector<ImVec2>& line, ImVec2 low, ImVec2 high) {
  constexpr float kStep = 4;
  int inside = 0;
  for (size_t i = 1; i < line.size(); ++i) {
    const ImVec2 way{line[i].x - line[i - 1].x, line[i].y - line[i - 1].y};
    const int steps = 1 + static_cast<int>(std::min(std::hypot(way.x, way.y), 1e4F) / kStep);
    for (int step = 0; step < steps; ++step) {
      const float share = static_cast<float>(step) / static_cast<float>(steps);
      const ImVec2 at{line[i - 1].x + share * way.x, line[i - 1].y + share * way.y};
      inside += static_cast<int>(at.x > low.x && at.x < high.x && at.y > low.y && at.y < high.y);
    }
  }
  return inside;
}

/// The corner of a rectangle about the mouse, on the screen, that covers least of the line; the first of
/// equally good ones.
ImVec2 place_beside(const std::vector<ImVec2>& line, ImVec2 size) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float off = scaled(kBeside), clear = scaled(kClearance);
  const std::array<ImVec2, 8> sides{{{1, 1}, {1, -1}, {-1, 1}, {-1, -1}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  ImVec2 best = mouse;
  int least = -1;
  for (const ImVec2& side : sides) {
    const ImVec2 middle{mouse.x + side.x * (off + size.x / 2), mouse.y + side.y * (off + size.y / 2)};
    const ImVec2 low{std::clamp(middle.x - size.x / 2, 0.0F, std::max(screen.x - size.x, 0.0F)),
                     std::clamp(middle.y - size.y / 2, 0.0F, std::max(screen.y - size.y, 0.0F))};
    const int covered =
        steps_inside(line, {low.x - clear, low.y - clear}, {low.x + size.x + clear, low.y + size.y + clear});
    if (least >= 0 && covered >= least) continue;
    least = covered;
    best = low;
  }
  return best;
}

void draw_words(const std::vector<std::string>& words, const std::vector<ImVec2>& line) {
  const ImVec2 pad = ImGui::GetStyle().WindowPadding;
  const ImVec2 text = ImGui::CalcTextSize(join(words, "\n").c_str());
  const float gaps = static_cast<float>(words.size() - 1) * ImGui::GetStyle().ItemSpacing.y;
  ImGui::SetNextWindowPos(place_beside(line, {text.x + 2 * pad.x, text.y + gaps + 2 * pad.y}));
  ImGui::BeginTooltip();
  for (size_t i = 0; i < words.size(); ++i) {
    if (i == 0) ImGui::PushFont(fonts().bold);
    ImGui::TextUnformatted(words[i].c_str());
    if (i == 0) ImGui::PopFont();
  }
  ImGui::EndTooltip();
}

std::string_view object_name(const Settings& settings, int object_id) {
  const auto place = static_cast<size_t>(object_id) - 1;
  return object_id > 0 && place < settings.models.size() ? settings.models[place].name : "";
}

}  // namespace

void draw_curve_under_mouse(Viewer& viewer, ViewState& view, const ComparedPicture& which,
                            const TileFrame& frame) {
  if (which.pinned || !viewer.can_draw() || !viewer.drawn() || ImGui::IsAnyMouseDown()) return;
  const Settings& settings = viewer.drawn()->settings();
  if (!shows_curves(settings, which.buffer) || viewer.pictures.shown(which.buffer, false).is_late) return;
  const Curves& curves = viewer.curves();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const PicturePoint point = point_under(view, frame, mouse.x, mouse.y);
  const auto radius_px = static_cast<float>(scaled(kCurveReach) / magnification(view, frame));
  const auto nearest = nearest_curve(curves, {static_cast<float>(point.x), static_cast<float>(point.y)},
                                     radius_px, settings.stroke.hidden);
  if (!nearest) return;
  const Curve& curve = curves.curves[*nearest];
  const std::vector<ImVec2> line = in_window(curve, view, frame);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto points = static_cast<int>(line.size());
  list.AddPolyline(line.data(), points, IM_COL32(255, 255, 255, 255), ImDrawFlags_None, scaled(5));
  list.AddPolyline(line.data(), points, theme().mark, ImDrawFlags_None, scaled(2.5F));
  view.curve_words = curve_words(curve, object_name(settings, curve.object_id));
  draw_words(view.curve_words, line);
}

}  // namespace inkbench
