// SPDX-License-Identifier: MIT
#include "app/panels/frame/left_panel.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <numeric>

#include "app/window/gui.h"
#include "app/window/theme.h"

namespace inkbench {
namespace {

constexpr std::array kTitles{"Parameters", "Presets", "History", "Cameras"};

void draw_tab(WindowLayout& layout, UiMap& ui_map, LeftTab tab, ImVec2 low, ImVec2 size) {
  const char* title = kTitles[static_cast<size_t>(tab)];
  const bool on = layout.left_tab == tab;
  ImGui::SetCursorScreenPos(low);
  if (ImGui::InvisibleButton(title, size)) layout.left_tab = tab;
  ui_map.mark_item(std::string("tab:") + title);
  const bool hot = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImFont* font = on ? fonts().bold : fonts().text;
  const float width = font->CalcTextSizeA(ImGui::GetFontSize(), FLT_MAX, 0, title).x;
  const ImVec2 high{low.x + size.x, low.y + size.y};
  list.PushClipRect(low, high, true);
  list.AddText(font, ImGui::GetFontSize(),
               {std::round(low.x + std::max((size.x - width) / 2, 0.0F)),
                std::round(low.y + (size.y - ImGui::GetFontSize()) / 2)},
               on || hot ? theme().text : theme().faint, title);
  if (on) list.AddRectFilled({low.x, high.y - scaled(2)}, high, theme().accent);
  list.PopClipRect();
}

float title_width(ImFont* font, size_t i) {
  return font->CalcTextSizeA(ImGui::GetFontSize(), FLT_MAX, 0, kTitles[i]).x;
}

/// As if each were the chosen one, so that they stand still; in a narrow panel as they are.
std::array<float, kTitles.size()> title_widths(size_t chosen, float room) {
  std::array<float, kTitles.size()> widths{};
  for (size_t i = 0; i < kTitles.size(); ++i) widths[i] = title_width(fonts().bold, i);
  if (std::accumulate(widths.begin(), widths.end(), 0.0F) <= room) return widths;
  for (size_t i = 0; i < kTitles.size(); ++i) {
    if (i != chosen) widths[i] = title_width(fonts().text, i);
  }
  return widths;
}

/// Widths by the titles' lengths, so that each has the same room around it.
void draw_tabs(WindowLayout& layout, UiMap& ui_map) {
  const ImVec2 low = ImGui::GetWindowPos();
  const float width = ImGui::GetWindowWidth();
  const float height = ImGui::GetFrameHeight() + scaled(2);
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + height}, theme().bar);
  const auto widths = title_widths(static_cast<size_t>(layout.left_tab), width);
  const float sum = std::accumulate(widths.begin(), widths.end(), 0.0F);
  const float room = std::clamp((width - sum) / static_cast<float>(kTitles.size()), 0.0F, scaled(22));
  const float shrink = std::min(1.0F, width / sum);
  float x = low.x;
  for (size_t i = 0; i < kTitles.size(); ++i) {
    const float each = std::floor(widths[i] * shrink + room);
    draw_tab(layout, ui_map, static_cast<LeftTab>(i), {x, low.y}, {each, height});
    x += each;
  }
  ImGui::SetCursorScreenPos({low.x + ImGui::GetStyle().WindowPadding.x, low.y + height + scaled(6)});
}

}  // namespace

void LeftPanel::focus_search() {
  layout_.show_parameters = true;
  layout_.left_tab = LeftTab::parameters;
  parameters_.focus_search();
}

void LeftPanel::draw() {
  draw_tabs(layout_, ui_map_);
  switch (layout_.left_tab) {
    case LeftTab::parameters:
      return parameters_.draw();
    case LeftTab::presets:
      return presets_.draw();
    case LeftTab::history:
      return history_.draw();
    case LeftTab::views:
      return views_.draw();
  }
}

}  // namespace inkbench
