// SPDX-License-Identifier: MIT
// G-buffer: draws all models once; out come the normal and depth maps (3.4.1, 3.4.2) and object ids.
#pragma once

#include <glm/mat4x4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/beyond_far.h"
#include "pipeline/passes/gbuffer/draw_item.h"
#include "pipeline/settings/camera.h"

namespace inkbench {

struct GBuffer {
  Texture normal_and_depth;  ///< rgba32f: 0.5 N + 0.5 in world space, (0.5, 0.5, 0.5) where no model is;
                             ///< alpha: linear depth / far, 1 where no model is. One texture, since the
                             ///< gradient reads both.
  Texture object_id;         ///< r32f: 0 where no model is.
  Texture surface;  ///< rgba32f: the triangles' planes (shaders/lib/surface.glsl), 0 where no model is;
                    ///< without storage where it was not asked for.
};

/// Does the settings' detector read the triangles' planes?
bool needs_surface(const Settings& settings);

class GBufferPass {
 public:
  using Value = GBuffer;
  static const PassKind& kind();
  /// The planes are drawn for the detector that reads them alone; the other maps and the key are the same.
  static bool lacks_part(const GBuffer& held, const Settings& settings);
  explicit GBufferPass(const GeneratedSources& generated);
  GBuffer run(const CameraParams& camera, std::span<const DrawItem> items, const ImageWindow& window,
              bool with_surface) const;
  std::vector<Program*> programs() { return {&maps_, &maps_and_surface_}; }

 private:
  const Program& program(bool with_surface) const { return with_surface ? maps_and_surface_ : maps_; }

  Program maps_,
      maps_and_surface_;  ///< Two, since nothing else keeps the software renderer from working out both.
  std::unique_ptr<BeyondFarNotes> beyond_far_ = std::make_unique<BeyondFarNotes>();
};

}  // namespace inkbench
