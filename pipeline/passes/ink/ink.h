// SPDX-License-Identifier: MIT
// Ink over the shading: the final image (3.5).
#pragma once

#include <array>

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// What the ink looks like.
struct InkLook {
  InkParams ink;
  bool is_papers = true;  ///< Then the rest has no effect.
  bool has_colours = false;
  ClassLooks of_class;
};

class InkPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit InkPass(const GeneratedSources& generated);
  /// In: the shading, what is drawn over it (drawn_ink.h). Out: rgba32f.
  Texture run(const InkLook& look, const Texture& shaded, const Texture& drawn) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
