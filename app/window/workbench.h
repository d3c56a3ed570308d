// The state of the window: the settings and every change of them, the pictures they give, how these are
// looked at, what went wrong. Panels read it and call it; they do not know each other. Nothing here draws
// widgets.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/window/message_log.h"
#include "app/window/pass_timer.h"
#include "app/window/pictures.h"
#include "app/window/tile.h"
#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/workbench/history.h"
#include "app/workbench/opened_file.h"
#include "app/workbench/session.h"
#include "pipeline/base/files.h"
#include "pipeline/scene/settings.h"

namespace inkbench {

/// What stands in the way, by where it comes from: each is shown until it is mended or dismissed.
enum class ProblemKind { drawing, shader, input };

/// What a panel wants of the window itself; the loop takes it after the frame.
struct WindowRequests {
  bool close = false, toggle_full_screen = false, screenshot = false;
};

/// How long frames take: for the status bar and reports.
struct FrameTimes {
  long frames = 0;
  double last_ms = 0.0, mean_ms = 0.0;
};

class Workbench {
 public:
  /// Needs a current OpenGL 4.5 context for its whole life. `baseline`: the settings as the session's scene
  /// file gives them. Errors (input): a shader does not compile.
  Workbench(const Session& session, const Settings& baseline);
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;
  ~Workbench();

  // --- settings: every change goes through these ---

  const Settings& settings() const { return history_.current(); }
  /// What the scene's file says: parameters that differ from it are marked as changed and can be reset to it.
  const Settings& baseline() const { return baseline_; }
  /// What is to come back at the next start.
  Session session() const;
  /// "paper.toml": for people.
  std::string scene_name() const;

  /// Sets one parameter; a value that it does not accept is told as a problem and changes nothing.
  void change(const std::string& key, const Value& value);
  /// The same from text as a person types it.
  void change_text(const std::string& key, const std::string& text);
  /// Back to the baseline's value.
  void reset(const std::string& key);
  /// All at once: a preset, an image's parameters, a camera; `name` is the step's, "" for what changed.
  void replace(const Settings& settings, const std::string& name = "");
  /// Changes between these two are one step: a slider that is being dragged, an orbit.
  void begin_edit() { history_.begin_edit(); }
  void end_edit() { history_.end_edit(); }
  bool is_editing() const { return history_.is_editing(); }
  void undo();
  void redo();
  const History& history() const { return history_; }

  /// Opens a scene, a preset, an exported image (its parameters), a mesh (in the main model's place) or a
  /// ramp (the diffuse one). What cannot be opened is told as a problem and changes nothing.
  void open(const std::string& path);

  // --- pictures ---

  /// Once a frame, before the panels: brings the pictures that are looked at up to date.
  void refresh();
  /// Now and then: takes in edits of shaders, meshes and ramps on disk. Returns whether there were any.
  bool poll_files();
  /// The settings of the pictures that are shown.
  const std::optional<Settings>& drawn_settings() const { return last_good_; }
  /// The buffers that the sheet shows, or those that fill the window.
  std::array<bool, kBufferCount> wanted_buffers() const;
  bool is_listed(BufferName buffer) const;
  void set_listed(BufferName buffer, bool listed);
  void pin();

  // --- what went wrong ---

  void tell(Severity severity, const std::string& text);
  void set_problem(ProblemKind kind, const std::string& text);
  const std::map<ProblemKind, std::string>& problems() const { return problems_; }
  void dismiss(ProblemKind kind) { problems_.erase(kind); }
  /// Back to the settings that last gave pictures.
  void go_back();

  /// Another frame is wanted after so many seconds, though nothing happens until then: a delayed tooltip.
  void wake_in(double seconds);
  double take_wake_seconds();

  WindowLayout layout;
  ViewState view;
  MessageLog log;
  UiMap ui_map;
  WindowRequests requests;
  FrameTimes frame_times;
  long marks = 0;   ///< Presses of the Pause key: a test that sees its own knows that all before it is done.
  PassTimer timer;  ///< Of the pipeline's passes.
  PassTimer window_timer;  ///< Of the tiles and the window itself.
  Pictures pictures;
  TilePainter tiles;

 private:
  template <class Change>
  bool apply(const Change& change, const std::string& name = "");
  void take_over(Settings& next, const OpenedFile& file);
  Key drawn_state() const;
  std::string files_state();

  History history_;
  Settings baseline_;
  fs::path scene_;
  std::vector<fs::path> recent_;
  std::vector<CameraBookmark> bookmarks_;
  std::optional<Settings> last_good_;
  std::optional<Key> failed_;  ///< What could not be drawn: not tried again until something changes.
  long files_revision_ = 0;
  std::string files_state_;
  std::map<ProblemKind, std::string> problems_;
  double wake_seconds_;
};

}  // namespace inkbench
