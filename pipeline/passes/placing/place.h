// SPDX-License-Identifier: MIT
// Where lines run: candidates thinned to one pixel, and how far from that pixel's centre the line is. For
// detectors that do not place their lines themselves.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"

namespace inkbench {

class PlacePass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit PlacePass(const GeneratedSources& generated);
  /// In: a detection, its classes, tiles and candidates. Out: placed lines (placed_lines.h). Thinned as
  /// measures are, on the CPU; the offset is to the middle of the strengths around.
  Texture run(const Texture& detection, const Texture& classes, const Texture& tiles,
              const Texture& candidates) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
