// SPDX-License-Identifier: MIT
#include "app/run_window.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <imgui_internal.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>

#include "app/panels/frame/main_frame.h"
#include "app/terminal.h"
#include "app/window/end_signals.h"
#include "app/window/gui.h"
#include "app/window/state_file.h"
#include "app/window/typing_wish.h"
#include "app/window/workbench.h"
#include "app/workbench/save_place.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/image/image_file.h"

namespace inkbench {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kPollSeconds = 0.5;
/// Frames after something happened: ImGui needs one more than the event's to settle (hover, popups' sizes).
constexpr int kSettleFrames = 3;
constexpr double kNewestShare = 0.2;

/// What the window looks like, row 0 on top.
Picture read_window(WindowSize size) {
  Picture picture(size.width_px, size.height_px, 3);
  std::vector<uint8_t> rows(picture.samples.size());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size.width_px, size.height_px, GL_RGB, GL_UNSIGNED_BYTE, rows.data());
  const size_t row = static_cast<size_t>(size.width_px) * 3;
  for (int y = 0; y < size.height_px; ++y) {
    std::copy_n(&rows[row * (size.height_px - 1 - y)], row, &picture.samples[row * y]);
  }
  return picture;
}

/// One that is free.
std::string screenshot_name() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 64> text{};
  std::strftime(text.data(), text.size(), "inkbench-%Y%m%d-%H%M%S", &local);
  std::string name = text.data();
  for (int i = 2; is_taken(name + ".png"); ++i) name = fmt::format("{}-{}", text.data(), i);
  return name + ".png";
}

class WindowLoop {
 public:
  explicit WindowLoop(const WindowOptions& options);
  void run();

 private:
  void wait();
  void poll();
  void tell_notes();
  void draw_frame();
  void build_frame();
  void take_requests();
  void take_screenshot();
  void write_state();
  void drag_by_itself();
  bool is_dragging_itself() const { return drag_frame_ < options_.drag_frames; }
  bool has_frames_to_draw() const {
    return frames_wanted_ > 0 || !input_.is_empty() || typing_is_expected() || is_dragging_itself();
  }
  void want_frames() { frames_wanted_ = kSettleFrames; }

  const WindowOptions& options_;
  Keeping keeping_;
  Session start_;
  Window window_;
  InputQueue input_;
  Gui gui_;
  Workbench bench_;
  MainFrame frame_;
  int frames_wanted_ = kSettleFrames;
  double next_poll_ = 0.0;
  double wake_at_ = kNever;
  int drag_frame_ = 0;
  long drawn_log_ = 0;  ///< The log's revision when the last frame began.
  std::string written_state_;
  bool failed_frame_ = false;
};

/// What to start with: the last session, with what the command line says instead of its settings.
Session start_session(const WindowOptions& options, Keeping& keeping) {
  Session session = keeping.start();
  if (options.settings) {
    session.settings = *options.settings;
    session.scene = options.scene;
  }
  if (options.size) {
    session.layout.width_px = options.size->width_px;
    session.layout.height_px = options.size->height_px;
    session.layout.maximised = false;
  }
  return session;
}

WindowLoop::WindowLoop(const WindowOptions& options)
    : options_(options),
      start_(start_session(options, keeping_)),
      window_("inkbench", {start_.layout.width_px, start_.layout.height_px}),
      input_(window_.handle()),
      gui_(window_, input_),
      bench_(start_, keeping_),
      frame_(bench_) {
  watch_end_signals();
  tell_notes();
  if (start_.layout.maximised) window_.maximise();
  if (!options.state_file.empty()) bench_.ui_map.enable();
  if (!options.file.empty()) bench_.files.open(options.file);
  if (is_dragging_itself()) bench_.layout.show_welcome = false;
}

/// Sleeps until there is something to do; sets how many frames that takes.
void WindowLoop::wait() {
  const double now = seconds_now();
  if (has_frames_to_draw()) {
    poll_events();
  } else {
    write_state();
    wait_for_events(std::min(next_poll_, wake_at_) - now);
  }
  if (end_is_asked()) window_.close();
  if (input_.take_activity()) want_frames();
  if (seconds_now() >= wake_at_) {
    frames_wanted_ = std::max(frames_wanted_, 1);
    wake_at_ = kNever;
  }
  if (bench_.news.take()) want_frames();
  if (seconds_now() >= next_poll_) poll();
  if (bench_.log.revision() != drawn_log_) want_frames();
}

/// Now and then, also while nothing happens.
void WindowLoop::poll() {
  if (bench_.viewer.disk.poll()) want_frames();
  if (options_.drag_frames == 0) keeping_.autosave(bench_.document, bench_.layout, seconds_now());
  tell_notes();
  next_poll_ = seconds_now() + kPollSeconds;
}

void WindowLoop::tell_notes() {
  for (const std::string& note : keeping_.take_notes()) bench_.problems.tell(Severity::warning, note);
}

void WindowLoop::build_frame() {
  bench_.files.open_all(input_.take_dropped());
  bench_.ui_map.begin_frame();
  bench_.viewer.refresh();
  frame_.draw();
}

void WindowLoop::draw_frame() {
  const auto start = std::chrono::steady_clock::now();
  drawn_log_ = bench_.log.revision();
  gui_.set_look(bench_.layout.theme, bench_.layout.ui_scale);
  gui_.begin_frame();
  try {
    build_frame();
    failed_frame_ = false;
  } catch (const std::exception& error) {
    // ImGui is left in the middle of a panel: its own tidying up keeps the next frame sound.
    ImGui::ErrorCheckEndFrameRecover(nullptr);
    if (!failed_frame_) bench_.problems.set(ProblemKind::drawing, error.what());
    failed_frame_ = true;
  }
  try {
    const PassScope scope(&bench_.viewer.window_timer, "window");
    gui_.end_frame();
  } catch (const Error& error) {
    bench_.problems.set(ProblemKind::drawing, error.what());
  }
  take_requests();
  window_.present();
  const double ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  FrameTimes& times = bench_.viewer.frame_times;
  times.last_ms = ms;
  times.mean_ms = times.frames < 2 ? ms :  // the first one loads meshes and makes textures
                      times.mean_ms + kNewestShare * (ms - times.mean_ms);
  ++times.frames;
}

void WindowLoop::take_requests() {
  const WindowRequests requests = std::exchange(bench_.requests, {});
  if (requests.screenshot) take_screenshot();
  if (requests.toggle_full_screen) window_.toggle_full_screen();
  if (requests.close) window_.close();
  wake_at_ = std::min(wake_at_, seconds_now() + requests.wake_seconds);
  const WindowSize size = window_.size();
  bench_.layout.maximised = window_.is_maximised();
  if (window_.is_full_screen() || bench_.layout.maximised || size.width_px < 1) return;
  bench_.layout.width_px = std::max(size.width_px, 480);
  bench_.layout.height_px = std::max(size.height_px, 320);
}

void WindowLoop::take_screenshot() {
  const std::string name = screenshot_name();
  try {
    write_png(name, read_window(window_.size()), {});
    bench_.problems.tell(Severity::note, "saved " + std::filesystem::absolute(name).string());
  } catch (const Error& error) {
    bench_.problems.set(ProblemKind::input, error.what());
  }
}

void WindowLoop::write_state() {
  if (options_.state_file.empty()) return;
  const std::string text = state_text(bench_);
  if (text == written_state_) return;
  write_file_atomically(options_.state_file, text);
  written_state_ = text;
}

/// A slider pulled to and fro over its whole range, as with the mouse: what a frame of it costs.
void WindowLoop::drag_by_itself() {
  if (!is_dragging_itself()) return;
  bench_.document.begin_edit();
  Settings settings = bench_.document.settings();
  const Field& field = *find_param(settings, options_.drag_key, "--drag").field;
  const double share = 0.5 + 0.45 * std::sin(0.1 * drag_frame_);
  const double value = field.slider.low * std::pow(field.slider.high / field.slider.low, share);
  const bool whole = field.type == FieldType::integer;
  bench_.document.change(options_.drag_key,
                         whole ? Value(static_cast<int>(value)) : Value(static_cast<float>(value)));
  ++drag_frame_;
  if (is_dragging_itself()) return;
  bench_.document.end_edit();
  bench_.requests.close = true;
}

void WindowLoop::run() {
  window_.show();
  const auto start = std::chrono::steady_clock::now();
  int frames = 0;
  while (!window_.wants_to_close()) {
    wait();
    if (!has_frames_to_draw()) continue;
    drag_by_itself();
    draw_frame();
    --frames_wanted_;
    ++frames;
    const bool waits_for_times = bench_.viewer.timer.is_waiting() || bench_.viewer.has_late();
    if (waits_for_times && frames_wanted_ <= 0 && !bench_.document.is_editing()) frames_wanted_ = 1;
    if (gui_.is_measuring()) frames_wanted_ = std::max(frames_wanted_, 1);
  }
  if (options_.drag_frames > 0) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    print_out("{} frames, {:.1f} ms each, {:.1f} a second\n", frames, 1e3 * seconds / frames,
              frames / seconds);
  }
  window_.hide();  // the end of a study's cell may take a moment
  bench_.studies.stop();
  write_state();
  if (options_.drag_frames == 0) keeping_.close(bench_.document, bench_.layout);
}

/// Left to itself glibc learns to keep large blocks: a mesh that went would leave its memory taken.
void give_large_blocks_back() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 4 << 20);
  mallopt(M_TRIM_THRESHOLD, 1 << 20);
#endif
}

}  // namespace

void run_window(const WindowOptions& options) {
  give_large_blocks_back();
  WindowLoop loop(options);
  loop.run();
}

}  // namespace inkbench
