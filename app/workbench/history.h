// SPDX-License-Identifier: MIT
// Undo and redo of every change of the settings. In: the settings after each change. Out: the settings to
// show, and the steps by name. A step holds only what it changed, so that memory stays small.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/param_changes.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

struct HistoryLimits {
  size_t steps = 1000;
  size_t bytes = size_t{64} << 20;  ///< About; the newest step stays however large it is.
};

class History {
 public:
  explicit History(Settings start, HistoryLimits limits = {});

  /// The settings as they are now, an open edit's included.
  const Settings& current() const { return current_; }

  /// One change that is a step of its own; "" names it after what changed. Returns whether there was a
  /// change: equal settings make no step and cut nothing off. Inside an edit, the same as `update_edit`.
  bool record(Settings next, const std::string& name = "");

  /// The same for settings that came from another file: `origin` is a number that the caller chose for it,
  /// and undo brings back the one before with its settings. At the start it is 0.
  /// `even_if_equal`: a step although no setting changes, since the origin does.
  bool record_from(size_t origin, Settings next, const std::string& name, bool even_if_equal = false);
  size_t origin() const { return origin_; }

  /// An edit is a change in many small moves, such as dragging a slider, that is one step. One that comes
  /// back to where it began is none. `begin_edit` within an edit ends that one first.
  void begin_edit(const std::string& name = "");
  void update_edit(Settings next);
  bool end_edit();
  /// Back to where it began: no step.
  void cancel_edit();
  bool is_editing() const { return editing_; }

  /// An open edit is ended first, so that undo takes it back.
  bool can_undo() const { return position_ > 0 || edit_has_changes(); }
  bool can_redo() const { return position_ < steps_.size() && !edit_has_changes(); }
  /// Nothing happens where there is nothing to undo or redo.
  const Settings& undo();
  const Settings& redo();
  /// To just after step `position - 1`; 0 is before the first step kept. Places past the end count as the
  /// end.
  const Settings& go_to(size_t position);

  /// The last place before the present one whose settings suit, as `go_to` takes it; none where none do.
  std::optional<size_t> find_back(const std::function<bool(const Settings&)>& suits) const;

  /// The steps' names, oldest first; those from `position()` on are undone.
  std::vector<std::string> step_names() const;
  size_t position() const { return position_; }
  /// Of the step that undo or redo would take; "" without one.
  std::string undo_name() const;
  std::string redo_name() const;

 private:
  struct Step {
    std::string name;
    std::vector<ParamChange> changes;
    /// Both sides whole, where models or lights came or went.
    std::shared_ptr<const Settings> before, after;
    size_t bytes = 0;
    size_t origin_before = 0, origin_after = 0;
  };

  static void take_back(Settings& settings, const Step& step);
  bool edit_has_changes() const;
  bool add_step(const Settings& before, const std::string& name, size_t origin, bool even_if_equal = false);
  void keep_limits();

  HistoryLimits limits_;
  Settings current_;
  std::deque<Step> steps_;
  size_t position_ = 0;  ///< Steps before it are done.
  size_t bytes_ = 0;
  size_t origin_ = 0;
  bool editing_ = false;
  Settings edit_start_;
  std::string edit_name_;
};

}  // namespace inkbench
