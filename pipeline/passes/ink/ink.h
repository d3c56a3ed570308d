// SPDX-License-Identifier: MIT
// Ink over the shading: the final image (3.5).
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/settings/ink_params.h"

namespace inkbench {

class InkPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit InkPass(const GeneratedSources& generated);
  /// Out: rgba32f, the ink's colour where `edges` is not 0, else the shading.
  Texture run(const InkParams& params, const Texture& shaded, const Texture& edges) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
