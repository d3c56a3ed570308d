// SPDX-License-Identifier: MIT
// Strokes over the shading or paper, or over the filter's ink; and what of all that is the final image.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// What strokes are laid over: what is under ink, with `ink.from = both` the filter's ink on it.
struct BelowStrokes {
  using Value = Texture;
  static const PassKind& kind();
  static size_t chosen(const Settings& settings) { return settings.ink.from == InkFrom::both ? 1 : 0; }
};

class StrokesOverPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit StrokesOverPass(const GeneratedSources& generated);
  /// In: a picture, strokes as `StrokeColoursPass` gives them. Out: rgba32f.
  Texture run(const Texture& below, const Texture& strokes) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

/// By `ink.from`.
struct FinalImage {
  using Value = Texture;
  static const PassKind& kind();
  static size_t chosen(const Settings& settings) { return settings.ink.from == InkFrom::filter ? 0 : 1; }
};

}  // namespace inkbench
