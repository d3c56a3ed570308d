// SPDX-License-Identifier: MIT
// Storage of textures that were given back, for the next texture of the same size and format: a sweep makes
// the same textures thousands of times, and fresh pages cost the software renderer as much as a pass. One
// pool a context; in it each user, such as a pipeline, has what it left idle to itself.
#pragma once

#include <vector>

#include "pipeline/gl/texture.h"

namespace inkbench {

class TexturePool {
 public:
  TexturePool() = default;
  TexturePool(const TexturePool&) = delete;
  TexturePool& operator=(const TexturePool&) = delete;
  /// The pool's context must be current, and every texture given back.
  ~TexturePool();

  /// Storage that the present user or nobody left idle; made where none fits.
  TextureStorage take(TextureFormat format, int width_px, int height_px);
  /// Keeps the storage for its user; of more than a dozen the oldest is deleted.
  void give_back(const TextureStorage& storage);

  /// Textures that had to be made so far, since none that was idle fitted.
  long made_count() const { return made_; }
  /// Textures that exist now: in use or idle.
  long alive_count() const { return made_ - deleted_; }

 private:
  friend class PoolUser;
  void destroy(const TextureStorage& storage);
  void free_idle_of(int user);
  void end_user(int user);

  static constexpr int kNobody = 0;

  std::vector<TextureStorage> idle_;  ///< The oldest first.
  std::vector<int> users_;
  int last_user_ = kNobody;
  int user_ = kNobody;  ///< For whom textures are made now.
  long made_ = 0, deleted_ = 0;
};

/// Whose idle textures nobody else takes or frees. When it ends, they are anyone's.
class PoolUser {
 public:
  /// The pool must outlive it.
  explicit PoolUser(TexturePool& pool);
  PoolUser(const PoolUser&) = delete;
  PoolUser& operator=(const PoolUser&) = delete;
  ~PoolUser() { pool_.end_user(id_); }

  /// Deletes what it left idle.
  void free_idle() { pool_.free_idle_of(id_); }

  /// Textures made while it lives are the user's.
  class Scope {
   public:
    explicit Scope(const PoolUser& user) : pool_(user.pool_), before_(pool_.user_) { pool_.user_ = user.id_; }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope() { pool_.user_ = before_; }

   private:
    TexturePool& pool_;
    int before_;
  };

 private:
  TexturePool& pool_;
  int id_;
};

}  // namespace inkbench
