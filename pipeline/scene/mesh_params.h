// How fine the scene's main model is drawn: a level of its decimation ladder, or a subdivision of it.
#pragma once

#include "pipeline/mesh/level_normals.h"
#include "pipeline/params/description.h"

namespace inkbench {

template <>
struct ChoiceNames<LevelNormals> {
  static constexpr auto names = kLevelNormalsNames;
};

struct MeshParams {
  int faces = 0;
  int subdivide = 0;
  LevelNormals normals = LevelNormals::smooth;

  static const Description& description();
  bool operator==(const MeshParams&) const = default;
};

}  // namespace inkbench
