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

Ring from_grid(const ClipperLib::Path& path) {
  Ring ring;
  ring.reserve(path.size());
  for (const ClipperLib::IntPoint& point : path)
    ring.emplace_back(static_cast<double>(point.X) / kGrid, static_cast<double>(point.Y) / kGrid);
  return ring;
}

/// The outer rings below the node, each with its holes, and what lies in those.
void append_outers(const ClipperLib::PolyNode& node, Outline& outline) {
  for (const ClipperLib::PolyNode* outer : node.Childs) {
    outline.push_back(from_grid(outer->Contour));
    for (const ClipperLib::PolyNode* hole : outer->Childs) outline.push_back(from_grid(hole->Contour));
    for (const ClipperLib::PolyNode* hole : outer->Childs) append_outers(*hole, outline);
  }
}

void add(const std::vector<Ring>& rings, ClipperLib::PolyType type, ClipperLib::Clipper& clipper) {
  for (const Ring& ring : rings) clipper.AddPath(on_grid(ring), type, true);
}

Outline result_of(ClipperLib::Clipper& clipper, ClipperLib::ClipType type) {
  ClipperLib::PolyTree tree;
  clipper.Execute(type, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  Outline outline;
  append_outers(tree, outline);
  return outline;
}

/// Positive of outer rings, negative of holes.
double signed_area(const Ring& ring) {
  double twice = 0.0;
  for (size_t i = 0, before = ring.size() - 1; i < ring.size(); before = i++)
    twice += ring[before].x * ring[i].y - ring[i].x * ring[before].y;
  return twice / 2.0;
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

std::vector<Outline> parts_of(const Outline& outline) {
  std::vector<Outline> parts;
  for (const Ring& ring : outline) {
    if (parts.empty() || signed_area(ring) > 0.0) parts.emplace_back();
    parts.back().push_back(ring);
  }
  return parts;
}

double area(const Outline& outline) {
  double sum = 0.0;
  for (const Ring& ring : outline) sum += signed_area(ring);
  return sum;
}

}  // namespace inkbench
