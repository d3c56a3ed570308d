// SPDX-License-Identifier: MIT
#include "app/window/typing_wish.h"

#include <imgui_internal.h>

namespace inkbench {
namespace {

constexpr int kPatienceFrames = 8;

struct Wish {
  int frames_left = 0;
  bool is_fresh = false;  ///< Asked for in the last frame: another field may still have the keyboard.
};

Wish& wish() {
  static Wish value;
  return value;
}

bool is_typed_into() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.ActiveId != 0 && context.ActiveId == context.InputTextState.ID;
}

}  // namespace

void expect_typing() {
  wish() = {kPatienceFrames, true};
}

void take_keyboard() {
  ImGui::SetKeyboardFocusHere();
  expect_typing();
}

bool typing_is_expected() {
  return wish().frames_left > 0;
}

bool keys_must_wait() {
  Wish& now = wish();
  if (now.frames_left == 0) return false;
  --now.frames_left;
  const bool is_fresh = now.is_fresh;
  now.is_fresh = false;
  if (!is_fresh && is_typed_into()) now.frames_left = 0;
  return now.frames_left > 0;
}

}  // namespace inkbench
