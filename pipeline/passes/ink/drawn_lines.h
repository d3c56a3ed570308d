// SPDX-License-Identifier: MIT
// The drawn lines as they are measured. In: what is drawn. Out: a map of 0 and 1, the buffer `lines`, which
// `score`, `measure`, studies and the window's judge all read; and the coverage that decides it.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"

namespace inkbench {

class LinesPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit LinesPass(const GeneratedSources& generated);
  /// Out: red: 1 where at least half of the pixel is ink, else 0; green: how much is. rg8.
  Texture run(bool is_papers, const Texture& drawn) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
