// SPDX-License-Identifier: MIT
// What shows the document: its pictures, the measures of its lines, and what both are made with. In: the
// document, layout and view, once a frame. Out: pictures and measures, the newest that there are. Nothing
// here draws widgets.
#pragma once

#include <memory>
#include <optional>

#include "app/window/disk_watch.h"
#include "app/window/judge_desk.h"
#include "app/window/ladder_desk.h"
#include "app/window/mark_overlay.h"
#include "app/window/pass_timer.h"
#include "app/window/pictures.h"
#include "app/window/tile.h"
#include "app/window/view_state.h"
#include "app/window/wire_painter.h"
#include "app/workbench/document.h"
#include "app/workbench/window_layout.h"
#include "pipeline/curves/curve.h"
#include "pipeline/explain.h"

namespace inkbench {

/// How long frames take: for the status bar and reports.
struct FrameTimes {
  long frames = 0;
  double last_ms = 0.0, mean_ms = 0.0;
};

class Viewer {
 public:
  /// Needs a current OpenGL 4.5 context for its whole life; the arguments must outlive it. Errors (input): a
  /// shader does not compile.
  Viewer(Document& document, Problems& problems, const WindowLayout& layout, const ViewState& view,
         News& news);

  /// Once a frame, before the panels: brings the pictures that are looked at up to date.
  void refresh();
  /// Whether something that is looked at waits for another frame.
  bool has_late() const { return !failed_ && (pictures.has_late() || judge.causes.has_step()); }
  /// Of the pictures that are shown. Panels read pixels of it: another would run a pass in the middle of the
  /// window's frame.
  const std::optional<Frame>& drawn() const { return drawn_; }
  /// Whether the present settings could be drawn, as far as it was told.
  bool can_draw() const { return !problems_.all().contains(ProblemKind::drawing); }
  /// The lines that the layout lays over pictures of the present settings; none where there are none yet.
  TileOverlay overlay() { return judge.overlay(layout_.overlay, pictures.reference()); }
  /// Why the pixel of what is drawn is a line or not; kept until either changes. Errors: as `explain_pixel`.
  const Explanation& explain(int x, int y);
  /// The same of the pinned state, which must be there.
  const Explanation& explain_pinned(int x, int y);
  /// The last one.
  const Explanation& explained() const { return explanation_; }
  /// The curves of what is drawn, which must be there; kept until they change. Errors: as their pass.
  const Curves& curves();
  /// Keeps the shown pictures to compare with.
  void pin();

  /// Back to the settings that last gave pictures, or to the last step that can be drawn.
  void go_back();
  /// Whether that leads elsewhere: a file that broke under the settings leaves nowhere to go at times.
  bool can_go_back();

  FrameTimes frame_times;
  PassTimer timer;         ///< Of the pipeline's passes.
  PassTimer window_timer;  ///< Of the tiles and the window itself.
  Pictures pictures;
  TilePainter tiles;
  WirePainter wires;
  MarkOverlay marks;
  JudgeDesk judge;
  LadderDesk ladders;
  DiskWatch disk;

 private:
  /// Where `go_back` leads: a step of the history, else the last good settings.
  struct WayBack {
    std::optional<size_t> step;
    bool to_last_good = false;
  };
  Key state_to_draw(const Settings& settings) const;
  void update_target();
  Frame next_frame();
  void draw(const Frame& frame);
  void fail(const Key& state, const std::string& why);
  const WayBack& way_back();
  bool can_be_drawn(const Settings& settings);

  Document& document_;
  Problems& problems_;
  const WindowLayout& layout_;
  const ViewState& view_;
  /// What is to be drawn: the settings, or the full mesh while its levels are made.
  struct Target {
    Settings settings;
    long revision = -1, files_revision = -1;
    Key state;
    std::optional<Frame> frame;
    bool has_past = false;  ///< `frame` goes on from the one before it.
  } target_;
  std::optional<Frame> drawn_;         ///< Of the pictures that are shown.
  std::optional<Settings> last_good_;  ///< That gave pictures.
  std::optional<Key> failed_;          ///< What could not be drawn: not tried again until something changes.
  WayBack way_back_;
  std::optional<Key> way_back_from_;  ///< The failure that it was found for.
  Explanation explanation_;
  Key explained_;  ///< What `explanation_` is of.
  std::shared_ptr<const Curves> curves_;
  Key curves_key_;
  Key drawn_state_;  ///< In the last frame.
  long drawn_changes_ = 0;
};

}  // namespace inkbench
