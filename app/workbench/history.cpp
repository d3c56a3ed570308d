// SPDX-License-Identifier: MIT
#include "app/workbench/history.h"

#include <algorithm>
#include <utility>

namespace inkbench {
namespace {

size_t bytes_of(const Value& value) {
  size_t bytes = sizeof(Value);
  if (const auto* text = std::get_if<std::string>(&value)) bytes += text->size();
  if (const auto* ramp = std::get_if<Ramp>(&value))
    bytes += ramp->image.size() + ramp->stops.size() * sizeof(RampStop);
  return bytes;
}

size_t bytes_of(const std::vector<ParamChange>& changes) {
  size_t bytes = 0;
  for (const ParamChange& change : changes) {
    bytes += sizeof(ParamChange) + change.key.size();
    if (change.before) bytes += bytes_of(*change.before);
    if (change.after) bytes += bytes_of(*change.after);
  }
  return bytes;
}

size_t bytes_of(const Settings& settings) {
  size_t bytes =
      sizeof(Settings) + settings.lights.size() * sizeof(LightParams) +
      (settings.ramp.diffuse.stops.size() + settings.ramp.specular.stops.size()) * sizeof(RampStop);
  for (const ModelParams& model : settings.models)
    bytes += sizeof(ModelParams) + model.name.size() + model.mesh.size() + model.part.size();
  return bytes;
}

}  // namespace

History::History(Settings start, HistoryLimits limits) : limits_(limits), current_(std::move(start)) {}

bool History::record(Settings next, const std::string& name) {
  if (editing_) {
    update_edit(std::move(next));
    return true;
  }
  std::swap(current_, next);
  return add_step(next, name, origin_);
}

bool History::record_from(size_t origin, Settings next, const std::string& name, bool even_if_equal) {
  end_edit();
  std::swap(current_, next);
  return add_step(next, name, origin, even_if_equal);
}

void History::begin_edit(const std::string& name) {
  end_edit();
  editing_ = true;
  edit_start_ = current_;
  edit_name_ = name;
}

void History::update_edit(Settings next) {
  if (!editing_) begin_edit();
  current_ = std::move(next);
}

bool History::end_edit() {
  if (!editing_) return false;
  editing_ = false;
  return add_step(edit_start_, edit_name_, origin_);
}

void History::cancel_edit() {
  if (!editing_) return;
  editing_ = false;
  current_ = edit_start_;
}

bool History::edit_has_changes() const {
  return editing_ && !same_settings(edit_start_, current_);
}

bool History::add_step(const Settings& before, const std::string& name, size_t origin, bool even_if_equal) {
  Step step;
  step.origin_before = std::exchange(origin_, origin);
  step.origin_after = origin;
  step.changes = changed_params(before, current_);
  const bool one_structure = same_structure(before, current_);
  if (step.changes.empty() && one_structure && !even_if_equal) return false;
  step.name = name.empty() ? changes_name(step.changes) : name;
  if (!one_structure) {
    step.changes.clear();
    step.before = std::make_shared<const Settings>(before);
    step.after = std::make_shared<const Settings>(current_);
    step.bytes = bytes_of(before) + bytes_of(current_);
  }
  step.bytes += sizeof(Step) + step.name.size() + bytes_of(step.changes);
  for (; steps_.size() > position_; steps_.pop_back()) bytes_ -= steps_.back().bytes;
  bytes_ += step.bytes;
  steps_.push_back(std::move(step));
  ++position_;
  keep_limits();
  return true;
}

void History::keep_limits() {
  while (steps_.size() > 1 && (steps_.size() > limits_.steps || bytes_ > limits_.bytes)) {
    bytes_ -= steps_.front().bytes;
    steps_.pop_front();
    --position_;
  }
}

void History::take_back(Settings& settings, const Step& step) {
  if (step.before) {
    settings = *step.before;
  } else {
    apply_changes(settings, step.changes, false);
  }
}

std::optional<size_t> History::find_back(const std::function<bool(const Settings&)>& suits) const {
  Settings settings = editing_ ? edit_start_ : current_;
  for (size_t place = position_; place > 0; --place) {
    take_back(settings, steps_[place - 1]);
    if (suits(settings)) return place - 1;
  }
  return std::nullopt;
}

const Settings& History::undo() {
  end_edit();
  if (position_ == 0) return current_;
  const Step& step = steps_[--position_];
  origin_ = step.origin_before;
  take_back(current_, step);
  return current_;
}

const Settings& History::redo() {
  end_edit();
  if (position_ == steps_.size()) return current_;
  const Step& step = steps_[position_++];
  origin_ = step.origin_after;
  if (step.after) {
    current_ = *step.after;
  } else {
    apply_changes(current_, step.changes);
  }
  return current_;
}

const Settings& History::go_to(size_t position) {
  end_edit();
  const size_t wanted = std::min(position, steps_.size());
  while (position_ > wanted) undo();
  while (position_ < wanted) redo();
  return current_;
}

std::vector<std::string> History::step_names() const {
  std::vector<std::string> names;
  for (const Step& step : steps_) names.push_back(step.name);
  return names;
}

std::string History::undo_name() const {
  if (edit_has_changes())
    return edit_name_.empty() ? changes_name(changed_params(edit_start_, current_)) : edit_name_;
  return position_ == 0 ? "" : steps_[position_ - 1].name;
}

std::string History::redo_name() const {
  return can_redo() ? steps_[position_].name : "";
}

}  // namespace inkbench
