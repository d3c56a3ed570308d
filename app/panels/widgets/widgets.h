// SPDX-License-Identifier: MIT
// Small parts that several panels draw with ImGui.
#pragma once

#include <imgui.h>

#include <span>
#include <string>
#include <string_view>

#include "app/window/ui_map.h"

namespace inkbench {

/// Text in a colour of the theme.
void coloured_text(ImU32 colour, std::string_view text);
/// Text that can wait.
void faint_text(std::string_view text);
/// Over as many lines as it takes, broken at spaces alone so that numbers stay whole.
void wrapped_text(std::string_view text, ImU32 colour);

/// Text that is cut with "..." where it would be wider than `width`; hovering shows all of it.
void fitted_text(std::string_view text, float width, ImU32 colour);

/// In the present font, in pixels.
float text_width(const std::string& text);

/// As `fitted_text`, drawn without taking space. Returns the width it took.
float draw_fitted_text(ImDrawList& list, ImVec2 place, float width, ImU32 colour, std::string_view text);

/// A button that is on or off.
bool toggle_button(const char* label, bool on, std::string_view help = "");

/// How wide a button with the label is.
float button_width(const char* label);

/// An item of a menu, `menu:LABEL` of the map; with a tick while it is on.
bool menu_item(UiMap& map, const char* label, const char* keys = nullptr, bool on = false);

/// A number of a table as people read it: at most four digits; any other text as it is.
std::string short_number(const std::string& text);

/// A heading across a panel.
void panel_heading(std::string_view text);

/// The same with several names of which one is chosen, each an item `tab:NAME` of the map.
void heading_tabs(UiMap& map, std::span<const char* const> names, size_t& chosen);

/// A cross at the right end of the panel's heading; after `panel_heading`.
bool close_button(const char* id);

/// A tooltip for the last item, which wraps long lines.
void help_for_item(std::string_view text);

/// How long the mouse has rested on the last item, in seconds; below zero where it is not on it.
double hover_seconds();
/// When tooltips that explain appear.
inline constexpr double kHelpDelay = 0.35;

}  // namespace inkbench
