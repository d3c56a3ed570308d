// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/mesh_write.h"

#include <fmt/format.h>

#include <bit>
#include <iterator>

#include "pipeline/base/files.h"

namespace inkbench {
namespace {

static_assert(std::endian::native == std::endian::little, "binary PLY is written as it lies in memory");

template <class Value>
void append_raw(std::string& out, const Value& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string comment_line(const char* mark, const std::string& comment) {
  return comment.empty() ? "" : mark + comment + "\n";
}

template <class Vector>
void append_vector(std::string& out, const char* word, const Vector& v) {
  fmt::format_to(std::back_inserter(out), "{} {} {} {}\n", word, v.x, v.y, v.z);
}

/// Floats hold the file's coordinates.
bool is_in_file_units(const Mesh& mesh) {
  return mesh.origin == glm::dvec3(0.0) && mesh.unit == 1.0;
}

glm::dvec3 place_in_file(const Mesh& mesh, size_t vertex) {
  return mesh.origin + mesh.unit * glm::dvec3(mesh.positions[vertex]);
}

}  // namespace

std::string ply_text(const Mesh& mesh, const std::string& comment) {
  std::string out = fmt::format(
      "ply\nformat binary_little_endian 1.0\n{1}element vertex {2}\n"
      "property {0} x\nproperty {0} y\nproperty {0} z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "element face {3}\nproperty list uchar int vertex_indices\nend_header\n",
      is_in_file_units(mesh) ? "float" : "double", comment_line("comment ", comment), mesh.positions.size(),
      mesh.triangles.size());
  out.reserve(out.size() + mesh.positions.size() * 36 + mesh.triangles.size() * 13);
  for (size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    if (is_in_file_units(mesh)) {
      append_raw(out, mesh.positions[vertex]);
    } else {
      append_raw(out, place_in_file(mesh, vertex));
    }
    append_raw(out, mesh.normals[vertex]);
  }
  for (const auto& triangle : mesh.triangles) {
    out.push_back(3);
    append_raw(out, triangle);
  }
  return out;
}

std::string obj_text(const Mesh& mesh, const std::string& comment) {
  std::string out = comment_line("# ", comment);
  for (size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    if (is_in_file_units(mesh)) {
      append_vector(out, "v", mesh.positions[vertex]);
    } else {
      append_vector(out, "v", place_in_file(mesh, vertex));
    }
  }
  for (const glm::vec3& normal : mesh.normals) append_vector(out, "vn", normal);
  for (const auto& t : mesh.triangles) {
    fmt::format_to(std::back_inserter(out), "f {0}//{0} {1}//{1} {2}//{2}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  }
  return out;
}

void write_mesh_file(const Mesh& mesh, const std::filesystem::path& path, MeshFileFormat format,
                     const std::string& comment) {
  write_file_atomically(path,
                        format == MeshFileFormat::ply ? ply_text(mesh, comment) : obj_text(mesh, comment));
}

}  // namespace inkbench
