// SPDX-License-Identifier: MIT
// What measuring costs, on one core: the full set for 1024 x 1024 maps of the paper's scene (rabbit and box),
// drawn with the paper's parameters and scored against the same scene with another k_normal; against itself
// shifted, and turned by 2 degrees, which is the hardest for the matching; and the parts of the first.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "pipeline/base/files.h"
#include "pipeline/gl/context.h"
#include "pipeline/lines/thinning.h"
#include "pipeline/pipeline.h"
#include "pipeline/settings/settings_file.h"
#include "studies/measures/components.h"
#include "studies/measures/distance.h"
#include "studies/measures/matching.h"
#include "studies/measures/measures.h"

namespace {

using namespace inkbench;

constexpr int kSidePx = 1024;

LineMap drawn_lines(Pipeline& pipeline, const Settings& settings) {
  return line_map_from(pipeline.at(settings).raw(BufferName::lines));
}

/// Moved by `shift_px` to the right and turned about the middle.
LineMap moved(const LineMap& map, double shift_px, double degrees) {
  const double angle = degrees * std::numbers::pi / 180, middle = kSidePx / 2.0;
  LineMap result(kSidePx, kSidePx);
  for (int y = 0; y < kSidePx; ++y) {
    for (int x = 0; x < kSidePx; ++x) {
      const double dx = x - middle - shift_px, dy = y - middle;
      const auto from_x = static_cast<int>(std::lround(middle + std::cos(angle) * dx - std::sin(angle) * dy));
      const auto from_y = static_cast<int>(std::lround(middle + std::sin(angle) * dx + std::cos(angle) * dy));
      if (map.contains(from_x, from_y) && map.at(from_x, from_y)) result.set(x, y);
    }
  }
  return result;
}

struct Maps {
  LineMap prediction, other_k, shifted, turned;
  LineMap thin_prediction, thin_other_k;

  Maps() {
    const HeadlessContext context;
    Pipeline pipeline;
    Settings settings = load_settings(project_file("data/scenes/paper.toml"));
    settings.image.width = settings.image.height = kSidePx;
    prediction = drawn_lines(pipeline, settings);
    settings.combine.k_normal = 0.025F;
    other_k = drawn_lines(pipeline, settings);
    shifted = moved(prediction, 2, 0);
    turned = moved(prediction, 0, 2);
    thin_prediction = counted_lines(prediction);
    thin_other_k = counted_lines(other_k);
  }
};

const Maps& maps() {
  static const Maps instance;
  return instance;
}

void full_set(benchmark::State& state, LineMap Maps::*reference) {
  const LineMap& prediction = maps().prediction;
  DrawingTally tally;
  for (auto _ : state) {
    tally = tally_maps({.prediction = prediction, .reference = maps().*reference});
    benchmark::DoNotOptimize(measures_json(measures_of_maps(), tally));
  }
  state.counters["ink_px"] = static_cast<double>(prediction.count());
  state.counters["predicted"] = static_cast<double>(tally.lines.predicted);
  state.counters["referenced"] = static_cast<double>(tally.lines.referenced);
  state.counters["f1"] = *find_measure("f1")->value(tally);
}

void matching(benchmark::State& state, double tolerance_px) {
  int64_t pairs = 0;
  for (auto _ : state) pairs = matched_count(maps().thin_prediction, maps().thin_other_k, tolerance_px);
  state.counters["pairs"] = static_cast<double>(pairs);
}

void thinning(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(thinned(maps().prediction));
}

void near_distance_map(benchmark::State& state) {
  std::vector<uint8_t> distances;
  for (auto _ : state) {
    near_distances(maps().thin_prediction, 0, kSidePx, distances);
    benchmark::DoNotOptimize(distances.data());
  }
}

void components(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(component_count(maps().thin_prediction));
}

BENCHMARK_CAPTURE(full_set, against_other_k, &Maps::other_k)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(full_set, against_itself_shifted, &Maps::shifted)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(full_set, against_itself_turned, &Maps::turned)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(matching, at_1px, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(matching, at_2px, 2.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(matching, at_diagonal, diagonal_tolerance_px(kSidePx, kSidePx))
    ->Unit(benchmark::kMillisecond);
BENCHMARK(thinning)->Unit(benchmark::kMillisecond);
BENCHMARK(near_distance_map)->Unit(benchmark::kMillisecond);
BENCHMARK(components)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
