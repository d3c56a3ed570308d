// Meshes on the GPU, loaded once for as long as the settings use them.
#pragma once

#include <map>
#include <span>

#include "pipeline/base/key.h"
#include "pipeline/gl/object.h"
#include "pipeline/mesh/mesh.h"
#include "pipeline/scene/model.h"

namespace inkbench {

/// Positions at attribute 0, normals at attribute 1, and triangle indices.
class GpuMesh {
 public:
  GpuMesh(const std::string& label, const Mesh& mesh);
  void draw() const;
  const Bounds& bounds() const { return bounds_; }
  bool closed_outwards() const { return closed_outwards_; }

 private:
  VertexArray vertex_array_;
  Buffer positions_, normals_, triangles_;
  GLsizei index_count_ = 0;
  Bounds bounds_;
  bool closed_outwards_ = false;
};

class MeshStore {
 public:
  /// Decides what `get` gives: the shape's parameters, or the file's content. Errors (input): the file cannot
  /// be read.
  Key identity(const ModelParams& model);
  /// Loads and uploads the first time. Errors (input): as `load_mesh_file`; its notes go to the log.
  const GpuMesh& get(const ModelParams& model);
  /// Frees all meshes that are not among these.
  void keep_only(std::span<const Key> keys);

 private:
  struct FileState {
    int64_t size = 0, time = 0;
    Key content;
  };
  Key content_key(const std::string& path);

  std::map<Key, GpuMesh> meshes_;
  std::map<std::string, FileState> files_;
};

}  // namespace inkbench
