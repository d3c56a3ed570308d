// SPDX-License-Identifier: MIT
#include "app/workbench/ramp_edit.h"

#include <algorithm>
#include <cassert>
#include <glm/common.hpp>
#include <vector>

namespace inkbench {
namespace {

constexpr size_t kMaxSteps = 32, kMaxSmoothStops = 64;

float clamped(float position) {
  return position >= 0.0F ? std::min(position, 1.0F) : 0.0F;  // NaN becomes 0
}

/// Where runs of equal texels begin.
std::vector<size_t> run_starts(const std::vector<glm::vec3>& table) {
  std::vector<size_t> starts{0};
  for (size_t i = 1; i < table.size(); ++i) {
    if (table[i] != table[i - 1]) starts.push_back(i);
  }
  return starts;
}

/// The texel between `first` and `last` farthest from the straight blend of both, and how far it is.
std::pair<size_t, float> farthest(const std::vector<glm::vec3>& table, size_t first, size_t last) {
  std::pair<size_t, float> worst{first, 0.0F};
  for (size_t i = first + 1; i < last; ++i) {
    const float t = static_cast<float>(i - first) / static_cast<float>(last - first);
    const glm::vec3 off = glm::abs(table[i] - glm::mix(table[first], table[last], t));
    const float distance = std::max({off.x, off.y, off.z});
    if (distance > worst.second) worst = {i, distance};
  }
  return worst;
}

/// Texels whose blend follows the table (Ramer 1972, Douglas and Peucker 1973): split at the worst one until
/// all are within half an 8-bit level or the stops are used up.
std::vector<size_t> fitted_texels(const std::vector<glm::vec3>& table) {
  std::vector<size_t> kept{0, table.size() - 1};
  while (kept.size() < kMaxSmoothStops) {
    std::pair<size_t, float> worst{0, 0.5F / 255.0F};
    for (size_t i = 0; i + 1 < kept.size(); ++i) {
      const auto candidate = farthest(table, kept[i], kept[i + 1]);
      if (candidate.second > worst.second) worst = candidate;
    }
    if (worst.first == 0) break;
    kept.insert(std::upper_bound(kept.begin(), kept.end(), worst.first), worst.first);
  }
  return kept;
}

/// The ramp's colours one after the other, each other than the one before, with their distances: where all
/// steps, as many as lie between them, else as far as their stops are from each other.
struct ColourPath {
  std::vector<glm::vec3> colours;
  std::vector<float> places;  ///< From 0, rising.

  glm::vec3 at(float place) const {
    size_t next = 1;
    while (next + 1 < places.size() && places[next] < place) ++next;
    if (next >= colours.size()) return colours.front();
    const float t = (place - places[next - 1]) / (places[next] - places[next - 1]);
    return glm::mix(colours[next - 1], colours[next], std::clamp(t, 0.0F, 1.0F));
  }
};

ColourPath colour_path(const Ramp& ramp) {
  constexpr float kLeastStep = 1e-6F;  // of a jump between two stops in one place
  const bool steps =
      std::all_of(ramp.stops.begin(), ramp.stops.end(), [](const RampStop& stop) { return stop.stepped; });
  ColourPath path{{ramp.stops.front().colour}, {0.0F}};
  for (size_t i = 1; i < ramp.stops.size(); ++i) {
    if (ramp.stops[i].colour == path.colours.back()) continue;
    const float width = ramp.stops[i].position - ramp.stops[i - 1].position;
    path.colours.push_back(ramp.stops[i].colour);
    path.places.push_back(path.places.back() + (steps ? 1.0F : std::max(width, kLeastStep)));
  }
  return path;
}

Ramp from_table(std::vector<glm::vec3> table) {
  for (glm::vec3& colour : table) {
    for (int c = 0; c < 3; ++c) colour[c] = clamped(colour[c]);
  }
  const auto texels = static_cast<float>(table.size());
  Ramp ramp;
  const std::vector<size_t> starts = run_starts(table);
  if (starts.size() <= kMaxSteps) {
    for (const size_t i : starts) ramp.stops.push_back({static_cast<float>(i) / texels, table[i], true});
    return ramp;
  }
  for (const size_t i : fitted_texels(table))
    ramp.stops.push_back({(static_cast<float>(i) + 0.5F) / texels, table[i], false});
  return ramp;
}

}  // namespace

Ramp with_stops(const Ramp& ramp) {
  if (!ramp.image.empty()) return from_table(ramp_table(ramp));
  if (!ramp.stops.empty()) return ramp;
  return {{{0.0F, glm::vec3(0.0F), false}, {1.0F, glm::vec3(1.0F), false}}, ""};
}

TouchedRamp move_stop(const Ramp& ramp, size_t index, float position) {
  assert(index < ramp.stops.size());
  TouchedRamp result{ramp, index};
  std::vector<RampStop>& stops = result.ramp.stops;
  stops[index].position = clamped(position);
  for (; index > 0 && stops[index - 1].position > stops[index].position; --index)
    std::swap(stops[index - 1], stops[index]);
  for (; index + 1 < stops.size() && stops[index + 1].position < stops[index].position; ++index)
    std::swap(stops[index + 1], stops[index]);
  result.index = index;
  return result;
}

TouchedRamp add_stop(const Ramp& ramp, float position) {
  assert(!ramp.stops.empty());
  TouchedRamp result{ramp, 0};
  const float place = clamped(position);
  std::vector<RampStop>& stops = result.ramp.stops;
  const auto next = std::upper_bound(stops.begin(), stops.end(), place,
                                     [](float value, const RampStop& stop) { return value < stop.position; });
  const RampStop& around = next == stops.begin() ? *next : *(next - 1);
  const RampStop stop{place, evaluate_ramp(ramp, place), around.stepped};
  result.index = static_cast<size_t>(next - stops.begin());
  stops.insert(next, stop);
  return result;
}

Ramp remove_stop(const Ramp& ramp, size_t index) {
  assert(index < ramp.stops.size());
  Ramp result = ramp;
  if (result.stops.size() > 1) result.stops.erase(result.stops.begin() + static_cast<std::ptrdiff_t>(index));
  return result;
}

Ramp set_stop_colour(const Ramp& ramp, size_t index, const glm::vec3& colour) {
  assert(index < ramp.stops.size());
  Ramp result = ramp;
  for (int c = 0; c < 3; ++c) result.stops[index].colour[c] = clamped(colour[c]);
  return result;
}

Ramp set_stop_stepped(const Ramp& ramp, size_t index, bool stepped) {
  assert(index < ramp.stops.size());
  Ramp result = ramp;
  result.stops[index].stepped = stepped;
  return result;
}

Ramp set_all_stepped(const Ramp& ramp, bool stepped) {
  Ramp result = ramp;
  for (RampStop& stop : result.stops) stop.stepped = stepped;
  return result;
}

Ramp even_bands(const Ramp& ramp, int count) {
  assert(!ramp.stops.empty());
  const int bands = std::clamp(count, 1, kMaxBands);
  const ColourPath path = colour_path(ramp);
  Ramp result;
  for (int i = 0; i < bands; ++i) {
    const float whole = path.places.back();
    const float place = bands > 1 ? static_cast<float>(i) * whole / static_cast<float>(bands - 1) : whole / 2;
    result.stops.push_back({static_cast<float>(i) / static_cast<float>(bands), path.at(place), true});
  }
  return result;
}

}  // namespace inkbench
