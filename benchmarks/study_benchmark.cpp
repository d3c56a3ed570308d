// SPDX-License-Identifier: MIT
// What a whole study costs beside its cells: a K sweep of the paper's scene, first its pictures drawn and
// written alone, then as a study with grid, report page and all, in turn. Counters: both times, and their
// ratio in wall time and in processor time, which at most 1.3 is asked of; `resumed`, the seconds of a run
// that finds all finished.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>

#include "pipeline/base/files.h"
#include "pipeline/base/worker_pool.h"
#include "pipeline/export.h"
#include "pipeline/gl/context.h"
#include "pipeline/pipeline.h"
#include "studies/sweep/run_study.h"

namespace {

using namespace inkbench;

struct Cost {
  double wall_s = 0, cpu_s = 0;
};

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) { return time.tv_sec + time.tv_usec * 1e-6; };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

template <class Action>
Cost cost_of(Action&& action) {
  const auto start = std::chrono::steady_clock::now();
  const double cpu = cpu_seconds();
  action();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          cpu_seconds() - cpu};
}

StudySpec k_sweep(int side_px, int columns, int rows) {
  const auto axis = [](const char* key, int count) {
    return fmt::format(
        "[[axis]]\nkey = \"combine.{}\"\nfrom = 0.001\nto = 0.05\ncount = {}\nscale = \"log\"\n", key, count);
  };
  const std::string text = fmt::format("title = \"K\"\nscene = \"{}\"\nsize = [{}, {}]\n",
                                       project_file("data/scenes/paper.toml").string(), side_px, side_px) +
                           axis("k_depth", columns) + axis("k_normal", rows);
  return parse_spec(text, "study_benchmark.toml", {});
}

/// As `run_study` draws and writes them, without tables, grid and page.
void draw_cells(const StudySpec& spec, const fs::path& folder) {
  Pipeline pipeline;
  make_folder(folder);
  const size_t threads = std::clamp<size_t>(std::thread::hardware_concurrency(), 1, 8);
  WorkerPool encoders(threads, 2 * threads);
  for (const CellView& place : run_order(pipeline, spec)) {
    const Settings settings = view_settings(spec, make_cell(spec, place.cell), place.view);
    const Frame frame = pipeline.at(settings);
    const auto picture = std::make_shared<Picture>(frame.picture(BufferName::final));
    benchmark::DoNotOptimize(frame.raw(BufferName::lines));  // whose ink is counted
    encoders.add([&folder, place, settings, picture] {
      write_png(folder / (std::to_string(place.cell) + ".png"), *picture,
                export_text(settings, BufferName::final));
    });
  }
  encoders.wait();
}

void run_whole(const StudySpec& spec, const fs::path& folder) {
  Pipeline pipeline;
  StudyOptions options;
  options.folder = folder;
  run_study(pipeline, spec, options);
}

void study(benchmark::State& state, int side_px, int columns, int rows) {
  const HeadlessContext context;
  const StudySpec spec = k_sweep(side_px, columns, rows);
  const fs::path folder = fs::temp_directory_path() / fmt::format("study_benchmark_{}", getpid());
  Cost cells, whole, resumed;
  for (auto _ : state) {
    fs::remove_all(folder);
    cells = cost_of([&] { draw_cells(spec, folder / "cells_alone"); });
    whole = cost_of([&] { run_whole(spec, folder / "whole"); });
    resumed = cost_of([&] { run_whole(spec, folder / "whole"); });
    state.SetIterationTime(whole.wall_s);
  }
  fs::remove_all(folder);
  state.counters["cells"] = cells.wall_s;
  state.counters["ratio"] = whole.wall_s / cells.wall_s;
  state.counters["ratio_cpu"] = whole.cpu_s / cells.cpu_s;
  state.counters["resumed"] = resumed.wall_s;
}

BENCHMARK_CAPTURE(study, of_120_cells_of_1024px, 1024, 12, 10)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(study, of_576_cells_of_512px, 512, 24, 24)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace

BENCHMARK_MAIN();
