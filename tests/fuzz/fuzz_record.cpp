// SPDX-License-Identifier: MIT
// Bytes as collapse record files, and as meshes to decimate: nothing unharmed may come out of harmed bytes,
// and whatever is accepted must replay to sound meshes. The first byte chooses.
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>

#include "pipeline/mesh/levels/collapse_record_file.h"
#include "pipeline/mesh/levels/decimation.h"
#include "pipeline/mesh/levels/subdivide.h"
#include "pipeline/mesh/shapes/primitives.h"

namespace inkbench {
namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void check_levels(const Mesh& mesh, const CollapseRecord& record) {
  require(is_record_of(record, mesh));
  for (size_t asked = 1; asked < mesh.triangles.size(); asked += 1 + mesh.triangles.size() / 8) {
    const Mesh level = mesh_at_level(mesh, record, asked);
    require(level.normals.size() == level.positions.size());
    for (const auto& t : level.triangles) {
      for (const uint32_t vertex : t) require(vertex < level.positions.size());
      require(level.positions[t[0]] != level.positions[t[1]]);
    }
  }
}

/// A box and its record, whose file is fed back with the input's bytes at the input's places.
void feed_patched(std::span<const uint8_t> patches) {
  static const Mesh mesh = make_box(2);
  static const Key key = collapse_record_key(mesh);
  static const std::string good = write_collapse_record(record_collapses(mesh), key);
  std::string bytes = good;
  for (; patches.size() >= 3; patches = patches.subspan(3)) {
    const size_t place = (patches[0] | patches[1] << 8) % bytes.size();
    bytes[place] = static_cast<char>(patches[2]);
  }
  if (const auto record = read_collapse_record(bytes, mesh, key)) {
    require(bytes == good);
    check_levels(mesh, *record);
  }
}

/// The input as the record's arrays, behind a good hash: what `is_record_of` alone must stop.
void feed_arrays(std::span<const uint8_t> content) {
  static const Mesh mesh = make_plane(1);
  static const Key key = collapse_record_key(mesh);
  CollapseRecord record = record_collapses(mesh);
  size_t i = 0;
  const auto patch = [&](auto& items) {
    for (auto& item : items) {
      std::span<uint8_t> bytes(reinterpret_cast<uint8_t*>(&item), sizeof item);
      for (size_t at = 0; at < bytes.size(); at += 4, ++i) {
        if (i < content.size() && content[i] < 32) bytes[at] = content[i];
      }
    }
  };
  if (!content.empty()) record.collapses.resize(content[0] % 8);
  record.faces.resize(record.collapses.size() + 1);
  patch(record.corners);
  patch(record.origin);
  patch(record.next_equal);
  patch(record.collapses);
  patch(record.faces);
  if (const auto read = read_collapse_record(write_collapse_record(record, key), mesh, key))
    check_levels(mesh, *read);
}

/// Few points on a coarse grid, so that corners coincide, edges crowd and areas vanish.
void feed_mesh(std::span<const uint8_t> bytes) {
  Mesh mesh;
  for (size_t i = 0; i < 27; ++i) mesh.positions.emplace_back(i % 3, i / 3 % 3, i / 9);
  for (size_t i = 0; i < 8; ++i) mesh.positions.push_back(mesh.positions[i * 3]);
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 1, 0));
  for (; bytes.size() >= 3; bytes = bytes.subspan(3)) {
    const auto vertex = [&](int i) { return static_cast<uint32_t>(bytes[i] % mesh.positions.size()); };
    mesh.triangles.push_back({vertex(0), vertex(1), vertex(2)});
  }
  check_levels(mesh, record_collapses(mesh));
  if (mesh.triangles.size() < 100) subdivide_mesh(mesh, 1);
}

void feed(uint8_t choice, std::span<const uint8_t> content) {
  switch (choice % 4) {
    case 0: {
      static const Mesh mesh = make_plane(1);
      static const Key key = collapse_record_key(mesh);
      const std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
      if (const auto record = read_collapse_record(text, mesh, key)) check_levels(mesh, *record);
      return;
    }
    case 1:
      return feed_patched(content);
    case 2:
      return feed_arrays(content);
    default:
      return feed_mesh(content);
  }
}

}  // namespace
}  // namespace inkbench

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size > 0) inkbench::feed(data[0], {data + 1, size - 1});
  return 0;
}
