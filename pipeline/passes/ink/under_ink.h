// SPDX-License-Identifier: MIT
// What ink lies on: the shaded picture, or blank paper.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/texture.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

class PaperPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  /// Out: rgba32f, all of the colour.
  Texture run(const glm::vec3& colour, const ImageWindow& window) const;
};

/// By `ink.over`.
struct UnderInk {
  using Value = Texture;
  static const PassKind& kind();
  static size_t chosen(const Settings& settings) { return static_cast<size_t>(settings.ink.over); }
};

}  // namespace inkbench
