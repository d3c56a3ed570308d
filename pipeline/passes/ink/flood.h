// SPDX-License-Identifier: MIT
// For each pixel the nearest placed line, as far as lines are wide: jump flooding (Rong and Tan 2006), in a
// number of steps that grows with the logarithm of the width.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/ink/line_widths.h"

namespace inkbench {

class FloodPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit FloodPass(const GeneratedSources& generated);
  /// In: seeds (seeds.h). Out: the same for every pixel that a line may reach: the seed whose line ends
  /// nearest.
  Texture run(const WidthParams& widths, const LensBlock& lens, const Texture& seeds,
              const Texture* visible) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
