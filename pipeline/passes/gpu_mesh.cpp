#include "pipeline/passes/gpu_mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/base/files.h"
#include "pipeline/base/log.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/closed.h"
#include "pipeline/mesh/collapse_record_file.h"
#include "pipeline/mesh/mesh_file.h"
#include "pipeline/mesh/subdivide.h"

namespace inkbench {
namespace {

void attach(const VertexArray& vertex_array, GLuint attribute, const Buffer& buffer) {
  glVertexArrayVertexBuffer(vertex_array.id(), attribute, buffer.id(), 0, sizeof(glm::vec3));
  glEnableVertexArrayAttrib(vertex_array.id(), attribute);
  glVertexArrayAttribFormat(vertex_array.id(), attribute, 3, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(vertex_array.id(), attribute, attribute);
}

/// A count that cannot be reached is no error, but must not pass for what was asked.
void note_if_missed(const ModelParams& model, const MeshParams& level, size_t reached) {
  const auto asked = static_cast<size_t>(level.faces);
  if (asked == 0 || (reached + 1 >= asked && reached <= asked)) return;
  log_note(fmt::format("model '{}': {} faces asked, {} drawn ({})", model.name, with_commas(level.faces),
                       with_commas(static_cast<long long>(reached)),
                       reached > asked ? "decimation ends there" : "it has no more"));
}

}  // namespace

GpuMesh::GpuMesh(const std::string& label, const Mesh& mesh, const Bounds& placement)
    : vertex_array_(label),
      positions_(label + " positions", bytes_of(std::span(mesh.positions))),
      normals_(label + " normals", bytes_of(std::span(mesh.normals))),
      triangles_(label + " triangles", bytes_of(std::span(mesh.triangles))),
      index_count_(static_cast<GLsizei>(mesh.triangles.size() * 3)),
      bounds_(bounds_of(mesh)),
      placement_(placement),
      closed_outwards_(is_closed_outwards(mesh)) {
  attach(vertex_array_, 0, positions_);
  attach(vertex_array_, 1, normals_);
  glVertexArrayElementBuffer(vertex_array_.id(), triangles_.id());
}

void GpuMesh::draw() const {
  glBindVertexArray(vertex_array_.id());
  glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

Key MeshStore::content_key(const std::string& path) {
  std::error_code error;
  const auto size = static_cast<int64_t>(fs::file_size(path, error));
  const int64_t time = error ? 0 : fs::last_write_time(path, error).time_since_epoch().count();
  FileState& state = files_[path];
  if (error || state.size != size || state.time != time) {
    state = {size, time, KeyBuilder().add(read_file(path)).key()};
  }
  return state.content;
}

Key MeshStore::full_identity(const ModelParams& model) {
  KeyBuilder builder;
  builder.add(std::to_string(static_cast<int>(model.shape)));
  if (model.shape == Shape::mesh) {
    return builder.add(content_key(model.mesh == "rabbit" ? find_rabbit().string() : model.mesh)).key();
  }
  return builder.add(std::to_string(model.segments))
      .add(shortest(model.fillet))
      .add(shortest(model.tube))
      .key();
}

Key MeshStore::identity(const ModelParams& model, const MeshParams& level) {
  const Key full = full_identity(model);
  if (level == MeshParams{}) return full;
  KeyBuilder builder;
  builder.add(full).add(std::to_string(level.faces)).add(std::to_string(level.subdivide));
  return builder.add(kLevelNormalsNames[static_cast<size_t>(level.normals)]).key();
}

Mesh MeshStore::level_mesh(const ModelParams& model, const MeshParams& level) {
  const Key key = full_identity(model);
  if (!ladder_ || ladder_->key != key || ladder_->rounds != level.subdivide) {
    ladder_.reset();
    Mesh full = make_model_mesh(model);
    Mesh subdivided = subdivide_mesh(full, level.subdivide);
    ladder_ = LadderSource{key, level.subdivide, std::move(full), std::move(subdivided), std::nullopt};
  }
  const bool decimates =
      level.faces > 0 && static_cast<size_t>(level.faces) < ladder_->subdivided.triangles.size();
  if (!decimates) {
    Mesh whole = ladder_->subdivided;
    // As loaded, smooth leaves the normals that a file may give.
    if (level.normals != LevelNormals::smooth) apply_level_normals(whole, level.normals, ladder_->full);
    return whole;
  }
  if (!ladder_->record) ladder_->record = cached_collapse_record(ladder_->subdivided);
  return level_with_normals(ladder_->subdivided, *ladder_->record, static_cast<size_t>(level.faces),
                            level.normals);
}

Mesh MeshStore::full_mesh(const ModelParams& model) {
  const bool held = ladder_ && ladder_->key == full_identity(model);
  return held ? ladder_->full : make_model_mesh(model);
}

Mesh MeshStore::drawn_mesh(const ModelParams& model, const MeshParams& level) {
  return level == MeshParams{} ? make_model_mesh(model) : level_mesh(model, level);
}

const GpuMesh& MeshStore::get(const ModelParams& model, const MeshParams& level) {
  const Key key = identity(model, level);
  const auto found = meshes_.find(key);
  if (found != meshes_.end()) return found->second;
  const Mesh drawn = drawn_mesh(model, level);
  for (const std::string& note : drawn.notes) log_note("model '" + model.name + "': " + note);
  note_if_missed(model, level, drawn.triangles.size());
  const Bounds placement = level == MeshParams{} ? bounds_of(drawn) : bounds_of(ladder_->full);
  return meshes_.emplace(key, GpuMesh("mesh of " + model.name, drawn, placement)).first->second;
}

void MeshStore::keep_only(std::span<const Key> keys) {
  std::erase_if(meshes_, [&](const auto& entry) {
    return std::find(keys.begin(), keys.end(), entry.first) == keys.end();
  });
}

}  // namespace inkbench
