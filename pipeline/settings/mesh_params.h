// SPDX-License-Identifier: MIT
// How fine the scene's main model is drawn: a level of its decimation ladder, or a subdivision of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "pipeline/params/description.h"

namespace inkbench {

/// `smooth`: the angle-weighted mean of the adjacent faces, so that shading knows no more than the level's
/// geometry. `flat`: each face its own. `nearest`: those of the full mesh at the nearest point of its
/// surface, as baked normals are.
enum class LevelNormals : uint8_t { smooth, flat, nearest };

template <>
struct ChoiceNames<LevelNormals> {
  static constexpr std::array<std::string_view, 3> names{"smooth", "flat", "nearest"};
};

inline constexpr int kMaxSubdivisionRounds = 4;
inline constexpr size_t kMaxSubdividedFaces = 20'000'000;

struct MeshParams {
  int faces = 0;
  int subdivide = 0;
  LevelNormals normals = LevelNormals::smooth;

  static const Description& description();
  bool operator==(const MeshParams&) const = default;
};

}  // namespace inkbench
