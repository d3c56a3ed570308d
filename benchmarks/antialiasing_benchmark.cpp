// SPDX-License-Identifier: MIT
// The paper's question 5.2 in numbers (docs/antialiasing.md): lines aliased, supersampled and by coverage,
// with how far they are from what they should cover and what the final picture costs.
//
//   antialiasing_benchmark [SIDE_PX=1024] [ROUNDS=3]
//
// On a ball and a turned box the outlines are known exactly. Ways take turns, and each counts with its
// fastest run, since machines are shared; errors are in display values, 0 to 255.
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/gl/context.h"
#include "pipeline/passes/gbuffer/meshes.h"
#include "pipeline/pipeline.h"
#include "pipeline/settings/settings_file.h"
#include "studies/judging/drawing_meter.h"

namespace {

using namespace inkbench;
using Clock = std::chrono::steady_clock;

constexpr int kCheapRuns = 4;  // a round, of ways that take little time
constexpr int kSamples = 32;   // a side of a pixel, for exact coverage

struct Way {
  std::string name;
  bool antialias;
  int supersample;
};
const std::vector<Way> kWays{{"aliased", false, 1},        {"supersampled 2", false, 2},
                             {"supersampled 4", false, 4}, {"supersampled 8", false, 8},
                             {"coverage", true, 1},        {"coverage, supersampled 2", true, 2}};

/// The distance in px of a place in the image (y down) to the nearest line; outlines run `inside_px` within.
using LineDistance = std::function<double(const glm::dvec2& place, double inside_px)>;

struct Scene {
  std::string name;
  Settings settings;
  LineDistance distance;  ///< None where it is not known.
};

Settings object_alone(int side_px, Shape shape) {
  Settings settings;
  settings.image.width = settings.image.height = side_px;
  settings.camera.eye = {0.3F, 0.4F, 5.0F};
  settings.camera.target = {0.0F, 0.0F, 0.0F};
  settings.models = {
      {.name = "object", .shape = shape, .segments = shape == Shape::box ? 1 : 512, .size = 2.0F}};
  settings.lights = {LightParams{.name = "sun", .direction = {0.4F, 0.9F, 0.5F}}};
  return settings;
}

/// Looked at through its middle, so that its outline is a circle.
Scene ball_scene(int side_px) {
  const Settings settings = object_alone(side_px, Shape::sphere);
  const double away = glm::length(glm::dvec3(settings.camera.eye)), sine = 1.0 / away;
  const double px_per_tangent = 1.0 / pixel_size(settings.camera, 1.0, side_px);
  const double radius_px = px_per_tangent * sine / std::sqrt(1.0 - sine * sine);
  return {"a ball", settings, [=](const glm::dvec2& place, double inside_px) {
            return std::abs(glm::length(place - glm::dvec2(0.5 * side_px)) - (radius_px - inside_px));
          }};
}

struct Segment {
  glm::dvec2 from, to;
  glm::dvec2 inwards;  ///< Zero for creases.
};

double distance_to(const Segment& segment, const glm::dvec2& place, double inside_px) {
  const glm::dvec2 from = segment.from + inside_px * segment.inwards, along = segment.to - segment.from;
  const double t = std::clamp(glm::dot(place - from, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::length(place - (from + t * along));
}

/// The edges of the box of a draw item that are seen.
std::vector<Segment> box_segments(const Settings& settings, const glm::mat4& model_to_world) {
  const int side_px = settings.image.height;
  const glm::dmat4 to_clip(glm::dmat4(projection_matrix(settings.camera, 1.0F)) *
                           glm::dmat4(view_matrix(settings.camera)) * glm::dmat4(model_to_world));
  const glm::dvec3 eye(glm::inverse(glm::dmat4(model_to_world)) * glm::dvec4(settings.camera.eye, 1.0));
  const auto image_place = [&](const glm::dvec3& corner) {
    const glm::dvec4 clip = to_clip * glm::dvec4(corner, 1.0);
    return (0.5 + glm::dvec2(0.5, -0.5) * glm::dvec2(clip.x, clip.y) / clip.w) * double(side_px);
  };
  const glm::dvec2 middle = image_place(glm::dvec3(0.0));
  std::vector<Segment> segments;
  for (int i = 0; i < 12; ++i) {
    const int axis = i % 3, u = (axis + 1) % 3, v = (axis + 2) % 3;
    glm::dvec3 from(0.0);
    from[u] = (i / 3) % 2 == 0 ? -0.5 : 0.5;
    from[v] = i / 6 == 0 ? -0.5 : 0.5;
    glm::dvec3 to = from;
    from[axis] = -0.5;
    to[axis] = 0.5;
    const bool sees_u = eye[u] * from[u] > 0.25, sees_v = eye[v] * from[v] > 0.25;
    if (!sees_u && !sees_v) continue;
    Segment segment{image_place(from), image_place(to), glm::dvec2(0.0)};
    if (sees_u != sees_v) {
      const glm::dvec2 along = glm::normalize(segment.to - segment.from), across(-along.y, along.x);
      segment.inwards = glm::dot(middle - segment.from, across) > 0.0 ? across : -across;
    }
    segments.push_back(segment);
  }
  return segments;
}

Scene box_scene(Pipeline& pipeline, int side_px) {
  Settings settings = object_alone(side_px, Shape::box);
  settings.models[0].rotation = {20.0F, 33.0F, 11.0F};
  const std::vector<Segment> segments =
      box_segments(settings, pipeline.at(settings).draw_items().front().model_to_world);
  return {"a turned box", settings, [segments](const glm::dvec2& place, double inside_px) {
            double nearest = std::numeric_limits<double>::max();
            for (const Segment& segment : segments)
              nearest = std::min(nearest, distance_to(segment, place, inside_px));
            return nearest;
          }};
}

Image exact_coverage(const Scene& scene, double inside_px) {
  const ImageParams& image = scene.settings.image;
  const double half_px = 0.5 * scene.settings.line.width;
  Image coverage(image.width, image.height, 1);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (scene.distance({x + 0.5, y + 0.5}, inside_px) > half_px + 0.75) continue;
      int covered = 0;
      for (int s = 0; s < kSamples * kSamples; ++s) {
        const glm::dvec2 place(x + (s % kSamples + 0.5) / kSamples, y + (s / kSamples + 0.5) / kSamples);
        covered += scene.distance(place, inside_px) <= half_px ? 1 : 0;
      }
      coverage.at(x, y) = static_cast<float>(covered) / (kSamples * kSamples);
    }
  }
  return coverage;
}

double mean_of(const Image& image) {
  double sum = 0;
  for (const float value : image.samples) sum += value;
  return sum / static_cast<double>(image.samples.size());
}

/// RMS in display values near lines.
std::string error_text(const std::optional<double>& rms) {
  return rms ? fmt::format("{:6.1f}", 255.0 * *rms) : "     -";
}

double drawing_ms(Pipeline& pipeline, const Settings& settings) {
  pipeline.forget_results();
  pipeline.at(settings).value<MeshesPass>();
  glFinish();
  const auto start = Clock::now();
  pipeline.at(settings).picture_texture(BufferName::final);
  glFinish();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

Settings with(Settings settings, const Way& way) {
  settings.line.antialias = way.antialias;
  settings.image.supersample = way.supersample;
  return settings;
}

void print_scene(Pipeline& pipeline, const Scene& scene, int rounds) {
  std::vector<double> ms(kWays.size(), std::numeric_limits<double>::max());
  for (int round = 0; round < rounds; ++round) {
    for (size_t i = 0; i < kWays.size(); ++i) {
      for (int run = 0; run < (kWays[i].supersample > 2 ? 1 : kCheapRuns); ++run)
        ms[i] = std::min(ms[i], drawing_ms(pipeline, with(scene.settings, kWays[i])));
    }
  }
  MeasureNeeds needs;
  needs.antialiasing = true;
  DrawingMeter meter(pipeline, needs);
  fmt::print("\n{}\n{:<26}{:>10}{:>10}{:>8}{:>10}{:>8}\n", scene.name, "", "same lines", "outline", "ink %",
             "ms", "times");
  for (size_t i = 0; i < kWays.size(); ++i) {
    const Frame frame = pipeline.at(with(scene.settings, kWays[i]));
    const Image drawn = drawn_coverage(frame);
    const auto tally = meter.tally(frame).antialiasing;
    std::optional<double> outline;
    if (scene.distance) {
      const Image exact = exact_coverage(scene, 0.5 / kWays[i].supersample);
      outline = tally_antialiasing(drawn, drawn, exact).drawn_rms();
    }
    fmt::print("{:<26}{:>10}{:>10}{:8.2f}{:10.1f}{:8.2f}\n", kWays[i].name,
               error_text(tally ? tally->drawn_rms() : std::nullopt), error_text(outline),
               100.0 * mean_of(drawn), ms[i], ms[i] / ms[0]);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  const HeadlessContext context;
  Pipeline pipeline;
  const int side_px = argc > 1 ? std::atoi(argv[1]) : 1024, rounds = argc > 2 ? std::atoi(argv[2]) : 3;
  std::vector<Scene> scenes{ball_scene(side_px),
                            box_scene(pipeline, side_px),
                            {"the paper's scene", load_settings(project_file("data/scenes/paper.toml")), {}}};
  for (Scene& scene : scenes) {
    scene.settings.image.width = scene.settings.image.height = side_px;
    scene.settings.edges.method = EdgeMethod::dihedral;
  }
  scenes.push_back(scenes.back());
  scenes.back().name = "the paper's scene by its own method";
  scenes.back().settings.edges.method = EdgeMethod::paper;
  fmt::print("{}, {} x {} px\n", renderer_info().renderer, side_px, side_px);
  for (const Scene& scene : scenes) print_scene(pipeline, scene, rounds);
  return 0;
} catch (const Error& error) {
  fmt::print(stderr, "antialiasing_benchmark: {}\n", error.what());
  return 1;
}
