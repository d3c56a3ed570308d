// SPDX-License-Identifier: MIT
// Curves of one view: what lines are before they get a look. What extraction from meshes and tracing of drawn
// lines put out, and what strokes, vector files and the window read.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/settings/curve_class.h"

namespace inkbench {

/// Why a curve ends there: it just ends; it meets others at a point of the surface; a nearer outline crosses
/// it in the image; an outline turns back on itself; the image or the view ends; the class changes, and the
/// chain goes on; its end is its start.
enum class CurveEnd { free, junction, crossing, cusp, frame, other_class, closed };
inline constexpr std::array<std::string_view, 7> kCurveEndNames{"free",  "junction",    "crossing", "cusp",
                                                                "frame", "other_class", "closed"};

/// What lies right behind an outline (`silhouette`, `boundary`, `object`), on its far side.
enum class Behind { unknown, same_object, other_object, nothing };

struct Curve {
  CurveClass curve_class = CurveClass::silhouette;
  int object_id = 0;  ///< As in the object-id buffer; 0 of traced lines where none is known.
  int covered = 0;    ///< By how many surfaces: 0 is visible.
  Behind behind = Behind::unknown;
  bool is_traced = false;  ///< From drawn lines, not from a mesh.
  uint32_t chain = 0;      ///< Curves of one chain follow each other in the list, in its order.
  CurveEnd start = CurveEnd::free, end = CurveEnd::free;

  /// Pixel space: x right, y down, pixel centres at + 0.5; 2 or more; a closed one repeats its first point.
  /// They may lie up to `kCurveMarginPx` outside the image.
  std::vector<glm::vec2> points;
  std::vector<float> depths;  ///< For each point the distance along the view axis; 0 where none is known.
  /// For each point what it lies on, equal from frame to frame: a vertex of a mesh, or a place on one of its
  /// edges; 0 for points that only the view makes.
  std::vector<uint64_t> places;

  bool is_closed() const { return points.size() > 2 && points.front() == points.back(); }
};

/// In the image.
double length_px(const Curve& curve);

inline constexpr float kCurveMarginPx = 64.0F;

struct Curves {
  int width_px = 0, height_px = 0;
  std::vector<Curve> curves;
  std::vector<std::string> notes;  ///< What could not be decided, for people.
};

}  // namespace inkbench
