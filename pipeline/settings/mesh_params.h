// SPDX-License-Identifier: MIT
// How fine the scene's main model is drawn: a level of its decimation ladder, or a subdivision of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "pipeline/params/description.h"

namespace inkbench {

/// `model`: as the model has them: its given ones at the vertices that are left, else smooth over the level's
/// faces, sharp where the full mesh is; or flat. `smooth`: the angle-weighted mean of the adjacent faces, so
/// that shading knows no more than the level's geometry. `flat`: each face its own. `nearest`: those of the
/// full mesh at the nearest point of its surface, as baked normals are.
enum class LevelNormals : uint8_t { model, smooth, flat, nearest };

template <>
struct ChoiceNames<LevelNormals> {
  static constexpr std::array<std::string_view, 4> names{"model", "smooth", "flat", "nearest"};
};

inline constexpr int kMaxSubdivisionRounds = 4;
inline constexpr size_t kMaxSubdividedFaces = 20'000'000;

struct MeshParams {
  int faces = 0;
  int subdivide = 0;
  LevelNormals normals = LevelNormals::model;

  static const Description& description();
  bool operator==(const MeshParams&) const = default;
};

}  // namespace inkbench
