// The normal and depth maps at eight bits, for `image.precision = "unorm8"`.
#pragma once

#include "pipeline/gl/program.h"

namespace inkbench {

struct QuantisedMaps {
  Texture normal;  ///< rgba8
  Texture depth;   ///< r8
};

class QuantisePass {
 public:
  explicit QuantisePass(const GeneratedSources& generated);
  QuantisedMaps run(const Texture& normal, const Texture& depth) const;
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
