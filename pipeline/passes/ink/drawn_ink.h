// SPDX-License-Identifier: MIT
// What is drawn over the shading. Of the filter: the paper's combined edges as they are, the published
// detectors' own look, or the coverage of placed lines; or strokes; or both. `lib/ink.glsl` says how it is
// read.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/texture.h"

namespace inkbench {

struct FilterInk {
  using Value = Texture;
  static const PassKind& kind();
  /// By `edges.method` and whether the method draws thinned lines.
  static size_t chosen(const Settings& settings);
};

struct DrawnInk {
  using Value = Texture;
  static const PassKind& kind();
  /// By `ink.from`.
  static size_t chosen(const Settings& settings) { return static_cast<size_t>(settings.ink.from); }
};

/// Does the filter place lines that have a width, and draw those?
bool places_lines(const Settings& settings);

/// Is the filter's ink the paper's combined edges, of which whatever is not 0 is ink?
inline bool is_papers_ink(const Settings& settings) {
  return settings.edges.method == EdgeMethod::paper;
}

}  // namespace inkbench
