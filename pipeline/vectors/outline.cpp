// SPDX-License-Identifier: MIT
#include "pipeline/vectors/outline.h"

#include <clipper.hpp>
#include <cmath>

namespace inkbench {
namespace {

constexpr double kGrid = 16384.0;

ClipperLib::Path on_grid(const Ring& ring) {
  ClipperLib::Path path;
  path.reserve(ring.size());
  for (const glm::dvec2& point : ring)
    path.emplace_back(std::llround(point.x * kGrid), std::llround(point.y * kGrid));
  return path;
}

Outline from_grid(const ClipperLib::Paths& paths) {
  Outline outline;
  for (const ClipperLib::Path& path : paths) {
    Ring& ring = outline.emplace_back();
    ring.reserve(path.size());
    for (const ClipperLib::IntPoint& point : path)
      ring.emplace_back(static_cast<double>(point.X) / kGrid, static_cast<double>(point.Y) / kGrid);
  }
  return outline;
}

void add(const std::vector<Ring>& rings, ClipperLib::PolyType type, ClipperLib::Clipper& clipper) {
  for (const Ring& ring : rings) clipper.AddPath(on_grid(ring), type, true);
}

Outline result_of(ClipperLib::Clipper& clipper, ClipperLib::ClipType type) {
  ClipperLib::Paths paths;
  clipper.Execute(type, paths, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return from_grid(paths);
}

}  // namespace

Outline united(const std::vector<Ring>& rings) {
  ClipperLib::Clipper clipper;
  add(rings, ClipperLib::ptSubject, clipper);
  return result_of(clipper, ClipperLib::ctUnion);
}

Outline without(const Outline& outline, const Outline& other) {
  ClipperLib::Clipper clipper;
  add(outline, ClipperLib::ptSubject, clipper);
  add(other, ClipperLib::ptClip, clipper);
  return result_of(clipper, ClipperLib::ctDifference);
}

double area(const Outline& outline) {
  double twice = 0.0;
  for (const Ring& ring : outline) {
    for (size_t i = 0, before = ring.size() - 1; i < ring.size(); before = i++)
      twice += ring[before].x * ring[i].y - ring[i].x * ring[before].y;
  }
  return std::abs(twice) / 2.0;
}

}  // namespace inkbench
