// SPDX-License-Identifier: MIT
// The triangles' planes as they follow from a smaller G-buffer's normals and depths, for `image.precision` of
// half and depth24. In: the G-buffer's planes. Out: planes.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/lens_block.h"

namespace inkbench {

class QuantisePlanesPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit QuantisePlanesPass(const GeneratedSources& generated);
  /// Where no planes are read, or eight bits, which are too few for planes, are wanted: the G-buffer's own.
  static bool hands_on(const Settings& settings);
  static const Texture& handed(const GBuffer& gbuffer) { return gbuffer.surface; }
  static PassInput handed_by() { return {EdgesParams::description().group}; }
  /// Out: rgba32f as shaders/lib/surface.glsl says.
  Texture run(const GBuffer& gbuffer, Precision precision, const CameraParams& camera, const LensBlock& lens,
              const ImageWindow& window) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
