// SPDX-License-Identifier: MIT
#include "app/panels/parameters/ramp_editor.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstdlib>

#include "app/panels/widgets/colour_picker.h"
#include "app/panels/widgets/letter_key.h"
#include "app/panels/widgets/value_bar.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "app/workbench/ramp_edit.h"
#include "app/workbench/ramp_file.h"
#include "pipeline/base/error.h"
#include "pipeline/settings/ramp.h"

namespace inkbench {
namespace {

/// Place and number of stops are parts of a ramp's value, which no parameter's description knows.
const Field& position_field() {
  static const Field kField = [] {
    Field field;
    field.type = FieldType::real;
    field.limits = field.slider = {0, 1};
    return field;
  }();
  return kField;
}

const Field& bands_field() {
  static const Field kField = [] {
    Field field;
    field.type = FieldType::integer;
    field.limits = {1, kMaxBands};
    field.slider = {1, 16};
    return field;
  }();
  return kField;
}

bool is_stepped(const Ramp& ramp, bool stepped) {
  return std::all_of(ramp.stops.begin(), ramp.stops.end(),
                     [&](const RampStop& stop) { return stop.stepped == stepped; });
}

/// Two buttons of which one is on; returns the one that was pressed.
std::optional<bool> step_or_smooth(UiMap& ui_map, const std::string& name, bool step_on, bool smooth_on,
                                   std::string_view help) {
  std::optional<bool> pressed;
  if (toggle_button("Step", step_on, help)) pressed = true;
  ui_map.mark_item("step:" + name);
  ImGui::SameLine(0, 2);
  if (toggle_button("Smooth", smooth_on, help)) pressed = false;
  ui_map.mark_item("smooth:" + name);
  return pressed;
}

/// Goes on in the same line, so far from the window's left.
void next_to(float place) {
  ImGui::SameLine();
  ImGui::SetCursorPosX(place);
}

}  // namespace

void RampEditor::file_buttons(const std::string& key, const Ramp& ramp) {
  if (ImGui::Button("Load"))
    question_.ask({"Load a ramp", "Stops (.toml) or an image, whose first row is the ramp.", "Load"},
                  [this, key](const std::string& path) { document_.change(key, load_ramp(path)); });
  ui_map_.mark_item("load:" + key);
  ImGui::SameLine();
  if (ImGui::Button("Save"))
    question_.ask({"Save the ramp", "As stops (.toml) or as an image (.png, .exr).", "Save", true},
                  [this, ramp](const std::string& path) {
                    save_ramp(path, ramp);
                    problems_.tell(Severity::note, "saved " + path);
                  });
  ui_map_.mark_item("save:" + key);
}

void RampEditor::title_row(const std::string& key, const Field& field, const Ramp& ramp, float width) {
  Editor& editor = editors_[key];
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted(field.name.data(), field.name.data() + field.name.size());
  ImGui::PopFont();
  help_for_item(field.help);
  const float files = ImGui::CalcTextSize("LoadSave").x + 4 * ImGui::GetStyle().FramePadding.x +
                      ImGui::GetStyle().ItemSpacing.x;
  if (ramp.image.empty()) {
    const float bands = scaled(64);
    const float label = ImGui::CalcTextSize("Even bands").x + scaled(6);
    const float modes = ImGui::CalcTextSize("StepSmooth").x + 4 * ImGui::GetStyle().FramePadding.x + 2;
    const float gap = scaled(16);
    next_to(left + width - files - bands - label - modes - 2 * gap);
    const bool several = ramp.stops.size() > 1;
    if (const auto stepped =
            step_or_smooth(ui_map_, "all:" + key, several && is_stepped(ramp, true),
                           several && is_stepped(ramp, false), "All stops: hold the colour, or blend."))
      document_.change(key, set_all_stepped(ramp, *stepped));
    next_to(left + width - files - bands - label - gap);
    faint_text("Even bands");
    ImGui::SameLine(0, scaled(6));
    const BarResult bar = value_bar("bands", static_cast<double>(ramp.stops.size()), bands_field(), bands);
    ui_map_.mark_item("bands:" + key);
    help_for_item("Steps of equal width between the ramp's ends. Drag, or Ctrl+click to type.");
    if (bar.pressed) {
      document_.begin_edit();
      editor.before_bands = ramp;
    }
    if (const auto count = entered(bar))
      document_.change(key, even_bands(editor.before_bands.value_or(ramp),
                                       static_cast<int>(std::clamp(*count, 1.0, 64.0))));
    if (bar.released) {
      document_.end_edit();
      editor.before_bands.reset();
    }
  }
  next_to(left + width - files);
  file_buttons(key, ramp);
}

void RampEditor::stop_colour(const std::string& key, const Ramp& ramp, bool opens) {
  const size_t index = std::min(editors_[key].strip.selected, ramp.stops.size() - 1);
  const glm::vec3 colour = ramp.stops[index].colour;
  const bool pressed = colour_swatch(colour, scaled(56));
  ui_map_.mark_item("stop colour:" + key);
  help_for_item("The stop's colour.");
  colour_picker(document_, ui_map_, "stop picker:" + key, colour, pressed || opens,
                [&](const glm::vec3& next) { document_.change(key, set_stop_colour(ramp, index, next)); });
}

void RampEditor::stop_row(const std::string& key, const Ramp& ramp) {
  Editor& editor = editors_[key];
  const size_t index = std::min(editor.strip.selected, ramp.stops.size() - 1);
  const RampStop& stop = ramp.stops[index];
  ImGui::AlignTextToFramePadding();
  faint_text(fmt::format("Stop {} of {}", index + 1, ramp.stops.size()));
  ImGui::SameLine(0, scaled(10));
  const BarResult bar = value_bar("position", stop.position, position_field(), scaled(110));
  ui_map_.mark_item("position:" + key);
  help_for_item("Where the stop is. Drag, or Ctrl+click to type.");
  if (bar.pressed) document_.begin_edit();
  if (const auto position = entered(bar)) {
    const TouchedRamp touched = move_stop(ramp, index, static_cast<float>(*position));
    editor.strip.selected = touched.index;
    document_.change(key, touched.ramp);
  }
  if (bar.released) document_.end_edit();
  ImGui::SameLine();
  if (const auto stepped = step_or_smooth(ui_map_, key, stop.stepped, !stop.stepped,
                                          "Up to the next stop: hold this colour, or blend."))
    document_.change(key, set_stop_stepped(ramp, index, *stepped));
  if (ramp.stops.size() < 2) return;
  ImGui::SameLine();
  const bool deletes = last_ == key && keys_are_free(layout_) && ImGui::IsKeyPressed(GLFW_KEY_DELETE, false);
  if (ImGui::Button("Remove") || deletes) {
    document_.change(key, remove_stop(ramp, index));
    editor.strip.selected = index > 0 ? index - 1 : 0;
  }
  ui_map_.mark_item("remove:" + key);
  help_for_item("Remove the stop (Delete, or drag it away).");
}

void RampEditor::draw_ramp(const std::string& key, const Field& field, const Ramp& ramp, float width) {
  Editor& editor = editors_[key];
  Colours& colours = editor.colours;
  if (colours.ramp != ramp || colours.files_revision != disk_.revision()) {
    colours = {ramp, disk_.revision(), {}, ""};
    try {
      colours.table = ramp_table(ramp);
    } catch (const Error& error) {
      colours.problem = error.what();
    }
  }
  title_row(key, field, ramp, width);
  const StripResult strip =
      ramp_strip_editor("ramp:" + key, ramp, colours.table, width, editor.strip, ui_map_);
  if (strip.pressed) {
    document_.begin_edit();
    last_ = key;
  }
  if (strip.changed && *strip.changed != ramp) document_.change(key, *strip.changed);
  if (strip.released) document_.end_edit();
  if (!ramp.image.empty()) {
    if (ImGui::Button("Turn into stops") && colours.problem.empty()) document_.change(key, with_stops(ramp));
    ui_map_.mark_item("to stops:" + key);
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    fitted_text(colours.problem.empty() ? ramp.image : colours.problem, ImGui::GetContentRegionAvail().x,
                colours.problem.empty() ? theme().faint : theme().error);
  } else if (!ramp.stops.empty()) {
    const Ramp& now = strip.changed ? *strip.changed : ramp;
    stop_colour(key, now, strip.double_clicked);
    ImGui::SameLine();
    stop_row(key, now);
  }
}

void RampEditor::draw() {
  const Settings settings = document_.settings();  // a copy: what is dragged changes the document's
  std::vector<ConstParam> ramps;
  for (const ConstParam& param : list_params(settings)) {
    if (param.field->type == FieldType::ramp) ramps.push_back(param);
  }
  const float gap = scaled(28);
  const float room = ImGui::GetContentRegionAvail().x;
  const bool beside = room > scaled(860) && ramps.size() == 2;
  const float width = beside ? std::floor((room - gap) / 2) : room;
  for (size_t i = 0; i < ramps.size(); ++i) {
    if (beside && i > 0) ImGui::SameLine(0, gap);
    ImGui::BeginGroup();
    ImGui::PushID(ramps[i].key.c_str());
    draw_ramp(ramps[i].key, *ramps[i].field, std::get<Ramp>(ramps[i].value()), width);
    ImGui::PopID();
    ImGui::EndGroup();
  }
  fitted_text("Click the strip to add a stop, drag to move, Delete removes.", room, theme().faint);
  question_.draw();
}

}  // namespace inkbench
