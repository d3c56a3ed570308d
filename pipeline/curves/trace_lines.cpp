// SPDX-License-Identifier: MIT
#include "pipeline/curves/trace_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "pipeline/curves/even_course.h"
#include "pipeline/curves/pixel_graph.h"
#include "pipeline/curves/steady_labels.h"

namespace inkbench {
namespace {

/// Over so many points a curve turns towards the one that it ends on.
constexpr size_t kTurnsOver = 6;
constexpr glm::vec2 kHalfOfDot{0.05F, 0.0F};

/// A chain with the even course of its points.
struct Course {
  PixelChain chain;
  std::vector<glm::vec2> points;  ///< One for each pixel.
};

bool is_outline(CurveClass curve_class) {
  return curve_class == CurveClass::silhouette || curve_class == CurveClass::boundary ||
         curve_class == CurveClass::object;
}

class LineTracing {
 public:
  LineTracing(const LinePixels& lines, float reach_px) : lines_(lines), reach_px_(reach_px), graph_(lines) {}

  Curves trace() {
    for (PixelChain& chain : chain_pixels(lines_, graph_)) add_course(std::move(chain));
    join_ends();
    for (uint32_t i = 0; i < courses_.size(); ++i) add_curves(i);
    return std::move(curves_);
  }

 private:
  const LinePixel& pixel(uint32_t index) const { return lines_.pixels[index]; }
  bool is_junction(uint32_t index) const { return graph_.links_of(index).size() > 2; }

  void add_course(PixelChain chain) {
    std::vector<glm::vec2> points, centres;
    for (const uint32_t index : chain.pixels) {
      points.push_back(pixel(index).point());
      centres.push_back(pixel(index).centre());
    }
    std::vector<glm::vec2> course = even_course(points, centres, chain.is_ring, reach_px_);
    courses_.push_back({std::move(chain), std::move(course)});
  }

  // ---- Ends that meet another course.

  /// Courses end where the one lies that goes on through the same pixel.
  void join_ends() {
    std::vector<std::optional<glm::vec2>> through(graph_.size());
    for (const Course& course : courses_) {
      const std::vector<uint32_t>& pixels = course.chain.pixels;
      for (size_t i = course.chain.is_ring ? 0 : 1; i + 1 < pixels.size(); ++i) {
        if (is_junction(pixels[i]) && !through[pixels[i]]) through[pixels[i]] = course.points[i];
      }
    }
    for (Course& course : courses_) {
      if (course.chain.is_ring) continue;
      std::vector<glm::vec2>& points = course.points;
      const std::optional<glm::vec2>& first = through[course.chain.pixels.front()];
      const std::optional<glm::vec2>& last = through[course.chain.pixels.back()];
      if (first) bend_start(course.chain.pixels.begin(), course.chain.pixels.end(), points.begin(), *first);
      if (last) bend_start(course.chain.pixels.rbegin(), course.chain.pixels.rend(), points.rbegin(), *last);
    }
  }

  /// Moves the first point of a course, and the following ones less and less, up to the next junction.
  template <class PixelAt, class PointAt>
  void bend_start(PixelAt pixel_at, PixelAt end, PointAt point_at, const glm::vec2& start) const {
    const glm::vec2 shift = start - *point_at;
    size_t count = 1;
    while (count < kTurnsOver && pixel_at + count != end && !is_junction(*(pixel_at + count))) ++count;
    for (size_t i = 0; i < count && pixel_at + i != end; ++i) {
      const float share = 1.0F - static_cast<float>(i) / static_cast<float>(count);
      point_at[i] = kept_within(point_at[i] + share * shift, pixel(pixel_at[i]).centre(), reach_px_);
    }
  }

  // ---- Curves of one class.

  uint32_t label(uint32_t index) const {
    const LinePixel& line = pixel(index);
    return static_cast<uint32_t>(line.object_id) * static_cast<uint32_t>(kCurveClasses) +
           static_cast<uint32_t>(line.curve_class);
  }

  void add_curves(uint32_t chain_index) {
    Course& course = courses_[chain_index];
    if (course.points.size() == 1) return add_dot(chain_index);
    std::vector<uint32_t> labels;
    const size_t count = course.points.size() - (course.chain.is_ring ? 1 : 0);
    for (size_t i = 0; i < count; ++i) labels.push_back(label(course.chain.pixels[i]));
    labels = steady_labels(labels, course.chain.is_ring);
    if (course.chain.is_ring) start_at_change(course, labels);
    for (size_t first = 0, next = 0; next < count; first = next - 1) {
      const size_t begin = next;
      while (next < count && labels[next] == labels[begin]) ++next;
      const size_t last = next == count ? course.points.size() - 1 : next - 1;
      add_piece(chain_index, labels[begin], begin == 0 ? 0 : first, last);
    }
  }

  /// Turns a ring of several classes so that none of them goes on across its start.
  static void start_at_change(Course& course, std::vector<uint32_t>& labels) {
    const auto change = std::adjacent_find(labels.begin(), labels.end(), std::not_equal_to<>());
    if (change == labels.end() || labels.front() != labels.back()) return;
    const auto start = change + 1 - labels.begin();
    std::rotate(labels.begin(), labels.begin() + start, labels.end());
    const auto turn = [&](auto& ring) {
      ring.pop_back();
      std::rotate(ring.begin(), ring.begin() + start, ring.end());
      ring.push_back(ring.front());
    };
    turn(course.chain.pixels);
    turn(course.points);
  }

  /// Points `first` to `last` of a course; both may be another piece's, too.
  void add_piece(uint32_t chain_index, uint32_t piece_label, size_t first, size_t last) {
    const Course& course = courses_[chain_index];
    const std::vector<uint32_t>& pixels = course.chain.pixels;
    Curve curve = empty_curve(chain_index, piece_label);
    const bool is_whole = first == 0 && last + 1 == pixels.size();
    const bool is_closed = is_whole && course.chain.is_ring;
    curve.start = is_closed ? CurveEnd::closed : end_at(course.chain, first);
    curve.end = is_closed ? CurveEnd::closed : end_at(course.chain, last);
    for (size_t i = first; i <= last; ++i) {
      curve.points.push_back(course.points[i]);
      curve.depths.push_back(pixel(pixels[i]).depth);
    }
    curve.places.assign(curve.points.size(), 0);
    if (is_outline(curve.curve_class))
      curve.behind = most_seen_behind({pixels.data() + first, last + 1 - first}, piece_label);
    curves_.curves.push_back(std::move(curve));
  }

  void add_dot(uint32_t chain_index) {
    const uint32_t index = courses_[chain_index].chain.pixels[0];
    const glm::vec2 point = courses_[chain_index].points[0], centre = pixel(index).centre();
    Curve curve = empty_curve(chain_index, label(index));
    curve.points = {kept_within(point - kHalfOfDot, centre, reach_px_),
                    kept_within(point + kHalfOfDot, centre, reach_px_)};
    curve.depths.assign(2, pixel(index).depth);
    curve.places.assign(2, 0);
    if (is_outline(curve.curve_class)) curve.behind = pixel(index).behind;
    curves_.curves.push_back(std::move(curve));
  }

  Curve empty_curve(uint32_t chain_index, uint32_t piece_label) const {
    Curve curve;
    curve.curve_class = static_cast<CurveClass>(piece_label % kCurveClasses);
    curve.object_id = static_cast<int>(piece_label / kCurveClasses);
    curve.is_traced = true;
    curve.chain = chain_index;
    return curve;
  }

  /// Where a chain is cut, or ends.
  CurveEnd end_at(const PixelChain& chain, size_t at) const {
    if (chain.is_ring || (at > 0 && at + 1 < chain.pixels.size())) return CurveEnd::other_class;
    if (is_junction(chain.pixels[at])) return CurveEnd::junction;
    const LinePixel& line = pixel(chain.pixels[at]);
    const bool is_at_frame =
        line.x == 0 || line.y == 0 || line.x + 1 == lines_.width_px || line.y + 1 == lines_.height_px;
    return is_at_frame ? CurveEnd::frame : CurveEnd::free;
  }

  /// By the pixels of the piece's own label.
  Behind most_seen_behind(std::span<const uint32_t> pixels, uint32_t piece_label) const {
    std::array<int, 4> seen{};
    for (const uint32_t index : pixels) {
      const Behind behind = pixel(index).behind;
      if (label(index) == piece_label && behind != Behind::unknown) ++seen[static_cast<size_t>(behind)];
    }
    const auto most = std::max_element(seen.begin(), seen.end());
    return *most == 0 ? Behind::unknown : static_cast<Behind>(most - seen.begin());
  }

  const LinePixels& lines_;
  float reach_px_;
  PixelGraph graph_;
  std::vector<Course> courses_;
  Curves curves_{lines_.width_px, lines_.height_px, {}, {}};
};

}  // namespace

Curves trace_lines(const LinePixels& lines, float reach_px) {
  return LineTracing(lines, reach_px).trace();
}

}  // namespace inkbench
