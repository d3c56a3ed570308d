// SPDX-License-Identifier: MIT
// Lines straight from pairs of neighbours: what `dihedral` finds is one pixel wide already, and it knows
// where planes meet.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/gl/texture.h"

namespace inkbench {

class DihedralPlacePass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit DihedralPlacePass(const GeneratedSources& generated);
  /// In: pairs (edges/pairs.h), and the tiles that have any over the limits. Out: placed lines
  /// (placed_lines.h). A crease lies where its planes meet; a step half a pixel inside the nearer surface,
  /// smoothed over five pixels along it.
  Texture run(const DihedralParams& params, float weak, const Texture& pairs, const Texture& tiles) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
