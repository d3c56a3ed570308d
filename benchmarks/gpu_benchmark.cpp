// SPDX-License-Identifier: MIT
// What every pass of every method takes on the renderer that is there, by its own clock (GL_TIME_ELAPSED),
// and whether it draws as another one did; scripts/check_gpu.sh runs it on both.
//
//   gpu_benchmark [--sizes 1920x1080,3840x2160] [--runs 30] [--scene FILE] [--against FOLDER]
//   gpu_benchmark --write FOLDER
//
// Ends with 1 where a shader was never drawn with, or where pictures differ by more than `--tolerance`.
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <string>

#include "app/window/wire_painter.h"
#include "benchmarks/compared_pictures.h"
#include "benchmarks/pass_clock.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/gl/context.h"
#include "pipeline/passes/ink/coverage.h"
#include "pipeline/pipeline.h"
#include "pipeline/settings/settings_file.h"

namespace {

using namespace inkbench;
using Clock = std::chrono::steady_clock;

/// What a frame of the paper's method may take at 1920 x 1080 px on a GPU.
constexpr double kWantedFrameMs = 0.5;
constexpr int kWarmUps = 3;

struct Options {
  std::vector<std::string> sizes{"1920x1080", "3840x2160"};
  int runs = 30;
  std::string scene, write_to, against;
  double tolerance = 0.01;  ///< Share of the other renderer's line pixels.
};

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Medians in ms.
struct MethodTimes {
  std::map<std::string, double> passes;  ///< Of the frame and of the other buffers.
  double frame = 0;                      ///< The sum of a frame's passes.
  double wall = 0;                       ///< From the first command to the last pixel, textures and all.
};

bool is_texture(BufferName buffer) {
  return buffer.info().shown_as != ShownAs::drawing;
}

/// Everything that is no part of the final image.
void draw_the_rest(const Frame& frame) {
  for (const BufferName buffer : all_buffers()) {
    if (is_texture(buffer)) frame.draw(buffer);
  }
  if (frame.settings().edges.method == EdgeMethod::paper) return;  // it has no lines with a width
  frame.value<AliasedCoverage>();
  frame.value<SampledCoverage>();
}

MethodTimes time_method(Pipeline& pipeline, const Settings& settings, int runs, DrawnShaders& drawn) {
  PassClock clock(drawn);
  std::map<std::string, std::vector<double>> passes;
  std::vector<double> frames, walls;
  for (int run = -kWarmUps; run < runs; ++run) {
    pipeline.forget_results();
    glFinish();
    pipeline.observe(&clock);
    const Clock::time_point start = Clock::now();
    const Frame frame = pipeline.at(settings);
    frame.draw(BufferName::final);
    glFinish();
    const double wall = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    const std::map<std::string, double> of_frame = clock.take();
    draw_the_rest(frame);
    const std::map<std::string, double> of_rest = clock.take();
    pipeline.observe(nullptr);
    if (run < 0) continue;
    double sum = 0;
    for (const auto& [name, ms] : of_frame) sum += ms;
    frames.push_back(sum);
    walls.push_back(wall);
    for (const auto* part : {&of_frame, &of_rest})
      for (const auto& [name, ms] : *part) passes[name].push_back(ms);
  }
  MethodTimes times{{}, median(frames), median(walls)};
  for (const auto& [name, values] : passes) times.passes[name] = median(values);
  return times;
}

void print_row(const std::string& name, const std::vector<std::string>& cells) {
  fmt::print("{:<20}", name);
  for (const std::string& cell : cells) fmt::print(" {:>15}", cell);
  fmt::print("\n");
}

void time_size(Pipeline& pipeline, Settings settings, const std::string& size, int runs,
               DrawnShaders& drawn) {
  const size_t x = size.find('x');
  if (x == std::string::npos) throw input_error("--sizes", "'" + size + "' is no size", "like 1920x1080");
  settings.image.width = std::atoi(size.substr(0, x).c_str());
  settings.image.height = std::atoi(size.substr(x + 1).c_str());
  constexpr auto kMethods = ChoiceNames<EdgeMethod>::names;
  std::vector<MethodTimes> times;
  for (const std::string_view method : kMethods)
    times.push_back(time_method(pipeline, with_method(settings, method), runs, drawn));
  fmt::print("\n{} px, ms, medians of {} frames from nothing\n", size, runs);
  print_row("pass", {kMethods.begin(), kMethods.end()});
  for (const std::string& pass : pipeline.pass_names()) {
    std::vector<std::string> cells;
    for (const MethodTimes& of : times)
      cells.push_back(of.passes.contains(pass) ? fmt::format("{:.3f}", of.passes.at(pass)) : "");
    if (std::ranges::any_of(cells, [](const std::string& cell) { return !cell.empty(); }))
      print_row(pass, cells);
  }
  std::vector<std::string> frames, walls;
  for (const MethodTimes& of : times) {
    frames.push_back(fmt::format("{:.3f}", of.frame));
    walls.push_back(fmt::format("{:.3f}", of.wall));
  }
  print_row("a frame's passes", frames);
  print_row("with what waits", walls);
  if (size == "1920x1080")
    fmt::print("the paper's frame takes {:.3f} ms; wanted on a GPU: under {} ms\n", times[0].frame,
               kWantedFrameMs);
}

/// Small frames of all methods in all ways that choose shaders.
void draw_everything(Pipeline& pipeline, const Settings& start, DrawnShaders& drawn) {
  PassClock clock(drawn);
  pipeline.observe(&clock);
  for (const std::string_view method : ChoiceNames<EdgeMethod>::names) {
    for (const char* change : {"line.width=1", "line.width=9", "image.precision=unorm8",
                               "image.supersample=2", "dihedral.normals=both"}) {
      Settings settings = with_method(start, method);
      settings.image.width = 320;
      settings.image.height = 180;
      apply_assignment(settings, change);
      const Frame frame = pipeline.at(settings);
      draw_the_rest(frame);
      for (const BufferName buffer : all_buffers()) {
        if (!is_texture(buffer)) continue;
        frame.picture(buffer);
        drawn.note();
      }
      clock.take();
    }
  }
  pipeline.observe(nullptr);
}

/// What only a second frame draws.
void draw_moved(Pipeline& pipeline, Settings settings, DrawnShaders& drawn) {
  PassClock clock(drawn);
  pipeline.observe(&clock);
  const Frame before = pipeline.at(settings);
  settings.camera.eye.x += 0.1F;
  pipeline.at(settings, before).draw(BufferName::motion);
  pipeline.observe(nullptr);
}

/// What the window draws beside the pipeline.
void draw_windows_own(Pipeline& pipeline, const Settings& settings, DrawnShaders& drawn) {
  const Frame frame = pipeline.at(settings);
  WirePainter wires;
  wires.paint(frame, {{}, 64, 64});
  drawn.note();
  TilePainter tiles;
  const PictureTexture picture = frame.picture_texture(BufferName::final);
  tiles.paint("final", *picture.texture, picture.key, {}, 64, 64);
  drawn.note();
}

bool all_drawn(const DrawnShaders& drawn) {
  const std::vector<std::string> missing = drawn.missing();
  for (const std::string& name : missing) fmt::print("shaders/{} was never drawn with\n", name);
  if (missing.empty()) fmt::print("all {} shaders compiled, linked and drawn with\n", drawn.count());
  return missing.empty();
}

void print_renderer() {
  const RendererInfo info = renderer_info();
  const bool is_software = info.renderer.find("llvmpipe") != std::string::npos ||
                           info.renderer.find("softpipe") != std::string::npos;
  fmt::print("{}, {}, OpenGL {}\n", info.renderer, info.vendor, info.version);
  if (is_software) fmt::print("A software renderer: what it takes says nothing of a GPU.\n");
}

bool check(const Options& options) {
  const HeadlessContext context;
  Pipeline pipeline;
  const Settings settings = load_settings(options.scene.empty() ? project_file("data/scenes/paper.toml")
                                                                : std::filesystem::path(options.scene));
  print_renderer();
  if (!options.write_to.empty()) {
    write_pictures(pipeline, settings, options.write_to);
    return true;
  }
  DrawnShaders drawn;
  for (const std::string& size : options.sizes) time_size(pipeline, settings, size, options.runs, drawn);
  pipeline.forget_results();
  draw_everything(pipeline, settings, drawn);
  draw_moved(pipeline, settings, drawn);
  draw_windows_own(pipeline, settings, drawn);
  fmt::print("\n");
  const bool is_complete = all_drawn(drawn);
  return (options.against.empty() ||
          draws_as_written(pipeline, settings, options.against, options.tolerance)) &&
         is_complete;
}

}  // namespace

int main(int argc, char** argv) try {
  Options options;
  CLI::App app("What every pass takes on the renderer that is there, and whether it draws as another did");
  app.add_option("--sizes", options.sizes, "Image sizes to time, in px")->delimiter(',');
  app.add_option("--runs", options.runs, "Frames of each method and size")->check(CLI::Range(1, 10000));
  app.add_option("--scene", options.scene, "Scene file; the paper's without it");
  app.add_option("--write", options.write_to, "Write the pictures that are compared, and end");
  app.add_option("--against", options.against, "Folder of another renderer's pictures");
  app.add_option("--tolerance", options.tolerance, "Share of line pixels that may differ");
  CLI11_PARSE(app, argc, argv);
  return check(options) ? 0 : 1;
} catch (const Error& error) {
  fmt::print(stderr, "gpu_benchmark: {}\n", error.what());
  return 1;
}
