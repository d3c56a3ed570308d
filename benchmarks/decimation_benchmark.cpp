// SPDX-License-Identifier: MIT
// What a recording costs beside OpenMesh's own decimation to the same count, and what a level costs. On the
// rabbit; the figures are only comparable within one run. For the limits: record / openmesh_quadrics
// at most 1.3, level at most 10 ms.
#include <benchmark/benchmark.h>

#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/levels/collapse_record_file.h"
#include "pipeline/mesh/levels/decimation.h"
#include "pipeline/mesh/levels/level_normals.h"
#include "pipeline/mesh/shapes/primitives.h"

namespace {

using namespace inkbench;

const Mesh& rabbit() {
  static const Mesh mesh = load_mesh_file(find_rabbit(), {.smooth_below_deg = 180.0});
  return mesh;
}

const CollapseRecord& rabbit_record() {
  static const CollapseRecord record = record_collapses(rabbit());
  return record;
}

void record(benchmark::State& state) {
  rabbit();
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(record_collapses(rabbit()));
}

void direct(benchmark::State& state, DecimationRules rules) {
  const size_t faces = rabbit_record().faces.back();
  for ([[maybe_unused]] auto _ : state) {
    const auto triangles = decimate_directly(rabbit(), faces, rules);
    state.counters["faces"] = static_cast<double>(triangles.size());
  }
}

void level(benchmark::State& state, LevelNormals normals) {
  const auto faces = static_cast<size_t>(state.range(0));
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(level_with_normals(rabbit(), rabbit_record(), faces, normals));
}

/// As for a mesh that is not a level: every normal is looked up on the surface.
void look_up_nearest(benchmark::State& state) {
  const NearestNormals nearest(rabbit());
  Mesh mesh = mesh_at_level(rabbit(), rabbit_record(), static_cast<size_t>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) apply_nearest_normals(mesh, nearest);
}

void nearest_tree(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(NearestNormals(rabbit()));
}

void read_cached(benchmark::State& state) {
  const Key key = collapse_record_key(rabbit());
  const std::string bytes = write_collapse_record(rabbit_record(), key);
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(read_collapse_record(bytes, rabbit(), collapse_record_key(rabbit())));
  state.counters["bytes"] = static_cast<double>(bytes.size());
}

void record_a_million(benchmark::State& state) {
  const Mesh torus = make_torus(500, 0.35F);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(record_collapses(torus));
  state.counters["faces"] = static_cast<double>(torus.triangles.size());
}

}  // namespace

BENCHMARK(record)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(direct, openmesh_quadrics, DecimationRules::quadrics)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(direct, openmesh_quadrics_no_flip, DecimationRules::quadrics_no_flip)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(level, smooth, LevelNormals::smooth)
    ->Arg(69000)
    ->Arg(10000)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(level, flat, LevelNormals::flat)
    ->Arg(69000)
    ->Arg(10000)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(level, nearest, LevelNormals::nearest)
    ->Arg(69000)
    ->Arg(10000)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(look_up_nearest)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(nearest_tree)->Unit(benchmark::kMillisecond);
BENCHMARK(read_cached)->Unit(benchmark::kMillisecond);
BENCHMARK(record_a_million)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_MAIN();
