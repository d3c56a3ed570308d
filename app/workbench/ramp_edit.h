// SPDX-License-Identifier: MIT
// Editing a ramp by its stops. Pure functions: a ramp in, a ramp out, stops in rising order as a ramp needs
// them. While dragging, apply them to the ramp as it was when the drag began, so that going back undoes.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

#include "pipeline/settings/ramp.h"

namespace inkbench {

/// A ramp and the place of the stop that was touched, which moving and adding can change.
struct TouchedRamp {
  Ramp ramp;
  size_t index = 0;
};

/// The same look as stops, for a ramp that is an image: steps where the image has at most 32 colours along
/// its row, else at most 64 smooth stops. A ramp that has stops is returned as it is; one without any gets
/// black and white. Errors (input): as `ramp_table`.
Ramp with_stops(const Ramp& ramp);

/// The functions below need a ramp with stops and an index below their number.

/// Moves a stop to `position`, clamped to 0 to 1. It passes other stops, as in most gradient editors, and
/// takes its colour along; against a stop at the same place it stays on the side that it comes from.
TouchedRamp move_stop(const Ramp& ramp, size_t index, float position);

/// A new stop that leaves the ramp's look as it is: it has the colour there and steps if its surroundings do.
TouchedRamp add_stop(const Ramp& ramp, float position);

/// The last stop stays: a ramp has at least one.
Ramp remove_stop(const Ramp& ramp, size_t index);

/// Components are clamped to 0 to 1.
Ramp set_stop_colour(const Ramp& ramp, size_t index, const glm::vec3& colour);

/// Whether the stop holds its colour to the next stop or blends into it.
Ramp set_stop_stepped(const Ramp& ramp, size_t index, bool stepped);
Ramp set_all_stepped(const Ramp& ramp, bool stepped);

/// `count` steps of equal width (1 to 64, clamped) between the ramp's ends, which keep their colours. Where
/// the ramp stays at one colour the bands do not: they go on along its colours, so that none repeats the one
/// before. Of a ramp of steps alone they are spread evenly, whatever the steps' widths.
Ramp even_bands(const Ramp& ramp, int count);

inline constexpr int kMaxBands = 64;

}  // namespace inkbench
