// SPDX-License-Identifier: MIT
#include "studies/measures/jaggedness.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace inkbench {
namespace {

constexpr double kReachPx = 4;
constexpr int kHalfWindow = 7;  // of a window of 15 samples, 1 px apart

/// Parameters at which a straight piece crosses lines of the pixel grid; 8 px cross at most 9 + 9 of them.
class Crossings {
 public:
  Crossings() { add(-kReachPx); }

  void add(double t) {
    if (count_ < values_.size()) values_[count_++] = t;
  }
  /// Where start + t * direction is a whole number.
  void add_grid_lines(double start, double direction) {
    const double low = start - kReachPx * std::abs(direction), high = start + kReachPx * std::abs(direction);
    for (double line = std::ceil(low); line <= high && direction != 0; ++line) {
      add(std::clamp((line - start) / direction, -kReachPx, kReachPx));
    }
  }
  std::span<const double> sorted() {
    add(kReachPx);
    std::sort(values_.begin(), values_.begin() + count_);
    return {values_.data(), count_};
  }

 private:
  std::array<double, 24> values_{};
  size_t count_ = 0;
};

bool is_inside(const LineMap& map, double x, double y) {
  return x >= kIgnoredBorderPx && y >= kIgnoredBorderPx && x < map.width_px() - kIgnoredBorderPx &&
         y < map.height_px() - kIgnoredBorderPx;
}

/// A straight piece of a polyline.
struct Piece {
  double x, y, dx, dy, length;
};

/// Those that have a direction: both ends finite and not the same.
std::vector<Piece> pieces_of(const Polyline& line) {
  std::vector<Piece> pieces;
  for (size_t i = 0; i + 1 < line.points.size(); ++i) {
    const double x = line.points[i].x, y = line.points[i].y;
    const double dx = line.points[i + 1].x - x, dy = line.points[i + 1].y - y, length = std::hypot(dx, dy);
    if (length > 0 && std::isfinite(length)) pieces.push_back({x, y, dx, dy, length});
  }
  return pieces;
}

/// The offset at each whole px of arc length.
std::vector<std::optional<double>> offsets_along(const LineMap& ink, const Polyline& line) {
  const std::vector<Piece> pieces = pieces_of(line);
  std::vector<std::optional<double>> offsets;
  double begin = 0;  // of the piece, in arc length
  for (size_t i = 0; i < pieces.size(); ++i) {
    const auto [x, y, dx, dy, length] = pieces[i];
    const bool is_last = i + 1 == pieces.size();
    const double end = begin + length;
    for (auto s = static_cast<double>(offsets.size()); s < end || (is_last && s <= end); ++s) {
      const double at_x = x + dx * (s - begin) / length, at_y = y + dy * (s - begin) / length;
      offsets.push_back(is_inside(ink, at_x, at_y) ? ink_offset(ink, at_x, at_y, -dy / length, dx / length)
                                                   : std::nullopt);
    }
    begin = end;
  }
  return offsets;
}

double moving_mean(std::span<const std::optional<double>> offsets, int centre) {
  double sum = 0;
  int count = 0;
  const int last = std::min(static_cast<int>(offsets.size()) - 1, centre + kHalfWindow);
  for (int i = std::max(0, centre - kHalfWindow); i <= last; ++i) {
    if (!offsets[i]) continue;
    sum += *offsets[i];
    ++count;
  }
  return sum / count;
}

}  // namespace

void LineOffsets::add(const LineOffsets& other) {
  samples += other.samples;
  sum += other.sum;
  squared_wobble_sum += other.squared_wobble_sum;
}

std::optional<double> ink_offset(const LineMap& ink, double x, double y, double normal_x, double normal_y) {
  Crossings crossings;
  crossings.add_grid_lines(x, normal_x);
  crossings.add_grid_lines(y, normal_y);
  const std::span<const double> t = crossings.sorted();
  double length = 0, moment = 0;
  for (size_t i = 0; i + 1 < t.size(); ++i) {
    const double middle = (t[i] + t[i + 1]) / 2;
    const double at_x = std::floor(x + middle * normal_x), at_y = std::floor(y + middle * normal_y);
    if (at_x < 0 || at_y < 0 || at_x >= ink.width_px() || at_y >= ink.height_px()) continue;
    if (!ink.at(static_cast<int>(at_x), static_cast<int>(at_y))) continue;
    length += t[i + 1] - t[i];
    moment += (t[i + 1] - t[i]) * middle;
  }
  if (!(length > 0)) return std::nullopt;
  return moment / length;
}

LineOffsets line_offsets(const LineMap& ink, std::span<const Polyline> polylines) {
  LineOffsets total;
  for (const Polyline& line : polylines) {
    const std::vector<std::optional<double>> offsets = offsets_along(ink, line);
    for (int i = 0; i < static_cast<int>(offsets.size()); ++i) {
      if (!offsets[i]) continue;
      const double wobble = *offsets[i] - moving_mean(offsets, i);
      ++total.samples;
      total.sum += *offsets[i];
      total.squared_wobble_sum += wobble * wobble;
    }
  }
  return total;
}

}  // namespace inkbench
