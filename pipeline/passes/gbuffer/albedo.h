// SPDX-License-Identifier: MIT
// The material of each pixel: its colour without light, and which one it is. Nothing is drawn again for it:
// a model has one material, so the object ids say all, and a change of colour costs one full-screen pass.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"

namespace inkbench {

/// By model: the material's colour; its number: 1, 2, ... by the first model that has one equal to it.
std::vector<glm::vec4> material_table(const Settings& settings);

class AlbedoPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit AlbedoPass(const GeneratedSources& generated);
  /// Out: rgba32f: `albedo`, linear as given; alpha: `material_id`. All 0 where no model is.
  Texture run(const std::vector<glm::vec4>& materials, const GBuffer& gbuffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
