// SPDX-License-Identifier: MIT
// What reading a mesh file costs, beside OpenMesh's own reader of the same file in the same run: an OBJ of a
// million faces and a binary PLY of half a million, both with normals, both written by our own writer.
// `own_soup` reads to the polygon soup, `own_mesh` on to the mesh that is drawn, `bytes` the file alone.
// OpenMesh reads to a mesh of its own with half-edges. Both ratios are of interest; for OBJ openmesh_mesh /
// own_soup must be 2 at least.
#include <benchmark/benchmark.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include "pipeline/base/files.h"
#include "pipeline/base/scratch_folder.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/formats/mesh_write.h"
#include "pipeline/mesh/shapes/primitives.h"

namespace {

using namespace inkbench;

/// A torus of about `faces` faces.
Mesh torus(int faces) {
  int segments = 8;
  while (std::ssize(make_torus(segments, 0.35F).triangles) < faces) segments += segments / 8;
  return make_torus(segments, 0.35F);
}

struct Files {
  ScratchFolder folder;
  fs::path obj = folder.path() / "million.obj";
  fs::path ply = folder.path() / "half.ply";

  Files() {
    write_mesh_file(torus(1'000'000), obj, MeshFileFormat::obj);
    write_mesh_file(torus(500'000), ply, MeshFileFormat::ply);
  }
};

const fs::path& file(bool is_obj) {
  static const Files files;
  return is_obj ? files.obj : files.ply;
}

void count(benchmark::State& state, size_t faces, const fs::path& path) {
  state.counters["faces"] = static_cast<double>(faces);
  state.SetBytesProcessed(state.iterations() * static_cast<int64_t>(fs::file_size(path)));
}

void bytes(benchmark::State& state, bool is_obj) {
  const fs::path& path = file(is_obj);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(read_file(path));
  count(state, 0, path);
}

void own_soup(benchmark::State& state, bool is_obj) {
  const fs::path& path = file(is_obj);
  size_t faces = 0;
  for ([[maybe_unused]] auto _ : state) faces = read_mesh_soup(path).corner_counts.size();
  count(state, faces, path);
}

void own_mesh(benchmark::State& state, bool is_obj) {
  const fs::path& path = file(is_obj);
  size_t faces = 0;
  for ([[maybe_unused]] auto _ : state) faces = load_mesh_file(path).triangles.size();
  count(state, faces, path);
}

void openmesh_mesh(benchmark::State& state, bool is_obj) {
  const fs::path& path = file(is_obj);
  size_t faces = 0;
  for ([[maybe_unused]] auto _ : state) {
    OpenMesh::PolyMesh_ArrayKernelT<> mesh;
    mesh.request_vertex_normals();
    OpenMesh::IO::Options options(OpenMesh::IO::Options::VertexNormal);
    if (!OpenMesh::IO::read_mesh(mesh, path.string(), options))
      state.SkipWithError("OpenMesh cannot read it");
    faces = mesh.n_faces();
  }
  count(state, faces, path);
}

BENCHMARK_CAPTURE(bytes, obj, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(own_soup, obj, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(own_mesh, obj, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(openmesh_mesh, obj, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bytes, ply, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(own_soup, ply, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(own_mesh, ply, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(openmesh_mesh, ply, false)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
