// SPDX-License-Identifier: MIT
// Which tiles of the image have a placed line: what looks for lines around each pixel leaves the others out.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"

namespace inkbench {

class LineTilesPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit LineTilesPass(const GeneratedSources& generated);
  /// In: placed lines, H x W. Out: r8, a texel for 8 x 8 pixels: 1 where one has a line, else 0.
  Texture run(const Texture& placed) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

/// The tiles that lines may be in, by the method's own way where it has one.
struct LineTiles {
  using Value = Texture;
  static const PassKind& kind();
  static size_t chosen(const Settings& settings);
};

}  // namespace inkbench
