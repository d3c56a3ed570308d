// SPDX-License-Identifier: MIT
#include "pipeline/strokes/smooth_path.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace inkbench {
namespace {

constexpr float kReach = 3.0F;  // standard deviations

/// From the middle on, one side; the whole sums up to 1.
std::vector<float> gaussian(float deviation) {
  std::vector<float> weights;
  float sum = 0.0F;
  const int reach = std::max(static_cast<int>(std::ceil(kReach * deviation)), 1);
  for (int i = 0; i <= reach; ++i) {
    const float x = static_cast<float>(i) / deviation;
    weights.push_back(std::exp(-0.5F * x * x));
    sum += i == 0 ? weights.back() : 2.0F * weights.back();
  }
  for (float& weight : weights) weight /= sum;
  return weights;
}

/// As many equal steps of at most a pixel, or a third of the deviation, as the path is long.
std::vector<PathPoint> even_points(const StrokePath& path, float deviation_px) {
  const float step = std::min(1.0F, deviation_px / 3.0F);
  const float start = path.points.front().along_px, length = length_px(path);
  const int count = std::max(static_cast<int>(std::ceil(length / step)), 2);
  std::vector<PathPoint> points;
  for (int i = 0; i <= count; ++i)
    points.push_back(point_at(path, start + length * static_cast<float>(i) / static_cast<float>(count)));
  points.back().at = path.points.back().at;
  return points;
}

/// Beyond an end the way from the chord to the path goes on turned over, so that the end stays.
std::vector<glm::vec2> smoothed_open(const std::vector<PathPoint>& points,
                                     const std::vector<float>& weights) {
  const auto last = static_cast<int>(points.size()) - 1;
  const glm::vec2 start = points.front().at, end = points.back().at;
  const auto chord = [&](int i) {
    return glm::mix(start, end, static_cast<float>(i) / static_cast<float>(last));
  };
  std::vector<glm::vec2> away;
  for (int i = 0; i <= last; ++i) away.push_back(points[i].at - chord(i));
  const auto away_at = [&](int i) {
    const int round = ((i % (2 * last)) + 2 * last) % (2 * last);
    return round <= last ? away[round] : -away[2 * last - round];
  };
  std::vector<glm::vec2> result;
  for (int i = 0; i <= last; ++i) {
    glm::vec2 sum = weights[0] * away[i];
    for (int k = 1; k < static_cast<int>(weights.size()); ++k)
      sum += weights[k] * (away_at(i - k) + away_at(i + k));
    result.push_back(chord(i) + sum);
  }
  result.front() = start;
  result.back() = end;
  return result;
}

std::vector<glm::vec2> smoothed_closed(const std::vector<PathPoint>& points,
                                       const std::vector<float>& weights) {
  const auto count = static_cast<int>(points.size()) - 1;
  const auto at = [&](int i) { return points[((i % count) + count) % count].at; };
  std::vector<glm::vec2> result;
  for (int i = 0; i < count; ++i) {
    glm::vec2 sum = weights[0] * at(i);
    for (int k = 1; k < static_cast<int>(weights.size()); ++k) sum += weights[k] * (at(i - k) + at(i + k));
    result.push_back(sum);
  }
  result.push_back(result.front());
  return result;
}

}  // namespace

StrokePath smoothed(const StrokePath& path, float deviation_px) {
  if (!(deviation_px > 0.0F) || length_px(path) <= 0.0F) return path;
  std::vector<PathPoint> points = even_points(path, deviation_px);
  const float step = length_px(path) / static_cast<float>(points.size() - 1);
  const std::vector<float> weights = gaussian(deviation_px / step);
  const std::vector<glm::vec2> places =
      path.is_closed ? smoothed_closed(points, weights) : smoothed_open(points, weights);
  StrokePath result = path;
  result.points = std::move(points);
  for (size_t i = 0; i < places.size(); ++i) result.points[i].at = places[i];
  measure_along(result);
  return result;
}

std::vector<float> smoothed_values(std::span<const float> values, const StrokePath& path,
                                   float deviation_px) {
  const std::vector<PathPoint>& points = path.points;
  const auto count = static_cast<int>(points.size());
  const float length = length_px(path), reach = kReach * deviation_px;
  std::vector<float> result(values.begin(), values.end());
  if (!(deviation_px > 0.0F)) return result;
  const auto weigh = [&](int i, int direction, float& sum, float& all) {
    float lap = 0.0F;
    for (int j = i + direction;; j += direction) {
      if (j < 0 || j >= count) {
        if (!path.is_closed || lap != 0.0F) return;
        lap = length;
        j = j < 0 ? count - 2 : 1;
      }
      const float away = std::abs(points[j].along_px + (direction > 0 ? lap : -lap) - points[i].along_px);
      if (away > reach) return;
      const float x = away / deviation_px, weight = std::exp(-0.5F * x * x);
      sum += weight * values[j];
      all += weight;
    }
  };
  for (int i = 0; i < count; ++i) {
    float sum = values[i], all = 1.0F;
    weigh(i, 1, sum, all);
    weigh(i, -1, sum, all);
    result[i] = sum / all;
  }
  return result;
}

}  // namespace inkbench
