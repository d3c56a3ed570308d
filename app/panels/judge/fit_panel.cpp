// SPDX-License-Identifier: MIT
#include "app/panels/judge/fit_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/value_bar.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

constexpr double kFollowFitSeconds = 0.1;
constexpr float kTraceHeight = 44;

/// "k_depth, k_normal".
std::string short_names(const std::vector<std::string>& keys) {
  std::vector<std::string> names;
  for (const std::string& key : keys) names.push_back(key.substr(key.rfind('.') + 1));
  return join(names, ", ");
}

/// "F 0.508 → 0.938", with as many digits as it takes to see a change; "marks" where it looks at those.
std::string change_of(const FitRequest& request, const std::optional<double>& before,
                      const std::optional<double>& after) {
  const char* name = request.marks.empty() ? "F" : "marks";
  if (!before || !after) return after ? fmt::format("{} {:.3f}", name, *after) : std::string(name) + " –";
  const int digits = std::abs(*after - *before) < 0.001 ? 4 : 3;
  return fmt::format("{} {:.{}f} → {:.{}f}", name, *before, digits, *after, digits);
}

/// "combine.k_depth 0.003 → 0.001931"; faint where it stays as it is.
void draw_fitted(const FitRequest& request, const FittedParameter& fitted, float width) {
  const std::string before = to_text(find_param(request.settings, fitted.key, fitted.key).value());
  const bool stays = before == fitted.value;
  fitted_text(fitted.key + " " + before + (stays ? " stays" : " → " + fitted.value), width,
              stays ? theme().faint : theme().text);
}

/// Too few candidates leave none to look around with.
bool knows_ranges(const FitResult& found) {
  return std::any_of(found.parameters.begin(), found.parameters.end(),
                     [](const FittedParameter& fitted) { return fitted.heat.has_value(); });
}

/// "91 / 200, F 0.508 → 0.937".
std::string progress_of(const FitRequest& request, const FitRun& run) {
  if (run.progress().done == 0) return "starts…";
  const auto count = [](size_t number) { return with_commas(static_cast<long long>(number)); };
  std::string text = count(run.progress().done) + " / " + count(run.progress().total);
  if (!run.trace().empty())
    text += ", " + change_of(request, run.trace().front().best, run.trace().back().best);
  return text;
}

/// The best objective over the candidates, from the first one's at the bottom to the best at the top.
void draw_trace(const FitRun& run) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = scaled(kTraceHeight);
  const float pad = scaled(4);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, {low.x + width, low.y + height}, theme().field, ImGui::GetStyle().FrameRounding);
  ImGui::Dummy({width, height});
  const std::vector<FitRun::TracePoint>& trace = run.trace();
  if (trace.empty()) return;
  const double from = trace.front().best, range = std::max(trace.back().best - from, 1e-9);
  const double total = static_cast<double>(std::max<size_t>(run.progress().total, 1));
  const auto place = [&](double done, double best) {
    return ImVec2{low.x + pad + static_cast<float>(done / total) * (width - 2 * pad),
                  low.y + height - pad - static_cast<float>((best - from) / range) * (height - 2 * pad)};
  };
  ImVec2 last = place(static_cast<double>(trace.front().done), from);
  for (const FitRun::TracePoint& point : trace) {
    const ImVec2 next = place(static_cast<double>(point.done), point.best);
    list.AddLine(last, {next.x, last.y}, theme().accent, scaled(1.5F));
    list.AddLine({next.x, last.y}, next, theme().accent, scaled(1.5F));
    last = next;
  }
  list.AddCircleFilled(last, scaled(2.5F), theme().accent);
}

}  // namespace

void follow_fit(FitDesk& fit, const Document& document, Problems& problems, WindowRequests& requests) {
  const bool ran = fit.is_running();
  fit.follow(document);
  if (fit.is_running()) requests.wake_in(kFollowFitSeconds);
  if (!ran || fit.is_running()) return;
  const FitResult* found = fit.result();
  if (found != nullptr) {
    problems.tell(Severity::note,
                  fmt::format("fit: {}, {} candidates", change_of(fit.request(), found->before, found->after),
                              found->candidates));
  } else if (fit.run()->state() == FitState::failed) {
    problems.tell(Severity::error, "fit: " + fit.run()->problem());
  }
}

void FitPanel::draw_choices() {
  const Settings& settings = document_.settings();
  for (const std::string& key : fit_.offered(settings)) {
    bool on = fit_.is_ticked(settings, key);
    if (ImGui::Checkbox(key.c_str(), &on)) fit_.tick(key, on);
    ui_map_.mark_item("fit tick:" + key);
    help_for_item(find_param(settings, key, key).field->help);
  }
  const size_t kept = keeping_.bookmarks().size();
  if (kept > 0) {
    const std::string label = "from " + counted(kept, "kept camera", "kept cameras");
    ImGui::Checkbox(label.c_str(), &fit_.options.uses_kept_cameras);
    ui_map_.mark_item("fit:kept cameras");
    help_for_item("Judged together from all cameras in the Views tab; else from the present one.");
  }
  draw_mark_choices();
  const Field& field = FitOptions::description().fields.front();
  ImGui::AlignTextToFramePadding();
  faint_text("candidates");
  ImGui::SameLine(scaled(78));
  const BarResult bar =
      value_bar("budget", fit_.options.budget, field, std::max(ImGui::GetContentRegionAvail().x, scaled(40)));
  ui_map_.mark_item("bar:fit.budget");
  help_for_item(field.help);
  if (const std::optional<double> wanted = entered(bar))
    fit_.options.budget = static_cast<int>(std::clamp(*wanted, field.limits.low, field.limits.high));
  wrapped_text("Right click a parameter's name to let a fit move it, too.", theme().faint);
}

/// Where something is painted.
void FitPanel::draw_mark_choices() {
  FitOptions all = fit_.options;
  all.uses_marks = true;
  if (fit_marks(document_.settings(), document_.marks(), all).empty()) return;
  ImGui::Checkbox("by the marks", &fit_.options.uses_marks);
  ui_map_.mark_item("fit:marks");
  help_for_item("What is painted as wanted is to be drawn, what is painted as unwanted is to go.");
  if (!fit_.options.uses_marks) return;
  ImGui::Checkbox("and a little by the reference lines", &fit_.options.uses_reference);
  ui_map_.mark_item("fit:reference");
  help_for_item("F counts a twentieth as much; without it no reference lines are found.");
}

void FitPanel::draw_start() {
  const Settings& settings = document_.settings();
  const std::vector<std::string> keys = fit_.ticked(settings);
  if (ImGui::Button("Fit"))
    attempt(problems_, [&] { fit_.start(settings, keeping_.bookmarks(), document_.marks()); });
  ui_map_.mark_item("fit");
  help_for_item(
      "Search for the values whose lines are the best against the reference lines, by F, or by the marks. "
      "Nothing "
      "changes before you take them over.");
  ImGui::SameLine();
  if (toggle_button("…", shows_choices_, "What may move, from which cameras, how long."))
    shows_choices_ = !shows_choices_;
  ui_map_.mark_item("fit:choices");
  ImGui::SameLine();
  const size_t kept = fit_.options.uses_kept_cameras ? keeping_.bookmarks().size() : 0;
  std::string text = keys.empty() ? "nothing is ticked" : short_names(keys);
  if (kept > 0) text += ", from " + counted(kept, "camera", "cameras");
  if (!fit_marks(settings, document_.marks(), fit_.options).empty()) text += ", by marks";
  ImGui::AlignTextToFramePadding();
  fitted_text(text, ImGui::GetContentRegionAvail().x, theme().faint);
  if (shows_choices_) draw_choices();
}

/// The button is not where `Fit` was: a second click would end what the first one began.
void FitPanel::draw_running() {
  const FitRun& run = *fit_.run();
  const bool stops = run.state() == FitState::stopping;
  const char* label = stops ? "End it" : "Cancel";
  const float room = ImGui::GetContentRegionAvail().x - button_width(label);
  ImGui::AlignTextToFramePadding();
  fitted_text(progress_of(fit_.request(), run), room - ImGui::GetStyle().ItemSpacing.x, theme().text);
  ImGui::SameLine(room + ImGui::GetCursorStartPos().x);
  if (ImGui::Button(label)) fit_.cancel();
  ui_map_.mark_item("fit:cancel");
  help_for_item(stops ? "End it at once." : "Stop here; the best so far is kept.");
  draw_trace(run);
}

void FitPanel::draw_found_buttons(const FitResult& found) {
  if (found.is_better() && !fit_.is_set()) {
    if (ImGui::Button("Take over")) attempt(problems_, [&] { fit_.take_over(document_); });
    ui_map_.mark_item("fit:take over");
    help_for_item("Set these values: one step, which Ctrl+Z takes back.");
    ImGui::SameLine();
  }
  const bool is_over = fit_.is_set() || !found.is_better();
  if (ImGui::Button(is_over ? "Clear" : "Discard")) fit_.clear();
  ui_map_.mark_item("fit:discard");
  help_for_item("Forget what was found, and what glows behind the sliders.");
}

/// What to know before it is taken over.
void FitPanel::draw_notes(const FitResult& found) {
  if (found.left_out)
    wrapped_text(fmt::format("{}F {:.3f} on a camera that it was not fitted on.",
                             found.is_gain ? "" : "Nothing was gained: ", *found.left_out),
                 found.is_gain ? theme().faint : theme().warning);
  for (const std::string& sentence : found.marks) wrapped_text(sentence, theme().text);
  const std::string indifferent = indifferent_text(found);
  if (!indifferent.empty()) wrapped_text(indifferent + ".", theme().warning);
  if (!found.stopped && !knows_ranges(found))
    wrapped_text("More candidates would tell which values are equally good.", theme().faint);
  if (fit_.is_set()) wrapped_text("These values are set.", theme().faint);
  if (!fit_.holds()) wrapped_text("The settings have moved on since.", theme().warning);
}

void FitPanel::draw_found() {
  const FitRun& run = *fit_.run();
  const float width = ImGui::GetContentRegionAvail().x;
  const FitResult* found = fit_.result();
  if (found == nullptr) {
    const bool failed = run.state() == FitState::failed;
    wrapped_text(failed ? run.problem() : "Stopped before anything was judged.",
                 failed ? theme().error : theme().faint);
    if (ImGui::Button("Clear")) fit_.clear();
    return ui_map_.mark_item("fit:discard");
  }
  draw_trace(run);
  const bool is_better = found->is_better();
  const std::string of =
      counted(found->candidates, "candidate", "candidates") + (found->stopped ? ", stopped" : "");
  fitted_text(is_better ? change_of(fit_.request(), found->before, found->after) + ", " + of
                        : "nothing better among " + of,
              width, is_better ? theme().good : theme().text);
  for (const FittedParameter& fitted : found->parameters) draw_fitted(fit_.request(), fitted, width);
  draw_notes(*found);
  const FitResult copy = *found;  // a button may drop it
  draw_found_buttons(copy);
}

void FitPanel::draw() {
  ImGui::PushID("fit");
  if (fit_.is_running()) {
    draw_running();
  } else {
    draw_start();
    if (fit_.run() != nullptr) draw_found();
  }
  ImGui::PopID();
  ImGui::Dummy({0, scaled(2)});
}

}  // namespace inkbench
