// SPDX-License-Identifier: MIT
// The filter's ink over the shading (3.5).
#pragma once

#include <array>
#include <vector>

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
  /// In: the shading (or paper), what is drawn over it (drawn_ink.h). Out: rgba32f.
  Texture run(const InkLook& look, const Texture& shaded, const Texture& drawn) const;
  std::vector<Program*> programs() { return {&papers_, &by_class_}; }

 private:
  Program papers_, by_class_;  ///< The paper's ink is all or nothing and does not pay for the rest.
};

}  // namespace inkbench
