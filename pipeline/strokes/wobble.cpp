// SPDX-License-Identifier: MIT
#include "pipeline/strokes/wobble.h"

#include <algorithm>
#include <glm/common.hpp>

#include "pipeline/strokes/coherent_noise.h"

namespace inkbench {
namespace {

constexpr float kLongestStepPx = 3.0F;

glm::vec2 noise_at(float along_px, float length_px, uint32_t seed) {
  const double at = double{along_px} / length_px;
  return {coherent_noise(at, seed), coherent_noise(at, hashed(seed, 7))};
}

/// Over the last `length_px` of a closed path it goes over into what it was before the start.
glm::vec2 noise_on(const StrokePath& path, float along_px, float length_px, uint32_t seed) {
  const glm::vec2 here = noise_at(along_px, length_px, seed);
  if (!path.is_closed) return here;
  const float round = inkbench::length_px(path), from_end = path.points.back().along_px - along_px;
  const float share = 1.0F - glm::smoothstep(0.0F, std::min(length_px, 0.5F * round), from_end);
  return glm::mix(here, noise_at(along_px - round, length_px, seed), share);
}

bool strays(const StrokeParams& params) {
  return params.wobble > 0.0F || (params.passes > 1 && params.spread > 0.0F);
}

}  // namespace

std::vector<glm::vec2> strayed(const StrokePath& path, const StrokeParams& params, int pass) {
  std::vector<glm::vec2> moves(path.points.size(), glm::vec2(0.0F));
  const uint32_t hand = hashed(path.number, static_cast<uint32_t>(params.seed));
  const uint32_t seed = hashed(hand, static_cast<uint32_t>(pass));
  const float spread = pass > 0 ? params.spread : 0.0F;
  if (params.wobble <= 0.0F && spread <= 0.0F) return moves;
  for (size_t i = 0; i < moves.size(); ++i) {
    const float along_px = path.points[i].along_px;
    if (params.wobble > 0.0F)
      moves[i] += params.wobble * noise_on(path, along_px, params.wobble_length, seed);
    // A hand that draws a line again misses it by much the same for long.
    if (spread > 0.0F)
      moves[i] += spread * noise_on(path, along_px, 3.0F * params.wobble_length, hashed(seed, 13));
  }
  return moves;
}

float longest_step_px(const StrokeParams& params) {
  if (!strays(params)) return kLongestStepPx;
  return std::clamp(params.wobble_length / 6.0F, 0.5F, kLongestStepPx);
}

}  // namespace inkbench
