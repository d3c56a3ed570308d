// SPDX-License-Identifier: MIT
#include "pipeline/lines/visibility.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inkbench {
namespace {

double length_px(const glm::dvec3& a, const glm::dvec3& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

std::vector<double> lengths_along(const ProjectedLine& line) {
  std::vector<double> along{0.0};
  for (size_t i = 1; i < line.size(); ++i) along.push_back(along.back() + length_px(line[i - 1], line[i]));
  return along;
}

void add_point(ProjectedLine& line, const glm::dvec3& point) {
  if (line.empty() || line.back().x != point.x || line.back().y != point.y) line.push_back(point);
}

/// The part of a line from one sample to another.
ProjectedLine part_of(const ProjectedLine& line, const std::vector<double>& along, const LineSample& from,
                      const LineSample& to) {
  ProjectedLine part{from.point};
  auto i = static_cast<size_t>(std::upper_bound(along.begin(), along.end(), from.along_px) - along.begin());
  for (; i < line.size() && along[i] < to.along_px; ++i) add_point(part, line[i]);
  add_point(part, to.point);
  return part;
}

/// First and last sample of a run that are visible.
struct Run {
  size_t first, last;
};

std::vector<Run> visible_runs(const std::vector<LineSample>& samples, const DepthTest& test) {
  std::vector<Run> runs;
  bool was_visible = false;
  for (size_t i = 0; i < samples.size(); ++i) {
    const bool visible = test.is_visible(samples[i].point);
    if (visible && !was_visible) runs.push_back({i, i});
    if (visible) runs.back().last = i;
    was_visible = visible;
  }
  return runs;
}

}  // namespace

std::vector<LineSample> sample_line(const ProjectedLine& line) {
  const std::vector<double> along = lengths_along(line);
  std::vector<LineSample> samples;
  size_t step = 0;
  for (size_t i = 1; i < line.size(); ++i) {
    const double length = along[i] - along[i - 1];
    for (double at = kSampleStepPx * static_cast<double>(step); at < along[i];
         at = kSampleStepPx * static_cast<double>(++step)) {
      samples.push_back({at, glm::mix(line[i - 1], line[i], std::max(at - along[i - 1], 0.0) / length)});
    }
  }
  samples.push_back({along.back(), line.back()});
  return samples;
}

bool DepthTest::is_visible(const glm::dvec3& point) const {
  const int x = std::clamp(static_cast<int>(std::floor(point.x)), 0, depth_.width_px - 1);
  const int y = std::clamp(static_cast<int>(std::floor(point.y)), 0, depth_.height_px - 1);
  float farthest = 0.0F;
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, depth_.height_px - 1); ++row) {
    for (int column = std::max(x - 1, 0); column <= std::min(x + 1, depth_.width_px - 1); ++column)
      farthest = std::max(farthest, depth_.at(column, row));
  }
  const double z = static_cast<double>(camera_.far) * static_cast<double>(farthest);
  if (is_orthographic(camera_)) return point.z <= z + kDepthSlack * camera_.view_height;
  return point.z * z >= 1.0 - kDepthSlack;
}

std::vector<ProjectedLine> visible_pieces(const ProjectedLine& line, const DepthTest& test) {
  const std::vector<double> along = lengths_along(line);
  const std::vector<LineSample> samples = sample_line(line);
  std::vector<Run> runs = visible_runs(samples, test);
  std::vector<ProjectedLine> pieces;
  const auto add_piece = [&](ProjectedLine piece) {
    if (lengths_along(piece).back() >= kShortestPiecePx) pieces.push_back(std::move(piece));
  };
  const bool across_start =
      is_closed(line) && runs.size() > 1 && runs.front().first == 0 && runs.back().last + 1 == samples.size();
  if (across_start) {
    ProjectedLine piece = part_of(line, along, samples[runs.back().first], samples.back());
    for (const glm::dvec3& point : part_of(line, along, samples[0], samples[runs.front().last]))
      add_point(piece, point);
    add_piece(std::move(piece));
    runs.pop_back();
    runs.erase(runs.begin());
  }
  for (const Run& run : runs) add_piece(part_of(line, along, samples[run.first], samples[run.last]));
  return pieces;
}

}  // namespace inkbench
