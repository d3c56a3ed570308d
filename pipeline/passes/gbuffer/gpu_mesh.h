// SPDX-License-Identifier: MIT
// Meshes on the GPU and in memory, loaded once for as long as the settings use them.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/base/key.h"
#include "pipeline/gl/buffer_texture.h"
#include "pipeline/gl/object.h"
#include "pipeline/mesh/levels/mesh_ladder.h"
#include "pipeline/mesh/mesh.h"
#include "pipeline/settings/mesh_params.h"
#include "pipeline/settings/model.h"

namespace inkbench {

/// Positions at attribute 0, normals at attribute 1, and triangle indices.
class GpuMesh {
 public:
  /// `placement` is the box by which the model is scaled and anchored: that of the full mesh, so that its
  /// levels stand still.
  GpuMesh(const std::string& label, std::shared_ptr<const Mesh> mesh, const Bounds& placement);
  void draw() const;
  /// A normal for each triangle (`face_normals`), by the place that `gl_PrimitiveID` has while it is drawn;
  /// uploaded when it is first asked for. Errors: as `BufferTexture`.
  const BufferTexture& face_normals() const;
  size_t face_count() const { return static_cast<size_t>(index_count_) / 3; }
  const Bounds& bounds() const { return bounds_; }
  const Bounds& placement() const { return placement_; }
  bool closed_outwards() const { return closed_outwards_; }

 private:
  std::string label_;
  std::shared_ptr<const Mesh> mesh_;
  mutable std::optional<BufferTexture> face_normals_;
  VertexArray vertex_array_;
  Buffer positions_, normals_, triangles_;
  GLsizei index_count_ = 0;
  Bounds bounds_, placement_;
  bool closed_outwards_ = false;
};

class MeshStore {
 public:
  /// Decides what `get` gives: the shape's parameters, or the file's content, which stays as it was read
  /// where the file goes away. Errors (input): the file cannot be read.
  Key identity(const ModelParams& model, const MeshParams& level);
  /// Of the file's content as it was read last; read again where its size or time is another. Errors (input):
  /// it cannot be read.
  Key content_key(const std::string& path);
  /// Loads and uploads the first time. Errors (input): as `load_mesh_file`; its notes go to the log. The full
  /// mesh and the record of its collapses stay, so that another level of it takes milliseconds.
  std::shared_ptr<const GpuMesh> get(const ModelParams& model, const MeshParams& level);
  /// Whether `get` would give it; reads the mesh where it is not in memory.
  bool can_get(const ModelParams& model, const MeshParams& level);
  /// Decides the full mesh of the model, whatever its level.
  Key full_identity(const ModelParams& model);
  /// Decides the model's ladder with these rounds of subdivision.
  Key ladder_identity(const ModelParams& model, int rounds);
  /// Whether `get` gives this level without reading the mesh or recording its collapses first.
  bool is_ready(const ModelParams& model, const MeshParams& level);
  /// Takes a ladder that was made elsewhere; `key` is its `ladder_identity`.
  void take_ladder(const Key& key, MeshLadder ladder);
  /// The model's full mesh in memory; read where neither it nor its ladder is held.
  std::shared_ptr<const Mesh> full_mesh(const ModelParams& model);
  /// Takes the model's full mesh, or another store's of it, so that it is not read twice. What is not drawn
  /// next is forgotten.
  void take_full(const ModelParams& model, std::shared_ptr<const Mesh> mesh);
  void share_full(MeshStore& other, const ModelParams& model);
  /// Takes what another store draws of the model at that level, and its full mesh.
  void share(MeshStore& other, const ModelParams& model, const MeshParams& level);
  /// The mesh that `get` draws, in memory.
  std::shared_ptr<const Mesh> drawn_mesh(const ModelParams& model, const MeshParams& level);
  /// Frees all meshes that are not among these.
  void keep_only(std::span<const Key> keys);

 private:
  struct FileState {
    int64_t size = 0, time = 0;
    Key content;
    std::vector<std::filesystem::path> read_with;  ///< Other files that belong to it (`files_read_with`).
    bool is_gone = false;                          ///< And that was told.
  };
  struct Held {
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const GpuMesh> gpu;
  };
  Key file_key(const std::string& path);
  std::shared_ptr<const GpuMesh> hold(const Key& key, const ModelParams& model,
                                      std::shared_ptr<const Mesh> mesh, const Bounds& placement);
  std::shared_ptr<const Mesh> make_mesh(const ModelParams& model, const MeshParams& level);

  std::map<Key, Held> meshes_;
  std::map<std::string, FileState> files_;
  std::optional<MeshLadder> ladder_;  ///< Of the model whose levels are asked for.
  Key ladder_key_;
};

}  // namespace inkbench
