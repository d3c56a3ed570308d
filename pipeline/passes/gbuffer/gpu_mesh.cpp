// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/gpu_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/log.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/closed.h"
#include "pipeline/mesh/face_normals.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/formats/scene_import.h"
#include "pipeline/mesh/levels/model_mesh.h"

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

GpuMesh::GpuMesh(const std::string& label, std::shared_ptr<const Mesh> mesh, const Bounds& placement)
    : label_(label),
      mesh_(std::move(mesh)),
      vertex_array_(label),
      positions_(label + " positions", bytes_of(std::span(mesh_->positions))),
      normals_(label + " normals", bytes_of(std::span(mesh_->normals))),
      triangles_(label + " triangles", bytes_of(std::span(mesh_->triangles))),
      index_count_(static_cast<GLsizei>(mesh_->triangles.size() * 3)),
      bounds_(bounds_of(*mesh_)),
      placement_(placement),
      closed_outwards_(is_closed_outwards(*mesh_)) {
  attach(vertex_array_, 0, positions_);
  attach(vertex_array_, 1, normals_);
  glVertexArrayElementBuffer(vertex_array_.id(), triangles_.id());
}

void GpuMesh::draw() const {
  glBindVertexArray(vertex_array_.id());
  glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

const BufferTexture& GpuMesh::face_normals() const {
  if (!face_normals_) face_normals_.emplace(label_ + " face normals", inkbench::face_normals(*mesh_));
  return *face_normals_;
}

Key MeshStore::file_key(const std::string& path) {
  std::error_code error;
  const auto size = static_cast<int64_t>(fs::file_size(path, error));
  const int64_t time = error ? 0 : fs::last_write_time(path, error).time_since_epoch().count();
  const auto known = files_.find(path);
  if (known != files_.end() && error == std::errc::no_such_file_or_directory) {
    if (!std::exchange(known->second.is_gone, true))
      log_note(fmt::format("{} is gone; what was read of it is drawn", path));
    return known->second.content;
  }
  if (known != files_.end() && !error && known->second.size == size && known->second.time == time) {
    known->second.is_gone = false;
    return known->second.content;
  }
  check_mesh_file(path);
  const Key content = KeyBuilder().add(read_file(path, kMostMeshBytes)).key();
  std::vector<fs::path> read_with = files_read_with(path);
  read_with.erase(read_with.begin());
  files_[path] = {size, time, content, std::move(read_with)};
  return content;
}

Key MeshStore::content_key(const std::string& path) {
  const Key own = file_key(path);
  const std::vector<fs::path> read_with = files_.at(path).read_with;
  if (read_with.empty()) return own;
  KeyBuilder builder;
  builder.add(own);
  for (const fs::path& file : read_with) builder.add(file_key(file.string()));
  return builder.key();
}

bool MeshStore::can_get(const ModelParams& model, const MeshParams& level) {
  try {
    if (!meshes_.contains(identity(model, level))) make_model_mesh(model);
    return true;
  } catch (const Error&) {
    return false;
  }
}

Key MeshStore::full_identity(const ModelParams& model) {
  KeyBuilder builder;
  builder.add(std::to_string(static_cast<int>(model.shape)));
  builder.add(std::to_string(static_cast<int>(model.normals))).add(shortest(model.smooth_angle));
  builder.add(std::to_string(static_cast<int>(model.orient)));
  if (model.shape == Shape::mesh) {
    return builder.add(content_key(mesh_path(model.mesh).string())).add(model.part).key();
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
  return builder.add(ChoiceNames<LevelNormals>::names[static_cast<size_t>(level.normals)]).key();
}

Key MeshStore::ladder_identity(const ModelParams& model, int rounds) {
  return KeyBuilder().add("ladder").add(full_identity(model)).add(std::to_string(rounds)).key();
}

bool MeshStore::is_ready(const ModelParams& model, const MeshParams& level) {
  if (level == MeshParams{} || meshes_.contains(identity(model, level))) return true;
  return ladder_ && ladder_key_ == ladder_identity(model, level.subdivide) && ladder_->is_ready_for(level);
}

void MeshStore::take_ladder(const Key& key, MeshLadder ladder) {
  ladder_ = std::move(ladder);
  ladder_key_ = key;
}

std::shared_ptr<const Mesh> MeshStore::full_mesh(const ModelParams& model) {
  return drawn_mesh(model, {});
}

std::shared_ptr<const Mesh> MeshStore::drawn_mesh(const ModelParams& model, const MeshParams& level) {
  const auto found = meshes_.find(identity(model, level));
  return found != meshes_.end() ? found->second.mesh : make_mesh(model, level);
}

std::shared_ptr<const Mesh> MeshStore::make_mesh(const ModelParams& model, const MeshParams& level) {
  const bool has_ladder = ladder_ && ladder_key_ == ladder_identity(model, ladder_->rounds());
  if (level == MeshParams{})
    return has_ladder ? ladder_->full() : std::make_shared<Mesh>(make_model_mesh(model));
  const Key key = ladder_identity(model, level.subdivide);
  if (!ladder_ || ladder_key_ != key) {
    ladder_.reset();  // before there are two
    take_ladder(key, MeshLadder(model, level.subdivide));
  }
  return ladder_->level(level);
}

std::shared_ptr<const GpuMesh> MeshStore::get(const ModelParams& model, const MeshParams& level) {
  const Key key = identity(model, level);
  const auto found = meshes_.find(key);
  if (found != meshes_.end()) return found->second.gpu;
  const std::shared_ptr<const Mesh> drawn = make_mesh(model, level);
  for (const std::string& note : drawn->notes) log_note("model '" + model.name + "': " + note);
  note_if_missed(model, level, drawn->triangles.size());
  const Bounds placement = level == MeshParams{} ? bounds_of(*drawn) : bounds_of(*ladder_->full());
  return hold(key, model, drawn, placement);
}

std::shared_ptr<const GpuMesh> MeshStore::hold(const Key& key, const ModelParams& model,
                                               std::shared_ptr<const Mesh> mesh, const Bounds& placement) {
  auto gpu = std::make_shared<const GpuMesh>("mesh of " + model.name, mesh, placement);
  return meshes_.emplace(key, Held{std::move(mesh), std::move(gpu)}).first->second.gpu;
}

void MeshStore::take_full(const ModelParams& model, std::shared_ptr<const Mesh> mesh) {
  const Bounds placement = bounds_of(*mesh);
  const Key key = identity(model, {});
  if (!meshes_.contains(key)) hold(key, model, std::move(mesh), placement);
}

void MeshStore::share_full(MeshStore& other, const ModelParams& model) {
  if (!meshes_.contains(identity(model, {}))) take_full(model, other.full_mesh(model));
}

void MeshStore::share(MeshStore& other, const ModelParams& model, const MeshParams& level) {
  for (const MeshParams& shared : {MeshParams{}, level}) {
    const Key key = identity(model, shared);
    if (!meshes_.contains(key))
      hold(key, model, other.drawn_mesh(model, shared), other.get(model, level)->placement());
  }
}

void MeshStore::keep_only(std::span<const Key> keys) {
  std::erase_if(meshes_, [&](const auto& entry) {
    return std::find(keys.begin(), keys.end(), entry.first) == keys.end();
  });
}

}  // namespace inkbench
