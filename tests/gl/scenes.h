// SPDX-License-Identifier: MIT
// Scenes for the GL tests.
#pragma once

#include "pipeline/settings/settings.h"

namespace inkbench {

/// A floor, a sphere and a turned box, seen from above with a tilted camera; exact for the CPU's ray caster.
/// One directional and one point light; stepped and smooth ramps. 161 x 117 px.
Settings analytic_scene();

/// The paper's scene from data/scenes/paper.toml, the rabbit included.
Settings paper_scene(int width_px, int height_px);

/// All of it this many times as large: places, sizes, camera and lights. Models must have a `size`, or be of
/// their own size times `scale`.
Settings scaled_scene(Settings settings, float scale);

/// The sphere alone in front of the background, small and quick.
Settings small_scene();

}  // namespace inkbench
