// SPDX-License-Identifier: MIT
#include "pipeline/mesh/shapes/primitives.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace inkbench {
namespace {

constexpr double kPi = std::numbers::pi;

uint32_t add_vertex(Mesh& mesh, const glm::dvec3& position, const glm::dvec3& normal) {
  mesh.positions.emplace_back(position);
  mesh.normals.emplace_back(normal);
  return static_cast<uint32_t>(mesh.positions.size() - 1);
}

void add_quad(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

/// A square of side 1 around `centre`, spanned by unit vectors; its normal is `right` x `up`.
void add_square(Mesh& mesh, const glm::dvec3& centre, const glm::dvec3& right, const glm::dvec3& up,
                int segments) {
  const auto row = static_cast<uint32_t>(segments + 1);
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  for (int j = 0; j <= segments; ++j) {
    for (int i = 0; i <= segments; ++i) {
      const double u = static_cast<double>(i) / segments - 0.5;
      const double v = static_cast<double>(j) / segments - 0.5;
      add_vertex(mesh, centre + u * right + v * up, glm::cross(right, up));
    }
  }
  for (uint32_t j = 0; j + 1 < row; ++j) {
    for (uint32_t i = 0; i + 1 < row; ++i) {
      const uint32_t corner = first + j * row + i;
      add_quad(mesh, corner, corner + 1, corner + row + 1, corner + row);
    }
  }
}

/// The unit direction at `polar` from +y, `around` y from +z towards +x.
glm::dvec3 direction(double polar, double around) {
  return {std::sin(polar) * std::sin(around), std::cos(polar), std::sin(polar) * std::cos(around)};
}

}  // namespace

Mesh make_box(int segments) {
  assert(segments >= 1);
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 normal(0.0);
    glm::dvec3 right(0.0);
    glm::dvec3 up(0.0);
    normal[axis] = right[(axis + 1) % 3] = up[(axis + 2) % 3] = 1.0;
    add_square(mesh, 0.5 * normal, right, up, segments);
    add_square(mesh, -0.5 * normal, up, right, segments);
  }
  return mesh;
}

Mesh make_plane(int segments) {
  assert(segments >= 1);
  Mesh mesh;
  add_square(mesh, glm::dvec3(0.0), {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, segments);
  return mesh;
}

Mesh make_sphere(int segments) {
  assert(segments >= 1);
  const int rings = std::max(segments, 2);
  const int sectors = std::max(2 * segments, 3);
  Mesh mesh;
  const uint32_t north = add_vertex(mesh, {0.0, 1.0, 0.0}, {0.0, 1.0, 0.0});
  const uint32_t south = add_vertex(mesh, {0.0, -1.0, 0.0}, {0.0, -1.0, 0.0});
  for (int ring = 1; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      const glm::dvec3 normal = direction(kPi * ring / rings, 2.0 * kPi * sector / sectors);
      add_vertex(mesh, normal, normal);
    }
  }
  const auto at = [&](int ring, int sector) {
    return static_cast<uint32_t>(2 + (ring - 1) * sectors + sector % sectors);
  };
  for (int sector = 0; sector < sectors; ++sector) {
    mesh.triangles.push_back({north, at(1, sector), at(1, sector + 1)});
    for (int ring = 1; ring + 1 < rings; ++ring) {
      add_quad(mesh, at(ring, sector), at(ring + 1, sector), at(ring + 1, sector + 1), at(ring, sector + 1));
    }
    mesh.triangles.push_back({south, at(rings - 1, sector + 1), at(rings - 1, sector)});
  }
  return mesh;
}

Mesh make_inside_out_sphere(int segments) {
  Mesh mesh = make_sphere(segments);
  for (glm::vec3& normal : mesh.normals) normal = -normal;
  for (std::array<uint32_t, 3>& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

Mesh make_torus(int segments, float tube) {
  assert(segments >= 1 && tube > 0.0F && tube < 1.0F);
  const int sectors = std::max(2 * segments, 3);
  const int sides = std::max(segments, 3);
  Mesh mesh;
  for (int sector = 0; sector < sectors; ++sector) {
    const double around = 2.0 * kPi * sector / sectors;
    const glm::dvec3 outwards(std::sin(around), 0.0, std::cos(around));
    for (int side = 0; side < sides; ++side) {
      const double angle = 2.0 * kPi * side / sides;
      const glm::dvec3 normal = std::cos(angle) * outwards + glm::dvec3(0.0, std::sin(angle), 0.0);
      add_vertex(mesh, outwards + static_cast<double>(tube) * normal, normal);
    }
  }
  const auto at = [&](int sector, int side) {
    return static_cast<uint32_t>(sector % sectors * sides + side % sides);
  };
  for (int sector = 0; sector < sectors; ++sector) {
    for (int side = 0; side < sides; ++side) {
      add_quad(mesh, at(sector, side), at(sector + 1, side), at(sector + 1, side + 1), at(sector, side + 1));
    }
  }
  return mesh;
}

}  // namespace inkbench
