// SPDX-License-Identifier: MIT
// gmax - gmin in the 3 x 3 region around each pixel (3.4.4).
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"

namespace inkbench {

class RangePass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit RangePass(const GeneratedSources& generated);
  /// In: two gradients. Out: rg32f, the range of each.
  Texture run(const Texture& gradient) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
