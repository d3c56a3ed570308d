// SPDX-License-Identifier: MIT
#include "studies/measures/causes.h"

#include <algorithm>
#include <cmath>

#include "studies/measures/distance.h"

namespace inkbench {
namespace {

constexpr std::array<CauseInfo, kCauses> kTable{{
    {Cause::doubled,
     "false_doubled",
     "doubled",
     "A second line beside one that is there already, or a line too thick to thin to one.",
     "thin the lines on the nearer side: another method, or a lower sensitivity",
     {230, 159, 0}},
    {Cause::quantised,
     "false_quantised",
     "quantised",
     "It is gone with float buffers.",
     "image.precision = float",
     {204, 121, 167}},
    {Cause::seam,
     "false_seam",
     "seam",
     "The normals jump on a smooth surface, where the file's vertices are split.",
     "model.NAME.normals = smooth, or a method that reads the surface",
     {0, 114, 178}},
    {Cause::facet,
     "false_facet",
     "facet",
     "It runs along mesh edges that bend less than a crease.",
     "smooth normals, more triangles, or a larger angle",
     {86, 180, 233}},
    {Cause::grazing,
     "false_grazing",
     "grazing",
     "The depth term sees a surface's slope: the neighbours lie in the pixel's plane.",
     "edges.method = dihedral, or a test against the plane",
     {213, 94, 0}},
    {Cause::bend,
     "false_bend",
     "bend",
     "A smooth bend looks sharp at this size and is gone at twice the size.",
     "a larger image, or a less sensitive limit",
     {0, 158, 115}},
    {Cause::other_false,
     "false_other",
     "other",
     "None of these.",
     "`inkbench explain` says what the terms are",
     {90, 90, 90}},
    {Cause::displaced,
     "missed_displaced",
     "displaced",
     "A line lies near, farther off than the tolerance.",
     "place lines on the nearer side: another method",
     {230, 159, 0}},
    {Cause::same_id,
     "missed_same_id",
     "ids only",
     "Two objects touch without a step or a bend, and the detector does not look at ids.",
     "edges.method = dihedral or mitchell",
     {204, 121, 167}},
    {Cause::no_signal,
     "missed_no_signal",
     "no signal",
     "The detector sees under 1 % of its limit there.",
     "another method: no limit of this one draws it",
     {90, 90, 90}},
    {Cause::under_the_limit,
     "missed_under_the_limit",
     "under the limit",
     "The detector sees something, though less than its limit.",
     "a lower limit; `inkbench explain` says which",
     {0, 114, 178}},
    {Cause::other_missed,
     "missed_other",
     "other",
     "Detected, yet not drawn there, or drawn and paired with another line.",
     "thinner or unbroken lines",
     {213, 94, 0}},
}};

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

/// The pixels of a map of half the size that have one of `large` among the four they become, or beside those.
LineMap halved(const LineMap& large, int width_px, int height_px) {
  LineMap result(width_px, height_px);
  for_each_pixel(large, [&](int x, int y) {
    result.set(std::min(x / 2, width_px - 1), std::min(y / 2, height_px - 1));
  });
  return result;
}

/// Thinning may move a line by a pixel, and a corner's by two.
constexpr double kSamePlacePx = 1.5;

/// The false pixels where another drawing has no line.
LineMap gone(const LineMap& wrong, const LineMap& other) {
  LineMap result = wrong;
  const LineMap stays = near(wrong, other, kSamePlacePx);
  for_each_pixel(wrong, [&](int x, int y) { result.set(x, y, !stays.at(x, y)); });
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

void find_false_causes(const CauseEvidence& evidence, CauseMap& causes) {
  CauseSetter setter(causes, evidence.maps.wrong);
  setter.set(Cause::doubled, near(setter.left(), evidence.reference, 2 * evidence.tolerance_px));
  const auto set_gone = [&](Cause cause, const std::optional<LineMap>& other) {
    if (other) setter.set(cause, gone(setter.left(), *other));
  };
  set_gone(Cause::quantised, evidence.float_buffers);
  set_gone(Cause::seam, evidence.smooth_normals);
  if (evidence.slight_bends)
    setter.set(Cause::facet, near(setter.left(), *evidence.slight_bends, kSamePlacePx));
  if (evidence.no_depth_term && evidence.even) {
    LineMap grazing = gone(setter.left(), *evidence.no_depth_term);
    for_each_pixel(LineMap(grazing), [&](int x, int y) { grazing.set(x, y, evidence.even->at(x, y)); });
    setter.set(Cause::grazing, grazing);
  }
  if (evidence.twice_as_large) {
    const LineMap large = halved(*evidence.twice_as_large, causes.width_px, causes.height_px);
    setter.set(Cause::bend, gone(setter.left(), large));
  }
  setter.set(Cause::other_false, evidence.maps.wrong);
}

/// The pixels around which the strength is in [low, high), at its largest within the tolerance.
LineMap with_strength(const LineMap& of, const Image& strength, double tolerance_px, double low,
                      double high) {
  const int reach = static_cast<int>(std::floor(tolerance_px));
  LineMap result(of.width_px(), of.height_px());
  for_each_pixel(of, [&](int x, int y) {
    float most = 0;
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        if (of.contains(x + dx, y + dy) && dx * dx + dy * dy <= tolerance_px * tolerance_px)
          most = std::max(most, strength.at(x + dx, y + dy));
      }
    }
    result.set(x, y, most >= low && most < high);
  });
  return result;
}

void find_missed_causes(const CauseEvidence& evidence, CauseMap& causes) {
  CauseSetter setter(causes, evidence.maps.missed);
  setter.set(Cause::displaced, near(setter.left(), evidence.drawn, 2 * evidence.tolerance_px));
  const auto strength_in = [&](double low, double high) {
    return with_strength(setter.left(), *evidence.strength, evidence.tolerance_px, low, high);
  };
  constexpr double kSignal = 0.01;
  if (evidence.strength) {
    if (!evidence.tells_objects) {
      LineMap unseen = strength_in(0.0, kSignal);
      const LineMap at_objects = near(unseen, evidence.objects, 1.0);
      setter.set(Cause::same_id, at_objects);
    }
    setter.set(Cause::no_signal, strength_in(0.0, kSignal));
    setter.set(Cause::under_the_limit, strength_in(kSignal, 1.0));
  }
  setter.set(Cause::other_missed, evidence.maps.missed);
}

}  // namespace

std::span<const CauseInfo, kCauses> cause_table() {
  return kTable;
}

CauseMaps find_causes(const CauseEvidence& evidence) {
  const int width_px = evidence.maps.wrong.width_px(), height_px = evidence.maps.wrong.height_px();
  CauseMaps causes{CauseMap(width_px, height_px, 1), CauseMap(width_px, height_px, 1)};
  find_false_causes(evidence, causes.of_false);
  find_missed_causes(evidence, causes.of_missed);
  return causes;
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
