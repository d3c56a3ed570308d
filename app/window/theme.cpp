// SPDX-License-Identifier: MIT
#include "app/window/theme.h"

#include <cmath>

namespace inkbench {
namespace {

constexpr ImU32 rgb(unsigned hex) {
  return IM_COL32((hex >> 16) & 0xff, (hex >> 8) & 0xff, hex & 0xff, 255);
}

constexpr Palette kDark{
    .canvas = rgb(0x17181a),
    .panel = rgb(0x222326),
    .bar = rgb(0x2a2b2f),
    .field = rgb(0x313338),
    .field_hot = rgb(0x3a3d43),
    .line = rgb(0x121315),
    .text = rgb(0xdcdee2),
    .faint = rgb(0x8c9098),
    .accent = rgb(0x4ea1e8),
    .accent_soft = rgb(0x2f5478),
    .on_accent = rgb(0x0c1117),
    .mark = rgb(0xe0503f),
    .warning = rgb(0xe2ad55),
    .error = rgb(0xe5736b),
    .good = rgb(0x7cba7e),
};

constexpr Palette kLight{
    .canvas = rgb(0xd6d8db),
    .panel = rgb(0xf4f5f6),
    .bar = rgb(0xe7e9eb),
    .field = rgb(0xe1e3e7),
    .field_hot = rgb(0xd6d9de),
    .line = rgb(0xc3c7cc),
    .text = rgb(0x1f2226),
    .faint = rgb(0x666c75),
    .accent = rgb(0x1a6fb9),
    .accent_soft = rgb(0xa9cdec),
    .on_accent = rgb(0xffffff),
    .mark = rgb(0xd1392b),
    .warning = rgb(0x9a6200),
    .error = rgb(0xbb342b),
    .good = rgb(0x2c7a35),
};

struct Current {
  Palette palette = kDark;
  float scale = 1.0F;
};

Current& current() {
  static Current value;
  return value;
}

void set_colours(ImGuiStyle& style, const Palette& t) {
  const auto set = [&](ImGuiCol place, ImU32 colour) { style.Colors[place] = as_vec4(colour); };
  const ImU32 none = IM_COL32(0, 0, 0, 0);
  set(ImGuiCol_Text, t.text);
  set(ImGuiCol_TextDisabled, t.faint);
  set(ImGuiCol_TextSelectedBg, t.accent_soft);
  set(ImGuiCol_WindowBg, t.panel);
  set(ImGuiCol_ChildBg, none);
  set(ImGuiCol_PopupBg, t.bar);
  set(ImGuiCol_MenuBarBg, t.bar);
  set(ImGuiCol_Border, with_alpha(t.faint, 0.35F));
  set(ImGuiCol_FrameBg, t.field);
  set(ImGuiCol_FrameBgHovered, t.field_hot);
  set(ImGuiCol_FrameBgActive, t.field_hot);
  set(ImGuiCol_Button, t.field);
  set(ImGuiCol_ButtonHovered, t.field_hot);
  set(ImGuiCol_ButtonActive, t.accent_soft);
  set(ImGuiCol_Header, t.accent_soft);
  set(ImGuiCol_HeaderHovered, t.field_hot);
  set(ImGuiCol_HeaderActive, t.accent_soft);
  set(ImGuiCol_CheckMark, t.accent);
  set(ImGuiCol_SliderGrab, t.accent);
  set(ImGuiCol_SliderGrabActive, t.accent);
  set(ImGuiCol_Separator, t.line);
  set(ImGuiCol_ScrollbarBg, none);
  set(ImGuiCol_ScrollbarGrab, t.field_hot);
  set(ImGuiCol_ScrollbarGrabHovered, with_alpha(t.faint, 0.7F));
  set(ImGuiCol_ScrollbarGrabActive, t.faint);
  set(ImGuiCol_TableHeaderBg, none);
  set(ImGuiCol_TableBorderLight, t.line);
  set(ImGuiCol_TableBorderStrong, t.line);
  set(ImGuiCol_TableRowBg, none);
  set(ImGuiCol_TableRowBgAlt, none);
  set(ImGuiCol_NavHighlight, t.accent);
  set(ImGuiCol_ModalWindowDimBg, IM_COL32(0, 0, 0, 120));
}

void set_sizes(ImGuiStyle& style) {
  style.WindowPadding = {10, 8};
  style.FramePadding = {7, 3};
  style.ItemSpacing = {7, 5};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {6, 2};
  style.IndentSpacing = 12;
  style.ScrollbarSize = 10;
  style.GrabMinSize = 8;
  style.WindowBorderSize = 0;
  style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.WindowRounding = 0;
  style.FrameRounding = 3;
  style.PopupRounding = 4;
  style.ScrollbarRounding = 5;
  style.GrabRounding = 3;
}

}  // namespace

const Palette& theme() {
  return current().palette;
}

void apply_theme(Theme name, float scale) {
  current() = {name == Theme::dark ? kDark : kLight, scale};
  ImGuiStyle style;
  set_sizes(style);
  set_colours(style, current().palette);
  style.ScaleAllSizes(scale);
  style.PopupBorderSize = std::max(1.0F, std::floor(scale));
  ImGui::GetStyle() = style;
}

float text_scale() {
  return current().scale;
}

float scaled(float length) {
  return std::round(length * current().scale);
}

ImVec4 as_vec4(ImU32 colour) {
  return ImGui::ColorConvertU32ToFloat4(colour);
}

ImU32 with_alpha(ImU32 colour, float alpha) {
  const auto byte = static_cast<ImU32>(std::lround(alpha * 255.0F));
  return (colour & ~IM_COL32_A_MASK) | (byte << IM_COL32_A_SHIFT);
}

}  // namespace inkbench
