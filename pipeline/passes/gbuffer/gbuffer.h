// G-buffer: draws all models once; out come the normal and depth maps (3.4.1, 3.4.2) and object ids.
#pragma once

#include <glm/mat4x4.hpp>
#include <span>

#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gpu_mesh.h"
#include "pipeline/settings/camera.h"

namespace inkbench {

struct GBuffer {
  Texture normal_and_depth;  ///< rgba32f: 0.5 N + 0.5 in world space, (0.5, 0.5, 0.5) where no model is;
                             ///< alpha: linear depth / far, 1 where no model is. One texture, since the
                             ///< gradient reads both.
  Texture object_id;         ///< r32f: 0 where no model is.
};

/// One model to draw.
struct DrawItem {
  const GpuMesh* mesh = nullptr;
  glm::mat4 model_to_world{1.0F};
  int object_id = 0;
};

/// The box in world space around the box of the item's mesh.
Bounds bounds_in_world(const DrawItem& item);

class GBufferPass {
 public:
  explicit GBufferPass(const GeneratedSources& generated);
  GBuffer run(const CameraParams& camera, std::span<const DrawItem> items, int width_px, int height_px) const;
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
