// Light: Blinn-Phong through the ramps, from the G-buffer (3.1, 3.2).
#pragma once

#include <vector>

#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/settings/light.h"
#include "pipeline/settings/ramp.h"
#include "pipeline/settings/scene_params.h"

namespace inkbench {

/// Lights and materials lie in uniform blocks of fixed size: the software renderer reads those several times
/// faster than storage buffers, and every driver has room for these.
constexpr int kMaxLights = 64;
constexpr int kMaxModels = 256;

/// All that light depends on besides the G-buffer.
struct ShadeParams {
  CameraParams camera;
  SceneParams scene;
  std::vector<LightParams> lights;
  std::vector<MaterialParams> materials;  ///< Material i belongs to object id i + 1.
  RampParams ramp;
};

class ShadePass {
 public:
  explicit ShadePass(const GeneratedSources& generated);
  /// Out: rgba32f, the background's colour where no model is. Errors (input): a ramp's image cannot be read;
  /// more than `kMaxLights` lights or `kMaxModels` materials.
  Texture run(const ShadeParams& params, const GBuffer& gbuffer) const;
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
