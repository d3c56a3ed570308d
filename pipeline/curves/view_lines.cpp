// SPDX-License-Identifier: MIT
#include "pipeline/curves/view_lines.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <iterator>

namespace inkbench {
namespace {

/// Signed distances to the six planes of the view, which is wider than the image by these shares of w.
std::array<double, 6> margins_of(const glm::dvec4& clip, const glm::dvec2& wide) {
  return {wide.x * clip.w + clip.x, wide.x * clip.w - clip.x, wide.y * clip.w + clip.y,
          wide.y * clip.w - clip.y, clip.w + clip.z,          clip.w - clip.z};
}

/// Shares of a step's length that lie inside; none if from > to.
struct Share {
  double from = 0.0, to = 1.0;
};

Share share_inside(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec2& wide) {
  const std::array<double, 6> at_a = margins_of(a, wide);
  const std::array<double, 6> at_b = margins_of(b, wide);
  Share share;
  for (size_t i = 0; i < at_a.size(); ++i) {
    if (at_a[i] < 0.0 && at_b[i] < 0.0) return {1.0, 0.0};
    if (at_a[i] < 0.0) share.from = std::max(share.from, at_a[i] / (at_a[i] - at_b[i]));
    if (at_b[i] < 0.0) share.to = std::min(share.to, at_a[i] / (at_a[i] - at_b[i]));
  }
  return share;
}

class Clipper {
 public:
  Clipper(const ViewLine& line, const CurveView& view)
      : line_(line),
        view_(view),
        wide_(1.0 + 2.0 * kCurveMarginPx / view.width_px(), 1.0 + 2.0 * kCurveMarginPx / view.height_px()) {}

  std::vector<ViewLine> parts() {
    bool is_open = false;
    glm::dvec4 from = view_.to_clip(line_.points[0].world);
    for (size_t i = 0; i + 1 < line_.points.size(); ++i) {
      const glm::dvec4 to = view_.to_clip(line_.points[i + 1].world);
      const Share share = share_inside(from, to, wide_);
      if (share.from < share.to) {
        if (!is_open || share.from > 0.0) begin(i, from, to, share.from);
        parts_.back().steps.push_back(line_.steps[i]);
        add(i, from, to, share.to);
      }
      is_open = share.from < share.to && share.to == 1.0;
      if (!is_open && !parts_.empty() && share.from < share.to) parts_.back().end = CurveEnd::frame;
      from = to;
    }
    if (line_.is_closed) close();
    return std::move(parts_);
  }

 private:
  void begin(size_t step, const glm::dvec4& from, const glm::dvec4& to, double share) {
    ViewLine part;
    part.line_class = line_.line_class;
    part.model = line_.model;
    part.covers = line_.covers;
    part.follows = line_.follows;
    part.is_drawn = line_.is_drawn;
    part.start = share > 0.0 ? CurveEnd::frame : CurveEnd::free;
    parts_.push_back(std::move(part));
    add(step, from, to, share);
  }

  void add(size_t step, const glm::dvec4& from, const glm::dvec4& to, double share) {
    const LinePoint& a = line_.points[step];
    const LinePoint& b = line_.points[step + 1];
    LinePoint point = share == 0.0   ? a
                      : share == 1.0 ? b
                                     : LinePoint{glm::mix(a.world, b.world, share), {}, 0, {}};
    point.pixel = view_.to_pixel(glm::mix(from, to, share));
    parts_.back().points.push_back(point);
  }

  /// The first part goes on from the last one, or is all of the line.
  void close() {
    if (parts_.empty()) return;
    ViewLine& first = parts_.front();
    ViewLine& last = parts_.back();
    const bool through = first.start != CurveEnd::frame && last.end != CurveEnd::frame &&
                         first.points.front().world == last.points.back().world;
    if (!through) return;
    if (parts_.size() == 1) {
      first.is_closed = true;
      first.start = first.end = CurveEnd::closed;
      return;
    }
    std::copy(first.points.begin() + 1, first.points.end(), std::back_inserter(last.points));
    std::copy(first.steps.begin(), first.steps.end(), std::back_inserter(last.steps));
    last.end = first.end;
    parts_.erase(parts_.begin());
  }

  const ViewLine& line_;
  const CurveView& view_;
  glm::dvec2 wide_;
  std::vector<ViewLine> parts_;
};

}  // namespace

double along_in_world(const LinePoint& a, const LinePoint& b, double along_in_image) {
  const bool is_perspective = a.pixel.z > 0.0;  // 1 / z; else -z, which is even in the world
  return is_perspective ? along_in_image * b.pixel.z / glm::mix(a.pixel.z, b.pixel.z, along_in_image)
                        : along_in_image;
}

void add_to_view(const ViewLine& line, const CurveView& view, std::vector<ViewLine>& lines) {
  std::vector<ViewLine> parts = Clipper(line, view).parts();
  std::move(parts.begin(), parts.end(), std::back_inserter(lines));
}

}  // namespace inkbench
