// SPDX-License-Identifier: MIT
// One-to-one matching between the pixels of two thinned line maps. In: the maps and a tolerance. Out: a
// matching with the largest possible number of pairs, from which precision and recall follow.
#pragma once

#include "pipeline/lines/line_map.h"

namespace inkbench {

/// The squared tolerance as a whole number: two pixels may be a pair if their squared distance is at most
/// this. A tolerance whose square is a whole number up to rounding counts as that number. In px, 0 or more.
int64_t squared_tolerance(double tolerance_px);

/// The benchmark convention 0.0075 x image diagonal, in px.
/// Source: Martin, Fowlkes and Malik, PAMI 26(5), 2004.
double diagonal_tolerance_px(int width_px, int height_px);

/// `partner_of_a[i]` is the number of the pixel of b that pixel i of a is paired with, or -1; and the other
/// way round. Pixels are numbered as in `pixels_of`.
struct Matching {
  int64_t pairs = 0;
  std::vector<int32_t> partner_of_a, partner_of_b;
};

/// A matching of maximum cardinality at Euclidean distance <= tolerance. Its size is unique; which pixels are
/// paired is not, but it is the same on every run. The maps must have the same size.
/// Source: Hopcroft and Karp, "An n^5/2 algorithm for maximum matchings in bipartite graphs", SIAM J. Comput.
/// 2(4), 1973. The graph is never written down: whom a pixel may be paired with is read off the bits of the
/// other map, and each bit is cleared when it is reached, so a search reads a pixel once however many edges
/// lead to it.
Matching matched(const LineMap& a, const LineMap& b, double tolerance_px);

/// The same, so that every pixel of a that `first` pairs has a partner, too: `first` is a matching of a with
/// `part`, whose pixels are pixels of b. Augmenting paths uncover none.
Matching matched_from(const Matching& first, const LineMap& part, const LineMap& a, const LineMap& b,
                      double tolerance_px);

/// The number of pairs alone.
int64_t matched_count(const LineMap& a, const LineMap& b, double tolerance_px);

}  // namespace inkbench
