// SPDX-License-Identifier: MIT
// What the curves of a view cost, on the CPU alone:
//
//   curve_benchmark [SIDE_PX=1024] [--blender]
//
// An update is a new eye: each run moves it a little, and the fastest of ten counts, since machines are
// shared. Silhouettes, boundaries, creases and cuts, then all classes, with what covers them, of the paper's
// scene, of the rabbit alone and of a million faces; how many nodes and edges silhouettes look at as faces
// grow; with --blender the same rabbit in Blender's Line Art, in the same run.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <glm/matrix.hpp>
#include <string>

#include "pipeline/base/files.h"
#include "pipeline/curves/curve_finder.h"
#include "pipeline/lines/mesh_lines.h"
#include "pipeline/mesh/levels/model_mesh.h"
#include "pipeline/mesh/shapes/primitives.h"
#include "pipeline/settings/settings_file.h"

namespace {

using namespace inkbench;
using Clock = std::chrono::steady_clock;

constexpr int kRuns = 10;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

CurveRequest request_of(const Settings& settings, int side_px) {
  CurveRequest request{.models = {},
                       .camera = settings.camera,
                       .params = settings.curves,
                       .width_px = side_px,
                       .height_px = side_px};
  for (const ModelParams& model : settings.models) {
    if (!model.visible) continue;
    auto mesh = std::make_shared<Mesh>(make_model_mesh(model));
    const glm::mat4 to_world = model_matrix(model, bounds_of(*mesh));
    request.models.push_back(
        {mesh, KeyBuilder().add(model.name).key(), to_world, static_cast<int>(request.models.size()) + 1});
  }
  return request;
}

CurvesParams all_classes(SilhouetteKind kind) {
  CurvesParams params;
  params.silhouette = kind;
  params.suggestive = params.ridge = params.valley = params.apparent_ridge = true;
  return params;
}

double fastest_update_ms(CurveFinder& finder, CurveRequest request) {
  finder.find(request);
  double fastest = 1e9;
  for (int i = 0; i < kRuns; ++i) {
    request.camera.eye.x += 1e-3F;
    const Clock::time_point start = Clock::now();
    finder.find(request);
    fastest = std::min(fastest, ms_since(start));
  }
  return fastest;
}

/// Prints a line of the table; gives the time of the mesh's own classes.
double show(const std::string& name, CurveRequest request) {
  size_t faces = 0;
  for (const CurveRequestModel& model : request.models) faces += model.mesh->triangles.size();
  CurveFinder finder;
  const Clock::time_point start = Clock::now();
  const Curves curves = finder.find(request);
  const double first = ms_since(start);
  const double mesh_classes = fastest_update_ms(finder, request);
  request.params = all_classes(SilhouetteKind::mesh);
  const double all = fastest_update_ms(finder, request);
  request.params = all_classes(SilhouetteKind::smooth);
  const double all_smooth = fastest_update_ms(finder, request);
  fmt::print("{:<16}{:>10}{:>9}{:>11.1f}{:>14.2f}{:>13.2f}{:>15.2f}\n", name, faces, curves.curves.size(),
             first, mesh_classes, all, all_smooth);
  std::fflush(stdout);
  return mesh_classes;
}

Settings scene(const std::string& name) {
  return load_settings(project_file("data/scenes/" + name));
}

void show_growth() {
  fmt::print("\nSilhouettes of a sphere as faces grow: nodes looked at, of edges\n");
  for (const int segments : {32, 64, 128, 256, 512}) {
    const MeshTopology topology = make_topology(make_sphere(segments));
    const EdgeSilhouettes silhouettes(topology);
    const Viewpoint eye(4.0, 1.5, 2.0);
    const Clock::time_point start = Clock::now();
    const size_t found = silhouettes.find(topology, eye, false).size();
    const double by_tree = ms_since(start);
    const Clock::time_point again = Clock::now();
    const size_t brute = silhouette_edges(topology, face_facings(topology, eye)).size();
    fmt::print("  {:>8} faces {:>7} of {:>8} nodes {:>6} silhouettes{} {:>7.3f} ms, all edges {:>7.3f} ms\n",
               topology.faces.size(), silhouettes.tree.visited(eye), topology.edges.size(), found,
               found == brute ? "" : " (NOT ALL)", by_tree, ms_since(again));
  }
}

/// Of `benchmarks/blender_line_art.py`; 0 where there is no Blender.
double blender_ms(const std::string& mesh, int side_px) {
  const std::string command =
      fmt::format("blender --background --factory-startup --python {} -- {} {} 2>/dev/null | grep ^line_art",
                  project_file("benchmarks/blender_line_art.py").string(), mesh, side_px);
  std::array<char, 256> line{};
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return 0.0;
  const char* read = fgets(line.data(), line.size(), pipe);
  pclose(pipe);
  return read == nullptr ? 0.0 : std::atof(line.data() + std::string("line_art ").size());
}

}  // namespace

int main(int count, char** arguments) {
  int side_px = 1024;
  bool with_blender = false;
  for (int i = 1; i < count; ++i) {
    if (std::string(arguments[i]) == "--blender") {
      with_blender = true;
    } else {
      side_px = std::atoi(arguments[i]);
    }
  }
  fmt::print(
      "{} px; ms for an update: mesh silhouettes, boundaries, creases, cuts; all classes; the same with "
      "smooth silhouettes\n",
      side_px);
  fmt::print("{:<16}{:>10}{:>9}{:>11}{:>14}{:>13}{:>15}\n", "", "faces", "curves", "first", "mesh classes",
             "all classes", "all, smooth");
  show("paper's scene", request_of(scene("paper.toml"), side_px));
  Settings rabbit = scene("paper.toml");
  for (ModelParams& model : rabbit.models) model.visible = model.name == "rabbit";
  const double alone = show("rabbit alone", request_of(rabbit, side_px));
  if (with_blender) {
    const double line_art = blender_ms(mesh_path(std::string(kRabbit)).string(), side_px);
    fmt::print("  Blender's Line Art of the rabbit alone: {:.1f} ms, {:.1f} times as long\n", line_art,
               line_art / alone);
  }
  show("machine", request_of(scene("machine.toml"), side_px));
  Settings million = scene("subject.toml");
  main_model(million).shape = Shape::torus;
  main_model(million).segments = 500;
  show("million faces", request_of(million, side_px));
  show_growth();
}
