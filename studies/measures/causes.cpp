// SPDX-License-Identifier: MIT
#include "studies/measures/causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/measures/distance.h"

namespace inkbench {
namespace {

/// Which pixels of `from` have one of `to` within a distance.
LineMap near(const LineMap& from, const LineMap& to, double distance_px) {
  LineMap result(from.width_px(), from.height_px());
  std::vector<Pixel> pixels;
  for_each_pixel(from, [&](int x, int y) { pixels.push_back({x, y}); });
  const std::vector<int64_t> distances = squared_distances(pixels, to);
  const double limit = distance_px * distance_px + 1e-9;
  for (size_t i = 0; i < pixels.size(); ++i) {
    if (distances[i] != kInfinitelyFar && static_cast<double>(distances[i]) <= limit)
      result.set(pixels[i].x, pixels[i].y);
  }
  return result;
}

/// Half the size: the pixels that have one of `large` among the four that they become.
LineMap halved(const LineMap& large, int width_px, int height_px) {
  LineMap result(width_px, height_px);
  for_each_pixel(large, [&](int x, int y) {
    if (x / 2 < width_px && y / 2 < height_px) result.set(x / 2, y / 2);
  });
  return result;
}

/// Thinning may move a line by a pixel, also aslant.
constexpr double kSamePlacePx = 1.5;

/// The pixels that another drawing has no line at.
LineMap gone(const LineMap& pixels, const LineMap& other) {
  LineMap result = pixels;
  for_each_pixel(near(pixels, other, kSamePlacePx), [&](int x, int y) { result.set(x, y, false); });
  return result;
}

LineMap both(const LineMap& a, const LineMap& b) {
  LineMap result(a.width_px(), a.height_px());
  for_each_pixel(a, [&](int x, int y) { result.set(x, y, b.at(x, y)); });
  return result;
}

class CauseSetter {
 public:
  CauseSetter(CauseMap& causes, const LineMap& of) : causes_(causes), left_(of) {}

  /// Gives the cause to what is left of the map's pixels.
  void set(Cause cause, const LineMap& where) {
    for_each_pixel(LineMap(left_), [&](int x, int y) {
      if (!where.at(x, y)) return;
      causes_.at(x, y) = static_cast<uint8_t>(cause);
      left_.set(x, y, false);
    });
  }
  const LineMap& left() const { return left_; }

 private:
  CauseMap& causes_;
  LineMap left_;
};

/// Along mesh edges that bend: gone with smooth normals, or seen by the surface itself, whose bend at one
/// edge is the same at any size.
LineMap facets(const LineMap& pixels, const CauseEvidence& evidence, const std::optional<LineMap>& large) {
  const LineMap along = near(pixels, *evidence.slight_bends, evidence.tolerance_px);
  LineMap found(pixels.width_px(), pixels.height_px());
  if (evidence.unfaceted) found = gone(along, *evidence.unfaceted);
  if (evidence.reads_surface && large) found = united(found, near(along, *large, kSamePlacePx));
  return found;
}

void find_false_causes(const CauseEvidence& evidence, CauseMap& causes) {
  CauseSetter setter(causes, evidence.maps.wrong);
  std::optional<LineMap> large;
  if (evidence.twice_as_large) large = halved(*evidence.twice_as_large, causes.width_px, causes.height_px);
  const auto set_gone = [&](Cause cause, const std::optional<LineMap>& other,
                            const LineMap* where = nullptr) {
    if (!other) return;
    const LineMap lost = gone(setter.left(), *other);
    setter.set(cause, where == nullptr ? lost : both(lost, *where));
  };
  setter.set(Cause::doubled, near(setter.left(), evidence.reference, 2 * evidence.tolerance_px));
  set_gone(Cause::quantised, evidence.float_buffers);
  set_gone(Cause::seam, evidence.smooth_normals);
  if (evidence.slight_bends) setter.set(Cause::facet, facets(setter.left(), evidence, large));
  if (evidence.even) set_gone(Cause::grazing, evidence.no_depth_term, &*evidence.even);
  set_gone(Cause::bend, large);
  setter.set(Cause::other_false, evidence.maps.wrong);
}

/// The largest within the tolerance: a line there would have been right.
float strongest_near(const Image& strength, int x, int y, double tolerance_px) {
  const int reach = static_cast<int>(std::floor(tolerance_px));
  float most = 0;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const bool is_inside =
          x + dx >= 0 && y + dy >= 0 && x + dx < strength.width_px && y + dy < strength.height_px;
      if (is_inside && dx * dx + dy * dy <= tolerance_px * tolerance_px)
        most = std::max(most, strength.at(x + dx, y + dy));
    }
  }
  return most;
}

/// Of the limit: less is as good as nothing.
constexpr float kSignal = 0.01F;

/// What is missed for want of strength, and by how much.
void find_weak(const CauseEvidence& evidence, CauseSetter& setter, Image& missing_factor) {
  LineMap silent = setter.left(), weak(silent.width_px(), silent.height_px());
  for_each_pixel(setter.left(), [&](int x, int y) {
    const float most = strongest_near(*evidence.strength, x, y, evidence.tolerance_px);
    silent.set(x, y, most < kSignal);
    weak.set(x, y, most >= kSignal && most < 1.0F);
    if (weak.at(x, y)) missing_factor.at(x, y) = 1.0F / most;
  });
  if (!evidence.tells_objects) setter.set(Cause::same_id, near(silent, evidence.objects, 1.0));
  setter.set(Cause::no_signal, silent);
  setter.set(Cause::under_the_limit, weak);
}

void find_missed_causes(const CauseEvidence& evidence, CauseMaps& maps) {
  CauseSetter setter(maps.of_missed, evidence.maps.missed);
  setter.set(Cause::displaced, near(setter.left(), evidence.drawn, 2 * evidence.tolerance_px));
  if (evidence.strength) find_weak(evidence, setter, maps.missing_factor);
  setter.set(Cause::other_missed, evidence.maps.missed);
}

}  // namespace

CauseMaps find_causes(const CauseEvidence& evidence) {
  const int width_px = evidence.maps.wrong.width_px(), height_px = evidence.maps.wrong.height_px();
  CauseMaps causes{CauseMap(width_px, height_px, 1), CauseMap(width_px, height_px, 1),
                   Image(width_px, height_px, 1)};
  find_false_causes(evidence, causes.of_false);
  find_missed_causes(evidence, causes);
  return causes;
}

std::optional<PixelCause> cause_near(const CauseMaps& causes, int x, int y, double reach_px) {
  const int reach = static_cast<int>(std::floor(reach_px));
  std::optional<PixelCause> nearest;
  double least = reach_px * reach_px;
  for (int other_y = std::max(y - reach, 0); other_y <= std::min(y + reach, causes.of_false.height_px - 1);
       ++other_y) {
    for (int other_x = std::max(x - reach, 0); other_x <= std::min(x + reach, causes.of_false.width_px - 1);
         ++other_x) {
      const double distance = (other_x - x) * (other_x - x) + (other_y - y) * (other_y - y);
      const Cause cause = causes.at(other_x, other_y);
      if (cause == Cause::none || distance > least || (nearest && distance == least)) continue;
      least = distance;
      const float factor = info_of(cause).is_of_missed() ? causes.missing_factor.at(other_x, other_y) : 0.0F;
      nearest = PixelCause{cause, other_x, other_y, factor};
    }
  }
  return nearest;
}

std::string cause_text(const PixelCause& found) {
  const CauseInfo& info = info_of(found.cause);
  std::string text =
      fmt::format("{} line, {}: {}", info.is_of_missed() ? "Missed" : "False", info.name, info.help);
  if (found.missing_factor > 0) text += fmt::format(" It lacks a factor of {:.3g}.", found.missing_factor);
  return text + fmt::format(" What would mend it: {}.", info.remedy);
}

void CauseCounts::add(const CauseCounts& other) {
  for (size_t i = 0; i < kCauses; ++i) pixels[i] += other.pixels[i];
}

CauseCounts count_causes(const CauseMaps& causes) {
  CauseCounts counts;
  for (const CauseMap* map : {&causes.of_false, &causes.of_missed}) {
    for (const uint8_t cause : map->samples) {
      if (cause > 0) ++counts.pixels[cause - 1U];
    }
  }
  return counts;
}

Picture cause_overlay(const CauseMaps& causes) {
  Picture picture(causes.of_false.width_px, causes.of_false.height_px, 4);
  for (int y = 0; y < picture.height_px; ++y) {
    for (int x = 0; x < picture.width_px; ++x) {
      const Cause cause = causes.at(x, y);
      if (cause == Cause::none) continue;
      for (int c = 0; c < 3; ++c) picture.at(x, y, c) = info_of(cause).colour[c];
      picture.at(x, y, 3) = 255;
    }
  }
  return picture;
}

}  // namespace inkbench
