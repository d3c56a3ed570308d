// SPDX-License-Identifier: MIT
// A search close to a point: NLopt's Subplex for the numbers, and each choice in turn. In: a start and a
// function of points. Out: the best point that it met.
#pragma once

#include <functional>

#include "studies/tuning/objective.h"
#include "studies/tuning/search_space.h"

namespace inkbench {

/// May throw, which ends the search and is passed on.
using ScoreOfPoint = std::function<Score(const Point&)>;

/// Looks at `most` points at the most, from one whose score is known, in steps of `step` at first (a share of
/// a side). Sides that are not `open` stay.
/// Source of the method: Rowan, "Functional stability analysis of numerical algorithms", 1990, as NLopt has
/// it (LN_SBPLX): it needs no slopes, of which a count of pixels has none.
void climb(const SearchSpace& space, const Point& start, const Score& start_score,
           const std::vector<bool>& open, double step, int most, const ScoreOfPoint& score);

}  // namespace inkbench
