// SPDX-License-Identifier: MIT
#include "app/panels/study/study_results_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/panels/study/study_chart_view.h"
#include "app/panels/study/study_list.h"
#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "app/workbench/folder_listing.h"
#include "app/workbench/open_outside.h"
#include "app/workbench/study_plan.h"
#include "pipeline/base/text.h"
#include "pipeline/export.h"

namespace inkbench {
namespace {

/// Until a picture that is being read is looked for again; a study that runs brings new ones all the time.
constexpr double kReadSeconds = 0.03, kReadSecondsBesideStudy = 0.15;

ListedStudy listed_of(const Studies& studies) {
  for (const ListedStudy& entry : studies.list()) {
    if (entry.study.folder == studies.shown()->folder) return entry;
  }
  ListedStudy other{.study = *studies.shown()};  // a folder that was opened
  if (!studies.results()) return other;
  const StudySummary& summary = studies.results()->summary();
  other.total = summary.cells;
  if (summary.state == "finished") other.state = StudyState::finished;
  return other;
}

/// The report where there is one, else the grid, else the folder.
std::filesystem::path page_of(const std::filesystem::path& folder) {
  for (const char* name : {"index.html", "grid.png"}) {
    std::error_code error;
    if (std::filesystem::exists(folder / name, error)) return folder / name;
  }
  return folder;
}

void open_page(Problems& problems, const std::filesystem::path& path) {
  if (attempt(problems, [&] { open_outside(path); }))
    problems.tell(Severity::note, "opened " + path.string());
}

}  // namespace

/// Pictures of another study, or of a new run of it, are other ones.
void StudyResultsPanel::follow_results() {
  if (folder_ != studies_.shown()->folder) {
    choice_ = {};
    wants_charts_ = false;
    chart_zoom_ = 1.0F;
  }
  folder_ = studies_.shown()->folder;
  if (revision_ != studies_.results_revision()) thumbnails_.forget();
  revision_ = studies_.results_revision();
}

void StudyResultsPanel::draw_head(const ListedStudy& listed) {
  const bool over = listed.state >= StudyState::finished;
  const bool finished = listed.state == StudyState::finished;
  const char* action = over ? (finished ? "Run again" : "Continue") : "Stop";
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float buttons = button_width(action) + button_width("Spec") + button_width("Open") + 2 * gap;
  const float width = ImGui::GetContentRegionAvail().x - buttons - scaled(12);
  ImGui::PushFont(fonts().bold);
  ImGui::AlignTextToFramePadding();
  fitted_text(listed.study.title, width, theme().text);
  ImGui::PopFont();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - buttons);
  const RecentStudy study = listed.study;
  if (ImGui::Button(action)) {
    if (!over) studies_.cancel(study);
    if (over) attempt(problems_, [&] { studies_.resume(study); });
  }
  ui_map_.mark_item(std::string("study action"));
  help_for_item(over ? "Cells that are there and the same are kept."
                     : "After this cell; it can be continued.");
  ImGui::SameLine();
  ImGui::BeginDisabled(study.spec.empty());
  if (ImGui::Button("Spec")) attempt(problems_, [&] { studies_.open_spec(study.spec); });
  ImGui::EndDisabled();
  ui_map_.mark_item("study spec");
  ImGui::SameLine();
  const std::filesystem::path page = page_of(study.folder);
  if (ImGui::Button("Open")) open_page(problems_, page);
  ui_map_.mark_item("open study");
  help_for_item("Shows " + page.filename().string() + " in the program that your desktop has for it.");
}

void StudyResultsPanel::draw_choices(const StudyResults& results) {
  const auto combo = [&](const char* id, float width, const std::string& now, size_t count, const auto& name,
                         const auto& choose) {
    if (ImGui::GetCursorPosX() + scaled(width) > ImGui::GetContentRegionMax().x) ImGui::NewLine();
    ImGui::SetNextItemWidth(scaled(width));
    const bool open = ImGui::BeginCombo(id, now.c_str(), ImGuiComboFlags_HeightLarge);
    ui_map_.mark_item(id);
    if (open) {
      for (size_t i = 0; i < count; ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable(name(i).c_str(), name(i) == now)) choose(i);
        ui_map_.mark_item(std::string(id) + "=" + name(i));
        ImGui::PopID();
      }
      ImGui::EndCombo();
    }
    ImGui::SameLine();
  };
  const auto& pictures = results.pictures();
  choice_.picture = std::min(choice_.picture, pictures.size() - 1);
  if (pictures.size() > 1)
    combo(
        "##picture", 150, pictures[choice_.picture], pictures.size(), [&](size_t i) { return pictures[i]; },
        [&](size_t i) { choice_.picture = i; });
  const GridAxis& pages = results.pages();
  choice_.page = std::min(choice_.page, pages.values.size() - 1);
  if (pages.values.size() > 1) {
    const auto name = [&](size_t i) {
      return pages.label.empty() ? pages.values[i] : pages.label + " " + pages.values[i];
    };
    combo("##page", 170, name(choice_.page), pages.values.size(), name, [&](size_t i) { choice_.page = i; });
  }
  const auto& numbers = results.numbers();
  if (choice_.number && *choice_.number >= numbers.size()) choice_.number.reset();
  const auto number_name = [&](size_t i) { return i == 0 ? std::string("no numbers") : numbers[i - 1]; };
  combo("##number", 150, number_name(choice_.number ? *choice_.number + 1 : 0), numbers.size() + 1,
        number_name, [&](size_t i) { choice_.number = i == 0 ? std::nullopt : std::optional(i - 1); });
}

void StudyResultsPanel::draw_zoom(float& zoom, float largest) {
  const float width = button_width("-") + button_width("Fit") + button_width("+") + 2 * 2;
  const float left = ImGui::GetContentRegionMax().x - width;
  if (ImGui::GetCursorPosX() > left) ImGui::NewLine();
  ImGui::SetCursorPosX(std::max(left, 0.0F));
  if (ImGui::Button("-")) zoom = std::max(1.0F, zoom / 1.25F);
  help_for_item("Smaller (Ctrl+wheel).");
  ImGui::SameLine(0, 2);
  if (toggle_button("Fit", zoom == 1.0F, "As large as the window has room for.")) zoom = 1.0F;
  ui_map_.mark_item("fit grid");
  ImGui::SameLine(0, 2);
  if (ImGui::Button("+")) zoom = std::min(largest, zoom * 1.25F);
  ui_map_.mark_item("larger cells");
  help_for_item("Larger (Ctrl+wheel).");
}

bool StudyResultsPanel::draw_kinds(const StudyResults& results) {
  if (results.charts().empty()) return false;
  const bool before = wants_charts_;
  if (toggle_button("Grid", !wants_charts_, "Every cell's picture.")) wants_charts_ = false;
  ui_map_.mark_item("show grid");
  ImGui::SameLine(0, 2);
  if (toggle_button("Charts", wants_charts_, "What the numbers of all cells say.")) wants_charts_ = true;
  ui_map_.mark_item("show charts");
  ImGui::SameLine();
  if (before != wants_charts_) thumbnails_.forget();  // the others are out of sight
  return wants_charts_;
}

void StudyResultsPanel::take_over(const StudyResults& results, size_t cell) {
  const std::filesystem::path file = results.picture(cell, choice_.picture);
  if (file.empty()) return;
  std::string taken = fmt::format("cell {}: {}", cell + 1, make_cell(results.spec(), cell).name);
  const bool worked = attempt(problems_, [&] {
    const Settings settings = read_origin(file).settings;
    const ImageParams& from = document_.settings().image;
    const ImageParams& to = settings.image;
    const bool same_size = from.width == to.width && from.height == to.height;
    if (!same_size) taken += fmt::format(", {} × {} px", to.width, to.height);
    document_.replace(settings, same_size ? "" : taken);
  });
  if (!worked) return;
  choice_.taken = cell;
  problems_.tell(Severity::note, "took over " + taken);
}

void StudyResultsPanel::draw_cell_menu(const StudyResults& results, const GridMouse& mouse) {
  if (mouse.menu) {
    menu_cell_ = mouse.menu;
    ImGui::OpenPopup("cell menu");
  }
  if (!menu_cell_ || !ImGui::BeginPopup("cell menu")) return;
  const size_t cell = *menu_cell_;
  const std::filesystem::path file =
      cell < cell_count(results.spec()) ? results.picture(cell, choice_.picture) : std::filesystem::path();
  faint_text(fmt::format("Cell {}", cell + 1));
  ImGui::Separator();
  if (ImGui::MenuItem("Take over its parameters", nullptr, false, !file.empty())) take_over(results, cell);
  if (ImGui::MenuItem("Open the picture", nullptr, false, !file.empty())) open_page(problems_, file);
  if (ImGui::MenuItem("Copy the picture's path", nullptr, false, !file.empty()))
    ImGui::SetClipboardText(file.c_str());
  ImGui::EndPopup();
}

void StudyResultsPanel::draw_grid(const StudyResults& results) {
  draw_choices(results);
  draw_zoom(choice_.zoom, kLargestGrid);
  ImGui::Dummy({0, scaled(2)});
  const GridMouse mouse = draw_study_grid(document_, ui_map_, results, choice_, thumbnails_);
  if (mouse.clicked) take_over(results, *mouse.clicked);
  draw_cell_menu(results, mouse);
}

void StudyResultsPanel::draw() {
  if (!studies_.shown()) return studies_.show_form();
  follow_results();
  const ListedStudy listed = listed_of(studies_);
  draw_head(listed);
  if (!studies_.shown()) return;
  if (!studies_.results()) {
    faint_text(state_text(listed));
    if (listed.job != nullptr && !listed.job->problem.empty())
      coloured_text(theme().error, listed.job->problem);
    return;
  }
  const StudyResults& results = *studies_.results();
  const float width = ImGui::GetContentRegionAvail().x;
  const bool all_done = listed.state == StudyState::finished && results.failed() == 0;
  const std::string size = results.bytes() > 0 ? shape_text(results.spec()) + ", " +
                                                     readable_bytes(static_cast<double>(results.bytes()))
                                               : plan_text(results.spec());
  fitted_text(
      (all_done ? "finished" : state_text(listed)) + "    " + size + "    " + path_text(results.folder()),
      width, theme().faint);
  if (listed.job != nullptr && listed.job->is_over() && !listed.job->problem.empty())
    fitted_text(listed.job->problem, width, theme().error);
  ImGui::Dummy({0, scaled(1)});
  thumbnails_.begin_frame();
  if (draw_kinds(results)) {
    draw_zoom(chart_zoom_, kLargestChart);
    ImGui::Dummy({0, scaled(2)});
    const std::filesystem::path clicked =
        draw_study_charts(ui_map_, results.charts(), chart_zoom_, thumbnails_);
    if (!clicked.empty()) open_page(problems_, clicked);
  } else {
    draw_grid(results);
  }
  thumbnails_.end_frame();
  if (thumbnails_.is_waiting())
    requests_.wake_in(studies_.is_busy() ? kReadSecondsBesideStudy : kReadSeconds);
}

}  // namespace inkbench
