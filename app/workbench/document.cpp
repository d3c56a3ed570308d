// SPDX-License-Identifier: MIT
#include "app/workbench/document.h"

#include <utility>

#include "pipeline/base/error.h"
#include "pipeline/mesh/levels/scene_file.h"

namespace inkbench {

Document::Document(const Settings& settings, const std::filesystem::path& scene, Problems& problems,
                   const PaintedMarks& marks)
    : problems_(problems), history_(settings), origins_{origin_in(scene, settings, marks)} {}

/// The baseline is what the file says now: what was changed since then is marked as changed.
Document::Origin Document::origin_in(const std::filesystem::path& scene, const Settings& settings,
                                     const PaintedMarks& marks) {
  Origin origin{
      "unnamed", {}, std::make_shared<const Settings>(settings), std::make_shared<const PaintedMarks>(marks)};
  if (scene.empty()) return origin;
  origin.name = scene.filename().string();
  origin.scene = scene;
  try {
    origin.baseline = std::make_shared<const Settings>(load_scene_file(scene));
  } catch (const Error&) {
    // It changed or went away since; its settings are here.
  }
  return origin;
}

/// Returns whether it worked; why not is told.
template <class Action>
bool Document::attempt(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    problems_.set(ProblemKind::input, error.what());
    return false;
  }
  problems_.dismiss(ProblemKind::input);
  return true;
}

void Document::change(const std::string& key, const Value& value) {
  attempt([&] {
    Settings next = settings();
    find_param(next, key, "").set(value, "");
    history_.record(std::move(next));
    ++revision_;
  });
}

void Document::change_text(const std::string& key, const std::string& text) {
  attempt([&] {
    Settings next = settings();
    set_param_text(next, key, text, "");
    history_.record(std::move(next));
    ++revision_;
  });
}

void Document::reset(const std::string& key) {
  const Settings& from = baseline();
  if (has_param(from, key)) change(key, find_param(from, key, "").value());
}

void Document::replace(const Settings& settings, const std::string& step) {
  attempt([&] { accept(settings, step); });
}

void Document::accept(const Settings& settings, const std::string& step,
                      const std::optional<PaintedMarks>& marks) {
  Settings next = settings;
  for (const Param& param : list_params(next)) param.set(param.value(), "");  // each is asked
  if (marks && !same_marks(*marks, this->marks())) return record(std::move(next), *marks, step);
  history_.record(std::move(next), step);
  ++revision_;
}

void Document::take_from(Origin origin, const Settings& settings, const std::string& step) {
  check_settings(settings);
  origins_.push_back(std::move(origin));
  history_.record_from(origins_.size() - 1, settings, step);
  ++revision_;
}

bool Document::take_over(const Settings& settings, const std::filesystem::path& scene,
                         const PaintedMarks& marks, const std::string& step) {
  return attempt([&] { take_from(origin_in(scene, settings, marks), settings, step); });
}

void Document::set_marks(PaintedMarks marks, const std::string& step) {
  if (!same_marks(marks, this->marks())) record(settings(), std::move(marks), step);
}

void Document::record(Settings settings, PaintedMarks marks, const std::string& step) {
  Origin origin = this->origin();
  origin.marks = std::make_shared<const PaintedMarks>(std::move(marks));
  origins_.push_back(std::move(origin));
  history_.record_from(origins_.size() - 1, std::move(settings), step, true);
  ++revision_;
}

void Document::accept_from(const std::string& name, const std::filesystem::path& scene,
                           const Settings& settings, const std::string& step) {
  take_from({name, scene, std::make_shared<const Settings>(settings), std::make_shared<const PaintedMarks>()},
            settings, step);
}

void Document::saved_as(const std::filesystem::path& file) {
  origins_.push_back(
      {file.filename().string(), file, std::make_shared<const Settings>(settings()), origin().marks});
  history_.record_from(origins_.size() - 1, settings(), "");
  ++revision_;
}

void Document::begin_edit() {
  if (!is_editing()) history_.begin_edit();
}

void Document::end_edit() {
  history_.end_edit();
  ++revision_;
}

void Document::cancel_edit() {
  if (!is_editing()) return;
  history_.cancel_edit();
  problems_.dismiss(ProblemKind::input);
  ++revision_;
}

void Document::undo() {
  if (history_.can_undo()) go_to_step(history_.position() - 1);
}

void Document::redo() {
  if (history_.can_redo()) go_to_step(history_.position() + 1);
}

void Document::go_to_step(size_t position) {
  if (is_editing()) return;  // what is held by the mouse goes on
  history_.go_to(position);
  problems_.dismiss(ProblemKind::input);
  ++revision_;
}

}  // namespace inkbench
