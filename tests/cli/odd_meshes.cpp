// SPDX-License-Identifier: MIT
#include "tests/cli/odd_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/mesh/shapes/primitives.h"

namespace inkbench {
namespace {

using Triangle = std::array<uint32_t, 3>;

Mesh joined(Mesh a, const Mesh& b, const glm::vec3& offset) {
  const auto base = static_cast<uint32_t>(a.positions.size());
  for (const glm::vec3& p : b.positions) a.positions.push_back(p + offset);
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  return a;
}

Mesh bowl() {
  Mesh mesh = make_sphere(16);
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](uint32_t vertex) { return mesh.positions[vertex].y > 0.3F; });
  });
  return mesh;
}

Mesh hundred_boxes() {
  const Mesh box = make_box(1);
  Mesh many;
  for (int i = 0; i < 100; ++i)
    many = joined(std::move(many), box,
                  {1.7F * static_cast<float>(i % 10), 0, 1.7F * static_cast<float>(i / 10)});
  return many;
}

/// Three half planes around one axis.
Mesh three_sheets() {
  const Mesh plane = make_plane(8);
  Mesh sheets;
  for (int i = 0; i < 3; ++i) {
    Mesh sheet = plane;
    const float angle = 2.0943951F * static_cast<float>(i);
    for (glm::vec3& p : sheet.positions)
      p = {p.x, (p.z + 0.5F) * std::cos(angle), (p.z + 0.5F) * std::sin(angle)};
    sheets = joined(std::move(sheets), sheet, glm::vec3(0));
  }
  return sheets;
}

/// Two closed cones with one tip.
Mesh two_cones() {
  constexpr uint32_t kSides = 24;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}};
  for (const float height : {1.0F, -1.0F}) {
    const auto base = static_cast<uint32_t>(mesh.positions.size());
    for (uint32_t i = 0; i < kSides; ++i) {
      const float angle = 6.2831853F * static_cast<float>(i) / kSides;
      mesh.positions.emplace_back(std::cos(angle), height, std::sin(angle));
    }
    const uint32_t middle = base + kSides;
    mesh.positions.emplace_back(0, height, 0);
    for (uint32_t i = 0; i < kSides; ++i) {
      uint32_t a = base + i, b = base + (i + 1) % kSides;
      if (height < 0) std::swap(a, b);
      mesh.triangles.push_back({0, b, a});
      mesh.triangles.push_back({middle, a, b});
    }
  }
  return mesh;
}

/// As STL text, each corner of each facet up to a float's step wrong.
std::string rounded_stl(const Mesh& mesh) {
  std::string text = "solid x\n";
  uint32_t random = 1;
  for (const Triangle& t : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const uint32_t vertex : t) {
      text += "vertex";
      for (int axis = 0; axis < 3; ++axis) {
        random = random * 1664525U + 1013904223U;
        const float value = mesh.positions[vertex][axis];
        text += fmt::format(" {:.9g}", (random >> 16) % 2 == 0 ? value : std::nextafter(value, 2.0F));
      }
      text += '\n';
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid x\n";
}

Mesh with_flat_faces() {
  Mesh mesh = make_box(4);
  mesh.triangles.push_back({0, 1, 2});  // three in a row
  mesh.triangles.push_back({3, 3, 4});
  return mesh;
}

/// Every face once more: the same, or turned over as the back of a sheet.
Mesh doubled(Mesh mesh, bool turned) {
  const size_t count = mesh.triangles.size();
  for (size_t i = 0; i < count; ++i) {
    Triangle t = mesh.triangles[i];
    if (turned) std::swap(t[0], t[1]);
    mesh.triangles.push_back(t);
  }
  return mesh;
}

Mesh with_turned_faces(Mesh mesh, size_t every) {
  for (size_t i = 0; i < mesh.triangles.size(); i += every)
    std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
  return mesh;
}

OddMesh odd(const std::string& name, const Mesh& mesh, const std::string& note = "") {
  return {name, obj_of(mesh), mesh.triangles.size(), note};
}

}  // namespace

std::string obj_of(const Mesh& mesh) {
  std::string text;
  for (const glm::vec3& p : mesh.positions) text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
  for (const Triangle& t : mesh.triangles) text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

std::vector<OddMesh> odd_meshes() {
  const Mesh torus = make_torus(16, 0.35F), box = make_box(4);
  const std::string nan = "v nan 0 0\nf 1 2 " + std::to_string(box.positions.size() + 1) + "\n";
  return {
      odd("bowl.obj", bowl(), "isolated"),
      odd("boxes.obj", hundred_boxes()),
      odd("sheets.obj", three_sheets(), "non-manifold"),
      odd("cones.obj", two_cones(), "inwards"),
      {"rounded.stl", rounded_stl(torus), torus.triangles.size(), "that rounding alone kept apart"},
      {"flat.obj", obj_of(with_flat_faces()), box.triangles.size(), "Dropped 2 faces without area"},
      {"one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", 1, ""},
      odd("doubled.obj", doubled(torus, false), "non-manifold"),
      odd("two_sided.obj", doubled(bowl(), true), "non-manifold"),
      {"nan.obj", obj_of(box) + nan, box.triangles.size(), "Dropped 1 face with a corner at NaN"},
      odd("inside_out.obj", with_turned_faces(torus, 1), "inwards"),
      odd("mixed.obj", with_turned_faces(torus, 3), "lay against the neighbours"),
  };
}

std::vector<OddMesh> hopeless_meshes() {
  return {
      {"all_flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3\nf 2 3 4\nf 1 1 2\n", 0, "without area"},
      {"all_nan.obj", "v nan 0 0\nv 0 nan 0\nv 0 0 nan\nf 1 2 3\n", 0, "NaN"},
      {"one_point.stl",
       "solid x\nfacet normal 0 0 1\nouter loop\nvertex 5 5 5\nvertex 5 5 5\nvertex 5 5 "
       "5\nendloop\nendfacet\nendsolid x\n",
       0, "without area"},
  };
}

}  // namespace inkbench
