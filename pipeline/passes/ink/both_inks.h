// SPDX-License-Identifier: MIT
// The filter's ink and the strokes' in one map, as they are measured.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"

namespace inkbench {

class BothInksPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit BothInksPass(const GeneratedSources& generated);
  /// Out: rg8: on each pixel the larger coverage and its class / 255; the paper's ink has no class.
  Texture run(bool is_papers, const Texture& filter, const Texture& strokes) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
