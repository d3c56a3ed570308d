// SPDX-License-Identifier: MIT
#include "pipeline/curves/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <span>

#include "pipeline/base/parallel.h"

namespace inkbench {
namespace {

constexpr double kCellPx = 8.0;
/// What rounding may add to a nearness, as a share of it: what touches is as near.
constexpr double kAsNear = 1e-7;
/// Less of a share than this is the outline's own running to and fro.
constexpr double kApart = 2e-3;

/// A step of a line.
struct Step {
  uint32_t line = 0, at = 0;
};

/// The image and its margin in square cells, each with the steps that run through it.
class CellGrid {
 public:
  CellGrid(int width_px, int height_px)
      : columns_(cells_for(width_px)), rows_(cells_for(height_px)), heads_(columns_ * rows_, kNone) {}

  void add(uint32_t step, const glm::dvec3& a, const glm::dvec3& b) {
    each_cell(a, b, [&](size_t cell) {
      links_.push_back({step, heads_[cell]});
      heads_[cell] = static_cast<uint32_t>(links_.size() - 1);
    });
  }

  template <class Use>
  void each_near(const glm::dvec3& a, const glm::dvec3& b, Use&& use) const {
    each_cell(a, b, [&](size_t cell) {
      for (uint32_t link = heads_[cell]; link != kNone; link = links_[link].next) use(links_[link].step);
    });
  }

 private:
  static constexpr uint32_t kNone = ~0U;
  struct Entry {
    uint32_t step, next;
  };

  static size_t cells_for(int size_px) {
    return static_cast<size_t>(std::ceil((size_px + 2.0 * kCurveMarginPx) / kCellPx)) + 1;
  }
  static double cell_of(double px) { return std::floor((px + kCurveMarginPx) / kCellPx); }

  /// Row by row those columns that the step, a little thickened, runs through.
  template <class Use>
  void each_cell(const glm::dvec3& a, const glm::dvec3& b, Use&& use) const {
    constexpr double kThick = 1e-3;
    const glm::dvec3& top = a.y <= b.y ? a : b;
    const glm::dvec3& bottom = a.y <= b.y ? b : a;
    const auto clamped = [](double cell, size_t count) {
      return static_cast<size_t>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
    };
    const size_t first_row = clamped(cell_of(top.y - kThick), rows_);
    const size_t last_row = clamped(cell_of(bottom.y + kThick), rows_);
    const double slope = top.y < bottom.y ? (bottom.x - top.x) / (bottom.y - top.y) : 0.0;
    for (size_t row = first_row; row <= last_row; ++row) {
      double left = std::min(a.x, b.x);
      double right = std::max(a.x, b.x);
      if (top.y < bottom.y) {
        const double row_top = static_cast<double>(row) * kCellPx - kCurveMarginPx - kThick;
        const double x0 = top.x + slope * (std::clamp(row_top, top.y, bottom.y) - top.y);
        const double x1 =
            top.x + slope * (std::clamp(row_top + kCellPx + 2.0 * kThick, top.y, bottom.y) - top.y);
        left = std::min(x0, x1);
        right = std::max(x0, x1);
      }
      const size_t last = clamped(cell_of(right + kThick), columns_);
      for (size_t column = clamped(cell_of(left - kThick), columns_); column <= last; ++column)
        use(row * columns_ + column);
    }
  }

  size_t columns_, rows_;
  std::vector<uint32_t> heads_;
  std::vector<Entry> links_;
};

double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// Where on the step from a to b the one from c to d meets it, both 0 to 1.
struct Meeting {
  double along = 0.0, other_along = 0.0;
};

std::optional<Meeting> meeting_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                                  const glm::dvec2& d) {
  const glm::dvec2 step = b - a;
  const glm::dvec2 other = d - c;
  const double turn = cross(step, other);
  if (turn == 0.0) return std::nullopt;  // Beside or along each other: their ends meet other steps.
  const double along = cross(c - a, other) / turn;
  const double other_along = cross(c - a, step) / turn;
  if (along < 0.0 || along > 1.0 || other_along < 0.0 || other_along > 1.0) return std::nullopt;
  return Meeting{along, other_along};
}

/// What is found on a step.
struct Found {
  std::vector<double> places;                     ///< 0 to 1, in order.
  std::array<std::optional<CurveEnd>, 2> at_end;  ///< At its ends.
};

class Splitter {
 public:
  Splitter(std::vector<ViewLine>& lines, int width_px, int height_px)
      : lines_(lines), grid_(width_px, height_px) {
    for (uint32_t i = 0; i < lines.size(); ++i) {
      for (uint32_t at = 0; at < lines[i].steps.size(); ++at) {
        if (lines[i].covers)
          grid_.add(static_cast<uint32_t>(steps_.size()), from({i, at}).pixel, to({i, at}).pixel);
        steps_.push_back({i, at});
      }
    }
    found_.resize(steps_.size());
  }

  void split() {
    for_each_in_parallel(steps_.size(), [&](size_t i) { find_on(steps_[i], found_[i]); });
    size_t first = 0;
    for (ViewLine& line : lines_) {
      const std::span<const Found> found(found_.data() + first, line.steps.size());
      first += line.steps.size();
      mark(line, found);
      put_points(line, found);
    }
  }

 private:
  const LinePoint& from(const Step& step) const { return lines_[step.line].points[step.at]; }
  const LinePoint& to(const Step& step) const { return lines_[step.line].points[step.at + 1]; }

  void find_on(const Step& step, Found& found) const {
    thread_local std::vector<uint32_t> near;  // so that a step allocates nothing
    near.clear();
    grid_.each_near(from(step).pixel, to(step).pixel, [&](uint32_t number) { near.push_back(number); });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const uint32_t number : near) meet(step, steps_[number], found);
    std::sort(found.places.begin(), found.places.end());
  }

  void meet(const Step& step, const Step& other, Found& found) const {
    if (step.line == other.line && (step.at == other.at || neighbours(step, other))) return;
    // What shares a point of a surface meets there, whatever rounding says.
    bool shared = false;
    for (size_t end = 0; end < 2; ++end) {
      const uint64_t place = (end == 0 ? from(step) : to(step)).place;
      if (place == 0 || (place != from(other).place && place != to(other).place)) continue;
      if (!found.at_end[end]) found.at_end[end] = CurveEnd::junction;
      shared = true;
    }
    if (shared) return;
    const std::optional<Meeting> meeting =
        meeting_of(glm::dvec2(from(step).pixel), glm::dvec2(to(step).pixel), glm::dvec2(from(other).pixel),
                   glm::dvec2(to(other).pixel));
    if (!meeting) return;
    const double own = glm::mix(from(step).pixel.z, to(step).pixel.z, meeting->along);
    const double its = glm::mix(from(other).pixel.z, to(other).pixel.z, meeting->other_along);
    const bool is_farther = its < own - kAsNear * std::abs(own);
    // Behind an outline something else is seen from where a farther one passes it.
    const bool shows = lines_[step.line].covers && its < own - kApart * std::abs(own);
    if (is_farther && !shows) return;
    if (meeting->along > 0.0 && meeting->along < 1.0) {
      found.places.push_back(meeting->along);
    } else if (std::optional<CurveEnd>& at_end = found.at_end[meeting->along <= 0.0 ? 0 : 1]; !at_end) {
      at_end = CurveEnd::crossing;
    }
  }

  bool neighbours(const Step& a, const Step& b) const {
    const size_t low = std::min(a.at, b.at);
    const size_t high = std::max(a.at, b.at);
    return high - low == 1 ||
           (lines_[a.line].is_closed && low == 0 && high + 1 == lines_[a.line].steps.size());
  }

  static void mark(ViewLine& line, std::span<const Found> found) {
    for (size_t at = 0; at < found.size(); ++at) {
      for (size_t end = 0; end < 2; ++end) {
        std::optional<CurveEnd>& change = line.points[at + end].change;
        if (!change) change = found[at].at_end[end];
      }
    }
    if (!line.is_closed) return;
    LinePoint& first = line.points.front();
    LinePoint& last = line.points.back();
    first.change = last.change = first.change ? first.change : last.change;
  }

  static void put_points(ViewLine& line, std::span<const Found> found) {
    size_t added = 0;
    for (const Found& on_step : found) added += on_step.places.size();
    if (added == 0) return;
    std::vector<LinePoint> points;
    std::vector<LineStep> steps;
    points.reserve(line.points.size() + added);
    steps.reserve(line.steps.size() + added);
    for (size_t at = 0; at < line.steps.size(); ++at) {
      const LinePoint& a = line.points[at];
      const LinePoint& b = line.points[at + 1];
      points.push_back(a);
      for (const double along : found[at].places) {
        LinePoint point;
        point.pixel = glm::mix(a.pixel, b.pixel, along);
        point.world = glm::mix(a.world, b.world, along_in_world(a, b, along));
        point.change = CurveEnd::crossing;
        if (point.pixel == points.back().pixel) continue;
        steps.push_back(line.steps[at]);
        points.push_back(point);
      }
      steps.push_back(line.steps[at]);
    }
    points.push_back(line.points.back());
    line.points = std::move(points);
    line.steps = std::move(steps);
  }

  std::vector<ViewLine>& lines_;
  CellGrid grid_;
  std::vector<Step> steps_;  ///< Of all lines; the grid holds those that cover.
  std::vector<Found> found_;
};

}  // namespace

void split_at_crossings(std::vector<ViewLine>& lines, int width_px, int height_px) {
  Splitter(lines, width_px, height_px).split();
}

}  // namespace inkbench
