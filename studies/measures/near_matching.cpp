// SPDX-License-Identifier: MIT
#include "studies/measures/near_matching.h"

#include "studies/measures/matching.h"

namespace inkbench {
namespace {

constexpr int32_t kNone = -1;
constexpr uint16_t kOutOfReach = UINT16_MAX;

}  // namespace

NearMatching::NearMatching(const LineMap& to, double tolerance_px)
    : to_(to), index_(to), disc_(squared_tolerance(tolerance_px)) {
  const size_t pixels = static_cast<size_t>(to.width_px()) * to.height_px();
  distance_.assign(pixels, kOutOfReach);
  nearest_.assign(pixels, kNone);
  partner_.assign(pixels, kNone);
  paired_with_.resize(index_.size());
  reached_from_.resize(index_.size());
  count_at_.resize(static_cast<size_t>(squared_tolerance(tolerance_px)) + 2);
  find_nearest();
}

void NearMatching::find_nearest() {
  for (int32_t i = 0; i < index_.size(); ++i) {
    const auto [centre_x, centre_y] = index_.pixel(i);
    for (int dy = -disc_.radius(); dy <= disc_.radius(); ++dy) {
      const int y = centre_y + dy, half = disc_.half_width(dy);
      if (y < 0 || y >= to_.height_px()) continue;
      const int first = std::max(0, centre_x - half), last = std::min(to_.width_px() - 1, centre_x + half);
      for (int x = first; x <= last; ++x) {
        const auto squared = static_cast<uint16_t>((x - centre_x) * (x - centre_x) + dy * dy);
        const size_t at = place({x, y});
        if (squared >= distance_[at]) continue;
        distance_[at] = squared;
        nearest_[at] = i;
      }
    }
  }
}

void NearMatching::order(const LineMap& from) {
  std::fill(count_at_.begin(), count_at_.end(), 0);
  for_each_pixel(from, [&](int x, int y) {
    if (const uint16_t squared = distance_[place({x, y})]; squared != kOutOfReach) ++count_at_[squared + 1];
  });
  for (size_t i = 1; i < count_at_.size(); ++i) count_at_[i] += count_at_[i - 1];
  ordered_.resize(count_at_.back());
  for_each_pixel(from, [&](int x, int y) {
    const uint16_t squared = distance_[place({x, y})];
    if (squared != kOutOfReach) ordered_[count_at_[squared]++] = {x, y};
  });
}

int64_t NearMatching::match(const LineMap& from, LineMap& paired) {
  assert(from.same_size(to_) && paired.same_size(to_));
  order(from);
  unclaimed_ = to_;
  unreached_ = to_;
  int64_t pairs = 0;
  for (const Pixel& pixel : ordered_) {
    if (!pair(pixel)) continue;
    ++pairs;
    paired.set(pixel.x, pixel.y);
  }
  return pairs;
}

bool NearMatching::pair(const Pixel& pixel) {
  const size_t at = place(pixel);
  const int32_t last = partner_[at], nearest = nearest_[at];
  if (last != kNone && !is_claimed(last)) return claim(pixel, last);
  if (!is_claimed(nearest)) return claim(pixel, nearest);
  return augment(pixel);
}

bool NearMatching::claim(const Pixel& pixel, int32_t number) {
  partner_[place(pixel)] = number;
  paired_with_[number] = pixel;
  unclaimed_.set(index_.pixel(number).x, index_.pixel(number).y, false);
  return true;
}

bool NearMatching::augment(const Pixel& pixel) {
  partner_[place(pixel)] = kNone;
  reached_.clear();
  frontier_.assign(1, pixel);
  while (!frontier_.empty()) {
    next_.clear();
    for (const Pixel& from : frontier_) {
      const int32_t end = reach(from);
      if (end == kNone) continue;
      flip_path(end);
      for (const int32_t j : reached_) unreached_.set(index_.pixel(j).x, index_.pixel(j).y);
      return true;
    }
    frontier_.swap(next_);
  }
  return false;
}

int32_t NearMatching::reach(const Pixel& pixel) {
  int32_t end = kNone;
  any_word_in_disc(unreached_, disc_, pixel, [&](uint64_t bits, int w, int y) {
    if (const uint64_t free = bits & unclaimed_.row(y)[w]; free != 0) {
      end = index_.number(to_, 64 * w + std::countr_zero(free), y);
      reached_from_[end] = pixel;
      return true;
    }
    unreached_.row(y)[w] &= ~bits;
    for_each_bit(bits, 64 * w, [&](int x) {
      const int32_t j = index_.number(to_, x, y);
      reached_.push_back(j);
      reached_from_[j] = pixel;
      next_.push_back(paired_with_[j]);
    });
    return false;
  });
  return end;
}

void NearMatching::flip_path(int32_t end) {
  unclaimed_.set(index_.pixel(end).x, index_.pixel(end).y, false);
  while (end != kNone) {
    const Pixel pixel = reached_from_[end];
    const int32_t before = partner_[place(pixel)];
    partner_[place(pixel)] = end;
    paired_with_[end] = pixel;
    end = before;
  }
}

}  // namespace inkbench
