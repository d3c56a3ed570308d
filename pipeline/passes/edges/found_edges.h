// SPDX-License-Identifier: MIT
// What the chosen detector finds, as a detection (detection_pass.h): the buffer `edge_strength`.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/texture.h"

namespace inkbench {

struct FoundEdges {
  using Value = Texture;
  static const PassKind& kind();
  /// By `edges.method`.
  static size_t chosen(const Settings& settings) { return static_cast<size_t>(settings.edges.method); }
};

}  // namespace inkbench
