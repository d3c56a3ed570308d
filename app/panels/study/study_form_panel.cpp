// SPDX-License-Identifier: MIT
#include "app/panels/study/study_form_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/panels/study/study_axes.h"
#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/value_bar.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "app/workbench/duration_text.h"
#include "app/workbench/folder_listing.h"
#include "app/workbench/study_plan.h"
#include "pipeline/base/text.h"
#include "studies/sweep/number_columns.h"

namespace inkbench {
namespace {

constexpr float kNames = 66;  // width of the column of names

/// A row's name, and the cursor where its widget begins.
void row_name(const char* name) {
  ImGui::AlignTextToFramePadding();
  faint_text(name);
  ImGui::SameLine(scaled(kNames));
}

void bold(const std::string& text) {
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopFont();
}

void show_row(UiMap& ui_map, StudyForm& form) {
  row_name("Show");
  const float left = ImGui::GetCursorPosX();
  std::vector<BufferName>& show = form.request.show;
  const std::vector<BufferName> buffers = all_buffers();
  for (const BufferName buffer : buffers) {
    const std::string name(name_of(buffer));
    const auto place = std::find(show.begin(), show.end(), buffer);
    const float width = ImGui::CalcTextSize(name.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    const bool is_first = buffer == buffers.front();
    if (!is_first) ImGui::SameLine(0, scaled(4));
    if (!is_first && ImGui::GetContentRegionAvail().x < width) {
      ImGui::NewLine();
      ImGui::SetCursorPosX(left);
    }
    if (toggle_button(name.c_str(), place != show.end())) {
      if (place == show.end()) {
        show.push_back(buffer);
        std::vector<BufferName> in_order;
        std::copy_if(buffers.begin(), buffers.end(), std::back_inserter(in_order), [&](BufferName other) {
          return std::find(show.begin(), show.end(), other) != show.end();
        });
        show = std::move(in_order);
      } else if (show.size() > 1) {
        show.erase(place);
      }
    }
    ui_map.mark_item("show:" + name);
  }
}

void measure_row(UiMap& ui_map, StudyForm& form) {
  row_name("Measure");
  bool on = !form.request.measures.empty();
  if (ImGui::Checkbox("##measure", &on))
    form.request.measures = on ? every_measure(false) : std::vector<std::string>();
  ui_map.mark_item("measure");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  faint_text("the lines against the reference lines");
}

/// Sizes from the parameter's own description.
void side_bar(const Document& document, UiMap& ui_map, const char* key, int& side, float width) {
  const Field& field = *find_param(document.settings(), key, "").field;
  const BarResult bar = value_bar(key, side, field, width);
  ui_map.mark_item(std::string("study:") + key);
  if (const auto value = bar.given_up ? bar.value : entered(bar))
    side = static_cast<int>(std::clamp(*value, field.limits.low, field.limits.high));
  help_for_item(field.help);
}

void size_row(const Document& document, UiMap& ui_map, StudyForm& form) {
  row_name("Size");
  const ImageParams& image = document.settings().image;
  side_bar(document, ui_map, "image.width", form.width_px, scaled(74));
  ImGui::SameLine(0, scaled(4));
  faint_text("×");
  ImGui::SameLine(0, scaled(4));
  side_bar(document, ui_map, "image.height", form.height_px, scaled(74));
  ImGui::SameLine(0, scaled(8));
  for (const auto& [label, share] : {std::pair{"1:2", 2}, {"1:1", 1}}) {
    const int width = std::max(1, image.width / share), height = std::max(1, image.height / share);
    if (toggle_button(
            label, form.width_px == width && form.height_px == height,
            fmt::format("{} × {} px, {} the window's.", width, height, share == 1 ? "as" : "half"))) {
      form.width_px = width;
      form.height_px = height;
    }
    ui_map.mark_item(std::string("size ") + label);
    ImGui::SameLine(0, 2);
  }
  ImGui::NewLine();
}

void text_row(UiMap& ui_map, const char* name, std::string& text, const std::string& hint) {
  row_name(name);
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint((std::string("##") + name).c_str(), hint.c_str(), &text);
  ui_map.mark_item(std::string("study ") + name);
}

void place_rows(UiMap& ui_map, StudyForm& form, const CheckedForm& shown) {
  text_row(ui_map, "Name", form.name, shown.draft.path.stem().string());
  std::string folder = form.folder.string();
  text_row(ui_map, "Folder", folder, "");
  form.folder = folder;
}

/// The window's own passes, for a pixel.
double pass_seconds_per_pixel(const Document& document, const PassTimer& timer) {
  const ImageParams& image = document.settings().image;
  return timer.mean_ms() * 1e-3 / (static_cast<double>(image.width) * image.height);
}

constexpr double kLongSeconds = 3600;

/// Of the disk that the folder is on, or will be; below 0 where that cannot be told.
double free_bytes(std::filesystem::path folder) {
  std::error_code error;
  while (!std::filesystem::exists(folder, error) && folder.has_relative_path()) folder = folder.parent_path();
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  return error ? -1.0 : static_cast<double>(space.available);
}

/// Why to ask before it runs; empty where there is no reason.
std::string too_large(const CheckedForm& checked, double seconds) {
  const double bytes = free_bytes(checked.out);
  if (bytes >= 0 && most_bytes(*checked.spec) > bytes)
    return "It may not fit on the disk: " + readable_bytes(bytes) + " are free.";
  return seconds > kLongSeconds ? "It takes about " + duration_text(seconds) + "." : "";
}

std::vector<std::string> keys_of(const StudyForm& form) {
  std::vector<std::string> keys;
  for (const SweepAxis& axis : form.request.axes) keys.push_back(axis.key);
  return keys;
}

bool accent_button(const char* label) {
  ImGui::PushStyleColor(ImGuiCol_Button, theme().accent);
  ImGui::PushStyleColor(ImGuiCol_Text, theme().on_accent);
  const bool pressed = ImGui::Button(label, {scaled(96), 0});
  ImGui::PopStyleColor(2);
  return pressed;
}

void save_button(Studies& studies, Problems& problems, UiMap& ui_map, const CheckedForm& checked) {
  const std::filesystem::path path = checked.draft.path;
  const bool saves = ImGui::Button("Save the spec");
  ui_map.mark_item("save spec");
  help_for_item(path_text(path));
  if (checked.spec && checked.is_saved) {
    ImGui::SameLine();
    faint_text("saved");
  }
  if (saves && attempt(problems, [&] { studies.save(); }))
    problems.tell(Severity::note, "saved " + path.string());
}

void empty_page(const Document& document, Studies& studies, Problems& problems) {
  bold("Nothing to run yet");
  ImGui::PushTextWrapPos(0);
  faint_text(
      "A study draws the scene with one to three parameters varied, as a grid. Start one here, or with the "
      "right "
      "mouse button on a parameter's name, or with S while the mouse is on it.");
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0, scaled(4)});
  if (ImGui::Button("New study")) attempt(problems, [&] { studies.new_form(document.settings()); });
}

/// `shown`: the names that are made from the axes, while `checked` has none.
void draw_fields(const Document& document, Studies& studies, Problems& problems, UiMap& ui_map,
                 StudyForm& form, const CheckedForm& checked, const CheckedForm& shown) {
  if (form.own_text) {
    bold(form.source.empty() ? "A spec of your own" : form.source.filename().string());
    ImGui::PushTextWrapPos(0);
    const bool told = checked.spec && !checked.spec->purpose.empty();
    if (told) ImGui::TextUnformatted(checked.spec->purpose.c_str());
    faint_text(form.source.empty() ? "Written by hand." : path_text(form.source));
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, scaled(6)});
  } else {
    draw_study_axes(document, studies, problems, ui_map, form, checked);
    ImGui::Dummy({0, scaled(4)});
    show_row(ui_map, form);
    measure_row(ui_map, form);
    size_row(document, ui_map, form);
    text_row(ui_map, "Title", form.request.title, shown.spec ? shown.spec->title : "");
  }
  place_rows(ui_map, form, shown);
}

}  // namespace

void StudyFormPanel::plan_lines(const CheckedForm& checked) {
  large_.clear();
  ImGui::PushTextWrapPos(0);
  if (checked.spec) {
    std::string text = plan_text(*checked.spec);
    const double seconds = studies_.estimated_seconds(pass_seconds_per_pixel(document_, timer_));
    large_ = too_large(checked, seconds);
    if (seconds >= 0) text += ", about " + duration_text(seconds);
    coloured_text(large_.empty() ? theme().text : theme().warning, text);
  } else {
    coloured_text(theme().error, checked.problem);
  }
  if (!checked.note.empty()) faint_text(checked.note);
  ImGui::PopTextWrapPos();
}

/// A large study is asked about; a change of it takes the question back.
void StudyFormPanel::run_buttons(const CheckedForm& checked) {
  const bool can_run = checked.spec.has_value();
  const bool asks = can_run && !large_.empty() && asked_about_ == checked.draft.text;
  if (!asks) asked_about_.clear();
  if (asks) wrapped_text(large_ + " Run it all the same?", theme().warning);
  ImGui::BeginDisabled(!can_run);
  const bool pressed = accent_button("Run");
  ui_map_.mark_item("run study");
  help_for_item(studies_.is_busy() ? "After those that run already."
                                   : "In the background; the window stays usable.");
  ImGui::SameLine();
  if (asks) {
    if (ImGui::Button("Do not run")) asked_about_.clear();
    ui_map_.mark_item("do not run");
    ImGui::SameLine();
  }
  save_button(studies_, problems_, ui_map_, checked);
  ImGui::EndDisabled();
  const bool answers = ImGui::GetIO().MouseClickedLastCount[0] < 2;  // a double click is one press
  if (!pressed || (asks && !answers)) return;
  const bool asks_now = !large_.empty() && !asks;
  asked_about_ = asks_now ? checked.draft.text : "";
  if (!asks_now) attempt(problems_, [&] { studies_.run(); });
}

void StudyFormPanel::remember(const StudyForm& form, const CheckedForm& checked) {
  const StudyDraft& known = last_good_.checked.draft;
  const bool is_new = known.text != checked.draft.text || known.path != checked.draft.path;
  if (checked.spec && is_new) last_good_ = {keys_of(form), checked};
}

const CheckedForm& StudyFormPanel::shown(const StudyForm& form, const CheckedForm& checked) const {
  const bool is_blank = !checked.spec && !form.own_text && !form.request.axes.empty();
  return is_blank && last_good_.keys == keys_of(form) ? last_good_.checked : checked;
}

/// Fields scroll where they do not fit; what runs them stays in sight.
void StudyFormPanel::draw_form(const CheckedForm& checked) {
  const float foot = ImGui::GetContentRegionAvail().y - foot_height_;
  ImGui::BeginChild("fields", {0, std::max(std::min(fields_height_, foot), scaled(40))}, false,
                    ImGuiWindowFlags_NoBackground);
  StudyForm& form = *studies_.form();
  draw_fields(document_, studies_, problems_, ui_map_, form, checked, shown(form, checked));
  const float fields = ImGui::GetCursorPosY();
  ImGui::EndChild();
  const float top = ImGui::GetCursorPosY();
  plan_lines(checked);
  ImGui::Dummy({0, scaled(4)});
  run_buttons(checked);
  const float height = ImGui::GetCursorPosY() - top + scaled(4);
  if (fields != fields_height_ || height != foot_height_) requests_.wake_in(0);
  fields_height_ = fields;
  foot_height_ = height;
}

/// Typing in the text makes it a spec written by hand.
void StudyFormPanel::draw_spec(const CheckedForm& checked) {
  StudyForm& form = *studies_.form();
  ImGui::AlignTextToFramePadding();
  bold("Spec");
  const float width = ImGui::CalcTextSize("Copy").x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  std::string text = form.own_text ? *form.own_text : shown(form, checked).draft.text;
  if (ImGui::Button("Copy")) ImGui::SetClipboardText(text.c_str());
  ui_map_.mark_item("copy spec");
  ImGui::PushFont(fonts().fixed);
  const float foot = ImGui::GetTextLineHeight() + scaled(10);
  if (ImGui::InputTextMultiline("##spec", &text, {-1, ImGui::GetContentRegionAvail().y - foot}))
    form.own_text = text;
  ui_map_.mark_item("spec text");
  ImGui::PopFont();
  if (!form.own_text) {
    fitted_text("Typing here replaces the form.", ImGui::GetContentRegionAvail().x, theme().faint);
  } else if (!form.request.axes.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme().accent);
    const bool back =
        ImGui::Selectable("Back to the form", false, 0, {ImGui::CalcTextSize("Back to the form").x, 0});
    ImGui::PopStyleColor();
    ui_map_.mark_item("back to the form");
    if (back) form.own_text.reset();
  } else {
    fitted_text("Changes are saved under the name.", ImGui::GetContentRegionAvail().x, theme().faint);
  }
}

void StudyFormPanel::draw() {
  if (studies_.form() == nullptr) return empty_page(document_, studies_, problems_);
  const CheckedForm& checked =
      studies_.checked(document_.settings(), document_.scene(), !document_.is_editing());
  remember(*studies_.form(), checked);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float gap = scaled(20);
  const float left = std::clamp(std::floor(room.x * 0.55F), scaled(330), scaled(520));
  const bool beside = room.x - left - gap > scaled(200);
  ImGui::BeginChild(
      "form", {beside ? left : 0, 0}, false,
      ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  draw_form(checked);
  ImGui::EndChild();
  if (!beside || studies_.form() == nullptr || !studies_.shows_form()) return;
  ImGui::SameLine(0, gap);
  ImGui::BeginChild("spec", {0, 0}, false, ImGuiWindowFlags_NoBackground);
  draw_spec(checked);
  ImGui::EndChild();
}

}  // namespace inkbench
