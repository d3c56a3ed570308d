// SPDX-License-Identifier: MIT
#include "pipeline/lines/thinning.h"

#include <array>

namespace inkbench {
namespace {

/// At least two of four.
uint64_t two_of(uint64_t a, uint64_t b, uint64_t c, uint64_t d) {
  return (a & b) | (c & d) | ((a | b) & (c | d));
}

/// The map with a frame of zero words around it, so that every word has eight neighbours.
class FramedWords {
 public:
  explicit FramedWords(const LineMap& map)
      : stride_(map.words_per_row() + 2), words_(static_cast<size_t>(stride_) * (map.height_px() + 2)) {
    for (int y = 0; y < map.height_px(); ++y) {
      for (int w = 0; w < map.words_per_row(); ++w) words_[index(w, y)] = map.row(y)[w];
    }
  }

  void copy_to(LineMap& map) const {
    for (int y = 0; y < map.height_px(); ++y) {
      for (int w = 0; w < map.words_per_row(); ++w) map.row(y)[w] = words_[index(w, y)];
    }
  }

  size_t size() const { return words_.size(); }
  int stride() const { return stride_; }
  uint64_t& operator[](size_t i) { return words_[i]; }

  /// Which pixels of word `i` a sub-iteration deletes: bit-parallel G1, G2 and G3 (G3' in the second one).
  /// x1 to x8 are the neighbours as planes of bits, from the east counter-clockwise.
  uint64_t deleted(size_t i, bool second) const {
    const size_t up = i - stride_, down = i + stride_;
    const uint64_t x1 = east(i), x5 = west(i), x3 = words_[up], x7 = words_[down];
    const uint64_t x2 = east(up), x4 = west(up), x8 = east(down), x6 = west(down);

    const uint64_t b1 = ~x1 & (x2 | x3), b2 = ~x3 & (x4 | x5), b3 = ~x5 & (x6 | x7), b4 = ~x7 & (x8 | x1);
    const uint64_t g1 = (b1 ^ b2 ^ b3 ^ b4) & ~((b1 & b2) | (b3 & b4));  // exactly one: odd, but not three

    const uint64_t x12 = x1 | x2, x34 = x3 | x4, x56 = x5 | x6, x78 = x7 | x8;  // terms of n1
    const uint64_t x23 = x2 | x3, x45 = x4 | x5, x67 = x6 | x7, x81 = x8 | x1;  // terms of n2
    const uint64_t both_four = x12 & x34 & x56 & x78 & x23 & x45 & x67 & x81;
    const uint64_t g2 = two_of(x12, x34, x56, x78) & two_of(x23, x45, x67, x81) & ~both_four;

    const uint64_t not_g3 = second ? (x6 | x7 | ~x4) & x5 : (x2 | x3 | ~x8) & x1;
    return words_[i] & g1 & g2 & ~not_g3;
  }

 private:
  size_t index(int w, int y) const { return static_cast<size_t>(y + 1) * stride_ + w + 1; }
  uint64_t east(size_t i) const { return words_[i] >> 1 | words_[i + 1] << 63; }
  uint64_t west(size_t i) const { return words_[i] << 1 | words_[i - 1] >> 63; }

  int stride_;
  std::vector<uint64_t> words_;
};

/// The words that a sub-iteration must look at: those with a change in reach since it last looked.
class WorkList {
 public:
  explicit WorkList(size_t words) : listed_(words) {}

  void add(size_t i) {
    if (listed_[i]) return;
    listed_[i] = 1;
    words_.push_back(i);
  }
  bool empty() const { return words_.empty(); }
  /// Empties the list into `words`.
  void take(std::vector<size_t>& words) {
    words.clear();
    words.swap(words_);
    for (const size_t i : words) listed_[i] = 0;
  }

 private:
  std::vector<uint8_t> listed_;
  std::vector<size_t> words_;
};

struct Deletion {
  size_t word = 0;
  uint64_t bits = 0;
};

/// Puts the words that can see one of the deleted pixels on the list.
void add_neighbours(const Deletion& deletion, FramedWords& words, WorkList& list) {
  const int first = (deletion.bits & 1) != 0 ? -1 : 0, last = deletion.bits >> 63 != 0 ? 1 : 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = first; dx <= last; ++dx) {
      const size_t i = deletion.word + dy * words.stride() + dx;
      if (words[i] != 0) list.add(i);
    }
  }
}

}  // namespace

LineMap thinned(const LineMap& map) {
  FramedWords words(map);
  std::array<WorkList, 2> lists = {WorkList(words.size()), WorkList(words.size())};
  for (size_t i = 0; i < words.size(); ++i) {
    if (words[i] == 0) continue;
    for (WorkList& list : lists) list.add(i);
  }
  std::vector<size_t> active;
  std::vector<Deletion> deletions;
  for (bool second = false; !lists[0].empty() || !lists[1].empty(); second = !second) {
    lists[second].take(active);
    deletions.clear();
    for (const size_t i : active) {
      if (const uint64_t bits = words.deleted(i, second)) deletions.push_back({i, bits});
    }
    // Only now, since a sub-iteration decides on all pixels before it deletes any.
    for (const Deletion& deletion : deletions) words[deletion.word] &= ~deletion.bits;
    for (const Deletion& deletion : deletions) {
      for (WorkList& list : lists) add_neighbours(deletion, words, list);
    }
  }
  LineMap result(map.width_px(), map.height_px());
  words.copy_to(result);
  return result;
}

}  // namespace inkbench
