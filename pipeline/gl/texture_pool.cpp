// SPDX-License-Identifier: MIT
#include "pipeline/gl/texture_pool.h"

#include <algorithm>
#include <cassert>

namespace inkbench {
namespace {

constexpr long kMaxIdle = 12;  // of one user

GLuint make_storage(TextureFormat format, int width_px, int height_px) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  glTextureStorage2D(id, 1, internal_format(format), width_px, height_px);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return id;
}

}  // namespace

TexturePool::~TexturePool() {
  assert(std::ssize(idle_) == alive_count() && "a texture outlives its context");
  for (const TextureStorage& storage : idle_) destroy(storage);
}

TextureStorage TexturePool::take(TextureFormat format, int width_px, int height_px) {
  const auto match = std::find_if(idle_.begin(), idle_.end(), [&](const TextureStorage& idle) {
    return idle.format == format && idle.width_px == width_px && idle.height_px == height_px &&
           (idle.user == user_ || idle.user == kNobody);
  });
  if (match == idle_.end()) {
    ++made_;
    return {make_storage(format, width_px, height_px), format, width_px, height_px, this, user_};
  }
  TextureStorage storage = *match;
  idle_.erase(match);
  storage.user = user_;
  return storage;
}

void TexturePool::give_back(const TextureStorage& storage) {
  idle_.push_back(storage);
  int& user = idle_.back().user;
  if (std::find(users_.begin(), users_.end(), user) == users_.end()) user = kNobody;
  const auto is_same_users = [user](const TextureStorage& idle) { return idle.user == user; };
  if (std::count_if(idle_.begin(), idle_.end(), is_same_users) <= kMaxIdle) return;
  const auto oldest = std::find_if(idle_.begin(), idle_.end(), is_same_users);
  destroy(*oldest);
  idle_.erase(oldest);
}

void TexturePool::destroy(const TextureStorage& storage) {
  glDeleteTextures(1, &storage.id);
  ++deleted_;
}

void TexturePool::free_idle_of(int user) {
  const auto kept = std::stable_partition(idle_.begin(), idle_.end(),
                                          [user](const TextureStorage& idle) { return idle.user != user; });
  std::for_each(kept, idle_.end(), [this](const TextureStorage& idle) { destroy(idle); });
  idle_.erase(kept, idle_.end());
}

/// Oldest first, so that nobody's share stays within its limit and keeps the newest.
void TexturePool::end_user(int user) {
  std::erase(users_, user);
  const auto left = std::stable_partition(idle_.begin(), idle_.end(),
                                          [user](const TextureStorage& idle) { return idle.user != user; });
  const std::vector<TextureStorage> ownerless(left, idle_.end());
  idle_.erase(left, idle_.end());
  for (const TextureStorage& storage : ownerless) give_back(storage);
}

PoolUser::PoolUser(TexturePool& pool) : pool_(pool), id_(++pool.last_user_) {
  pool_.users_.push_back(id_);
}

}  // namespace inkbench
