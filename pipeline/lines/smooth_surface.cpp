// SPDX-License-Identifier: MIT
#include "pipeline/lines/smooth_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numeric>

#include "pipeline/lines/face_shape.h"
#include "pipeline/lines/mesh_lines.h"
#include "pipeline/mesh/triangle_edges.h"

namespace inkbench {
namespace {

using Face = std::array<uint32_t, 3>;

// ---- Parts: corners of faces that are one point of one smooth part.

uint32_t corner_at(const MeshTopology& topology, uint32_t face, uint32_t point) {
  const Face& corners = topology.faces[face];
  return 3 * face + (corners[0] == point ? 0 : corners[1] == point ? 1 : 2);
}

/// 1 where the surface goes on smoothly across an edge.
std::vector<uint8_t> smooth_edges(const MeshTopology& topology, double crease_angle_deg,
                                  const glm::dmat3& stretch) {
  std::vector<uint8_t> smooth(topology.edges.size());
  for (size_t e = 0; e < smooth.size(); ++e) {
    const auto uses = topology.uses_of(topology.edges[e]);
    smooth[e] = uses.size() == 2 && consistent(uses[0], uses[1]) ? 1 : 0;
  }
  for (const uint32_t crease : crease_edges(topology, crease_angle_deg, stretch)) smooth[crease] = 0;
  return smooth;
}

void split_into_parts(const MeshTopology& topology, const std::vector<uint8_t>& smooth,
                      const glm::dmat3& stretch, SmoothSurface& surface) {
  const auto corner_count = static_cast<uint32_t>(topology.faces.size() * 3);
  Forest parts(corner_count);
  for (size_t e = 0; e < smooth.size(); ++e) {
    if (smooth[e] == 0) continue;
    const auto uses = topology.uses_of(topology.edges[e]);
    for (const uint32_t point : topology.edges[e].points)
      parts.join(corner_at(topology, uses[0].face, point), corner_at(topology, uses[1].face, point));
  }
  std::vector<uint32_t> index(corner_count);
  surface.faces.resize(topology.faces.size());
  for (uint32_t corner = 0; corner < corner_count; ++corner) {
    const uint32_t root = parts.root(corner);
    if (root == corner) {
      index[corner] = static_cast<uint32_t>(surface.positions.size());
      surface.positions.push_back(stretch * topology.positions[topology.faces[corner / 3][corner % 3]]);
    }
    surface.faces[corner / 3][corner % 3] = index[root];
  }
}

/// A line goes on across an edge if both faces have the same points there: also across a crease too short to
/// part the surface.
void number_crossings(const MeshTopology& topology, SmoothSurface& surface) {
  surface.crossings = topology.face_edges;
  surface.crossing_count = static_cast<uint32_t>(topology.edges.size());
  const auto at = [&](const MeshTopology::Use& use, uint32_t point) {
    const uint32_t corner = corner_at(topology, use.face, point);
    return surface.faces[corner / 3][corner % 3];
  };
  for (Face& crossings : surface.crossings) {
    for (uint32_t& crossing : crossings) {
      const MeshTopology::Edge& edge = topology.edges[crossing];
      const auto uses = topology.uses_of(edge);
      const bool goes_on = uses.size() == 2 && at(uses[0], edge.points[0]) == at(uses[1], edge.points[0]) &&
                           at(uses[0], edge.points[1]) == at(uses[1], edge.points[1]);
      if (!goes_on) crossing = surface.crossing_count++;
    }
  }
}

void collect_point_faces(SmoothSurface& surface) {
  surface.face_starts.assign(surface.positions.size() + 1, 0);
  for (const Face& face : surface.faces) {
    for (const uint32_t point : face) ++surface.face_starts[point + 1];
  }
  std::partial_sum(surface.face_starts.begin(), surface.face_starts.end(), surface.face_starts.begin());
  std::vector<uint32_t> filled(surface.face_starts.begin(), surface.face_starts.end() - 1);
  surface.point_faces.resize(3 * surface.faces.size());
  for (uint32_t f = 0; f < surface.faces.size(); ++f) {
    for (const uint32_t point : surface.faces[f]) surface.point_faces[filled[point]++] = f;
  }
}

// ---- Normals and curvature, not smoothed.

glm::dvec3 unit_or(const glm::dvec3& vector, const glm::dvec3& otherwise) {
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : otherwise;
}

void find_normals(SmoothSurface& surface) {
  surface.normals.assign(surface.positions.size(), glm::dvec3(0.0));
  for (const Face& face : surface.faces) {
    const FaceShape shape = shape_of(surface, face);
    for (size_t i = 0; i < 3; ++i) {
      const double in = glm::dot(shape.edges[(i + 2) % 3], shape.edges[(i + 2) % 3]);
      const double out = glm::dot(shape.edges[i], shape.edges[i]);
      surface.normals[face[i]] += shape.normal / (in * out);
    }
  }
  for (glm::dvec3& normal : surface.normals) normal = unit_or(normal, {0.0, 1.0, 0.0});
}

void add_product(SymmetricTensor& tensor, double weight, const glm::dvec3& a, const glm::dvec3& b) {
  const std::array<double, 6> product{a.x * b.x, (a.x * b.y + a.y * b.x) / 2, (a.x * b.z + a.z * b.x) / 2,
                                      a.y * b.y, (a.y * b.z + a.z * b.y) / 2, a.z * b.z};
  for (size_t i = 0; i < 6; ++i) tensor[i] += weight * product[i];
}

/// Curvature along u, along v and of both, which explains best how the normals differ along the edges.
glm::dvec3 fit_curvature(const SmoothSurface& surface, const Face& face, const FaceShape& shape,
                         const glm::dvec3& u, const glm::dvec3& v) {
  glm::dmat3 products(0.0);
  glm::dvec3 right(0.0);
  for (size_t i = 0; i < 3; ++i) {
    const double along_u = glm::dot(shape.edges[i], u);
    const double along_v = glm::dot(shape.edges[i], v);
    const glm::dvec3 change = surface.normals[face[(i + 1) % 3]] - surface.normals[face[i]];
    const double change_u = glm::dot(change, u);
    const double change_v = glm::dot(change, v);
    products[0][0] += along_u * along_u;
    products[0][1] += along_u * along_v;
    products[2][2] += along_v * along_v;
    right += glm::dvec3(change_u * along_u, change_u * along_v + change_v * along_u, change_v * along_v);
  }
  products[1][0] = products[1][2] = products[2][1] = products[0][1];
  products[1][1] = products[0][0] + products[2][2];
  return glm::inverse(products) * right;
}

/// The direction of the face's plane that becomes `direction` when the plane is turned onto the point's.
glm::dvec3 turned(const glm::dvec3& direction, const glm::dvec3& from, const glm::dvec3& to) {
  const double cosine = glm::dot(from, to);
  if (cosine <= -0.999) return -direction;
  const glm::dvec3 axis_part = from + to;
  return direction - axis_part * (glm::dot(to, direction) / (1.0 + cosine));
}

void find_curvature(SmoothSurface& surface) {
  surface.curvature.assign(surface.positions.size(), SymmetricTensor{});
  std::vector<double> weights(surface.positions.size(), 0.0);
  for (const Face& face : surface.faces) {
    const FaceShape shape = shape_of(surface, face);
    const double area = glm::length(shape.normal);
    const double longest =
        std::max({glm::length(shape.edges[0]), glm::length(shape.edges[1]), glm::length(shape.edges[2])});
    // A needle's normals say nothing about the curvature across it.
    if (!(area > 1e-6 * longest * longest)) continue;
    const glm::dvec3 normal = shape.normal / area;
    const glm::dvec3 u = glm::normalize(shape.edges[0]);
    const glm::dvec3 v = glm::cross(normal, u);
    const glm::dvec3 fit = fit_curvature(surface, face, shape, u, v);
    for (const uint32_t point : face) {
      const glm::dvec3 turned_u = turned(u, normal, surface.normals[point]);
      const glm::dvec3 turned_v = turned(v, normal, surface.normals[point]);
      add_product(surface.curvature[point], area * fit[0], turned_u, turned_u);
      add_product(surface.curvature[point], area * fit[1] * 2.0, turned_u, turned_v);
      add_product(surface.curvature[point], area * fit[2], turned_v, turned_v);
      weights[point] += area;
    }
  }
  for (size_t point = 0; point < weights.size(); ++point) {
    for (double& value : surface.curvature[point]) value /= weights[point] > 0.0 ? weights[point] : 1.0;
  }
}

// ---- Smoothing.

/// Neighbours of each point with weights that sum to 1 together with the point's own.
class Averaging {
 public:
  Averaging(const SmoothSurface& surface, double mean_edge) : starts_(surface.positions.size() + 1, 0) {
    find_neighbours(surface);
    std::vector<double> areas(surface.positions.size(), 0.0);
    for (const Face& face : surface.faces) {
      const double area = glm::length(shape_of(surface, face).normal);
      for (const uint32_t point : face) areas[point] += area;
    }
    weights_.resize(neighbours_.size());
    own_.resize(surface.positions.size());
    for (size_t point = 0; point < own_.size(); ++point) {
      double sum = areas[point];
      for (uint32_t i = starts_[point]; i < starts_[point + 1]; ++i) {
        const double distance =
            glm::length(surface.positions[neighbours_[i]] - surface.positions[point]) / mean_edge;
        weights_[i] = areas[neighbours_[i]] * std::exp(-0.5 * distance * distance);
        sum += weights_[i];
      }
      const double scale = sum > 0.0 ? 1.0 / sum : 0.0;
      for (uint32_t i = starts_[point]; i < starts_[point + 1]; ++i) weights_[i] *= scale;
      own_[point] = sum > 0.0 ? areas[point] * scale : 1.0;
    }
  }

  template <class Value, class Add>
  void average(std::vector<Value>& values, std::vector<Value>& scratch, const Add& add) const {
    scratch.resize(values.size());
    for (size_t point = 0; point < values.size(); ++point) {
      Value sum{};
      add(sum, own_[point], values[point]);
      for (uint32_t i = starts_[point]; i < starts_[point + 1]; ++i)
        add(sum, weights_[i], values[neighbours_[i]]);
      scratch[point] = sum;
    }
    values.swap(scratch);
  }

 private:
  void find_neighbours(const SmoothSurface& surface) {
    std::vector<uint32_t> filled(surface.positions.size() + 1, 0);
    for (const Face& face : surface.faces) {
      for (const uint32_t point : face) filled[point + 1] += 2;
    }
    std::partial_sum(filled.begin(), filled.end(), filled.begin());
    const std::vector<uint32_t> begins = filled;
    std::vector<uint32_t> both(surface.faces.size() * 6);
    for (const Face& face : surface.faces) {
      for (size_t i = 0; i < 3; ++i) {
        both[filled[face[i]]++] = face[(i + 1) % 3];
        both[filled[face[i]]++] = face[(i + 2) % 3];
      }
    }
    for (size_t point = 0; point + 1 < begins.size(); ++point) {
      const auto begin = both.begin() + begins[point];
      const auto end = both.begin() + begins[point + 1];
      std::sort(begin, end);
      neighbours_.insert(neighbours_.end(), begin, std::unique(begin, end));
      starts_[point + 1] = static_cast<uint32_t>(neighbours_.size());
    }
  }

  std::vector<uint32_t> starts_, neighbours_;
  std::vector<double> weights_, own_;
};

double mean_edge_length(const MeshTopology& topology, const glm::dmat3& stretch) {
  double sum = 0.0;
  for (const MeshTopology::Edge& edge : topology.edges) {
    sum += glm::length(stretch * (topology.positions[edge.points[1]] - topology.positions[edge.points[0]]));
  }
  return topology.edges.empty() ? 1.0 : sum / static_cast<double>(topology.edges.size());
}

/// Variance, in squared mean edges along each axis, that one step of `Averaging` adds on a lattice of
/// equilateral triangles: six neighbours at distance 1 of weight exp(-1/2), half of it along each axis.
constexpr double kVarianceOfStep = 0.3922;

int steps_for(double smoothing) {
  return static_cast<int>(std::lround(smoothing * smoothing / kVarianceOfStep));
}

void smooth_normals_of(SmoothSurface& surface, const Averaging& averaging, int steps) {
  std::vector<glm::dvec3> scratch;
  for (int step = 0; step < steps; ++step) {
    averaging.average(surface.normals, scratch,
                      [](glm::dvec3& sum, double weight, const glm::dvec3& value) { sum += weight * value; });
    for (size_t point = 0; point < scratch.size(); ++point)
      surface.normals[point] = unit_or(surface.normals[point], scratch[point]);
  }
}

void smooth_curvature(SmoothSurface& surface, const Averaging& averaging, int steps) {
  std::vector<SymmetricTensor> scratch;
  for (int step = 0; step < steps; ++step) {
    averaging.average(surface.curvature, scratch,
                      [](SymmetricTensor& sum, double weight, const SymmetricTensor& value) {
                        for (size_t i = 0; i < 6; ++i) sum[i] += weight * value[i];
                      });
  }
}

double half_diagonal(const std::vector<glm::dvec3>& positions) {
  if (positions.empty()) return 0.0;
  glm::dvec3 low = positions[0];
  glm::dvec3 high = positions[0];
  for (const glm::dvec3& position : positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  return glm::length(high - low) / 2.0;
}

}  // namespace

double quadratic_form(const SymmetricTensor& t, const glm::dvec3& d) {
  return t[0] * d.x * d.x + t[3] * d.y * d.y + t[5] * d.z * d.z +
         2.0 * (t[1] * d.x * d.y + t[2] * d.x * d.z + t[4] * d.y * d.z);
}

SmoothSurface make_smooth_surface(const MeshTopology& topology, double crease_angle_deg, double smoothing,
                                  const glm::dmat3& stretch) {
  SmoothSurface surface;
  const std::vector<uint8_t> smooth = smooth_edges(topology, crease_angle_deg, stretch);
  split_into_parts(topology, smooth, stretch, surface);
  number_crossings(topology, surface);
  collect_point_faces(surface);
  surface.radius = half_diagonal(surface.positions);
  find_normals(surface);
  surface.point_normals = surface.normals;
  const Averaging averaging(surface, mean_edge_length(topology, stretch));
  smooth_normals_of(surface, averaging, steps_for(smoothing));
  find_curvature(surface);
  smooth_curvature(surface, averaging, steps_for(smoothing));
  return surface;
}

}  // namespace inkbench
