// SPDX-License-Identifier: MIT
#include "app/panels/widgets/widgets.h"

#include <fmt/format.h>

#include <cfloat>
#include <cstdlib>
#include <utility>

#include "app/window/gui.h"
#include "app/window/theme.h"

namespace inkbench {
namespace {

const char* begin_of(std::string_view text) {
  return text.data();
}
const char* end_of(std::string_view text) {
  return text.data() + text.size();
}

float width_of(std::string_view text) {
  return ImGui::CalcTextSize(begin_of(text), end_of(text)).x;
}

/// The longest start of the text that fits with "..." behind it.
std::string shortened(std::string_view text, float width) {
  const float dots = width_of("…");
  const char* rest = nullptr;
  ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), std::max(width - dots, 0.0F), 0.0F, begin_of(text),
                                  end_of(text), &rest);
  return std::string(begin_of(text), rest) + "…";
}

}  // namespace

void coloured_text(ImU32 colour, std::string_view text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::TextUnformatted(begin_of(text), end_of(text));
  ImGui::PopStyleColor();
}

void faint_text(std::string_view text) {
  coloured_text(theme().faint, text);
}

void wrapped_text(std::string_view text, ImU32 colour) {
  const float width = ImGui::GetContentRegionAvail().x;
  std::string lines;
  std::string line;
  size_t next = 0;
  while (next < text.size()) {
    const size_t end = std::min(text.find_first_of(" \n", next), text.size());
    const std::string word(text.substr(next, end - next));
    const std::string longer = line.empty() ? word : line + " " + word;
    const bool fits = line.empty() || width_of(longer) <= width;
    if (!fits) lines += line + "\n";
    line = fits ? longer : word;
    if (end < text.size() && text[end] == '\n') lines += std::exchange(line, "") + "\n";
    next = end + 1;
  }
  ImGui::PushTextWrapPos(0);  // for words that are longer, such as paths
  coloured_text(colour, lines + line);
  ImGui::PopTextWrapPos();
}

void fitted_text(std::string_view text, float width, ImU32 colour) {
  if (width_of(text) <= width) {
    coloured_text(colour, text);
    return;
  }
  coloured_text(colour, shortened(text, width));
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%.*s", static_cast<int>(text.size()), text.data());
}

float text_width(const std::string& text) {
  return ImGui::CalcTextSize(text.c_str()).x;
}

float draw_fitted_text(ImDrawList& list, ImVec2 place, float width, ImU32 colour, std::string_view text) {
  const std::string shown = width_of(text) <= width ? std::string(text) : shortened(text, width);
  list.AddText(place, colour, shown.data(), shown.data() + shown.size());
  return width_of(shown);
}

bool toggle_button(const char* label, bool on, std::string_view help) {
  if (on) {
    ImGui::PushStyleColor(ImGuiCol_Button, theme().accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, theme().accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, theme().accent);
    ImGui::PushStyleColor(ImGuiCol_Text, theme().on_accent);
  }
  const bool pressed = ImGui::Button(label);
  if (on) ImGui::PopStyleColor(4);
  if (!help.empty()) help_for_item(help);
  return pressed;
}

float button_width(const char* label) {
  return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

bool menu_item(UiMap& map, const char* label, const char* keys, bool on) {
  const bool chosen = ImGui::MenuItem(label, keys, on);
  map.mark_item(std::string("menu:") + label);
  return chosen;
}

std::string short_number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool is_number = !text.empty() && end == text.c_str() + text.size();
  return is_number && text.size() > 6 ? fmt::format("{:.4g}", value) : text;
}

void panel_heading(std::string_view text) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low = ImGui::GetWindowPos();
  const float height = ImGui::GetFrameHeight() + scaled(2);
  const ImVec2 high{low.x + ImGui::GetWindowWidth(), low.y + height};
  list.PushClipRect(low, high, false);
  list.AddRectFilled(low, high, theme().bar);
  list.AddText(fonts().bold, ImGui::GetFontSize(),
               {low.x + scaled(10), low.y + (height - ImGui::GetFontSize()) / 2}, theme().text,
               begin_of(text), end_of(text));
  list.PopClipRect();
  ImGui::SetCursorScreenPos({low.x + ImGui::GetStyle().WindowPadding.x, high.y + scaled(7)});
}

void heading_tabs(UiMap& map, std::span<const char* const> names, size_t& chosen) {
  panel_heading("");
  const ImVec2 back = ImGui::GetCursorScreenPos();
  const ImVec2 corner = ImGui::GetWindowPos();
  const float height = ImGui::GetFrameHeight() + scaled(2);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(corner, {corner.x + ImGui::GetWindowWidth(), corner.y + height}, false);
  float x = corner.x + scaled(10);
  for (size_t i = 0; i < names.size(); ++i) {
    const float width = fonts().bold->CalcTextSizeA(ImGui::GetFontSize(), FLT_MAX, 0, names[i]).x;
    ImGui::SetCursorScreenPos({x, corner.y});
    if (ImGui::InvisibleButton(names[i], {width, height})) chosen = i;
    map.mark_item(std::string("tab:") + names[i]);
    const bool bright = i == chosen || ImGui::IsItemHovered();
    list.AddText(fonts().bold, ImGui::GetFontSize(), {x, corner.y + (height - ImGui::GetFontSize()) / 2},
                 bright ? theme().text : theme().faint, names[i]);
    if (i == chosen)
      list.AddRectFilled({x, corner.y + height - scaled(2)}, {x + width, corner.y + height}, theme().accent);
    x += width + scaled(18);
  }
  list.PopClipRect();
  ImGui::SetCursorScreenPos(back);
}

bool close_button(const char* id) {
  const ImVec2 back = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight() + scaled(2);
  const ImVec2 low{ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - height - scaled(4),
                   ImGui::GetWindowPos().y};
  ImGui::SetCursorScreenPos(low);
  const bool pressed = ImGui::InvisibleButton(id, {height, height});
  const ImU32 colour = ImGui::IsItemHovered() ? theme().text : theme().faint;
  const ImVec2 middle{low.x + height / 2, low.y + height / 2};
  const float r = scaled(4);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(low, {low.x + height, low.y + height}, false);
  list.AddLine({middle.x - r, middle.y - r}, {middle.x + r, middle.y + r}, colour, scaled(1.5F));
  list.AddLine({middle.x - r, middle.y + r}, {middle.x + r, middle.y - r}, colour, scaled(1.5F));
  list.PopClipRect();
  ImGui::SetCursorScreenPos(back);
  return pressed;
}

void help_for_item(std::string_view text) {
  if (hover_seconds() < kHelpDelay) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(scaled(320));
  ImGui::TextUnformatted(begin_of(text), end_of(text));
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace inkbench
