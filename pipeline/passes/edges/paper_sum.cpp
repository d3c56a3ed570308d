// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/paper_sum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "pipeline/base/text.h"

namespace inkbench {
namespace {

/// The 3 x 3 region (3.4.4), nearest first; the weights are those of the gradient (3.4.3).
struct Neighbour {
  Offset offset;
  float weight;
};
constexpr std::array<Neighbour, 9> kRegion{{{{0, 0}, 0},
                                            {{0, -1}, 2},
                                            {{-1, 0}, 2},
                                            {{1, 0}, 2},
                                            {{0, 1}, 2},
                                            {{-1, -1}, 1},
                                            {{1, -1}, 1},
                                            {{-1, 1}, 1},
                                            {{1, 1}, 1}}};

bool is_inside(const Image& image, int x, int y) {
  return x >= 0 && x < image.width_px && y >= 0 && y < image.height_px;
}

/// shaders/range.frag and one term of shaders/combine.frag. Neighbours outside the image, which the shader
/// clamps to pixels that it has seen already, change nothing.
TermWhy term(const Image& edges, float k, bool used, int x, int y) {
  TermWhy why{.used = used, .k = k, .gmax = edges.at(x, y), .gmin = edges.at(x, y)};
  for (const auto& [offset, weight] : kRegion) {
    if (!is_inside(edges, x + offset.dx, y + offset.dy)) continue;
    const float g = edges.at(x + offset.dx, y + offset.dy);
    if (g > why.gmax) {
      why.gmax = g;
      why.max_at = offset;
    }
    if (g < why.gmin) {
      why.gmin = g;
      why.min_at = offset;
    }
  }
  why.ratio = (why.gmax - why.gmin) / k;
  why.p = used ? std::min(why.ratio * why.ratio, 1.0F) : 0.0F;
  return why;
}

float mean_difference(const Image& map, int x, int y, int other_x, int other_y) {
  float sum = 0;
  for (int c = 0; c < map.channels; ++c) sum += std::abs(map.at(other_x, other_y, c) - map.at(x, y, c));
  return sum / static_cast<float>(map.channels);
}

glm::vec3 normal_at(const Image& map, int x, int y) {
  return 2.0F * glm::vec3(map.at(x, y, 0), map.at(x, y, 1), map.at(x, y, 2)) - 1.0F;
}

float angle_between(const glm::vec3& a, const glm::vec3& b) {
  const float lengths = glm::length(a) * glm::length(b);
  if (lengths <= 0.0F) return 0.0F;  // where no model is
  return glm::degrees(std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0F, 1.0F)));
}

float stored(float edge, Precision precision) {
  return precision == Precision::unorm8 ? std::round(edge * 255.0F) / 255.0F : edge;
}

std::string number(float value) {
  return fmt::format("{:.4g}", value);
}

std::string object_name(int object, std::span<const std::string> names) {
  if (object == 0) return "the background";
  const auto index = static_cast<size_t>(object) - 1;
  return index < names.size() ? names[index] : fmt::format("object {}", object);
}

}  // namespace

GradientStep step_between_pixels(const SurfaceMaps& maps, int x, int y, Offset to) {
  const int other_x = x + to.dx;
  const int other_y = y + to.dy;
  GradientStep step{.to = to};
  if (maps.depth != nullptr) {
    step.from_depth = maps.depth->at(x, y);
    step.to_depth = maps.depth->at(other_x, other_y);
  }
  if (maps.normal != nullptr) {
    step.angle_deg = angle_between(normal_at(*maps.normal, x, y), normal_at(*maps.normal, other_x, other_y));
  }
  if (maps.object_id != nullptr) {
    step.from_object = static_cast<int>(maps.object_id->at(x, y));
    step.to_object = static_cast<int>(maps.object_id->at(other_x, other_y));
  }
  return step;
}

std::optional<GradientStep> largest_step(const SurfaceMaps& maps, const Image& map, int x, int y) {
  float total = 0;
  float largest = 0;
  Offset to;
  for (const auto& [offset, weight] : kRegion) {
    if (!is_inside(map, x + offset.dx, y + offset.dy)) continue;
    const float part = weight * mean_difference(map, x, y, x + offset.dx, y + offset.dy);
    total += part;
    if (part <= largest) continue;
    largest = part;
    to = offset;
  }
  if (!(largest > 0)) return std::nullopt;
  GradientStep step = step_between_pixels(maps, x, y, to);
  step.share = largest / total;
  return step;
}

PixelWhy why_pixel(const EdgeBuffers& buffers, const CombineParams& params, int x, int y,
                   Precision precision) {
  assert(is_inside(buffers.depth_edges, x, y));
  PixelWhy why{.x = x, .y = y, .threshold = params.threshold};
  why.depth = term(buffers.depth_edges, params.k_depth, params.use_depth, x, y);
  why.normal = term(buffers.normal_edges, params.k_normal, params.use_normal, x, y);
  const auto step_of = [&](const TermWhy& part, const Image* map) -> std::optional<GradientStep> {
    if (map == nullptr) return std::nullopt;
    return largest_step(buffers.surfaces(), *map, x + part.max_at.dx, y + part.max_at.dy);
  };
  why.depth.step = step_of(why.depth, buffers.depth);
  why.normal.step = step_of(why.normal, buffers.normal);
  why.sum = why.depth.p + why.normal.p;
  why.edge = why.sum < params.threshold ? 0.0F : stored(std::min(why.sum, 1.0F), precision);
  why.inked = why.edge != 0.0F;
  return why;
}

std::string verdict_text(const PixelWhy& why) {
  const bool is_close = number(why.sum) == number(why.threshold);  // four digits would not tell them apart
  const std::string sum =
      fmt::format("the sum of the terms, {},", is_close ? shortest(why.sum) : number(why.sum));
  if (why.inked)
    return fmt::format("A line, because {} reaches the threshold {}.", sum, shortest(why.threshold));
  if (why.sum < why.threshold)
    return fmt::format("No line, because {} is below the threshold {}.", sum, shortest(why.threshold));
  if (why.sum > 0) return fmt::format("No line: {} rounds to 0 in eight bits.", sum);
  return "No line, because both terms are 0.";
}

std::string cause_text(const GradientStep& step, bool is_depth, std::span<const std::string> names) {
  std::string text =
      is_depth ? fmt::format("a step in depth from {} to {}", number(step.from_depth), number(step.to_depth))
               : fmt::format("normals {:.0f} degrees apart", step.angle_deg);
  if (step.from_object != step.to_object) {
    text += fmt::format(" between {} and {}", object_name(step.from_object, names),
                        object_name(step.to_object, names));
  }
  return text;
}

}  // namespace inkbench
