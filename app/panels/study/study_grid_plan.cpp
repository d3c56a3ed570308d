// SPDX-License-Identifier: MIT
#include "app/panels/study/study_grid_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"

namespace inkbench {
namespace {

constexpr float kSmallestCell = 44, kLargestCell = 640, kWidestValue = 110;
constexpr int kUsualDigits = 3, kMostDigits = 9;

bool is_labelled(const GridAxis& axis) {
  return axis.values.size() > 1 || !axis.values.front().empty();
}

float widest_value(const GridAxis& axis) {
  float widest = 0;
  const size_t step = std::max<size_t>(1, axis.values.size() / 500);
  for (size_t i = 0; i < axis.values.size(); i += step) widest = std::max(widest, text_width(axis.values[i]));
  return widest;
}

std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size()) return std::nullopt;
  return value;
}

std::string with_digits(double value, int digits) {
  return fmt::format("{:.{}g}", value, digits);
}

/// The fewest digits with which neighbours in the axis still differ.
int least_digits(const GridAxis& axis) {
  const auto differ = [&](int digits) {
    std::string before;
    for (const std::string& text : axis.values) {
      const std::optional<double> value = number_in(text);
      if (!value) continue;
      std::string shown = with_digits(*value, digits);
      if (shown == before) return false;
      before = std::move(shown);
    }
    return true;
  };
  int digits = 1;
  while (digits < kMostDigits && !differ(digits)) ++digits;
  return digits;
}

/// That numbers above the columns still differ in.
float narrowest_cell(const GridAxis& columns, int digits) {
  float widest = scaled(kSmallestCell);
  const size_t step = std::max<size_t>(1, columns.values.size() / 500);
  for (size_t i = 0; i < columns.values.size(); i += step) {
    if (const auto value = number_in(columns.values[i]))
      widest = std::max(widest, text_width(with_digits(*value, digits)) + scaled(2));
  }
  return std::min(widest, std::max(scaled(kWidestValue), scaled(kSmallestCell)));
}

float fitting_width(const GridPlan& plan, ImVec2 room, float aspect) {
  const auto columns = static_cast<float>(plan.columns), rows = static_cast<float>(plan.rows);
  const float across = (room.x - plan.left + plan.gap) / columns - plan.gap;
  const float down = (room.y - plan.top + plan.gap) / rows - plan.gap - plan.caption_height -
                     (plan.flows ? plan.value_height : 0);
  return std::min(across, down * aspect);
}

/// The number of columns with the largest cells.
void flow(GridPlan& plan, ImVec2 room, float aspect) {
  size_t best = 1;
  float widest = 0;
  for (size_t columns = 1; columns <= std::min<size_t>(plan.count, 64); ++columns) {
    plan.columns = columns;
    plan.rows = (plan.count + columns - 1) / columns;
    const float width = fitting_width(plan, room, aspect);
    if (width <= widest) continue;
    widest = width;
    best = columns;
  }
  plan.columns = best;
  plan.rows = (plan.count + best - 1) / best;
}

/// Rows of cells so wide, no longer than the room; what is below it is scrolled to.
void wrap(GridPlan& plan, ImVec2 room, float width) {
  const float scroll_bar = ImGui::GetStyle().ScrollbarSize;
  const float across = room.x - plan.left - scroll_bar + plan.gap;
  const float columns = std::floor(across / (std::floor(width) + plan.gap));
  plan.columns = static_cast<size_t>(std::clamp(columns, 1.0F, static_cast<float>(plan.count)));
  plan.rows = (plan.count + plan.columns - 1) / plan.columns;
}

}  // namespace

std::string fitting_value(const std::string& text, float width, int least) {
  const std::optional<double> value = number_in(text);
  std::string shown = text;
  for (int digits = std::max(kUsualDigits, least); value && digits >= least && text_width(shown) > width;
       --digits)
    shown = with_digits(*value, digits);
  return shown;
}

GridPlan plan_of(const StudyResults& results, const GridChoice& choice, ImVec2 room) {
  const GridAxis& columns = results.columns();
  const GridAxis& rows = results.rows();
  GridPlan plan{.columns = columns.values.size(), .rows = rows.values.size()};
  plan.count = plan.columns * plan.rows;
  plan.gap = scaled(6);
  plan.value_height = ImGui::GetTextLineHeight() + scaled(3);
  plan.caption_height = choice.number ? ImGui::GetTextLineHeight() + scaled(2) : 0;
  plan.flows = !is_labelled(rows) && columns.values.size() > 3;
  if (is_labelled(rows))
    plan.left = std::min(std::max(widest_value(rows), text_width(rows.label)), scaled(130)) + scaled(10);
  if (is_labelled(columns) || !columns.label.empty() || is_labelled(rows))
    plan.top = plan.value_height * (plan.flows ? 1.0F : 2.0F);
  const ImageParams& image = results.spec().base.image;
  const float aspect = static_cast<float>(image.width) / static_cast<float>(image.height);
  if (plan.flows) flow(plan, room, aspect);
  const float fit = fitting_width(plan, room, aspect);
  plan.digits = least_digits(columns);
  const float least = narrowest_cell(columns, plan.digits);
  const float width = std::min(std::max(fit, least) * choice.zoom, scaled(kLargestCell));
  if (plan.flows && width > fit) wrap(plan, room, width);
  plan.cell = {std::floor(width), std::max(1.0F, std::floor(width / aspect))};
  return plan;
}

}  // namespace inkbench
