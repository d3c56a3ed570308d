// SPDX-License-Identifier: MIT
// Bytes as mesh files of every format and as raw polygons: nothing but an inkbench::Error may come out
// besides a mesh that keeps its promises. The first byte chooses: a format, a soup, or what an importing
// child process could send.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <span>

#include "pipeline/base/error.h"
#include "pipeline/base/scratch_folder.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/formats/scene_import.h"
#include "pipeline/mesh/formats/scene_transfer.h"
#include "pipeline/mesh/mesh_from_soup.h"

namespace inkbench {
namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void check_invariants(const Mesh& mesh) {
  require(!mesh.triangles.empty() && mesh.normals.size() == mesh.positions.size());
  for (const glm::vec3& position : mesh.positions) {
    require(std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z));
  }
  for (const glm::vec3& normal : mesh.normals) require(std::abs(glm::length(normal) - 1.0F) < 1e-4F);
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t vertex : triangle) require(vertex < mesh.positions.size());
  }
  const Bounds bounds = bounds_of(mesh);
  for (int axis = 0; axis < 3; ++axis) require(bounds.low[axis] <= bounds.high[axis]);
}

/// One folder for the whole run, in memory where the system has such a place. An Error ends the run.
const fs::path& scratch_folder() noexcept {
  static const ScratchFolder scratch(memory_place());
  return scratch.path();
}

void load_as(const char* name, std::span<const uint8_t> content) {
  const fs::path path = scratch_folder() / name;
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(content.data()), static_cast<std::streamsize>(content.size()));
  check_invariants(load_mesh_file(path));
}

/// A quarter of the bytes as points, the rest as faces of few corners. The first byte of the rest says
/// whether there are normals, smoothing groups, and what the format means.
PolygonSoup soup_of(std::span<const uint8_t> bytes) {
  PolygonSoup soup;
  soup.points.resize(bytes.size() / 4 / sizeof(glm::dvec3));
  if (!soup.points.empty())
    std::memcpy(soup.points.data(), bytes.data(), soup.points.size() * sizeof(glm::dvec3));
  bytes = bytes.subspan(soup.points.size() * sizeof(glm::dvec3));
  const uint8_t flags = bytes.empty() ? 0 : bytes[0];
  soup.corners_are_rounded = (flags & 2) != 0;
  soup.is_flat = (flags & 4) != 0;
  while (!bytes.empty()) {
    const size_t corners = std::min<size_t>(bytes[0] % 8, bytes.size() - 1);
    for (const uint8_t index : bytes.subspan(1, corners)) soup.corners.push_back(static_cast<int8_t>(index));
    soup.corner_counts.push_back(static_cast<uint32_t>(corners));
    if ((flags & 8) != 0) soup.smoothing_groups.push_back(bytes[0] / 64);
    bytes = bytes.subspan(1 + corners);
  }
  if ((flags & 1) != 0) soup.normals.assign(soup.points.rbegin(), soup.points.rend());
  if ((flags & 1) != 0) soup.corner_normals.assign(soup.corners.rbegin(), soup.corners.rend());
  return soup;
}

void feed(uint8_t choice, std::span<const uint8_t> content) {
  switch (choice % 6) {
    case 0:
      return load_as("fuzz.obj", content);
    case 1:
      return load_as("fuzz.ply", content);
    case 2:
      return load_as("fuzz.off", content);
    case 3:
      return load_as("fuzz.stl", content);
    case 4:
      return check_invariants(mesh_from_soup(soup_of(content), "soup"));
    default:
      return check_invariants(mesh_from_soup(joined_soup(receive_scene(content)), "scene"));
  }
}

}  // namespace
}  // namespace inkbench

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  try {
    inkbench::feed(data[0], {data + 1, size - 1});
  } catch (const inkbench::Error&) {
    // Refusing bad input is right.
  }
  return 0;
}
