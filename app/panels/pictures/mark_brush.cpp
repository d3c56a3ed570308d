// SPDX-License-Identifier: MIT
#include "app/panels/pictures/mark_brush.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/panels/widgets/held_drag.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/theme.h"
#include "pipeline/base/error.h"
#include "pipeline/lines/drawing.h"

namespace inkbench {
namespace {

constexpr double kBrushStep = 1.2;      // of the wheel
constexpr double kLeastMovedPx = 0.25;  // of the picture: nearer points say nothing new
constexpr size_t kMostStrokePoints = 20000;

ImU32 colour_of(MarkBrush brush) {
  if (brush == MarkBrush::eraser) return IM_COL32(255, 255, 255, kMarkAlpha);
  const MarkColour& colour = brush == MarkBrush::wanted ? kWantedMark : kUnwantedMark;
  return IM_COL32(colour.red, colour.green, colour.blue, kMarkAlpha);
}

const char* step_name(MarkBrush brush) {
  constexpr std::array kNames{"mark as wanted", "mark as unwanted", "erase marks"};
  return kNames[static_cast<size_t>(brush)];
}

/// Pictures of an earlier size are not painted on.
bool has_own_size(const Settings& settings, const TileFrame& frame) {
  return frame.picture_width == settings.image.width && frame.picture_height == settings.image.height;
}

LineMap lines_now(const Settings& settings, const Viewer& viewer) {
  if (viewer.drawn() && viewer.can_draw()) {
    LineMap lines = line_map_from(viewer.drawn()->raw(BufferName::lines));
    if (lines.width_px() == settings.image.width && lines.height_px() == settings.image.height) return lines;
  }
  return {settings.image.width, settings.image.height};
}

void finish_stroke(Document& document, const Viewer& viewer, const BrushStroke& stroke) {
  const Settings& settings = document.settings();
  try {
    MarkMaps maps = maps_for(document.marks(), settings.camera, settings.image.width, settings.image.height);
    paint(maps, stroke, lines_now(settings, viewer));
    document.set_marks(with_maps(document.marks(), settings.camera, maps), step_name(stroke.brush));
  } catch (const Error&) {
    // What cannot be drawn is told by the pictures, and cannot be marked.
  }
}

void add_point(BrushStroke& stroke, const BrushPoint& point) {
  if (!stroke.points.empty()) {
    const BrushPoint& last = stroke.points.back();
    if (std::hypot(point.x - last.x, point.y - last.y) < kLeastMovedPx) return;
  }
  if (stroke.points.size() < kMostStrokePoints) stroke.points.push_back(point);
}

void draw_stroke(const ViewState& view, const TileFrame& frame) {
  const BrushStroke& stroke = *view.stroke;
  const auto radius = static_cast<float>(stroke.radius_px * magnification(view, frame));
  std::vector<ImVec2> points;
  for (const BrushPoint& point : stroke.points) {
    const PicturePoint place = point_over(view, frame, point.x, point.y);
    points.emplace_back(static_cast<float>(place.x), static_cast<float>(place.y));
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (points.size() == 1) list.AddCircleFilled(points.front(), radius, colour_of(stroke.brush));
  list.AddPolyline(points.data(), static_cast<int>(points.size()), colour_of(stroke.brush), 0, 2 * radius);
}

/// Of the present camera at the present size; nothing where it has none.
void erase_all(Document& document) {
  const Settings& settings = document.settings();
  const LineMap none(settings.image.width, settings.image.height);
  document.set_marks(with_maps(document.marks(), settings.camera, {none, none, none}), "erase all marks");
}

void brush_button(ViewState& view, UiMap& ui_map, const char* label, MarkBrush brush, const char* help) {
  if (toggle_button(label, view.brush == brush, help)) view.brush = brush;
  ui_map.mark_item(std::string("brush:") + label);
  ImGui::SameLine(0, 2);
}

}  // namespace

bool brush_mouse(Document& document, Viewer& viewer, ViewState& view, const TileFrame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  const PicturePoint point = point_under(view, frame, io.MousePos.x, io.MousePos.y);
  if (view.stroke && ImGui::IsItemDeactivated()) {
    BrushStroke stroke = *view.stroke;
    view.stroke.reset();
    add_point(stroke, {point.x, point.y});  // the last move may come with the release
    if (!was_given_up()) finish_stroke(document, viewer, stroke);
    return true;
  }
  if (view.tool != MouseTool::mark || io.KeyAlt) return false;
  if (ImGui::IsItemActivated() && ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
      has_own_size(document.settings(), frame))
    view.stroke = BrushStroke{view.brush, view.brush_px, {}};
  if (view.stroke && ImGui::IsItemActive()) add_point(*view.stroke, {point.x, point.y});
  if (ImGui::IsItemHovered() && io.KeyCtrl && io.MouseWheel != 0)
    view.brush_px = std::clamp(view.brush_px * std::pow(kBrushStep, static_cast<double>(io.MouseWheel)),
                               kLeastBrushPx, kMostBrushPx);
  return true;
}

void draw_marks(const Document& document, Viewer& viewer, const ViewState& view, const TileFrame& frame) {
  const Settings& settings = document.settings();
  if (!has_own_size(settings, frame)) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Texture* marks =
      viewer.marks.find(document.marks(), settings.camera, frame.picture_width, frame.picture_height);
  if (marks != nullptr) {
    const PicturePoint low = point_over(view, frame, 0, 0);
    const PicturePoint high = point_over(view, frame, frame.picture_width, frame.picture_height);
    list.AddImage(reinterpret_cast<ImTextureID>(static_cast<intptr_t>(marks->id())),
                  {static_cast<float>(low.x), static_cast<float>(low.y)},
                  {static_cast<float>(high.x), static_cast<float>(high.y)}, {0, 1}, {1, 0});
  }
  if (view.stroke) draw_stroke(view, frame);
  const bool shows_brush = view.tool == MouseTool::mark && view.hovered;
  if (!shows_brush) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto radius = static_cast<float>(view.brush_px * magnification(view, frame));
  list.AddCircle(mouse, radius, IM_COL32(0, 0, 0, 160), 0, scaled(2));
  list.AddCircle(mouse, radius, colour_of(view.brush) | IM_COL32_A_MASK, 0, scaled(1));
}

void draw_brush_tools(Document& document, ViewState& view, UiMap& ui_map) {
  if (view.tool != MouseTool::mark) return;
  brush_button(view, ui_map, "Wanted", MarkBrush::wanted, "Paint where there should be lines.");
  brush_button(view, ui_map, "Unwanted", MarkBrush::unwanted, "Paint over lines that should go.");
  brush_button(view, ui_map, "Erase", MarkBrush::eraser, "Take marks away.");
  ImGui::SameLine();
  auto radius = static_cast<float>(view.brush_px);
  ImGui::SetNextItemWidth(scaled(140));
  if (ImGui::SliderFloat("##radius", &radius, static_cast<float>(kLeastBrushPx),
                         static_cast<float>(kMostBrushPx), "%.0f px", ImGuiSliderFlags_Logarithmic))
    view.brush_px = std::clamp(static_cast<double>(radius), kLeastBrushPx, kMostBrushPx);
  ui_map.mark_item("brush:radius");
  help_for_item("The brush's radius in the picture's pixels (Ctrl and the wheel).");
  ImGui::SameLine();
  if (ImGui::Button("Erase all")) erase_all(document);
  ui_map.mark_item("brush:erase all");
  help_for_item("All marks of this camera.");
}

}  // namespace inkbench
