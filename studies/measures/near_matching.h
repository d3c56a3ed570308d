// SPDX-License-Identifier: MIT
// Maximum matchings of one thinned drawing with many thinned maps, one after the other, each nearly the same
// as the one before. In: the drawing, a tolerance, then the maps. Out: how many pixels pair, and which.
#pragma once

#include "studies/measures/disc.h"
#include "studies/measures/pixel_index.h"

namespace inkbench {

/// `match` finds a matching of maximum cardinality, as `matched` does. Of the sets of pixels of a map that
/// such matchings pair, it is the one whose pixels lie nearest to the drawing: of each two pixels that could
/// stand for each other it holds the one with the smaller distance to its nearest pixel of the drawing, and
/// at equal distances the upper one, or the left one of a row. So it is unique and depends on nothing but the
/// two maps: pixels are taken in that order, and each that can be paired beside those before it is (the
/// greedy rule of a transversal matroid: Edmonds and Fulkerson, "Transversals and matroid partition", 1965).
/// What is kept from map to map is whom a pixel was paired with, which is tried first.
class NearMatching {
 public:
  /// `to` is thinned. The tolerance is 0 to 100 px.
  NearMatching(const LineMap& to, double tolerance_px);

  /// The number of pairs of `from`, which has the drawing's size, and the drawing. Adds the pixels of `from`
  /// that have a partner to `paired`.
  int64_t match(const LineMap& from, LineMap& paired);

  int64_t size() const { return index_.size(); }

 private:
  void find_nearest();
  size_t place(const Pixel& pixel) const { return static_cast<size_t>(pixel.y) * to_.width_px() + pixel.x; }
  /// The pixels of `from` within reach of the drawing, the nearest first.
  void order(const LineMap& from);
  bool pair(const Pixel& pixel);
  bool claim(const Pixel& pixel, int32_t number);
  bool is_claimed(int32_t number) const {
    return !unclaimed_.at(index_.pixel(number).x, index_.pixel(number).y);
  }
  /// Looks for an augmenting path, breadth first. Where there is none, what was reached leads nowhere for
  /// any later pixel either and is not looked at again.
  bool augment(const Pixel& pixel);
  /// Reaches what lies around `pixel`; an unclaimed pixel of the drawing, or -1.
  int32_t reach(const Pixel& pixel);
  void flip_path(int32_t end);

  LineMap to_;
  PixelIndex index_;
  Disc disc_;
  // Of every pixel of the image.
  std::vector<uint16_t> distance_;  ///< Squared, to the drawing; over the tolerance where it is out of reach.
  std::vector<int32_t> nearest_;    ///< The nearest pixel of the drawing.
  std::vector<int32_t> partner_;    ///< In this map's matching, or the last one's that had the pixel.
  // Of every pixel of the drawing.
  std::vector<Pixel> paired_with_;  ///< Where it is claimed.
  std::vector<Pixel> reached_from_;
  LineMap unclaimed_, unreached_;
  std::vector<Pixel> ordered_, frontier_, next_;
  std::vector<size_t> count_at_;  ///< Of pixels by distance, for sorting.
  std::vector<int32_t> reached_;  ///< By the search at hand.
};

}  // namespace inkbench
