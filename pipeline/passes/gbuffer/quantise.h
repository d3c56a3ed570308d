// The normal and depth maps at eight bits, for `image.precision = "unorm8"`.
#pragma once

#include "pipeline/gl/program.h"

namespace inkbench {

class QuantisePass {
 public:
  explicit QuantisePass(const GeneratedSources& generated);
  /// In: normal and depth as the G-buffer has them. Out: the same as rgba8.
  Texture run(const Texture& normal_and_depth) const;
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
