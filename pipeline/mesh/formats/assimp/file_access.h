// SPDX-License-Identifier: MIT
// How Assimp reaches the files that a scene file refers to: regular files alone, since a pipe or a device
// would keep it waiting, and by the names that escapes ("%20") in their places mean.
#pragma once

#include <assimp/DefaultIOSystem.h>

namespace inkbench {

class FileAccess : public Assimp::DefaultIOSystem {
 public:
  bool Exists(const char* place) const override;
  Assimp::IOStream* Open(const char* place, const char* mode) override;
};

}  // namespace inkbench
