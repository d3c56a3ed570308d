// SPDX-License-Identifier: MIT
#include "app/panels/study/study_list.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "app/workbench/duration_text.h"
#include "app/workbench/folder_listing.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

std::string cells_text(size_t count) {
  return with_commas(static_cast<long long>(count)) + (count == 1 ? " cell" : " cells");
}

std::string progress_text(const ListedStudy& study) {
  if (study.total == 0) return "starting";
  std::string text = fmt::format("{} of {}", with_commas(static_cast<long long>(study.done)),
                                 with_commas(static_cast<long long>(study.total)));
  const double left = study.job == nullptr ? -1 : study.job->seconds_left();
  if (left > 0) text += ", " + duration_text(left) + " left";
  return text;
}

ImU32 colour_of(const ListedStudy& study) {
  if (study.state == StudyState::failed) return theme().error;
  return study.state == StudyState::running ? theme().accent : theme().faint;
}

void draw_progress(const ListedStudy& study, ImVec2 low, float width) {
  const bool moves = study.state == StudyState::running || study.state == StudyState::stopping;
  if (!moves) return;
  const float share =
      study.total == 0 ? 0.0F : static_cast<float>(study.done) / static_cast<float>(study.total);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float height = scaled(3);
  list.AddRectFilled(low, {low.x + width, low.y + height}, theme().field, height / 2);
  if (share > 0)
    list.AddRectFilled(low, {low.x + std::max(width * share, height), low.y + height}, theme().accent,
                       height / 2);
}

void entry_menu(Studies& studies, Problems& problems, const ListedStudy& entry) {
  if (!ImGui::BeginPopupContextItem("study menu")) return;
  const bool over = entry.state >= StudyState::finished;
  if (!over && ImGui::MenuItem(entry.state == StudyState::stopping ? "Stop at once" : "Stop"))
    studies.cancel(entry.study);
  if (over && ImGui::MenuItem(entry.state == StudyState::finished ? "Run again" : "Continue"))
    attempt(problems, [&] { studies.resume(entry.study); });
  if (ImGui::MenuItem("Open the spec")) attempt(problems, [&] { studies.open_spec(entry.study.spec); });
  if (ImGui::MenuItem("Copy the folder's path")) ImGui::SetClipboardText(entry.study.folder.c_str());
  ImGui::Separator();
  if (ImGui::MenuItem("Take off this list", nullptr, false, over))
    attempt(problems, [&] { studies.forget(entry.study); });
  help_for_item("The files stay.");
  ImGui::EndPopup();
}

void draw_entry(Studies& studies, Problems& problems, UiMap& ui_map, const ListedStudy& entry, int index) {
  ImGui::PushID(index);
  const float pad = scaled(8), line = ImGui::GetTextLineHeight();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = 3 * line + scaled(20);
  if (ImGui::InvisibleButton("entry", {width, height})) attempt(problems, [&] { studies.show(entry.study); });
  ui_map.mark_item("study:" + entry.study.folder.filename().string());
  const auto& shown = studies.shown();
  const bool selected = !studies.shows_form() && shown && shown->folder == entry.study.folder;
  const bool hot = ImGui::IsItemHovered();
  help_for_item(path_text(entry.study.folder));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (selected || hot)
    list.AddRectFilled(low, {low.x + width, low.y + height}, selected ? theme().accent_soft : theme().field,
                       scaled(3));
  const float inner = width - 2 * pad;
  draw_fitted_text(list, {low.x + pad, low.y + scaled(5)}, inner, theme().text, entry.study.title);
  // Two runs of one sweep differ in their folders alone.
  draw_fitted_text(list, {low.x + pad, low.y + scaled(7) + line}, inner, theme().faint,
                   entry.study.folder.filename().string());
  const ImU32 colour = selected && colour_of(entry) == theme().faint ? theme().text : colour_of(entry);
  draw_fitted_text(list, {low.x + pad, low.y + scaled(9) + 2 * line}, inner, colour, state_text(entry));
  draw_progress(entry, {low.x + pad, low.y + height - scaled(6)}, inner);
  entry_menu(studies, problems, entry);
  ImGui::PopID();
}

}  // namespace

std::string state_text(const ListedStudy& study) {
  switch (study.state) {
    case StudyState::waiting:
      return "waits for its turn";
    case StudyState::running:
      return progress_text(study);
    case StudyState::stopping:
      return "stopping after this cell";
    case StudyState::finished:
      if (study.job != nullptr && study.job->failed > 0) return cells_text(study.job->failed) + " failed";
      return cells_text(study.total);
    case StudyState::stopped:
      return study.done > 0 ? fmt::format("stopped, {} of {}", study.done, study.total) : "not finished";
    case StudyState::failed:
      return "failed";
  }
  return "";
}

void draw_study_list(const Document& document, Studies& studies, Problems& problems, UiMap& ui_map) {
  if (toggle_button("New study",
                    studies.shows_form() && studies.form() != nullptr && !studies.form()->own_text))
    attempt(problems,
            [&] { studies.form() == nullptr ? studies.new_form(document.settings()) : studies.show_form(); });
  ui_map.mark_item("new study");
  ImGui::Dummy({0, scaled(2)});
  const std::vector<ListedStudy> list = studies.list();
  for (size_t i = 0; i < list.size(); ++i) {
    // What an entry does may change the list that its job is in.
    draw_entry(studies, problems, ui_map, list[i], static_cast<int>(i));
    if (studies.list().size() != list.size()) return;
  }
  if (!list.empty()) return;
  wrapped_text("Studies that you run are listed here. They run in the background, one after the other.",
               theme().faint);
}

}  // namespace inkbench
