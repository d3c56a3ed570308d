// SPDX-License-Identifier: MIT
#include "pipeline/curves/even_course.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inkbench {
namespace {

/// Half widths of the boxes of which three in a row are nearly a Gaussian of deviation sqrt(r (r + 1)).
constexpr std::array<int, 4> kHalfWidths{1, 2, 4, 8};
constexpr int kBoxes = 9;

/// In the end all is smoothed this often and kept in the tube, so that it bends evenly where the tube holds
/// it.
constexpr int kLastRounds = 5;
constexpr int kLastHalfWidth = 1;

/// A course counts as leaving the tube from this share of its reach on.
constexpr float kShareOfReach = 0.8F;

/// Point i of a course that goes on beyond its ends: a ring around, a line turned about its end.
class Endless {
 public:
  Endless(std::span<const glm::vec2> points, bool ring)
      : points_(points), ring_(ring), last_(static_cast<int>(points.size()) - 1) {}

  glm::dvec2 at(int i) const {
    const int period = ring_ ? last_ : 2 * last_;
    const int turns = i >= 0 ? i / period : -((period - 1 - i) / period);
    const int within = i - turns * period;
    if (ring_) return points_[within];
    const glm::dvec2 first = points_.front(), last = points_.back();
    const glm::dvec2 shift = 2.0 * turns * (last - first);
    if (within <= last_) return glm::dvec2(points_[within]) + shift;
    return 2.0 * last - glm::dvec2(points_[period - within]) + shift;
  }

 private:
  std::span<const glm::vec2> points_;
  bool ring_;
  int last_;
};

/// Means over 2 r + 1 values each; 2 r values fewer.
void box(std::vector<glm::dvec2>& values, int r) {
  const size_t width = 2 * static_cast<size_t>(r) + 1;
  glm::dvec2 sum(0.0);
  for (size_t i = 0; i + 1 < width; ++i) sum += values[i];
  for (size_t i = 0; i + width <= values.size(); ++i) {
    const glm::dvec2 first = values[i];
    sum += values[i + width - 1];
    values[i] = sum / static_cast<double>(width);
    sum -= first;
  }
  values.resize(values.size() - width + 1);
}

/// Smoothed once, and what that takes away smoothed twice given back: 1 - (1 - G)^3 keeps polynomials of the
/// fifth degree, so that arcs keep their radius.
std::vector<glm::vec2> smoothed(std::span<const glm::vec2> points, bool ring, int r) {
  const Endless endless(points, ring);
  const int count = static_cast<int>(points.size());
  const int margin = kBoxes * r;
  std::vector<glm::dvec2> once;
  once.reserve(static_cast<size_t>(count) + 2 * static_cast<size_t>(margin));
  for (int i = -margin; i < 0; ++i) once.push_back(endless.at(i));
  once.insert(once.end(), points.begin(), points.end());
  for (int i = count; i < count + margin; ++i) once.push_back(endless.at(i));
  const auto smooth = [&](std::vector<glm::dvec2>& values) {
    for (int i = 0; i < kBoxes / 3; ++i) box(values, r);
  };
  smooth(once);
  std::vector<glm::dvec2> twice = once;
  smooth(twice);
  std::vector<glm::dvec2> thrice = twice;
  smooth(thrice);
  std::vector<glm::vec2> result(points.size());
  const size_t third = static_cast<size_t>(margin) / 3;
  for (size_t i = 0; i < result.size(); ++i)
    result[i] = 3.0 * once[i + 2 * third] - 3.0 * twice[i + third] + thrice[i];
  return result;
}

/// For each point how many points away the nearest one is that is marked; at most `most`.
std::vector<int> distances(const std::vector<uint8_t>& marked, bool ring, int most) {
  std::vector<int> distance(marked.size(), most);
  const auto sweep = [&](auto begin, auto end, auto mark) {
    int since = most;
    for (int turn = ring ? 0 : 1; turn < 2; ++turn) {  // a ring twice around
      auto is_marked = mark;
      for (auto at = begin; at != end; ++at, ++is_marked) {
        since = *is_marked != 0 ? 0 : std::min(since + 1, most);
        *at = std::min(*at, since);
      }
    }
  };
  sweep(distance.begin(), distance.end(), marked.begin());
  sweep(distance.rbegin(), distance.rend(), marked.rbegin());
  return distance;
}

/// Takes the smoother course wherever it stays in the tube, as far from where it does not as it is smoothed.
void take(std::vector<glm::vec2>& course, const std::vector<glm::vec2>& smoother,
          std::span<const glm::vec2> points, bool ring, int r, float reach_px) {
  std::vector<uint8_t> leaves(points.size());
  for (size_t i = 0; i < leaves.size(); ++i)
    leaves[i] = glm::distance(smoother[i], points[i]) > kShareOfReach * reach_px ? 1 : 0;
  const std::vector<int> distance = distances(leaves, ring, 2 * r);
  for (size_t i = 0; i < course.size(); ++i) {
    const float share = static_cast<float>(distance[i] - r) / static_cast<float>(r);
    course[i] = glm::mix(course[i], smoother[i], std::clamp(share, 0.0F, 1.0F));
  }
}

}  // namespace

glm::vec2 kept_within(const glm::vec2& point, const glm::vec2& centre, float reach_px) {
  const glm::vec2 away = point - centre;
  const float length = glm::length(away);
  return length > reach_px ? centre + away * (reach_px / length) : point;
}

std::vector<glm::vec2> even_course(std::span<const glm::vec2> points, std::span<const glm::vec2> centres,
                                   bool ring, float reach_px) {
  std::vector<glm::vec2> course(points.begin(), points.end());
  for (const int r : kHalfWidths) {
    if (points.size() < 2 * static_cast<size_t>(r) + 1) break;
    const std::vector<glm::vec2> smoother = smoothed(points, ring, r);
    if (r == kHalfWidths[0])
      course = smoother;
    else
      take(course, smoother, points, ring, r, reach_px);
  }
  for (int round = 0; round < kLastRounds; ++round) {
    if (round > 0 && points.size() > 2) course = smoothed(course, ring, kLastHalfWidth);
    if (!ring) course.front() = points.front();
    course.back() = ring ? course.front() : points.back();
    for (size_t i = 0; i < course.size(); ++i) course[i] = kept_within(course[i], centres[i], reach_px);
  }
  return course;
}

}  // namespace inkbench
