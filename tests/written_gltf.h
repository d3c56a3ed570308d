// SPDX-License-Identifier: MIT
// Small glTF files for tests: a mesh of two triangles in a buffer beside the file, and what a test adds.
#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

namespace inkbench {

/// A glTF file's parts as JSON; each takes its place among the file's own.
struct GltfText {
  std::string nodes = R"({"name": "sheet", "mesh": 0})";
  std::string scene_nodes = "0";
  /// Mesh 0 is a square in the plane z = 0 from (0, 0, 0) to (1, 1, 0), of two triangles, seen from +z.
  std::string
      attributes;  ///< More of its points, such as `"NORMAL": 0`, their places; with a comma before it.
  std::string primitive;  ///< More of its primitive, such as `"material": 0`; with a comma before it.
  std::string more;       ///< More of the file, such as `"cameras": [...]`; with a comma before it.
};

/// Writes NAME.gltf, and its buffer as `buffer`; returns the file's path.
inline std::filesystem::path write_gltf(const std::filesystem::path& folder, const GltfText& text = {},
                                        const std::string& name = "square",
                                        const std::string& buffer = "square.bin",
                                        const std::string& buffer_uri = "square.bin") {
  const std::array<float, 12> points{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const std::array<uint16_t, 6> corners{0, 1, 2, 0, 2, 3};
  std::ofstream bytes(folder / buffer, std::ios::binary);
  bytes.write(reinterpret_cast<const char*>(points.data()), sizeof points);
  bytes.write(reinterpret_cast<const char*>(corners.data()), sizeof corners);
  const std::filesystem::path path = folder / (name + ".gltf");
  std::ofstream(path) << R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [)"
                      << text.scene_nodes << R"(]}], "nodes": [)" << text.nodes
                      << R"(], "meshes": [{"primitives": [{"attributes": {"POSITION": 0)" << text.attributes
                      << R"(}, "indices": 1)" << text.primitive << R"(}]}], "buffers": [{"uri": ")"
                      << buffer_uri << R"(", "byteLength": 60}], "bufferViews": [)"
                      << R"({"buffer": 0, "byteOffset": 0, "byteLength": 48},)"
                      << R"({"buffer": 0, "byteOffset": 48, "byteLength": 12}], "accessors": [)"
                      << R"({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",)"
                      << R"( "min": [0, 0, 0], "max": [1, 1, 0]},)"
                      << R"({"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}])"
                      << text.more << "}\n";
  return path;
}

}  // namespace inkbench
