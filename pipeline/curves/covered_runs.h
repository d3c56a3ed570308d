// SPDX-License-Identifier: MIT
// Lines as curves. In: a view's lines and what covers each of their parts. Out: curves, each of one class and
// covered by one number of surfaces.
#pragma once

#include <span>
#include <vector>

#include "pipeline/curves/covering.h"

namespace inkbench {

/// Shorter parts take what covers the parts on both sides, where those agree: half a pixel is nothing to see,
/// and a ray that runs through the edge of something says little.
inline constexpr double kShortestRunPx = 0.5;
/// The same of lines that follow another one, whose steps are decided one by one.
inline constexpr double kShortestFollowedPx = 3.0;
/// The same of what lies behind an outline.
inline constexpr double kShortestBehindPx = 4.0;

/// `edges` are all of `lines`' parts, in order. Chains are numbered in the lines' order.
std::vector<Curve> curves_of(const std::vector<ViewLine>& lines, std::span<const ViewEdge> edges,
                             std::span<const CurveModel> models, const CurveView& view);

}  // namespace inkbench
