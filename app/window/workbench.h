// The state of the window: the settings and every change of them, the pictures they give, how these are
// looked at, what went wrong. Panels read it and call it; they do not know each other. Nothing here draws
// widgets.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "app/window/judge_desk.h"
#include "app/window/keeping.h"
#include "app/window/ladder_desk.h"
#include "app/window/message_log.h"
#include "app/window/pass_timer.h"
#include "app/window/pictures.h"
#include "app/window/pixel_probe.h"
#include "app/window/studies.h"
#include "app/window/tile.h"
#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/window/wire_painter.h"
#include "app/workbench/history.h"
#include "app/workbench/opened_file.h"
#include "app/workbench/window_layout.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// What stands in the way, by where it comes from: each is shown until it is mended or dismissed.
enum class ProblemKind { drawing, shader, input };

/// What a panel wants of the window itself; the loop takes it after the frame.
struct WindowRequests {
  bool close = false, toggle_full_screen = false, screenshot = false;
  bool keyboard = false;  ///< A text field asked for it and has it two frames later.
};

/// What asks for a file's path.
enum class FileDialog { open, save_settings, save_image };

/// How long frames take: for the status bar and reports.
struct FrameTimes {
  long frames = 0;
  double last_ms = 0.0, mean_ms = 0.0;
};

class Workbench {
 public:
  /// Needs a current OpenGL 4.5 context for its whole life. Errors (input): a shader does not compile.
  /// Starts with the session's settings; `keeping` must outlive this.
  Workbench(const Session& session, Keeping& keeping);
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;
  ~Workbench();

  // --- settings: every change goes through these ---

  const Settings& settings() const { return history_.current(); }
  /// What the opened file says: parameters that differ from it are marked as changed and can be reset to it.
  const Settings& baseline() const { return origin().baseline; }
  const std::string& scene_name() const { return origin().name; }
  /// The file that the settings came from; empty where no file holds them as a scene.
  const std::filesystem::path& scene() const { return origin().scene; }

  /// Sets one parameter; a value that it does not accept is told as a problem and changes nothing.
  void change(const std::string& key, const Value& value);
  /// The same from text as a person types it.
  void change_text(const std::string& key, const std::string& text);
  /// Back to the baseline's value.
  void reset(const std::string& key);
  /// All at once; `step` names it in the history, else what changed does.
  void replace(const Settings& settings, const std::string& step = "");
  /// The same with the file that they come from, whose own settings are the new baseline. Returns whether
  /// they were accepted.
  bool take_over(const Settings& settings, const std::filesystem::path& scene, const std::string& step);
  /// Changes between these two are one step: a slider that is being dragged, an orbit.
  void begin_edit();
  void end_edit();
  bool is_editing() const { return history_.is_editing(); }
  const History& history() const { return history_; }
  void undo();
  void redo();
  /// To just after that many steps.
  void go_to_step(size_t position);
  /// Rises with every change of the settings or of where they came from.
  long revision() const { return revision_; }

  /// Opens whatever inkbench knows, by what the file holds: scenes, presets, exported images, meshes, ramps,
  /// studies. What cannot be opened is told as a problem and changes nothing.
  void open(const std::string& path) { open_all({path}); }
  /// One after the other; what could not be opened is told even where another could.
  void open_all(const std::vector<std::string>& paths);
  /// Takes a study that was opened; without it, its settings are taken over.
  std::function<void(const OpenedFile&)> on_study;
  /// The settings are in this file now: it is the scene, and nothing differs from it.
  void saved_as(const std::filesystem::path& file);

  // --- pictures ---

  /// Once a frame, before the panels: brings the pictures that are looked at up to date.
  void refresh();
  /// Whether something that is looked at waits for another frame.
  bool has_late() const { return !failed_ && pictures.has_late(); }
  /// Whether something made beside the window is there since the last call: a frame should show it.
  bool take_news();
  /// Now and then: takes in edits of shaders, meshes and ramps on disk. Returns whether there were any.
  bool poll_files();
  /// Another number after each such edit.
  long files_revision() const { return files_revision_; }
  /// Of the pictures that are shown. Panels read pixels of it: another would run a pass in the middle of the
  /// window's frame.
  const std::optional<Frame>& drawn() const { return drawn_; }
  /// The buffers that the sheet shows, or those that fill the window.
  std::vector<BufferName> wanted_buffers() const;
  bool is_listed(BufferName buffer) const;
  void set_listed(BufferName buffer, bool listed);
  void pin();

  // --- what went wrong ---

  void tell(Severity severity, const std::string& text);
  void set_problem(ProblemKind kind, const std::string& text);
  const std::map<ProblemKind, std::string>& problems() const { return problems_; }
  void dismiss(ProblemKind kind) { problems_.erase(kind); }
  /// Back to the settings that last gave pictures, or to the last step that can be drawn.
  void go_back();
  /// Whether that leads elsewhere: a file that broke under the settings leaves nowhere to go at times.
  bool can_go_back();

  /// Another frame is wanted after so many seconds, though nothing happens until then: a delayed tooltip.
  void wake_in(double seconds);
  double take_wake_seconds();

  Keeping& keeping;
  WindowLayout layout;
  ViewState view;
  MessageLog log;
  UiMap ui_map;
  WindowRequests requests;
  std::optional<FileDialog> wanted_dialog;
  FrameTimes frame_times;
  long marks = 0;   ///< Presses of the Pause key: a test that sees its own knows that all before it is done.
  PassTimer timer;  ///< Of the pipeline's passes.
  PassTimer window_timer;  ///< Of the tiles and the window itself.
  Pictures pictures;
  Studies studies;
  TilePainter tiles;
  WirePainter wires;
  JudgeDesk judge;
  LadderDesk ladders;
  PixelProbe probe;  ///< Of the marked pixel.

 private:
  /// Where settings came from.
  struct Origin {
    std::string name;
    std::filesystem::path scene;
    Settings baseline;
  };
  static Origin origin_in(const std::filesystem::path& scene, const Settings& settings);
  const Origin& origin() const { return origins_.at(history_.origin()); }
  template <class Change>
  bool apply(const Change& change, const std::string& step = "");
  std::string open_one(const std::string& path);
  void take(const OpenedFile& file);
  void take_mesh(const OpenedFile& file);
  bool is_kept_preset(const std::filesystem::path& file) const;
  void take_from(const Origin& origin, const Settings& settings, const std::string& step);
  const Settings& update_target();
  Key state_to_draw(const Settings& settings) const;
  /// Where `go_back` leads: a step of the history, else the last good settings.
  struct WayBack {
    std::optional<size_t> step;
    bool to_last_good = false;
  };
  const WayBack& way_back();
  bool can_be_drawn(const Settings& settings);
  std::string files_state();
  bool take_files_state();
  bool reload_shaders();
  std::string shader_problem();

  History history_;
  std::vector<Origin> origins_;  ///< By the numbers that the history knows.
  long revision_ = 0;
  std::optional<Frame> drawn_;         ///< Of the pictures that are shown.
  std::optional<Settings> last_good_;  ///< That gave pictures.
  std::optional<Key> failed_;          ///< What could not be drawn: not tried again until something changes.
  WayBack way_back_;
  std::optional<Key> way_back_from_;  ///< The failure that it was found for.
  long files_revision_ = 0;
  /// What is to be drawn: the settings, or the full mesh while its levels are made.
  struct Target {
    Settings settings;
    long revision = -1, files_revision = -1;
    Key state;
    std::optional<Frame> frame;
  } target_;
  Key drawn_state_;  ///< In the last frame.
  long drawn_changes_ = 0;
  std::string files_settings_, files_state_;  ///< At the last look.
  std::map<ProblemKind, std::string> problems_;
  double wake_seconds_;
};

}  // namespace inkbench
