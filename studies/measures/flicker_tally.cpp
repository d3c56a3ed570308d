// SPDX-License-Identifier: MIT
#include "studies/measures/flicker_tally.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "pipeline/base/stop.h"
#include "pipeline/lines/visibility.h"
#include "studies/measures/matching.h"

namespace inkbench {
namespace {

/// Places in the image are whole numbers of this part of a pixel.
constexpr int64_t kParts = 256;

struct Place {
  int64_t x = 0, y = 0;  ///< In parts, from the image's corner.
};

int64_t parts_of(double px) {
  return std::llround(px * static_cast<double>(kParts));
}

Place centre_of(int x, int y) {
  return {x * kParts + kParts / 2, y * kParts + kParts / 2};
}

/// One way: from one frame to another.
struct Way {
  SeenSurface from, to;
  const MotionMap& motion;
  double tolerance_px = 0;

  int64_t reach() const { return static_cast<int64_t>(std::floor(tolerance_px)); }

  /// The pixel whose surface is nearest to the eye within the tolerance; of equal ones the one nearest in the
  /// image. None where there is only background.
  std::optional<Pixel> surface_near(const Pixel& pixel) const {
    const int64_t most = squared_tolerance(tolerance_px);
    std::optional<Pixel> best;
    std::tuple<float, int64_t> best_rank{1.0F, 0};  // the background's depth
    for (int64_t dy = -reach(); dy <= reach(); ++dy) {
      for (int64_t dx = -reach(); dx <= reach(); ++dx) {
        const Pixel at{static_cast<int>(pixel.x + dx), static_cast<int>(pixel.y + dy)};
        const bool is_inside = dx * dx + dy * dy <= most && at.x >= 0 && at.y >= 0 &&
                               at.x < from.depth.width_px && at.y < from.depth.height_px;
        if (!is_inside) continue;
        const std::tuple rank{from.depth.at(at.x, at.y), dx * dx + dy * dy};
        if (std::get<0>(rank) >= 1.0F || rank >= best_rank) continue;
        best_rank = rank;
        best = at;
      }
    }
    return best;
  }

  /// Whether the disc of the tolerance around it lies in what is measured.
  bool is_measured(const Place& place) const {
    const int64_t margin = parts_of(kIgnoredBorderPx + tolerance_px);
    return place.x >= margin && place.y >= margin && place.x <= to.depth.width_px * kParts - margin &&
           place.y <= to.depth.height_px * kParts - margin;
  }

  /// Where a line pixel is in the other frame; none where its surface is not seen there.
  std::optional<Place> carried(const Pixel& pixel) const {
    const std::optional<Pixel> surface = surface_near(pixel);
    if (!surface || motion.at(surface->x, surface->y, 3) == 0.0F) return std::nullopt;
    const auto moved = [&](int channel) {
      return static_cast<double>(motion.at(surface->x, surface->y, channel));
    };
    const double x = surface->x + 0.5 + moved(0), y = surface->y + 0.5 + moved(1);
    const bool is_in_image = x >= 0 && y >= 0 && x < to.depth.width_px && y < to.depth.height_px;
    if (!is_in_image || !DepthTest(to.depth, to.camera)
                             .is_visible({x, y, is_orthographic(to.camera) ? moved(2) : 1.0 / moved(2)}))
      return std::nullopt;
    const Place start = centre_of(pixel.x, pixel.y);
    const Place place{start.x + parts_of(moved(0)), start.y + parts_of(moved(1))};
    return is_measured(place) ? std::optional(place) : std::nullopt;
  }

  bool has_line_near(const Place& place, const LineMap& lines) const {
    const auto most = static_cast<int64_t>(std::floor(tolerance_px * tolerance_px * kParts * kParts));
    const int64_t column = place.x / kParts, row = place.y / kParts;
    for (int64_t y = row - reach() - 1; y <= row + reach() + 1; ++y) {
      for (int64_t x = column - reach() - 1; x <= column + reach() + 1; ++x) {
        const Pixel at{static_cast<int>(x), static_cast<int>(y)};
        if (!lines.contains(at.x, at.y) || !lines.at(at.x, at.y)) continue;
        const Place centre = centre_of(at.x, at.y);
        const int64_t dx = centre.x - place.x, dy = centre.y - place.y;
        if (dx * dx + dy * dy <= most) return true;
      }
    }
    return false;
  }

  /// How many are carried, and how many of them find no line.
  struct Counts {
    int64_t carried = 0, alone = 0;
  };
  Counts counts(const LineMap& lines, const LineMap& others) const {
    Counts counts;
    for (const Pixel& pixel : pixels_of(lines)) {
      stop_if_asked();
      const std::optional<Place> place = carried(pixel);
      if (!place) continue;
      ++counts.carried;
      counts.alone += has_line_near(*place, others) ? 0 : 1;
    }
    return counts;
  }
};

}  // namespace

void FlickerCounts::add(const FlickerCounts& other) {
  died += other.died;
  born += other.born;
  carried += other.carried;
}

std::optional<double> FlickerCounts::share() const {
  if (carried == 0) return std::nullopt;
  return static_cast<double>(died + born) / static_cast<double>(carried);
}

void FlickerTally::add(const FlickerTally& other) {
  drawn.add(other.drawn);
  wanted.add(other.wanted);
}

FlickerCounts LineCarrier::counts(const LineMap& before, const LineMap& now) const {
  const Way::Counts ahead = Way{before_, now_, to_now_, tolerance_px_}.counts(before, now);
  const Way::Counts back = Way{now_, before_, to_before_, tolerance_px_}.counts(now, before);
  return {.died = ahead.alone, .born = back.alone, .carried = ahead.carried + back.carried};
}

}  // namespace inkbench
