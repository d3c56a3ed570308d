#include "studies/sweep/run_study.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <thread>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/export.h"
#include "pipeline/scene/settings_file.h"
#include "studies/reference/buffer_source.h"
#include "studies/sweep/cell_numbers.h"
#include "studies/sweep/manifest.h"
#include "studies/sweep/study_folder.h"
#include "studies/sweep/study_grid.h"
#include "studies/sweep/worker_pool.h"

namespace inkbench {
namespace {

/// What was drawn of one cell, on its way to the disk.
struct DrawnCell {
  size_t index = 0;
  std::string name;
  Settings settings;
  std::vector<Picture> pictures;  ///< One for each shown buffer.
  std::vector<std::string> numbers;
};

Key cell_key(Pipeline& pipeline, const StudySpec& spec, const Settings& settings) {
  const PassKeys keys = pipeline.keys(settings);
  KeyBuilder builder;
  builder.add(INKBENCH_VERSION).add(settings_text(settings)).add(keys.picture);
  for (const Key& key : {keys.ink, keys.blinn_phong, keys.quantise}) builder.add(key);
  for (const BufferName buffer : spec.show) builder.add(name_of(buffer));
  for (const std::string& measure : spec.measures) builder.add(measure);
  return builder.key();
}

class StudyRun {
 public:
  StudyRun(Pipeline& pipeline, const StudySpec& spec, const StudyOptions& options)
      : pipeline_(pipeline),
        spec_(spec),
        options_(options),
        folder_(spec, options.folder, cell_keys(), options.fresh) {
    result_.progress.total = cell_count(spec);
    result_.progress.done = folder_.done_count();
  }

  StudyResult run() {
    write_manifest(folder_.path(), spec_, result_, "running");
    draw_cells();
    if (fatal_) std::rethrow_exception(fatal_);
    folder_.finish();
    std::sort(failures_.begin(), failures_.end());
    for (const auto& [index, text] : failures_) result_.failures.push_back(text);
    pipeline_.forget_results();  // room for the grid, so that it does not set the study's peak
    if (!result_.stopped) result_.grids = write_study_grid(spec_, folder_);
    if (!result_.stopped) result_.charts = draw_study_charts(spec_, folder_.path(), result_.failures);
    result_.progress.seconds = seconds();
    write_manifest(folder_.path(), spec_, result_, result_.stopped ? "stopped" : "finished");
    return std::move(result_);
  }

 private:
  std::vector<Key> cell_keys() {
    std::vector<Key> keys;
    for (size_t i = 0; i < cell_count(spec_); ++i) {
      keys.push_back(cell_key(pipeline_, spec_, cell_settings(spec_, make_cell(spec_, i))));
    }
    return keys;
  }

  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  bool should_stop() const {
    const std::lock_guard lock(mutex_);
    return fatal_ || (options_.stop != nullptr && *options_.stop) ||
           (options_.fail_fast && result_.progress.failed > 0);
  }

  void draw_cells() {
    const size_t threads = std::clamp<size_t>(std::thread::hardware_concurrency(), 1, 8);
    WorkerPool encoders(threads, threads);
    for (const size_t index : run_order(pipeline_, spec_)) {
      if (folder_.is_done(index)) continue;
      if (should_stop()) {
        result_.stopped = true;
        break;
      }
      const Cell cell = make_cell(spec_, index);
      try {
        auto drawn = std::make_shared<DrawnCell>(draw(cell));
        encoders.add([this, drawn] { store(*drawn); });
      } catch (const Error& error) {
        fail(index, cell.name, error.what());
      }
    }
    encoders.wait();
  }

  DrawnCell draw(const Cell& cell) {
    DrawnCell drawn{cell.index, cell.name, cell_settings(spec_, cell), {}, {}};
    for (const BufferName buffer : spec_.show)
      drawn.pictures.push_back(buffers_.picture(drawn.settings, buffer));
    drawn.numbers = meter_.numbers(drawn.settings);
    return drawn;
  }

  /// On an encoder's thread.
  void store(const DrawnCell& drawn) {
    try {
      for (size_t i = 0; i < spec_.show.size(); ++i) {
        write_png(folder_.path() / folder_.cell_file(drawn.index, spec_.show[i]), drawn.pictures[i],
                  export_text(drawn.settings, spec_.show[i]));
      }
      folder_.add(drawn.index, drawn.numbers);
      report(true);
    } catch (const Error& error) {
      fail(drawn.index, drawn.name, error.what());
    }
  }

  void fail(size_t index, const std::string& name, const std::string& message) {
    try {
      folder_.add_failure(index, message);
    } catch (const Error&) {
      const std::lock_guard lock(mutex_);
      if (!fatal_) fatal_ = std::current_exception();  // not even the failure can be written down
    }
    {
      const std::lock_guard lock(mutex_);
      failures_.emplace_back(index, "cell " + std::to_string(index + 1) +
                                        (name.empty() ? "" : " (" + name + ")") + ": " + message);
    }
    report(false);
  }

  void report(bool success) {
    const std::lock_guard lock(mutex_);
    StudyProgress& progress = result_.progress;
    ++(success ? progress.done : progress.failed);
    progress.drawn += success ? 1 : 0;
    progress.seconds = seconds();
    if (options_.on_progress) options_.on_progress(progress);
  }

  Pipeline& pipeline_;
  BufferSource buffers_{pipeline_};
  const StudySpec& spec_;
  CellMeter meter_{buffers_, spec_};
  const StudyOptions& options_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  StudyFolder folder_;
  StudyResult result_;
  std::vector<std::pair<size_t, std::string>> failures_;
  std::exception_ptr fatal_;
  mutable std::mutex mutex_;
};

}  // namespace

StudyResult run_study(Pipeline& pipeline, const StudySpec& spec, const StudyOptions& options) {
  return StudyRun(pipeline, spec, options).run();
}

}  // namespace inkbench
