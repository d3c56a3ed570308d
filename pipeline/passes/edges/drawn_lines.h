// SPDX-License-Identifier: MIT
// The drawn lines as they are measured. In: what the edge detector gives. Out: a map of 0 and 1, the buffer
// `lines`, which `score`, `measure`, studies and the window's judge all read.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"

namespace inkbench {

class LinesPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit LinesPass(const GeneratedSources& generated);
  /// Out: r8, 1 where `edges` is not 0, which is where the ink lies, else 0.
  Texture run(const Texture& edges) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
