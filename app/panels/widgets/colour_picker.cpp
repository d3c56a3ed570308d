// SPDX-License-Identifier: MIT
#include "app/panels/widgets/colour_picker.h"

#include <imgui.h>

#include "app/panels/widgets/held_drag.h"
#include "app/window/theme.h"

namespace inkbench {
namespace {

constexpr ImGuiColorEditFlags kSwatchFlags = ImGuiColorEditFlags_NoAlpha | ImGuiColorEditFlags_NoTooltip;
constexpr ImGuiColorEditFlags kPickerFlags =
    ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_Float | ImGuiColorEditFlags_PickerHueBar;

/// Another mouse for ImGui's own widgets, whose fields would move faster with Shift instead of finer.
class OtherMouse {
 public:
  OtherMouse(ImVec2 place, ImVec2 step)
      : io_(ImGui::GetIO()), place_(io_.MousePos), step_(io_.MouseDelta), shift_(io_.KeyShift) {
    io_.MousePos = place;
    io_.MouseDelta = step;
    io_.KeyShift = false;
  }
  OtherMouse(const OtherMouse&) = delete;
  OtherMouse& operator=(const OtherMouse&) = delete;
  ~OtherMouse() {
    io_.MousePos = place_;
    io_.MouseDelta = step_;
    io_.KeyShift = shift_;
  }

 private:
  ImGuiIO& io_;
  ImVec2 place_, step_;
  bool shift_;
};

bool picker_with_mouse(glm::vec3& colour, ImVec2 place, ImVec2 step) {
  const OtherMouse mouse(place, step);
  return ImGui::ColorPicker3("##picker", &colour.x, kPickerFlags);
}

/// The picker that is dragged or typed in.
struct Picking {
  ImGuiID id = 0;  ///< 0: none.
  ImVec2 place;    ///< Of the mouse as it sees it.
};

Picking& picking() {
  static Picking value;
  return value;
}

}  // namespace

bool colour_swatch(const glm::vec3& colour, float width) {
  return ImGui::ColorButton("colour", {colour.x, colour.y, colour.z, 1}, kSwatchFlags,
                            {width, ImGui::GetFrameHeight()});
}

void colour_picker(Document& document, UiMap& ui_map, const std::string& mark, glm::vec3 colour, bool opens,
                   const std::function<void(const glm::vec3&)>& change) {
  Picking& state = picking();
  const ImGuiID own = ImGui::GetID("picker");
  if (opens) ImGui::OpenPopup("picker");
  if (!ImGui::BeginPopup("picker")) {
    if (state.id == own) document.end_edit();  // closed in the middle of a drag
    if (state.id == own) state.id = 0;
    return;
  }
  const ImVec2 step = drag_step();
  const ImVec2 place =
      state.id == own ? ImVec2{state.place.x + step.x, state.place.y + step.y} : ImGui::GetIO().MousePos;
  state.place = place;
  ImGui::SetNextItemWidth(scaled(220));
  const bool changed = picker_with_mouse(colour, place, step);
  ui_map.mark_item(mark);
  if (ImGui::IsItemActivated()) {
    state.id = own;
    document.begin_edit();
  }
  if (changed) change(colour);
  if (ImGui::IsItemDeactivated() && state.id == own) {
    state.id = 0;
    document.end_edit();
  }
  ImGui::EndPopup();
}

}  // namespace inkbench
