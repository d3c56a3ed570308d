// SPDX-License-Identifier: MIT
#include "app/panels/widgets/file_chooser.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>

#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "app/window/typing_wish.h"
#include "app/workbench/save_place.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

constexpr float kPlacesWidth = 132, kSizeWidth = 74;

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

fs::path working_folder() {
  std::error_code error;
  return fs::current_path(error);
}

bool key_pressed(ImGuiKey key) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

}  // namespace

void FileChooser::ask(ChooserQuestion question) {
  question_ = std::move(question);
  asking_ = true;
  expect_typing();
  replaces_.reset();
}

fs::path FileChooser::path_of(const FolderEntry& entry) const {
  return shows_recent_ ? fs::path(entry.name) : listing_.folder / entry.name;
}

/// An empty folder stands for the recent files.
void FileChooser::go_to(const fs::path& folder) {
  shows_recent_ = folder.empty();
  selected_.reset();
  replaces_.reset();
  problem_.clear();
  if (!shows_recent_) {
    listing_ = list_folder(folder, question_.extensions);
    path_text_ = folder.string();
    return;
  }
  listing_ = {};
  path_text_.clear();
  for (const fs::path& file : keeping_.recent()) {
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(file, error);
    if (!error) listing_.entries.push_back({file.string(), false, bytes});
  }
  if (listing_.entries.empty()) go_to(project_file("data/scenes"));
}

void FileChooser::place(const char* name, const fs::path& folder) {
  const bool here = folder.empty() ? shows_recent_ : !shows_recent_ && listing_.folder == folder;
  if (!folder.empty() && !is_folder(folder)) return;
  if (ImGui::Selectable(name, here)) go_to(folder);
  ui_map_.mark_item(std::string("place:") + name);
}

void FileChooser::draw_places() {
  const bool has_recent = !question_.saves && !keeping_.recent().empty();
  if (has_recent) place("Recent", {});
  place("Scenes", project_file("data/scenes"));
  if (!question_.saves) place("Studies", project_root() / "studies");
  place("Presets", keeping_.presets().folder());
  place("Working folder", working_folder());
  if (const char* home = std::getenv("HOME"); home != nullptr) place("Home", home);
  place("All files", "/");
}

void FileChooser::draw_path() {
  const float up = button_width("Up");
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - up - ImGui::GetStyle().ItemSpacing.x);
  if (focus_ && !question_.saves) take_keyboard();
  const bool entered =
      ImGui::InputTextWithHint("##path", "Type or paste a path", &path_text_,
                               ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ui_map_.mark_item("path");
  if (ImGui::IsItemEdited()) selected_.reset();  // what was typed last is meant
  if (ImGui::IsItemEdited()) problem_.clear();
  if (entered && path_text_ != listing_.folder.string()) selected_.reset();
  if (entered) open_chosen();
  ImGui::SameLine();
  if (ImGui::Button("Up") && !shows_recent_) go_to(listing_.folder.parent_path());
  ui_map_.mark_item("chooser:up");
}

/// What Enter and a double click do: into a folder, or that file.
void FileChooser::activate(const fs::path& path) {
  if (path.empty()) return;
  if (is_folder(path)) {
    go_to(path.has_filename() ? path : path.parent_path());
    focus_ = true;
  } else if (question_.saves) {
    name_file(path);
  } else if (is_taken(path)) {
    choose(path);
  } else {
    tell_missing(path);
  }
}

/// The text stays, to be mended beside what its folder has.
void FileChooser::tell_missing(const fs::path& path) {
  const fs::path folder = path.parent_path();
  if (is_folder(folder) && folder != listing_.folder) {
    go_to(folder);
    path_text_ = path.string();
  }
  problem_ = "There is no " + path.string();
}

/// The file that would be written.
fs::path FileChooser::target() const {
  return save_path(question_.name, listing_.folder, question_.extensions);
}

/// A whole path becomes the folder that is shown and the name in it, so that what is asked next is seen
/// there.
void FileChooser::name_file(const fs::path& path) {
  if (path.empty()) return;
  if (is_folder(path)) {
    question_.name.clear();
    return activate(path);
  }
  const fs::path folder = path.parent_path();
  question_.name = is_folder(folder) ? path.filename().string() : path.string();
  if (is_folder(folder) && folder != listing_.folder) go_to(folder);
  focus_ = true;
  choose(target());
}

/// What is to be saved is asked about where it would replace a file; no folder is made for it.
void FileChooser::choose(const fs::path& path) {
  problem_ = question_.saves ? save_problem(path) : "";
  if (!problem_.empty()) return;
  if (question_.saves && is_taken(path) && replaces_ != path) {
    replaces_ = path;
  } else {
    chosen_ = path;
  }
}

void FileChooser::draw_entry(size_t index) {
  const FolderEntry& entry = listing_.entries[index];
  const bool selected = selected_ == index;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(static_cast<int>(index));
  const bool pressed = ImGui::Selectable(
      "##entry", selected, ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick);
  ui_map_.mark_item("entry:" + entry.name);
  const ImVec2 low = ImGui::GetItemRectMin();
  const bool twice = pressed && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (selected && scroll_) ImGui::SetScrollHereY();
  ImGui::SameLine(0, 0);
  const fs::path shown(entry.name);
  const std::string text = shows_recent_ ? shown.filename().string() + "   " + shown.parent_path().string()
                                         : entry.name + (entry.is_folder ? "/" : "");
  const float width = ImGui::GetContentRegionAvail().x;
  draw_fitted_text(*ImGui::GetWindowDrawList(), {low.x + scaled(4), ImGui::GetCursorScreenPos().y},
                   width - scaled(4), entry.is_folder ? theme().accent : theme().text, text);
  ImGui::NewLine();
  ImGui::TableNextColumn();
  if (!entry.is_folder) faint_text(readable_bytes(static_cast<double>(entry.bytes)));
  ImGui::PopID();
  if (pressed) selected_ = index;
  if (pressed && question_.saves && !entry.is_folder) question_.name = entry.name;
  if (twice) activate(path_of(entry));
}

void FileChooser::move_by_keys() {
  const size_t count = listing_.entries.size();
  scroll_ = false;
  if (count == 0) return;
  if (key_pressed(ImGuiKey_DownArrow)) selected_ = selected_ ? std::min(*selected_ + 1, count - 1) : 0;
  if (key_pressed(ImGuiKey_UpArrow)) selected_ = selected_ && *selected_ > 0 ? *selected_ - 1 : 0;
  scroll_ = key_pressed(ImGuiKey_DownArrow) || key_pressed(ImGuiKey_UpArrow);
  const bool into = key_pressed(ImGuiKey_Enter) && !ImGui::GetIO().WantTextInput && selected_;
  if (into) activate(path_of(listing_.entries[*selected_]));
}

void FileChooser::draw_entries(float height) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, theme().panel);
  ImGui::BeginChild("entries", {0, height}, true);
  const size_t drawn_folder = listing_.entries.size();
  if (ImGui::BeginTable("files", 2)) {
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed, scaled(kSizeWidth));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(drawn_folder));
    if (scroll_ && selected_) clipper.ForceDisplayRangeByIndices(*selected_, *selected_ + 1);
    while (clipper.Step()) {
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
        if (static_cast<size_t>(i) < listing_.entries.size()) draw_entry(i);
      }
    }
    ImGui::EndTable();
  }
  if (listing_.entries.empty()) faint_text("No file of this kind here.");
  if (!listing_.problem.empty()) coloured_text(theme().warning, listing_.problem);
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

void FileChooser::draw_buttons() {
  bool accepts = false;
  if (question_.saves) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Name");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (focus_) take_keyboard();
    accepts = ImGui::InputText("##name", &question_.name,
                               ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    ui_map_.mark_item("chooser:name");
    if (ImGui::IsItemEdited()) problem_.clear();
    if (replaces_ && *replaces_ != target()) replaces_.reset();
  }
  focus_ = false;
  const char* label = replaces_ ? "Replace" : question_.button.c_str();
  accepts |= ImGui::Button(label, {scaled(100), 0});
  ui_map_.mark_item("chooser:ok");
  ImGui::SameLine();
  const bool cancels = ImGui::Button("Cancel", {scaled(100), 0}) || key_pressed(ImGuiKey_Escape);
  ui_map_.mark_item("chooser:cancel");
  ImGui::SameLine();
  if (replaces_) {
    fitted_text(replaces_->filename().string() + " is there already. Replace it?",
                ImGui::GetContentRegionAvail().x, theme().warning);
    ui_map_.mark_item("chooser:replace");
  } else if (!problem_.empty()) {
    fitted_text(problem_, ImGui::GetContentRegionAvail().x, theme().error);
    ui_map_.mark_item("chooser:problem");
  } else {
    ImGui::NewLine();
  }
  if (accepts && question_.saves && !question_.name.empty()) name_file(target());
  if (accepts && !question_.saves) open_chosen();
  if (cancels) ImGui::CloseCurrentPopup();
}

/// What is selected in the list, else what was typed.
void FileChooser::open_chosen() {
  if (selected_) return activate(path_of(listing_.entries[*selected_]));
  const fs::path typed = path_from_text(path_text_, shows_recent_ ? working_folder() : listing_.folder);
  if (typed != listing_.folder) activate(typed);
}

std::optional<fs::path> FileChooser::draw(const std::function<void()>& extras) {
  if (asking_) {
    ImGui::OpenPopup("file chooser");
    go_to(question_.folder);
    focus_ = true;
    asking_ = false;
  }
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSize({std::min(scaled(720), screen.x - scaled(20)), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(18), scaled(14)));
  open_ = ImGui::BeginPopupModal("file chooser", nullptr,
                                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings |
                                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize);
  ImGui::PopStyleVar();
  if (!open_) return std::nullopt;
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted(question_.title.c_str());
  ImGui::PopFont();
  wrapped_text(question_.help, theme().faint);
  ImGui::Dummy({0, scaled(2)});
  const float height = std::min(scaled(330), screen.y - scaled(230));
  ImGui::BeginChild("places", {scaled(kPlacesWidth), height});
  draw_places();
  ImGui::EndChild();
  ImGui::SameLine(0, scaled(14));
  ImGui::BeginChild("folder", {0, height});
  move_by_keys();
  draw_path();
  draw_entries(0);
  ImGui::EndChild();
  if (extras) extras();
  draw_buttons();
  if (chosen_) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return std::exchange(chosen_, std::nullopt);
}

}  // namespace inkbench
