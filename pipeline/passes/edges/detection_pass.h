// SPDX-License-Identifier: MIT
// What the passes that detect have in common: a full-screen program that reads the maps and writes a
// detection.
#pragma once

#include "pipeline/gl/program.h"
#include "pipeline/params/glsl_block.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/lens_block.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// A detection: rg32f, H x W. Red: strength, 1 = at the limit, 0 = none, without an upper end; green: 0 where
/// the strength is under `edges.weak`, else the class (EdgeClass), or -n where the surfaces up to n pixels
/// away tell it (edge_classes.h).
Texture detection_target(const std::string& label, const Texture& like);

/// Uniforms of a described group, as its generated block has them.
template <class Params>
Buffer block_buffer(const Params& params) {
  const Description& description = Params::description();
  return {std::string(description.group) + " block", pack_std140(description, &params)};
}

/// The block of `edges` for detectors, which read `weak` of it alone.
Buffer weak_block(float weak);

/// Draws `program` over the whole of `target`. Samplers and blocks in the program's order.
void draw_over(const Texture& target, const Program& program, std::initializer_list<const Texture*> maps,
               std::initializer_list<const Buffer*> blocks);

}  // namespace inkbench
