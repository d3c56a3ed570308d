// SPDX-License-Identifier: MIT
#include "pipeline/vectors/stroke_outline.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "pipeline/base/stop.h"

namespace inkbench {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

struct Disc {
  glm::dvec2 centre{0.0};
  double radius = 0.0;

  glm::dvec2 at(double angle) const { return centre + radius * glm::dvec2(std::cos(angle), std::sin(angle)); }
};

Disc disc_of(const StrokePoint& point) {
  return {glm::dvec2(point.at), static_cast<double>(point.radius_px)};
}

/// Between the corners of a disc's polygon, which has them at whole multiples from angle 0 on: so that the
/// discs at the ends of two steps are one.
double corner_angle(double radius) {
  const double share = std::min(1.0, kArcError / std::max(radius, 1e-9));
  return kTurn / std::clamp(std::ceil(std::numbers::pi / std::acos(1.0 - share)), 8.0, 1024.0);
}

/// The disc's border from one angle to another, larger one.
void append_arc(const Disc& disc, double from, double to, Ring& ring) {
  const double step = corner_angle(disc.radius);
  ring.push_back(disc.at(from));
  for (double i = std::floor(from / step) + 1.0; i * step < to; i += 1.0) ring.push_back(disc.at(i * step));
  ring.push_back(disc.at(to));
}

Ring polygon(const Disc& disc) {
  Ring ring;
  append_arc(disc, 0.0, kTurn, ring);
  ring.pop_back();
  return ring;
}

/// All discs between the two: their hull, or the larger one where it holds the other.
Ring capsule(const Disc& from, const Disc& to) {
  const glm::dvec2 way = to.centre - from.centre;
  const double length = glm::length(way), growth = to.radius - from.radius;
  if (length <= std::abs(growth)) return polygon(growth > 0.0 ? to : from);
  const double heading = std::atan2(way.y, way.x);
  const double side = std::acos(-growth / length);  // of the tangents' ends, from the heading
  Ring ring;
  append_arc(to, heading - side, heading + side, ring);
  append_arc(from, heading + side, heading - side + kTurn, ring);
  return ring;
}

Outline part_outline(const StrokePart& part) {
  std::vector<Ring> capsules;
  for (size_t i = part.first; i < part.last; ++i) {
    const Disc from = disc_of(part.stroke->points[i]), to = disc_of(part.stroke->points[i + 1]);
    if (std::max(from.radius, to.radius) > 0.0) capsules.push_back(capsule(from, to));
  }
  return united(capsules);
}

}  // namespace

StrokePart whole(const Stroke& stroke) {
  return {&stroke, 0, stroke.points.size() - 1};
}

Outline stroke_outline(std::span<const StrokePart> parts) {
  Outline outlines;
  for (const StrokePart& part : parts) {
    stop_if_asked();
    Outline outline = part_outline(part);
    std::move(outline.begin(), outline.end(), std::back_inserter(outlines));
  }
  return parts.size() == 1 ? outlines : united(outlines);
}

}  // namespace inkbench
