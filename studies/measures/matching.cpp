// SPDX-License-Identifier: MIT
#include "studies/measures/matching.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/measures/disc.h"
#include "studies/measures/pixel_index.h"

namespace inkbench {
namespace {

constexpr int32_t kFree = -1;

/// One side of the graph: pixels and their partners on the other side.
struct Side {
  const LineMap* map;
  PixelIndex index;
  std::vector<int32_t> partner;

  explicit Side(const LineMap& line_map) : map(&line_map), index(line_map), partner(index.size(), kFree) {}
  int number(int x, int y) const { return index.number(*map, x, y); }
};

/// Pairs each pixel of `from`, row by row, with the first free one of `to` in its disc. Along a line this is
/// the rule that is best for intervals (Glover 1967: who comes first takes what ends first), so few pixels
/// are left over that need not be: fewer than when nearest is paired with nearest. Pairs that are there stay.
/// Returns the pixels that are still free, without those that have nothing in reach at all.
class Greedy {
 public:
  Greedy(Side& from, Side& to, const Disc& disc) : from_(from), to_(to), disc_(disc), free_(*to.map) {
    for (int32_t j = 0; j < to.index.size(); ++j) {
      if (to.partner[j] != kFree) free_.set(to.index.pixel(j).x, to.index.pixel(j).y, false);
    }
  }

  std::vector<int32_t> pair() {
    std::vector<int32_t> left;
    for (int32_t i = 0; i < from_.index.size(); ++i) {
      if (from_.partner[i] != kFree) continue;
      if (!pair_first(i) && has_any(from_.index.pixel(i))) left.push_back(i);
    }
    return left;
  }

 private:
  bool pair_first(int32_t i) {
    return any_word_in_disc(free_, disc_, from_.index.pixel(i), [&](uint64_t bits, int w, int y) {
      const int x = 64 * w + std::countr_zero(bits);
      const int32_t j = to_.number(x, y);
      from_.partner[i] = j;
      to_.partner[j] = i;
      free_.set(x, y, false);
      return true;
    });
  }

  bool has_any(const Pixel& centre) const {
    return any_word_in_disc(*to_.map, disc_, centre, [](uint64_t, int, int) { return true; });
  }

  Side& from_;
  Side& to_;
  const Disc& disc_;
  LineMap free_;
};

/// The phases of Hopcroft and Karp: layers from all free pixels of `from` at once, then as many disjoint
/// shortest augmenting paths along the layers as there are. Paths are searched backwards, from the free
/// pixels of `to` in the last layer: every pixel has a way back, while most ways forward lead nowhere.
class Augmenter {
 public:
  Augmenter(Side& from, Side& to, const Disc& disc, std::vector<int32_t> free_from)
      : from_(from), to_(to), disc_(disc), free_from_(std::move(free_from)), layer_(from.index.size()) {}

  void run() {
    while (!free_from_.empty() && make_layers()) {
      for (const int32_t j : found_) augment(j);
      std::erase_if(free_from_, [&](int32_t i) { return from_.partner[i] != kFree; });
    }
  }

 private:
  /// Breadth first. A pixel of `from` gets the number of matched pairs between it and the free ones. Stops
  /// with the layer that first reaches free pixels of `to`, which it lists; false where there are none.
  bool make_layers() {
    unreached_ = *to_.map;
    open_ = LineMap(from_.map->width_px(), from_.map->height_px());
    found_.clear();
    last_layer_ = 0;
    std::vector<int32_t> frontier = free_from_, next;
    for (const int32_t i : frontier) open(i, 0);
    for (; !frontier.empty(); ++last_layer_) {
      next.clear();
      for (const int32_t i : frontier) reach_from(i, next);
      if (!found_.empty()) return true;
      frontier.swap(next);
    }
    return false;
  }

  void open(int32_t i, int32_t layer) {
    layer_[i] = layer;
    open_.set(from_.index.pixel(i).x, from_.index.pixel(i).y);
  }

  void reach_from(int32_t i, std::vector<int32_t>& next) {
    any_word_in_disc(unreached_, disc_, from_.index.pixel(i), [&](uint64_t bits, int w, int y) {
      unreached_.row(y)[w] &= ~bits;
      for_each_bit(bits, 64 * w, [&](int x) {
        const int32_t j = to_.number(x, y), partner = to_.partner[j];
        if (partner == kFree) {
          found_.push_back(j);
        } else {
          open(partner, last_layer_ + 1);
          next.push_back(partner);
        }
      });
      return false;
    });
  }

  /// A pixel of `to` on a path and the pixel of `from` through which the path goes on.
  struct Step {
    int32_t j, i;
  };

  /// Depth first from a free pixel of `to` back along the layers; a pixel of `from` once entered is closed
  /// for this phase. Flips the path where it arrives at a free pixel.
  void augment(int32_t target) {
    path_.assign(1, {target, kFree});
    while (!path_.empty()) {
      const int32_t layer = last_layer_ - static_cast<int32_t>(path_.size()) + 1;
      Step& step = path_.back();
      if (!go_back(step, layer)) {
        path_.pop_back();
      } else if (layer > 0) {
        path_.push_back({from_.partner[step.i], kFree});
      } else {
        return flip_path();
      }
    }
  }

  /// Finds an open pixel of `layer` within reach of the step's and closes it.
  bool go_back(Step& step, int32_t layer) {
    return any_word_in_disc(open_, disc_, to_.index.pixel(step.j), [&](uint64_t bits, int w, int y) {
      for (; bits != 0; bits &= bits - 1) {
        const int x = 64 * w + std::countr_zero(bits);
        step.i = from_.number(x, y);
        if (layer_[step.i] != layer) continue;
        open_.set(x, y, false);
        return true;
      }
      return false;
    });
  }

  void flip_path() {
    for (const Step& step : path_) {
      from_.partner[step.i] = step.j;
      to_.partner[step.j] = step.i;
    }
  }

  Side& from_;
  Side& to_;
  const Disc& disc_;
  std::vector<int32_t> free_from_, found_;
  std::vector<int32_t> layer_;  ///< Of the pixels of `from` that are open or were.
  int32_t last_layer_ = 0;
  LineMap unreached_, open_;
  std::vector<Step> path_;
};

}  // namespace

int64_t squared_tolerance(double tolerance_px) {
  assert(tolerance_px >= 0);
  return static_cast<int64_t>(std::floor(tolerance_px * tolerance_px * (1 + 1e-12)));
}

double diagonal_tolerance_px(int width_px, int height_px) {
  return 0.0075 * std::hypot(width_px, height_px);
}

namespace {

/// Completes the pairs that both sides have.
Matching completed(Side& side_a, Side& side_b, double tolerance_px) {
  const Disc disc(squared_tolerance(tolerance_px));
  // From the smaller side, which has fewer pixels to search from.
  const bool swap = side_a.index.size() > side_b.index.size();
  Side& from = swap ? side_b : side_a;
  Side& to = swap ? side_a : side_b;
  Augmenter(from, to, disc, Greedy(from, to, disc).pair()).run();
  Matching result;
  result.pairs = from.index.size() - std::count(from.partner.begin(), from.partner.end(), kFree);
  result.partner_of_a = std::move(side_a.partner);
  result.partner_of_b = std::move(side_b.partner);
  return result;
}

}  // namespace

Matching matched(const LineMap& a, const LineMap& b, double tolerance_px) {
  assert(a.same_size(b));
  Side side_a(a), side_b(b);
  return completed(side_a, side_b, tolerance_px);
}

Matching matched_from(const Matching& first, const LineMap& part, const LineMap& a, const LineMap& b,
                      double tolerance_px) {
  assert(a.same_size(b) && a.same_size(part));
  Side side_a(a), side_b(b);
  const PixelIndex index_of_part(part);
  for (int32_t i = 0; i < side_a.index.size(); ++i) {
    if (first.partner_of_a[i] == kFree) continue;
    const Pixel partner = index_of_part.pixel(first.partner_of_a[i]);
    const int32_t j = side_b.number(partner.x, partner.y);
    side_a.partner[i] = j;
    side_b.partner[j] = i;
  }
  return completed(side_a, side_b, tolerance_px);
}

int64_t matched_count(const LineMap& a, const LineMap& b, double tolerance_px) {
  return matched(a, b, tolerance_px).pairs;
}

}  // namespace inkbench
