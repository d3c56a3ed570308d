// SPDX-License-Identifier: MIT
#include "studies/sweep/run_study.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/forced_end.h"
#include "pipeline/base/log.h"
#include "pipeline/base/stop.h"
#include "pipeline/base/worker_pool.h"
#include "pipeline/export.h"
#include "pipeline/lines/drawing.h"
#include "pipeline/passes/lines/reference.h"
#include "studies/judging/cause_finder.h"
#include "studies/judging/drawing_meter.h"
#include "studies/measures/curve_text.h"
#include "studies/sweep/cell_keys.h"
#include "studies/sweep/cell_tiles.h"
#include "studies/sweep/manifest.h"
#include "studies/sweep/number_columns.h"
#include "studies/sweep/study_curves.h"
#include "studies/sweep/study_folder.h"
#include "studies/sweep/study_grid.h"
#include "studies/sweep/study_page.h"
#include "studies/sweep/view_frames.h"

namespace inkbench {
namespace {

constexpr const char* kOutOfMemory = "out of memory; choose smaller images or meshes";

/// What was drawn of one view of a cell, on its way to the disk.
struct DrawnView {
  CellView place;
  Settings settings;
  std::vector<Picture> pictures;  ///< One for each shown buffer.
  bool is_kept = false;           ///< Its pictures lie on the disk already, and none are here.
  std::vector<UsedFile> files;    ///< That the pictures are made from.
};

/// A cell of which not all views are stored.
struct OpenCell {
  DrawingTally tally;
  std::vector<std::string> overlays;  ///< By view, where lines are found; empty until it is drawn.
  size_t stored = 0;
  bool failed = false;
};

class StudyRun {
 public:
  StudyRun(Pipeline& pipeline, const StudySpec& spec, const StudyOptions& options)
      : pipeline_(pipeline),
        spec_(spec),
        options_(options),
        origin_(options.origin ? *options.origin : this_origin()),
        folder_(spec, options.folder, all_keys(), origin_, options.fresh) {
    for (const std::string& note : folder_.notes()) log_note(note);
    result_.progress.total = cell_count(spec);
    result_.progress.done = folder_.done_count();
  }

  StudyResult run() {
    const ForcedEndAction at_forced_end([folder = folder_.path()] { mark_stopped(folder); });
    try {
      return run_to_the_end();
    } catch (...) {
      write_stopped();
      throw;
    }
  }

 private:
  StudyResult run_to_the_end() {
    pipeline_.check_room(spec_.base.image);
    write_manifest("running");
    draw_cells();
    if (fatal_) std::rethrow_exception(fatal_);
    folder_.finish();
    std::sort(failures_.begin(), failures_.end());
    for (const auto& [index, text] : failures_) result_.failures.push_back(text);
    pipeline_.forget_results();  // room for the grid, so that it does not set the study's peak
    if (!result_.stopped) write_report_or_stop();
    result_.progress.seconds = seconds();
    write_manifest(result_.stopped ? "stopped" : "finished");
    return std::move(result_);
  }

  /// After a failure, of which a full disk is the likeliest.
  void write_stopped() noexcept {
    try {
      write_manifest("stopped");
    } catch (const std::exception&) {
      mark_stopped(folder_.path());
    }
  }

  void write_manifest(const std::string& state) const {
    inkbench::write_manifest(folder_.path(), spec_, made_by(spec_, options_.extras), result_, state);
  }

  std::vector<CellKeys> all_keys() {
    std::vector<CellKeys> keys;
    for (size_t i = 0; i < cell_count(spec_); ++i) {
      stop_if_asked();
      keys.push_back(cell_keys(pipeline_, spec_, make_cell(spec_, i), origin_));
    }
    return keys;
  }

  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  bool should_stop() const {
    const std::lock_guard lock(mutex_);
    return fatal_ || stop_asked() || (options_.stop != nullptr && *options_.stop) ||
           (options_.fail_fast && result_.progress.failed > 0);
  }

  void write_report_or_stop() {
    try {
      write_report();
    } catch (const Stopped&) {
      result_.stopped = true;
    }
  }

  void write_report() {
    result_.charts = options_.extras.charts;
    for (DrawnChart& chart : draw_study_charts(spec_, folder_.path(), result_.failures))
      result_.charts.push_back(std::move(chart));
    if (spec_.curves) draw_curve_charts();
    StudyPageWriter page(
        spec_, folder_,
        {made_by(spec_, options_.extras), renderer_info().renderer, study_versions(), options_.extras},
        result_.charts, tiles_);
    tiles_.keep_missing(folder_);
    result_.grids = write_study_grid(spec_, folder_, [&](size_t cell, size_t shown) {
      KeptPicture kept = tiles_.get(folder_, cell, shown);
      page.add(cell, shown, kept);
      return kept;
    });
    add_frames_beside_the_grid(page);
    result_.page = page.write(result_.grids);
    result_.pictures_decoded = tiles_.decoded();
    tiles_.remove_others();
  }

  void draw_curve_charts() {
    for (DrawnChart& chart : draw_study_curves(spec_, folder_, result_.failures))
      result_.charts.push_back(std::move(chart));
  }

  /// The page shows every frame of a path.
  void add_frames_beside_the_grid(StudyPageWriter& page) {
    for (const size_t cell : folder_.done_cells()) {
      for (size_t shown = 0; shown < picture_count(spec_); ++shown) {
        if (is_in_grid(spec_, shown)) continue;
        stop_if_asked();
        page.add(cell, shown, tiles_.get(folder_, cell, shown));
      }
    }
  }

  void draw_cells() {
    const size_t threads = std::clamp<size_t>(std::thread::hardware_concurrency(), 1, 8);
    WorkerPool encoders(threads, 2 * threads);
    for (const CellView& place : run_order(pipeline_, spec_)) {
      if (folder_.is_done(place.cell) || has_failed(place.cell)) continue;
      if (should_stop()) {
        result_.stopped = true;
        break;
      }
      try {
        auto drawn = std::make_shared<DrawnView>(draw(place));
        encoders.add([this, drawn] { store(*drawn); });
      } catch (const Stopped&) {
        result_.stopped = true;
        break;
      } catch (const Error& error) {
        fail(place.cell, error.what());
      } catch (const std::bad_alloc&) {
        fail(place.cell, kOutOfMemory);
      }
    }
    encoders.wait();
  }

  bool has_failed(size_t index) const {
    const std::lock_guard lock(mutex_);
    const auto open = open_.find(index);
    return open != open_.end() && open->second.failed;
  }

  DrawnView draw(const CellView& place) {
    const ViewFrame at = frames_.at(make_cell(spec_, place.cell), place.view);
    const Frame& frame = at.frame;
    DrawnView drawn{place, frame.settings(), {}};
    drawn.is_kept = folder_.work(place.cell) == CellWork::measure;
    for (const BufferName buffer : spec_.show) {
      if (!drawn.is_kept) drawn.pictures.push_back(frame.picture(buffer));
    }
    if (!drawn.is_kept) drawn.files = frame.used_files();
    const DrawingTally tally = meter_.tally(frame, at.past());
    const std::string overlay = finds_lines(spec_) ? write_overlay(frame) : "";
    const std::string causes = finds_causes(spec_) ? write_causes(frame) : "";
    const std::lock_guard lock(mutex_);
    OpenCell& open = open_[place.cell];
    open.overlays.resize(overlay_count(spec_));
    if (!overlay.empty()) open.overlays[place.view] = overlay;
    if (!causes.empty()) open.overlays[(finds_lines(spec_) ? view_count(spec_) : 0) + place.view] = causes;
    open.tally.add(tally);
    return drawn;
  }

  /// Cells of equal geometry and camera share a file.
  std::string write_overlay(const Frame& frame) {
    const std::string name = "reference/" + frame.key(BufferName::reference).text().substr(0, 16) + ".svg";
    if (overlays_.contains(name)) return name;
    write_file_atomically(folder_.path() / name, reference_svg(*frame.value<ReferencePass>()), Sync::later);
    overlays_.insert(name);
    return name;
  }

  /// Of the view that was tallied last.
  std::string write_causes(const Frame& frame) {
    const std::string name = "causes/" + causes_key(frame).text().substr(0, 16) + ".png";
    if (overlays_.contains(name)) return name;
    write_png(folder_.path() / name, cause_overlay(*meter_.last_causes()), {}, Sync::later);
    overlays_.insert(name);
    return name;
  }

  /// On an encoder's thread.
  void store(const DrawnView& drawn) {
    const size_t index = drawn.place.cell;
    try {
      for (size_t i = 0; i < drawn.pictures.size(); ++i) {
        const std::string file = folder_.cell_file(index, drawn.place.view, spec_.show[i]);
        write_png(folder_.path() / file, drawn.pictures[i],
                  export_text(drawn.settings, spec_.show[i], drawn.files), Sync::later);
        tiles_.keep(index, drawn.place.view * spec_.show.size() + i, drawn.pictures[i],
                    record_file(folder_.path(), file).hash);
      }
      if (std::optional<OpenCell> whole = note_stored(index)) {
        if (spec_.curves) whole->overlays.back() = write_curve(index, *whole->tally.strengths);
        folder_.add(index, cell_numbers(spec_, whole->tally), whole->overlays);
        report(drawn.is_kept ? CellEnd::measured : CellEnd::drawn);
      }
    } catch (const Error& error) {
      fail(index, error.what());
    } catch (const std::bad_alloc&) {
      fail(index, kOutOfMemory);
    }
  }

  std::string write_curve(size_t index, const StrengthCurve& curve) const {
    const std::string name = folder_.curve_file(index);
    write_file_atomically(folder_.path() / name, whole_curve_csv(curve), Sync::later);
    return name;
  }

  /// The cell, once all of its views are stored.
  std::optional<OpenCell> note_stored(size_t index) {
    const std::lock_guard lock(mutex_);
    OpenCell& open = open_.at(index);
    if (++open.stored < view_count(spec_) || open.failed) return std::nullopt;
    OpenCell whole = std::move(open);
    open_.erase(index);
    return whole;
  }

  /// A cell fails once, whichever of its views was the first.
  void fail(size_t index, const std::string& message) {
    {
      const std::lock_guard lock(mutex_);
      if (std::exchange(open_[index].failed, true)) return;
      const std::string name = make_cell(spec_, index).name;
      failures_.emplace_back(index, "cell " + std::to_string(index + 1) +
                                        (name.empty() ? "" : " (" + name + ")") + ": " + message);
    }
    try {
      folder_.add_failure(index, message);
    } catch (const Error&) {
      const std::lock_guard lock(mutex_);
      if (!fatal_) fatal_ = std::current_exception();  // not even the failure can be written down
    }
    report(CellEnd::failed);
  }

  enum class CellEnd { drawn, measured, failed };

  void report(CellEnd end) {
    const std::lock_guard lock(mutex_);
    StudyProgress& progress = result_.progress;
    ++(end == CellEnd::failed ? progress.failed : progress.done);
    progress.drawn += end == CellEnd::drawn ? 1 : 0;
    progress.measured += end == CellEnd::measured ? 1 : 0;
    progress.seconds = seconds();
    if (options_.on_progress) options_.on_progress(progress);
  }

  Pipeline& pipeline_;
  const StudySpec& spec_;
  ViewFrames frames_{pipeline_, spec_};
  DrawingMeter meter_{pipeline_, needs_of(spec_)};
  const StudyOptions& options_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  ResultOrigin origin_;
  StudyFolder folder_;
  CellTiles tiles_{spec_, folder_.path() / "tiles"};
  StudyResult result_;
  std::map<size_t, OpenCell> open_;
  std::set<std::string> overlays_;  ///< Written in this run.
  std::vector<std::pair<size_t, std::string>> failures_;
  std::exception_ptr fatal_;
  mutable std::mutex mutex_;
};

}  // namespace

StudyResult run_study(Pipeline& pipeline, const StudySpec& spec, const StudyOptions& options) {
  return StudyRun(pipeline, spec, options).run();
}

}  // namespace inkbench
