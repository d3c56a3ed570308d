// SPDX-License-Identifier: MIT
#include "studies/scoring/score_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <thread>

#include "pipeline/base/error.h"
#include "pipeline/base/memory_room.h"
#include "pipeline/base/stop.h"
#include "pipeline/base/text.h"
#include "pipeline/base/worker_pool.h"
#include "pipeline/strength_file.h"
#include "studies/measures/matching.h"

namespace inkbench {
namespace {

constexpr size_t kMostThreads = 16;

/// Does `work(i)` for all images, several at a time. Throws what the first image in order threw that failed.
void for_each_image(size_t count, size_t threads, const std::function<void(size_t)>& work) {
  std::mutex mutex;
  size_t failed = count;
  std::exception_ptr thrown;
  {
    WorkerPool pool(threads, 2 * threads, WorkerPriority::own);
    for (size_t i = 0; i < count; ++i) {
      pool.add([&, i] {
        {
          const std::lock_guard lock(mutex);
          if (i > failed) return;
        }
        try {
          stop_if_asked();
          work(i);
        } catch (...) {
          const std::lock_guard lock(mutex);
          if (i > failed) return;
          failed = i;
          thrown = std::current_exception();
        }
      });
    }
    pool.wait();
  }
  if (thrown) std::rethrow_exception(thrown);
}

/// One side as all of its files have it.
struct Side {
  int64_t light = 0, dark = 0, clear = 0;

  void add(const SurveyedFile& file) {
    light += file.light;
    dark += file.dark;
    clear += file.clear;
  }
  /// Lines are what there is less of; on a transparent ground, what there is more of.
  bool lines_are_dark() const {
    const bool ground_is_clear = clear >= light && clear >= dark;
    return ground_is_clear ? dark > light : light > dark;
  }
};

struct SurveyedPair {
  SurveyedFile prediction;
  std::vector<SurveyedFile> drawings;
};

std::string size_text(const SurveyedFile& file) {
  return fmt::format("{} x {}", file.width_px, file.height_px);
}

SurveyedPair survey(const ImagePair& pair) {
  SurveyedPair result{survey_strengths(pair.prediction), {}};
  for (const std::filesystem::path& path : pair.drawings) {
    const SurveyedFile& drawing = result.drawings.emplace_back(survey_drawings(path));
    const bool same =
        drawing.width_px == result.prediction.width_px && drawing.height_px == result.prediction.height_px;
    if (!same)
      throw input_error(
          pair.prediction.string(),
          fmt::format("is {}, but {} is {}", size_text(result.prediction), path.string(), size_text(drawing)),
          "both must have the same size");
  }
  return result;
}

/// Bytes, of one image at a time: its strengths as they are read, and what the matching knows of each pixel.
double memory_of(const SurveyedPair& pair) {
  constexpr double kOfStrengths = 12, kOfDrawing = 11;
  int drawings = 0;
  for (const SurveyedFile& file : pair.drawings) drawings += file.drawings;
  const double pixels = static_cast<double>(pair.prediction.width_px) * pair.prediction.height_px;
  return pixels * (kOfStrengths + kOfDrawing * drawings);
}

class CurveScorer {
 public:
  CurveScorer(const ImagePairs& pairs, const CurveScoreOptions& options)
      : pairs_(pairs.pairs), options_(options), surveyed_(pairs_.size()) {
    score_.notes = pairs.notes;
    score_.images.resize(pairs_.size());
  }

  CurveScore run() {
    for_each_image(pairs_.size(), most_threads(), [this](size_t i) { surveyed_[i] = survey(pairs_[i]); });
    decide();
    for_each_image(pairs_.size(), threads_in_room(), [this](size_t i) { count(i); });
    note_odd_curve();
    return std::move(score_);
  }

 private:
  static size_t most_threads() {
    return std::clamp<size_t>(std::thread::hardware_concurrency(), 1, kMostThreads);
  }

  /// As many as there is memory for.
  size_t threads_in_room() const {
    const auto largest =
        std::max_element(surveyed_.begin(), surveyed_.end(),
                         [](const auto& a, const auto& b) { return memory_of(a) < memory_of(b); });
    const double bytes = memory_of(*largest);
    check_memory(bytes, largest->prediction.path.string(),
                 fmt::format("scoring {} px", size_text(largest->prediction)), "choose smaller images");
    const double room = static_cast<double>(memory_room()) / bytes;
    return static_cast<size_t>(std::clamp(room, 1.0, static_cast<double>(most_threads())));
  }

  void decide() {
    Side predictions, drawings;
    for (const SurveyedPair& pair : surveyed_) {
      predictions.add(pair.prediction);
      for (const SurveyedFile& file : pair.drawings) {
        drawings.add(file);
        score_.drawings += file.drawings;
      }
    }
    score_.prediction_inverted = inverted("the predictions", predictions);
    score_.reference_inverted = inverted("the references", drawings);
  }

  bool inverted(const char* side, const Side& sums) {
    if (options_.invert != Invert::automatic) return options_.invert == Invert::yes;
    if (!sums.lines_are_dark()) return false;
    score_.notes.push_back(fmt::format(
        "{} are read as dark lines on light, all of them: {:.1f} % of them is light; --invert no takes the "
        "light",
        side,
        100 * static_cast<double>(sums.light) / static_cast<double>(sums.light + sums.dark + sums.clear)));
    return true;
  }

  /// What says itself how it reads is inverted by an express wish alone.
  bool inverted(const SurveyedFile& file, bool side) const {
    return file.says_itself ? options_.invert == Invert::yes : side;
  }

  void count(size_t i) {
    const SurveyedPair& pair = surveyed_[i];
    const StrengthLevels levels =
        levels_of(read_strengths(pair.prediction, inverted(pair.prediction, score_.prediction_inverted)));
    std::vector<TieredLines> drawings;
    for (const SurveyedFile& file : pair.drawings) {
      for (TieredLines& drawing : read_drawings(file, inverted(file, score_.reference_inverted)))
        drawings.push_back(std::move(drawing));
    }
    check_unchanged(pair, levels, drawings);
    const double diagonal_px = diagonal_tolerance_px(levels.width_px, levels.height_px);
    add(i, count_strengths(levels, drawings, options_.tolerance_px.value_or(diagonal_px)));
  }

  static void check_unchanged(const SurveyedPair& pair, const StrengthLevels& levels,
                              const std::vector<TieredLines>& drawings) {
    for (const TieredLines& drawing : drawings) {
      if (drawing.wanted.width_px() != levels.width_px || drawing.wanted.height_px() != levels.height_px)
        throw work_error(pair.prediction.path.string(), "or its drawings changed while they were read",
                         "score again");
    }
  }

  void add(size_t i, const CurveCounts& counts) {
    const int best = best_threshold(counts);
    const std::lock_guard lock(mutex_);
    score_.curve.add(counts);
    score_.images[i] = {pairs_[i].name, best, counts[best]};
    if (options_.on_progress) options_.on_progress(++done_, pairs_.size());
  }

  void note_odd_curve() {
    const CurveCounts& pooled = score_.curve.pooled();
    if (pooled[0].predicted == 0)
      score_.notes.emplace_back("the predictions have no line at any threshold: no pixel reaches 0.01");
    if (pooled[0].referenced == 0)
      score_.notes.emplace_back("the references have no line: there is no recall, and no AP");
    const bool has_one_point = pooled[0].predicted > 0 &&
                               std::all_of(pooled.begin(), pooled.end(),
                                           [&](const StrengthCounts& counts) { return counts == pooled[0]; });
    if (has_one_point)
      score_.notes.emplace_back(
          "the predictions are the same lines at every threshold: the curve is one point, and AP says "
          "nothing");
  }

  const std::vector<ImagePair>& pairs_;
  const CurveScoreOptions& options_;
  std::vector<SurveyedPair> surveyed_;
  CurveScore score_;
  size_t done_ = 0;
  std::mutex mutex_;
};

}  // namespace

CurveScore score_curve(const ImagePairs& pairs, const CurveScoreOptions& options) {
  return CurveScorer(pairs, options).run();
}

}  // namespace inkbench
