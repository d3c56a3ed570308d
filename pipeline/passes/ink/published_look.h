// SPDX-License-Identifier: MIT
// Lines as the published detectors draw them: Decaudin's and Saito and Takahashi's grey p, Mitchell's pixels
// made wider. In: a detection, its classes and tiles. Out: ink, as the lines' coverage is
// (pipeline/passes/ink/coverage.h).
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"

namespace inkbench {

class PublishedLookPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit PublishedLookPass(const GeneratedSources& generated);
  /// Out: rg8: coverage 0 to 1, which is half at the detection's limit; class / 255.
  Texture run(EdgeMethod method, const Texture& detection, const Texture& classes,
              const Texture& tiles) const;
  std::vector<Program*> programs() { return {&grey_, &dilated_}; }

 private:
  Program grey_;     ///< Decaudin's, Saito and Takahashi's.
  Program dilated_;  ///< Mitchell's, over the tiles that have any.
};

}  // namespace inkbench
