// SPDX-License-Identifier: MIT
// What a person works on: the settings and the marks painted over their pictures, every change of them with
// undo, and where they came from. In: changes. Out: the settings now, and the baseline that they are compared
// with. What is not accepted becomes a problem.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/history.h"
#include "app/workbench/painted_marks.h"
#include "app/workbench/problems.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

class Document {
 public:
  /// `scene` is the file that the settings came from, or empty. `problems` must outlive it.
  Document(const Settings& settings, const std::filesystem::path& scene, Problems& problems,
           const PaintedMarks& marks = {});

  const Settings& settings() const { return history_.current(); }
  /// What the opened file says: parameters that differ from it are marked as changed and can be reset to it.
  const Settings& baseline() const { return *origin().baseline; }
  const std::string& scene_name() const { return origin().name; }
  /// The file that the settings came from; empty where no file holds them as a scene.
  const std::filesystem::path& scene() const { return origin().scene; }
  /// What is painted over the pictures, of all cameras.
  const PaintedMarks& marks() const { return *origin().marks; }
  /// Rises with every change of the settings, of the marks or of where they came from.
  long revision() const { return revision_; }

  // --- changes: what is not accepted is told as a problem and changes nothing ---

  /// Sets one parameter.
  void change(const std::string& key, const Value& value);
  /// The same from text as a person types it.
  void change_text(const std::string& key, const std::string& text);
  /// Back to the baseline's value.
  void reset(const std::string& key);
  /// All at once; `step` names it in the history, else what changed does.
  void replace(const Settings& settings, const std::string& step = "");
  /// Other marks, as a step of its own.
  void set_marks(PaintedMarks marks, const std::string& step);
  /// The same with the file that they come from, whose own settings are the new baseline, and with marks.
  /// Returns whether they were accepted.
  bool take_over(const Settings& settings, const std::filesystem::path& scene, const PaintedMarks& marks,
                 const std::string& step);

  // --- the same for opening files, which goes on after an error: these throw it ---

  /// As `replace`, with marks where there are some to take. Errors (input): a value that is not accepted.
  void accept(const Settings& settings, const std::string& step,
              const std::optional<PaintedMarks>& marks = {});
  /// Settings as a file holds them are their own baseline, and nothing is painted over them; `name` stands
  /// for the file. Errors (input): what
  /// `check_settings` refuses.
  void accept_from(const std::string& name, const std::filesystem::path& scene, const Settings& settings,
                   const std::string& step);

  /// The settings are in this file now: it is the scene, and nothing differs from it.
  void saved_as(const std::filesystem::path& file);

  // --- steps ---

  /// Changes between these two are one step: a slider that is being dragged, an orbit.
  void begin_edit();
  void end_edit();
  /// As if it had never begun.
  void cancel_edit();
  bool is_editing() const { return history_.is_editing(); }
  const History& history() const { return history_; }
  /// Nothing happens where there is nothing to undo or redo, nor during an edit.
  void undo();
  void redo();
  /// To just after that many steps.
  void go_to_step(size_t position);

 private:
  /// Where settings came from, and what else is no parameter.
  struct Origin {
    std::string name;
    std::filesystem::path scene;
    std::shared_ptr<const Settings> baseline;
    std::shared_ptr<const PaintedMarks> marks;
  };
  static Origin origin_in(const std::filesystem::path& scene, const Settings& settings,
                          const PaintedMarks& marks);
  const Origin& origin() const { return origins_.at(history_.origin()); }
  void take_from(Origin origin, const Settings& settings, const std::string& step);
  void record(Settings settings, PaintedMarks marks, const std::string& step);
  template <class Action>
  bool attempt(const Action& action);

  Problems& problems_;
  History history_;
  std::vector<Origin> origins_;  ///< By the numbers that the history knows.
  long revision_ = 0;
};

}  // namespace inkbench
