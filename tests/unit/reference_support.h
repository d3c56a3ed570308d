// SPDX-License-Identifier: MIT
// What tests of reference lines share: a scene of meshes, and a small rasteriser in double precision that
// gives its depth and object-id buffers without OpenGL.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "pipeline/lines/reference_lines.h"

namespace inkbench {

/// A triangle mesh from positions and triangles alone.
inline Mesh plain_mesh(std::vector<glm::vec3> positions, std::vector<std::array<uint32_t, 3>> triangles) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.normals.assign(mesh.positions.size(), {0.0F, 1.0F, 0.0F});
  mesh.triangles = std::move(triangles);
  return mesh;
}

class ReferenceScene {
 public:
  CameraParams camera;
  int width_px = 256, height_px = 256;

  /// Ids are 1, 2, ... in order.
  void add(const Mesh& mesh, const glm::mat4& model_to_world = glm::mat4(1.0F),
           const FeatureParams& params = {}) {
    topologies_.push_back(make_topology(mesh));
    features_.push_back(make_features(topologies_.back(), params));
    meshes_.push_back(
        {&topologies_.back(), model_to_world, static_cast<int>(meshes_.size()) + 1, &features_.back()});
  }

  /// Draws the buffers as the pipeline does: pixel centres, all faces, the nearest wins.
  void rasterise() {
    depth = Image(width_px, height_px, 1, 1.0F);
    object_id = Image(width_px, height_px, 1, 0.0F);
    for (const SceneMesh& mesh : meshes_) {
      const glm::dmat4 to_clip = glm::dmat4(projection_matrix(camera, aspect())) *
                                 glm::dmat4(view_matrix(camera)) * glm::dmat4(mesh.model_to_world);
      for (const std::array<uint32_t, 3>& face : mesh.topology->faces) {
        std::vector<glm::dvec4> corners;
        for (const uint32_t point : face)
          corners.push_back(to_clip * glm::dvec4(mesh.topology->positions[point], 1.0));
        draw_polygon(clip_near(corners), mesh.object_id);
      }
    }
  }

  ReferenceLines lines() {
    rasterise();
    return reference_lines(meshes_, camera, depth, object_id);
  }

  float aspect() const { return static_cast<float>(width_px) / static_cast<float>(height_px); }
  const std::vector<SceneMesh>& meshes() const { return meshes_; }

  /// Where a point of the world is in the image, and 1 / z; in orthographic views z.
  glm::dvec3 pixel_of(const glm::dvec3& world) const {
    const glm::dvec4 clip = glm::dmat4(projection_matrix(camera, aspect())) *
                            glm::dmat4(view_matrix(camera)) * glm::dvec4(world, 1.0);
    return to_pixel(clip);
  }

  Image depth, object_id;

 private:
  glm::dvec3 to_pixel(const glm::dvec4& clip) const {
    const double z = camera.near + (0.5 + 0.5 * clip.z) * (double{camera.far} - camera.near);
    return {(0.5 + 0.5 * clip.x / clip.w) * width_px, (0.5 - 0.5 * clip.y / clip.w) * height_px,
            is_orthographic(camera) ? z : 1.0 / clip.w};
  }

  static std::vector<glm::dvec4> clip_near(const std::vector<glm::dvec4>& polygon) {
    std::vector<glm::dvec4> kept;
    for (size_t i = 0; i < polygon.size(); ++i) {
      const glm::dvec4& a = polygon[i];
      const glm::dvec4& b = polygon[(i + 1) % polygon.size()];
      const double at_a = a.w + a.z;
      const double at_b = b.w + b.z;
      if (at_a >= 0.0) kept.push_back(a);
      if ((at_a < 0.0) != (at_b < 0.0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    return kept;
  }

  void draw_polygon(const std::vector<glm::dvec4>& polygon, int id) {
    std::vector<glm::dvec3> corners;
    for (const glm::dvec4& clip : polygon) corners.push_back(to_pixel(clip));
    for (size_t i = 2; i < corners.size(); ++i) draw_triangle(corners[0], corners[i - 1], corners[i], id);
  }

  void draw_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int id) {
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0.0) return;
    const auto first = [](double low) { return std::max(0, static_cast<int>(std::floor(low))); };
    const int x_end = std::min<double>(width_px, std::max({a.x, b.x, c.x}) + 1);
    const int y_end = std::min<double>(height_px, std::max({a.y, b.y, c.y}) + 1);
    for (int y = first(std::min({a.y, b.y, c.y})); y < y_end; ++y) {
      for (int x = first(std::min({a.x, b.x, c.x})); x < x_end; ++x) {
        const double u = ((b.x - x - 0.5) * (c.y - y - 0.5) - (b.y - y - 0.5) * (c.x - x - 0.5)) / area;
        const double v = ((c.x - x - 0.5) * (a.y - y - 0.5) - (c.y - y - 0.5) * (a.x - x - 0.5)) / area;
        if (u < 0.0 || v < 0.0 || u + v > 1.0) continue;
        const double third = u * a.z + v * b.z + (1.0 - u - v) * c.z;
        const auto pixel_depth =
            static_cast<float>((is_orthographic(camera) ? third : 1.0 / third) / double{camera.far});
        if (pixel_depth > 1.0F || pixel_depth >= depth.at(x, y)) continue;
        depth.at(x, y) = pixel_depth;
        object_id.at(x, y) = static_cast<float>(id);
      }
    }
  }

  std::deque<MeshTopology> topologies_;
  std::deque<MeshFeatures> features_;
  std::vector<SceneMesh> meshes_;
};

inline std::vector<Polyline> of_class(const ReferenceLines& lines, LineClass line_class) {
  std::vector<Polyline> found;
  for (const Polyline& line : lines.polylines) {
    if (line.line_class == line_class) found.push_back(line);
  }
  return found;
}

inline bool is_closed_line(const Polyline& line) {
  return line.points.size() > 2 && line.points.front() == line.points.back();
}

inline double length_of(const Polyline& line) {
  double length = 0.0;
  for (size_t i = 1; i < line.points.size(); ++i)
    length += glm::length(glm::dvec2(line.points[i]) - glm::dvec2(line.points[i - 1]));
  return length;
}

inline double total_length(const std::vector<Polyline>& lines) {
  double length = 0.0;
  for (const Polyline& line : lines) length += length_of(line);
  return length;
}

inline double distance_to_segment(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 along = b - a;
  const double squared = glm::dot(along, along);
  const double share = squared > 0.0 ? std::clamp(glm::dot(point - a, along) / squared, 0.0, 1.0) : 0.0;
  return glm::length(point - (a + share * along));
}

/// Distance to the nearest of the lines; infinite without any.
inline double distance_to(const glm::dvec2& point, const std::vector<Polyline>& lines) {
  double nearest = INFINITY;
  for (const Polyline& line : lines) {
    for (size_t i = 1; i < line.points.size(); ++i)
      nearest = std::min(nearest, distance_to_segment(point, line.points[i - 1], line.points[i]));
  }
  return nearest;
}

/// Points every half pixel along lines.
inline std::vector<glm::dvec2> points_along(const std::vector<Polyline>& lines) {
  std::vector<glm::dvec2> points;
  for (const Polyline& line : lines) {
    for (size_t i = 1; i < line.points.size(); ++i) {
      const glm::dvec2 a = line.points[i - 1];
      const glm::dvec2 b = line.points[i];
      const int steps = static_cast<int>(std::ceil(glm::length(b - a) / 0.5));
      for (int step = 0; step <= steps; ++step)
        points.push_back(a + (b - a) * (static_cast<double>(step) / std::max(steps, 1)));
    }
  }
  return points;
}

}  // namespace inkbench
