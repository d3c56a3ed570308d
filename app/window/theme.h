// SPDX-License-Identifier: MIT
// How the window looks: two palettes with neutral greys, which do not tint the pictures between them, and one
// accent. In: which palette and how large. Out: ImGui's style, and colours for what panels draw themselves.
#pragma once

#include <imgui.h>

#include "app/workbench/window_layout.h"

namespace inkbench {

struct Palette {
  ImU32 canvas;     ///< Behind pictures.
  ImU32 panel;      ///< Behind everything else.
  ImU32 bar;        ///< Menu, headings, status.
  ImU32 field;      ///< Behind values that can be changed.
  ImU32 field_hot;  ///< The same under the mouse.
  ImU32 line;       ///< Between panels, around pictures.
  ImU32 text;
  ImU32 faint;  ///< Text that can wait.
  ImU32 accent;
  ImU32 accent_soft;  ///< The filled part of a slider, a selected row.
  ImU32 on_accent;    ///< Text on the accent.
  ImU32 mark;         ///< On pictures of any colour, beside the accent.
  ImU32 warning, error, good;
};

/// The palette in use.
const Palette& theme();

/// Sets the palette and ImGui's style for text `scale` times as large as usual.
void apply_theme(Theme name, float scale);

/// How many times the usual size text has.
float text_scale();

/// A length at the usual text size, in pixels of this display.
float scaled(float length);

ImVec4 as_vec4(ImU32 colour);

/// The colour with another opacity, 0 to 1.
ImU32 with_alpha(ImU32 colour, float alpha);

}  // namespace inkbench
