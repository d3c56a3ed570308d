// SPDX-License-Identifier: MIT
// Paths put together end to end. In: paths, which ends may be linked and at what cost, how two become one.
// Out: fewer, longer paths.
#pragma once

#include <functional>
#include <vector>

#include "pipeline/strokes/stroke_path.h"

namespace inkbench {

/// End 2i is the start of path i, end 2i + 1 its end.
struct PathEnd {
  size_t number = 0;
  glm::vec2 at{0.0F};
  glm::vec2 outwards{0.0F};  ///< Direction in which the path would go on; of length 1, or 0.

  size_t path() const { return number / 2; }
  bool is_start() const { return number % 2 == 0; }
};

PathEnd end_of(const StrokePath& path, size_t number);

/// All ends but those of closed paths and those where the view ends, in the order of x.
std::vector<PathEnd> open_ends(const std::vector<StrokePath>& paths);

struct PathLink {
  float cost = 0.0F;
  size_t a = 0, b = 0;  ///< Numbers of ends, the smaller one first.
};

/// Both may be parts of one stroke: of one object (or both traced), both hidden or both not.
bool may_be_one(const StrokePath& a, const StrokePath& b);

/// The links between pairs of ends that are at most `reach_px` apart and for which `cost(a, b)`, with `a` the
/// lower number, gives one that is not below 0.
std::vector<PathLink> links_between(const std::vector<StrokePath>& paths, float reach_px,
                                    const std::function<float(const PathEnd& a, const PathEnd& b)>& cost);

/// Puts the second path, whose start is linked to the first one's end, behind the first.
using PutBehind = std::function<void(StrokePath& path, const StrokePath& next)>;
/// Makes a path whose end is linked to its own start a closed one.
using Close = std::function<void(StrokePath& path)>;

/// Takes the cheapest links first, each end once. What is closed repeats its first point.
std::vector<StrokePath> linked(const std::vector<StrokePath>& paths, std::vector<PathLink> links,
                               const PutBehind& put_behind, const Close& close);

/// What both together are: the outline of the longer one, the lower number, the second one's end.
void unite(StrokePath& path, const StrokePath& next);

/// Its last point becomes its first one.
void close_path(StrokePath& path);

}  // namespace inkbench
