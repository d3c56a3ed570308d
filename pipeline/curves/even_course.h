// SPDX-License-Identifier: MIT
// Pixels' lines made even. In: points about a pixel apart. Out: a course that runs as evenly as a tube around
// the pixels lets it.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace inkbench {

/// Each point moved to at most `reach_px` from its pixel's centre, so that the course as a whole stays as
/// near to the line through the centres, and the other way round. Ends stay as far as that lets them; `ring`:
/// the last point is the first one. Smoothed over up to some 20 px along the line, over less where the tube
/// is left otherwise (corners, small rings), by a filter that keeps bends: arcs do not shrink.
std::vector<glm::vec2> even_course(std::span<const glm::vec2> points, std::span<const glm::vec2> centres,
                                   bool ring, float reach_px);

/// The nearest place that is at most `reach_px` from the centre.
glm::vec2 kept_within(const glm::vec2& point, const glm::vec2& centre, float reach_px);

}  // namespace inkbench
