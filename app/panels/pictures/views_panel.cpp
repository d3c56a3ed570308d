// SPDX-License-Identifier: MIT
#include "app/panels/pictures/views_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>

#include "app/panels/widgets/widgets.h"
#include "app/window/scene_bounds.h"
#include "app/window/theme.h"
#include "app/window/typing_wish.h"
#include "app/workbench/camera_control.h"
#include "pipeline/base/error.h"

namespace inkbench {
namespace {

using Bookmarks = std::vector<CameraBookmark>;

void set_camera(Document& document, const CameraParams& camera, const std::string& step) {
  Settings next = document.settings();
  next.camera = camera;
  document.replace(next, step);
}

void recall(Document& document, const CameraBookmark& bookmark) {
  set_camera(document, bookmark.camera, "view " + bookmark.name);
}

int free_key(const Bookmarks& bookmarks) {
  for (int key = 1; key <= 9; ++key) {
    if (std::none_of(bookmarks.begin(), bookmarks.end(), [&](const auto& one) { return one.key == key; }))
      return key;
  }
  return 0;
}

std::string usual_name(const Bookmarks& bookmarks, int key) {
  return "View " + std::to_string(key > 0 ? key : static_cast<int>(bookmarks.size()) + 1);
}

struct Direction {
  const char* name;
  double azimuth_deg, elevation_deg;
};
constexpr std::array kDirections{Direction{"Front", 0, 0},  Direction{"Right", 90, 0},
                                 Direction{"Top", 0, 90},   Direction{"Back", 180, 0},
                                 Direction{"Left", 270, 0}, Direction{"Angle", 35, 25}};

void draw_directions(Document& document, Pictures& pictures, Problems& problems, UiMap& ui_map) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2 * spacing) / 3;
  for (size_t i = 0; i < kDirections.size(); ++i) {
    const Direction& direction = kDirections[i];
    if (i % 3 != 0) ImGui::SameLine();
    if (ImGui::Button(direction.name, {width, 0}))
      set_camera(document,
                 view_from(document.settings().camera, direction.azimuth_deg, direction.elevation_deg),
                 std::string("view from ") + direction.name);
    ui_map.mark_item(std::string("view:") + direction.name);
  }
  const float half = (ImGui::GetContentRegionAvail().x - spacing) / 2;
  if (ImGui::Button("Fit the scene", {half, 0})) fit_view(document, pictures, problems, FitTo::scene);
  ui_map.mark_item("view:fit scene");
  help_for_item("The camera keeps its direction; all visible models fill the picture (Home).");
  ImGui::SameLine();
  if (ImGui::Button("Fit the model", {half, 0})) fit_view(document, pictures, problems, FitTo::model);
  ui_map.mark_item("view:fit model");
  help_for_item("The same for the main model, the first one that is a mesh (Shift+Home).");
  bool orthographic = is_orthographic(document.settings().camera);
  if (ImGui::Checkbox("Orthographic", &orthographic)) toggle_projection(document, pictures, problems);
  ui_map.mark_item("view:orthographic");
  help_for_item("Parallel lines of sight; what is at the target keeps its size (X).");
}

void draw_key(int key, ImVec2 low, float size) {
  if (key == 0) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string text = std::to_string(key);
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  list.AddRectFilled({low.x, low.y + 1}, {low.x + size, low.y + size - 1}, theme().field, scaled(3));
  list.AddText({low.x + (size - width) / 2, low.y + (size - ImGui::GetFontSize()) / 2}, theme().text,
               text.c_str());
}

}  // namespace

void keep_view(const Document& document, Keeping& keeping, Problems& problems, int key) {
  Bookmarks bookmarks = keeping.bookmarks();
  const auto same = std::find_if(bookmarks.begin(), bookmarks.end(),
                                 [&](const auto& bookmark) { return key > 0 && bookmark.key == key; });
  if (same != bookmarks.end()) {
    same->camera = document.settings().camera;
  } else {
    bookmarks.push_back({usual_name(bookmarks, key), key, document.settings().camera});
  }
  keeping.set_bookmarks(std::move(bookmarks));
  problems.tell(Severity::note, fmt::format("kept the camera; Shift+{} brings it back", key));
}

void recall_view(Document& document, Keeping& keeping, Problems& problems, int key) {
  for (const CameraBookmark& bookmark : keeping.bookmarks()) {
    if (bookmark.key == key) return recall(document, CameraBookmark(bookmark));
  }
  problems.tell(Severity::note, fmt::format("no camera has the key {0}; Ctrl+{0} keeps this one", key));
}

void toggle_projection(Document& document, Pictures& pictures, Problems& problems) {
  const CameraParams& camera = document.settings().camera;
  try {
    if (is_orthographic(camera)) {
      const CameraParams moved = with_projection(camera, CameraProjection::perspective);
      return set_camera(document, moved, "perspective view");
    }
    const Bounds bounds = bounds_in_world(pictures.pipeline().at(document.settings()), false);
    const CameraParams moved = with_projection(camera, CameraProjection::orthographic);
    set_camera(document, keep_in_range(moved, bounds), "orthographic view");
  } catch (const Error& error) {
    problems.set(ProblemKind::drawing, error.what());
  }
}

void fit_view(Document& document, Pictures& pictures, Problems& problems, FitTo what) {
  try {
    const Bounds bounds = bounds_in_world(pictures.pipeline().at(document.settings()), what == FitTo::model);
    const ImageParams& image = document.settings().image;
    const ViewSize size{static_cast<float>(image.width), static_cast<float>(image.height)};
    set_camera(document, fit_to_bounds(document.settings().camera, bounds, size),
               what == FitTo::model ? "fit the model" : "fit the scene");
  } catch (const Error& error) {
    problems.set(ProblemKind::drawing, error.what());
  }
}

void ViewsPanel::draw_name(size_t index, float width) {
  ImGui::SetNextItemWidth(width);
  if (focus_) take_keyboard();
  focus_ = false;
  const bool entered = ImGui::InputText(
      "##new name", &new_name_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ui_map_.mark_item("view:new name");
  if (!entered && !ImGui::IsItemDeactivated()) return;
  Bookmarks bookmarks = keeping_.bookmarks();
  if (entered && !new_name_.empty()) bookmarks[index].name = new_name_;
  keeping_.set_bookmarks(std::move(bookmarks));
  renamed_ = -1;
}

void ViewsPanel::draw_bookmark(size_t index) {
  const CameraBookmark bookmark = keeping_.bookmarks()[index];
  const float size = ImGui::GetFrameHeight();
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(static_cast<int>(index));
  draw_key(bookmark.key, place, size);
  if (renamed_ == static_cast<int>(index)) {
    ImGui::SetCursorScreenPos({place.x + size + scaled(6), place.y});
    draw_name(index, width - size - scaled(6));
    return ImGui::PopID();
  }
  ImGui::SetCursorScreenPos({place.x + size + scaled(6), place.y});
  const float row = width - 2 * size - scaled(10);
  if (ImGui::InvisibleButton("row", {row, size})) recall(document_, bookmark);
  ui_map_.mark_item("bookmark:" + bookmark.name);
  const bool hot = ImGui::IsItemHovered();
  if (hot)
    ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                              theme().field_hot, ImGui::GetStyle().FrameRounding);
  help_for_item("Click to look from there. Right click to rename it or change it.");
  bool dropped = false;
  Bookmarks bookmarks = keeping_.bookmarks();
  if (ImGui::BeginPopupContextItem("bookmark menu")) {
    if (ImGui::MenuItem("Rename")) {
      renamed_ = static_cast<int>(index);
      new_name_ = bookmark.name;
      focus_ = true;
      expect_typing();
    }
    if (ImGui::MenuItem("Replace with the camera now")) {
      bookmarks[index].camera = document_.settings().camera;
      keeping_.set_bookmarks(bookmarks);
    }
    dropped = ImGui::MenuItem("Delete");
    ImGui::EndPopup();
  }
  draw_fitted_text(*ImGui::GetWindowDrawList(),
                   {place.x + size + scaled(10), place.y + ImGui::GetStyle().FramePadding.y}, row - scaled(8),
                   theme().text, bookmark.name);
  ImGui::SameLine(0, scaled(2));
  const ImVec2 cross = ImGui::GetCursorScreenPos();
  dropped |= ImGui::InvisibleButton("drop", {size, size});
  ui_map_.mark_item("drop bookmark:" + bookmark.name);
  ImGui::GetWindowDrawList()->AddText({cross.x + scaled(6), cross.y + ImGui::GetStyle().FramePadding.y},
                                      ImGui::IsItemHovered() ? theme().text : theme().faint, "✕");
  ImGui::PopID();
  if (!dropped) return;
  bookmarks.erase(bookmarks.begin() + static_cast<std::ptrdiff_t>(index));
  keeping_.set_bookmarks(std::move(bookmarks));
}

void ViewsPanel::draw_bookmarks() {
  const float button = button_width("Keep");
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x);
  const int key = free_key(keeping_.bookmarks());
  const bool entered = ImGui::InputTextWithHint("##view name", usual_name(keeping_.bookmarks(), key).c_str(),
                                                &name_, ImGuiInputTextFlags_EnterReturnsTrue);
  ui_map_.mark_item("view:name");
  ImGui::SameLine();
  const bool pressed = ImGui::Button("Keep");
  ui_map_.mark_item("view:keep");
  help_for_item("Keep the camera under this name (Ctrl+1 to 9).");
  if (entered || pressed) {
    Bookmarks bookmarks = keeping_.bookmarks();
    bookmarks.push_back(
        {name_.empty() ? usual_name(bookmarks, key) : name_, key, document_.settings().camera});
    keeping_.set_bookmarks(std::move(bookmarks));
    name_.clear();
  }
  ImGui::BeginChild("bookmarks", {0, 0}, false, ImGuiWindowFlags_NoBackground);
  for (size_t i = 0; i < keeping_.bookmarks().size(); ++i) draw_bookmark(i);
  if (keeping_.bookmarks().empty()) {
    wrapped_text("No cameras kept yet. Ctrl+1 to 9 keeps the camera, Shift+1 to 9 brings it back.",
                 theme().faint);
  }
  ImGui::EndChild();
}

void ViewsPanel::draw() {
  draw_directions(document_, pictures_, problems_, ui_map_);
  ImGui::Dummy({0, scaled(4)});
  ImGui::Separator();
  ImGui::Dummy({0, scaled(2)});
  draw_bookmarks();
}

}  // namespace inkbench
