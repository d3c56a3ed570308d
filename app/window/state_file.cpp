// SPDX-License-Identifier: MIT
#include "app/window/state_file.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace inkbench {
namespace {

using Json = nlohmann::ordered_json;

Json parameters_of(const Settings& settings) {
  Json json = Json::object();
  for (const ConstParam& param : list_params(settings)) json[param.key] = to_text(param.value());
  return json;
}

const char* tool_name(MouseTool tool) {
  constexpr std::array kTools{"view", "camera", "mark"};
  return kTools[static_cast<size_t>(tool)];
}

/// Pixels of the present camera's marks.
Json painted_of(const Document& document) {
  const Settings& settings = document.settings();
  const MarkMaps maps =
      maps_for(document.marks(), settings.camera, settings.image.width, settings.image.height);
  return {{"wanted", maps.wanted.count()},
          {"unwanted", maps.unwanted.count()},
          {"drawn", maps.drawn.count()},
          {"cameras", document.marks().size()}};
}

Json view_of(const ViewState& view) {
  Json json{{"zoom", view.zoom},
            {"centre", {view.centre_x, view.centre_y}},
            {"magnification", view.magnification},
            {"selected", name_of(view.selected)},
            {"filled", view.filled ? std::string(name_of(*view.filled)) : ""},
            {"marked", view.marked ? Json{view.marked->x, view.marked->y} : Json(nullptr)},
            {"curve", view.curve_words},
            {"wireframe", view.wireframe},
            {"tool", tool_name(view.tool)},
            {"brush_px", view.brush_px}};
  json["comparison"] = {{"active", view.comparison.active},
                        {"flips", view.comparison.flips},
                        {"shows_b", view.comparison.shows_b},
                        {"split", view.comparison.split},
                        {"a", {name_of(view.comparison.a.buffer), view.comparison.a.pinned}},
                        {"b", {name_of(view.comparison.b.buffer), view.comparison.b.pinned}}};
  return json;
}

Json judgement_of(const Judgement* judgement) {
  if (judgement == nullptr || !judgement->error.empty()) return nullptr;
  std::vector<const Measure*> shown;
  for (const Measure& measure : measure_table()) {
    if (is_judged(measure, judgement->tally)) shown.push_back(&measure);
  }
  return Json::parse(measures_json(shown, judgement->tally));
}

Json judge_of(const JudgeDesk& judge) {
  return {{"behind", judge.is_behind()},
          {"now", judgement_of(judge.now())},
          {"pinned", judgement_of(judge.pinned())}};
}

/// The sum behind the marked pixel.
Json why_of(const Workbench& bench) {
  if (!bench.view.marked) return nullptr;
  const Explanation& why = bench.viewer.explained();
  Json json{{"pixel", {why.x, why.y}}, {"sum", why.sum},      {"inked", why.is_line},
            {"drawn", why.drawn},      {"text", why.verdict}, {"pinned", asks_pinned(bench.view)}};
  for (const ExplainedTerm& term : why.terms) {
    json[term.name]["p"] = term.value;
    for (const ExplainedInput& input : term.inputs) json[term.name][input.name] = input.value;
  }
  return json;
}

/// Pixels of each cause; null where they are not asked for or not found yet.
Json causes_of(const CauseDesk& causes) {
  if (causes.now() == nullptr) return nullptr;
  Json json = Json::object();
  for (const CauseInfo& info : cause_table()) json[std::string(info.key)] = causes.counts().of(info.cause);
  return json;
}

Json passes_of(const Workbench& bench) {
  Json json = Json::object();
  for (const auto& [name, count] : bench.viewer.pictures.pipeline().counts()) {
    const PassTime time = bench.viewer.timer.time_of(name);
    json[name] = {{"runs", count.runs}, {"reuses", count.reuses}, {"ran", time.ran}, {"ms", time.last_ms}};
  }
  return json;
}

/// The keys of the pictures; nothing for the pinned ones where no state is pinned.
Json pictures_of(const Workbench& bench, bool pinned) {
  Json json = Json::object();
  for (const BufferName buffer : all_buffers()) {
    const ShownPicture& shown = bench.viewer.pictures.shown(buffer, pinned);
    if (!pinned || shown.texture != nullptr) json[std::string(name_of(buffer))] = shown.key.text();
  }
  return json;
}

Json layout_of(const WindowLayout& layout) {
  Json json = Json::object();
  for (const Field& field : WindowLayout::description().fields)
    json[std::string(field.name)] = to_text(field.get(&layout));
  return json;
}

Json log_of(const MessageLog& log) {
  Json json = Json::array();
  for (const Message& message : log.messages()) json.push_back(message.text);
  return json;
}

Json errors_of(const MessageLog& log) {
  Json json = Json::array();
  for (const Message& message : log.messages()) {
    if (message.severity == Severity::error) json.push_back(message.text);
  }
  return json;
}

/// Whether one is seen, beyond the frame in which ImGui measures it.
bool shows_tooltip() {
  const auto& windows = ImGui::GetCurrentContext()->Windows;
  return std::any_of(windows.begin(), windows.end(), [](const ImGuiWindow* window) {
    return (window->Flags & ImGuiWindowFlags_Tooltip) != 0 && window->Active && !window->Hidden;
  });
}

Json form_of(const Studies& studies) {
  const StudyForm* form = studies.form();
  if (form == nullptr) return nullptr;
  const CheckedForm& checked = studies.last_checked();
  Json axes = Json::array();
  for (const SweepAxis& axis : form->request.axes)
    axes.push_back({{"key", axis.key},
                    {"from", axis.from},
                    {"to", axis.to},
                    {"count", axis.count},
                    {"values", axis.values.size()}});
  return {{"shown", studies.shows_form()},
          {"axes", axes},
          {"size", {form->width_px, form->height_px}},
          {"spec", checked.draft.path.string()},
          {"saved", checked.is_saved},
          {"cells", checked.spec ? cell_count(*checked.spec) : 0},
          {"problem", checked.problem}};
}

/// By the names of their folders, newest first.
Json study_list_of(const Studies& studies) {
  constexpr std::array kNames{"waiting", "running", "stopping", "finished", "stopped", "failed"};
  Json json = Json::array();
  for (const ListedStudy& study : studies.list()) {
    Json entry{{"name", study.study.folder.filename().string()},
               {"state", kNames.at(static_cast<size_t>(study.state))},
               {"done", study.done},
               {"total", study.total}};
    if (study.job != nullptr) entry["drawn"] = study.job->drawn;
    if (study.job != nullptr) entry["problem"] = study.job->problem;
    json.push_back(std::move(entry));
  }
  return json;
}

Json studies_of(const Studies& studies) {
  Json json{{"page_open", studies.page_open}, {"form", form_of(studies)}, {"list", study_list_of(studies)}};
  json["shown"] = studies.shown() ? Json(studies.shown()->folder.filename().string()) : Json(nullptr);
  json["cells"] = studies.results() ? Json(studies.results()->done()) : Json(nullptr);
  return json;
}

Json fit_result_of(const FitDesk& fit) {
  const FitResult* found = fit.result();
  if (found == nullptr) return nullptr;
  Json json{{"before", found->before ? Json(*found->before) : Json()},
            {"after", found->after ? Json(*found->after) : Json()},
            {"stopped", found->stopped},
            {"marks", found->marks},
            {"is_set", fit.is_set()}};
  for (const FittedParameter& fitted : found->parameters) {
    json["values"][fitted.key] = fitted.value;
    if (const ValueHeat* heat = fit.heat(fitted.key)) json["heat"][fitted.key] = heat->points.size();
  }
  return json;
}

Json fit_of(const FitDesk& fit, const Settings& settings) {
  constexpr std::array kNames{"running", "stopping", "finished", "stopped", "failed"};
  Json json{{"ticked", fit.ticked(settings)}, {"result", fit_result_of(fit)}};
  if (fit.run() == nullptr) return json;
  json["state"] = kNames.at(static_cast<size_t>(fit.run()->state()));
  json["done"] = fit.run()->progress().done;
  json["best"] = fit.run()->progress().best.value_or(0);
  json["points"] = fit.run()->trace().size();
  json["cameras"] = fit.request().cameras.size();
  json["problem"] = fit.run()->problem();
  return json;
}

}  // namespace

std::string state_text(const Workbench& bench) {
  Json json{{"scene", bench.document.scene_name()},
            {"steps", bench.document.history().step_names()},
            {"marks", bench.ui_map.pauses},
            {"text_field", ImGui::GetIO().WantTextInput},
            {"position", bench.document.history().position()},
            {"frames", bench.viewer.frame_times.frames},
            {"frame_ms", bench.viewer.frame_times.mean_ms},
            {"parameters", parameters_of(bench.document.settings())},
            {"view", view_of(bench.view)},
            {"painted", painted_of(bench.document)},
            {"passes", passes_of(bench)},
            {"pictures", pictures_of(bench, false)},
            {"pinned", pictures_of(bench, true)},
            {"layout", layout_of(bench.layout)},
            {"finds_lines", bench.viewer.pictures.reference().is_busy()},
            {"prepares_levels", bench.viewer.ladders.is_busy()},
            {"judge", judge_of(bench.viewer.judge)},
            {"causes", causes_of(bench.viewer.judge.causes)},
            {"why", why_of(bench)},
            {"studies", studies_of(bench.studies)},
            {"fit", fit_of(bench.fit, bench.document.settings())},
            {"tooltip", shows_tooltip()},
            {"log", log_of(bench.log)},
            {"errors", errors_of(bench.log)}};
  json["bookmarks"] = Json::array();
  for (const CameraBookmark& bookmark : bench.keeping.bookmarks())
    json["bookmarks"].push_back({bookmark.name, bookmark.key});
  json["recent"] = Json::array();
  for (const std::filesystem::path& file : bench.keeping.recent()) json["recent"].push_back(file.string());
  json["unsaved"] = bench.keeping.unsaved().size();
  json["problems"] = Json::array();
  for (const auto& [kind, text] : bench.problems.all()) json["problems"].push_back(text);
  json["ui"] = Json::object();
  for (const auto& [name, rect] : bench.ui_map.rects())
    json["ui"][name] = {rect.left, rect.top, rect.right, rect.bottom};
  // Log lines may quote broken files: what is not UTF-8 is replaced instead of refused.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace inkbench
