// SPDX-License-Identifier: MIT
// Light: Blinn-Phong through the ramps, from the G-buffer (3.1, 3.2).
#pragma once

#include <vector>

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/settings/light.h"
#include "pipeline/settings/ramp.h"
#include "pipeline/settings/scene_params.h"

namespace inkbench {

/// All that light depends on besides the G-buffer.
struct ShadeParams {
  CameraParams camera;
  SceneParams scene;
  std::vector<LightParams> lights;
  std::vector<MaterialParams> materials;  ///< Material i belongs to object id i + 1.
  RampParams ramp;
  ImageWindow window;
};

class ShadePass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit ShadePass(const GeneratedSources& generated);
  /// Out: rgba32f, the background's colour where no model is. Errors (input): a ramp's image cannot be read;
  /// more than `kMaxLights` lights.
  Texture run(const ShadeParams& params, const GBuffer& gbuffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

/// Plain Blinn-Phong light by the same pass.
struct BlinnPhong {
  using Value = Texture;
  using Pass = ShadePass;
  static const PassKind& kind();
};

}  // namespace inkbench
