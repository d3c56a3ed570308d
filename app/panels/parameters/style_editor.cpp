// SPDX-License-Identifier: MIT
#include "app/panels/parameters/style_editor.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/settings/settings_file.h"
#include "pipeline/settings/style_file.h"

namespace inkbench {
namespace {

ConstParam profile_param(const Settings& settings) {
  const std::vector<ConstParam> params = list_params(settings);
  return *std::find_if(params.begin(), params.end(),
                       [](const ConstParam& param) { return param.field->is_profile; });
}

/// The window's folder: what a person types is whole, so that it hardly matters.
fs::path here() {
  return fs::current_path();
}

void title(const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
}

}  // namespace

void StyleEditor::list() {
  attempt(problems_, [&] {
    for (const std::string& name : style_names()) {
      const fs::path file = find_style(name, here(), "styles");
      styles_.push_back({name, style_title(file), read_style(file)});
    }
  });
}

void StyleEditor::find_which_is_on() {
  if (compared_revision_ == document_.revision()) return;
  compared_revision_ = document_.revision();
  for (ListedStyle& style : styles_) {
    Settings with = document_.settings();
    apply_table(with, style.parameters, style.name, here());
    style.is_on = same_settings(with, document_.settings());
  }
}

void StyleEditor::take(const std::string& style, const std::string& step) {
  attempt(problems_, [&] {
    Settings next = document_.settings();
    apply_style(next, style, here(), "style");
    document_.replace(next, step);
  });
}

void StyleEditor::draw_styles(float width) {
  const float gap = scaled(4);
  float left = width;  // of this row
  for (const ListedStyle& style : styles_) {
    std::string label = style.name;
    std::replace(label.begin(), label.end(), '_', ' ');
    left -= button_width(label.c_str()) + gap;
    if (left >= -gap && &style != &styles_.front())
      ImGui::SameLine(0, gap);
    else
      left = width - button_width(label.c_str()) - gap;
    if (toggle_button(label.c_str(), style.is_on, style.title + ".")) take(style.name, "style " + style.name);
    ui_map_.mark_item("style:" + style.name);
  }
}

void StyleEditor::draw_files() {
  if (ImGui::Button("Load"))
    question_.ask({"Load a stroke style", "A style's file (.toml).", "Load"},
                  [this](const std::string& path) {
                    Settings next = document_.settings();
                    apply_style(next, path, here(), "style");
                    document_.replace(next, "style " + fs::path(path).stem().string());
                  });
  ui_map_.mark_item("style:load");
  ImGui::SameLine();
  if (ImGui::Button("Save"))
    question_.ask({"Save the stroke style", "As a file (.toml) that --style takes.", "Save", true},
                  [this](const std::string& path) {
                    write_file_atomically(path,
                                          style_text(fs::path(path).stem().string(), document_.settings()));
                    problems_.tell(Severity::note, "saved " + path);
                  });
  ui_map_.mark_item("style:save");
  help_for_item("Curves, stroke and ink as they are now.");
}

void StyleEditor::draw_profile(float width, float height) {
  const ConstParam param = profile_param(document_.settings());
  const auto text = std::get<std::string>(param.value());
  WidthProfile profile;
  std::string problem;
  try {
    profile = parse_profile(text, param.key);
  } catch (const Error& error) {
    problem = error.what();
  }
  const float right = ImGui::GetCursorPosX() + width;
  title("Width along the stroke");
  help_for_item(param.field->help);
  ImGui::SameLine();
  ImGui::BeginDisabled(text.empty());
  if (ImGui::Button("Reset")) document_.change(param.key, std::string());
  ui_map_.mark_item("profile:reset");
  ImGui::EndDisabled();
  ImGui::SameLine();
  fitted_text(problem.empty() ? "Draw it; drag points, double click removes." : problem,
              std::max(right - ImGui::GetCursorPosX(), scaled(40)),
              problem.empty() ? theme().faint : theme().error);
  const float canvas_height = std::max(height - ImGui::GetFrameHeightWithSpacing(), scaled(30));
  const CanvasResult canvas =
      profile_canvas("profile:" + param.key, profile, {width, canvas_height}, canvas_, ui_map_);
  if (canvas.pressed) document_.begin_edit();
  if (canvas.changed && profile_text(*canvas.changed) != text)
    document_.change(param.key, profile_text(*canvas.changed));
  if (canvas.released) document_.end_edit();
}

void StyleEditor::draw() {
  if (styles_.empty()) list();
  find_which_is_on();
  const float gap = scaled(16);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float list_width = std::min(scaled(280), room.x * 0.36F);
  const bool has_sample = room.x > scaled(640);
  const float each = std::floor((room.x - list_width - 2 * gap) * (has_sample ? 0.58F : 1.0F));
  const float left = ImGui::GetCursorPosX();
  ImGui::BeginGroup();
  title("Styles");
  ImGui::SameLine(left + list_width - button_width("Load") - button_width("Save") -
                  ImGui::GetStyle().ItemSpacing.x);
  draw_files();
  draw_styles(list_width);
  ImGui::EndGroup();
  ImGui::SameLine(left + list_width + gap);
  ImGui::BeginGroup();
  draw_profile(each, room.y);
  ImGui::EndGroup();
  if (has_sample) {
    ImGui::SameLine(0, gap);
    sample_.draw(document_, {ImGui::GetContentRegionAvail().x, room.y - scaled(2)});
  }
  question_.draw();
}

}  // namespace inkbench
