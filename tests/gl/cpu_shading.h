// SPDX-License-Identifier: MIT
// Blinn-Phong light through ramps in double precision, written from the equations of 3.1 and 3.2.
#pragma once

#include "pipeline/settings/settings.h"
#include "tests/gl/cpu_reference.h"

namespace inkbench::reference {

struct Shading {
  Map colour;                ///< H x W x 3.
  ImageOf<uint8_t> at_step;  ///< Not 0 where some light's brightness is within 1/1024 of a ramp's step.
};

/// The ramp's colour at t (3.2): that of the last stop at or before t, blended into the next where the stop
/// is smooth.
glm::dvec3 ramp_colour(const Ramp& ramp, double t);

/// Light on what the maps show, at the centres of the pixels; `use_ramps` false: plain Blinn-Phong.
Shading shade(const Settings& settings, const Map& normal, const Map& depth, const Map& object_id,
              bool use_ramps);

}  // namespace inkbench::reference
