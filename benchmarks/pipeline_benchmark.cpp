// SPDX-License-Identifier: MIT
// What a frame and each kind of change cost, on the paper's scene at 512, 1024 and 2048 px squared. Figures
// are only comparable within one run; the passes run are counted beside the times.
#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <filesystem>

#include "pipeline/base/files.h"
#include "pipeline/export.h"
#include "pipeline/gl/context.h"
#include "pipeline/pipeline.h"
#include "pipeline/settings/settings_file.h"

namespace {

using namespace inkbench;

/// One context and pipeline for all benchmarks, since making them is not what is timed.
struct Bench {
  HeadlessContext context;
  Pipeline pipeline;
  Settings settings = load_settings(project_file("data/scenes/paper.toml"));
};

Bench& bench() {
  static Bench instance;
  return instance;
}

Settings& prepare(const benchmark::State& state) {
  Settings& settings = bench().settings;
  settings.image.width = settings.image.height = static_cast<int>(state.range(0));
  bench().pipeline.at(settings).draw(BufferName::final);
  glFinish();
  return settings;
}

long runs() {
  long total = 0;
  for (const auto& [name, count] : bench().pipeline.counts()) total += count.runs;
  return total;
}

/// Times drawing the final image after `change` of the settings, which is given the iteration's number.
template <class Change>
void time_change(benchmark::State& state, Change&& change) {
  Settings& settings = prepare(state);
  const long before = runs();
  int i = 0;
  for ([[maybe_unused]] auto _ : state) {
    change(settings, ++i);
    bench().pipeline.at(settings).draw(BufferName::final);
    glFinish();
  }
  state.counters["passes"] = static_cast<double>(runs() - before) / static_cast<double>(state.iterations());
}

void whole_frame_from_nothing(benchmark::State& state) {
  time_change(state, [](Settings&, int) { bench().pipeline.forget_results(); });
}

void k_change(benchmark::State& state) {
  time_change(state,
              [](Settings& s, int i) { s.combine.k_depth = 0.003F + 1e-5F * static_cast<float>(i % 100); });
}

void ramp_change(benchmark::State& state) {
  time_change(state, [](Settings& s, int i) {
    s.ramp.diffuse.stops[1].position = 0.1F + 1e-3F * static_cast<float>(i % 100);
  });
}

void camera_change(benchmark::State& state) {
  time_change(state, [](Settings& s, int i) { s.camera.eye.x = 2.4F + 1e-4F * static_cast<float>(i % 100); });
}

void unchanged(benchmark::State& state) {
  time_change(state, [](Settings&, int) {});
}

/// All textures' pictures of a frame that did not change: what the window asks for each time it draws itself.
void unchanged_pictures(benchmark::State& state) {
  const Frame frame = bench().pipeline.at(prepare(state));
  const auto show = [&] {
    for (const BufferName buffer : all_buffers()) {
      if (buffer.info().shown_as != ShownAs::drawing) frame.picture_texture(buffer);
    }
  };
  show();
  for ([[maybe_unused]] auto _ : state) show();
}

/// A k change, read back, encoded and written: what a cell of a k sweep costs without any overlap.
void study_cell(benchmark::State& state) {
  Settings& settings = prepare(state);
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "inkbench_benchmark_cell.png";
  int i = 0;
  for ([[maybe_unused]] auto _ : state) {
    settings.combine.k_normal = 0.0125F + 1e-5F * static_cast<float>(++i % 100);
    write_png(file, bench().pipeline.at(settings).picture(BufferName::final),
              export_text(settings, BufferName::final));
  }
  settings.combine.k_normal = 0.0125F;
  std::filesystem::remove(file);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(512)
      ->Arg(1024)
      ->Arg(2048)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
}

BENCHMARK(whole_frame_from_nothing)->Apply(sizes);
BENCHMARK(k_change)->Apply(sizes);
BENCHMARK(ramp_change)->Apply(sizes);
BENCHMARK(camera_change)->Apply(sizes);
BENCHMARK(unchanged)->Apply(sizes);
BENCHMARK(unchanged_pictures)->Apply(sizes);
BENCHMARK(study_cell)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
