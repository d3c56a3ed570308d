// SPDX-License-Identifier: MIT
// The tiles of the image that pairs over the limits are in, before any line is placed: what places and draws
// lines leaves the others out.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/gl/texture.h"

namespace inkbench {

/// Of the pairs, whatever the limits.
class PairTilesPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit PairTilesPass(const GeneratedSources& generated);
  /// In: pairs (edges/pairs.h), H x W. Out: rg32f, a texel for 8 x 8 pixels: the largest angle in degrees
  /// and gap in pixel sizes of the pairs that they belong to.
  Texture run(const Texture& pairs) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

/// Against the limits.
class DihedralTilesPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit DihedralTilesPass(const GeneratedSources& generated);
  /// Out: r8, a texel for 8 x 8 pixels: 1 where a pair of one of them reaches a limit, else 0 (line_tiles.h).
  Texture run(const DihedralParams& params, float weak, const Texture& largest) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
