// gmax - gmin in the 3 x 3 region around each pixel (3.4.4).
#pragma once

#include "pipeline/gl/program.h"

namespace inkbench {

class RangePass {
 public:
  explicit RangePass(const GeneratedSources& generated);
  /// In: two gradients. Out: rg32f, the range of each.
  Texture run(const Texture& gradient) const;
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
