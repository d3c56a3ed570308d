// SPDX-License-Identifier: MIT
#include "studies/measures/distance.h"

#include <algorithm>

namespace inkbench {
namespace {

/// One step of the vertical pass: the distance grows by one, except on a true pixel.
void step_rows(std::span<const uint64_t> ink, std::span<uint8_t> column_distance) {
  const size_t width = column_distance.size();
  for (uint8_t& d : column_distance) d = std::min<uint8_t>(d + 1, kNearLimitPx);
  for (size_t w = 0; w * 64 < width; ++w) {
    for_each_bit(ink[w], static_cast<int>(64 * w), [&](int x) { column_distance[x] = 0; });
  }
}

/// Rows of vertical distances for a band, at most kNearLimitPx, with that much padding left and right.
class VerticalDistances {
 public:
  VerticalDistances(const LineMap& to, int first_row, int end_row)
      : stride_(to.width_px() + 2 * kNearLimitPx),
        rows_(static_cast<size_t>(stride_) * (end_row - first_row), kNearLimitPx) {
    std::vector<uint8_t> distance(to.width_px(), kNearLimitPx);
    for (int y = std::max(0, first_row - kNearLimitPx); y < end_row; ++y) {
      step_rows(to.row(y), distance);
      if (y >= first_row) std::copy(distance.begin(), distance.end(), inner(y - first_row));
    }
    std::fill(distance.begin(), distance.end(), kNearLimitPx);
    for (int y = std::min(to.height_px(), end_row + kNearLimitPx) - 1; y >= first_row; --y) {
      step_rows(to.row(y), distance);
      if (y >= end_row) continue;
      uint8_t* row = inner(y - first_row);
      for (size_t x = 0; x < distance.size(); ++x) row[x] = std::min(row[x], distance[x]);
    }
  }

  std::span<const uint8_t> padded_row(int row) const {
    return {&rows_[static_cast<size_t>(row) * stride_], static_cast<size_t>(stride_)};
  }

 private:
  uint8_t* inner(int row) { return &rows_[static_cast<size_t>(row) * stride_ + kNearLimitPx]; }

  int stride_;
  std::vector<uint8_t> rows_;
};

/// The rows of each column's true pixels, one column after the other.
struct ColumnLists {
  std::vector<uint32_t> start;
  std::vector<int32_t> rows;

  explicit ColumnLists(const LineMap& map) : start(map.width_px() + 1) {
    for_each_pixel(map, [&](int x, int) { ++start[x + 1]; });
    for (size_t x = 1; x < start.size(); ++x) start[x] += start[x - 1];
    rows.resize(start.back());
    std::vector<uint32_t> next(start.begin(), start.end() - 1);
    for_each_pixel(map, [&](int x, int y) { rows[next[x]++] = y; });
  }
};

/// Answers for one row at a time, from the top: first the distance within each column, then along the row.
class RowDistances {
 public:
  explicit RowDistances(const LineMap& to)
      : columns_(to), next_(columns_.start.begin(), columns_.start.end() - 1), vertical_(to.width_px()) {}

  bool nothing() const { return columns_.rows.empty(); }

  void go_to_row(int y) {
    for (size_t x = 0; x < vertical_.size(); ++x) {
      uint32_t& next = next_[x];
      const uint32_t begin = columns_.start[x], end = columns_.start[x + 1];
      while (next < end && columns_.rows[next] < y) ++next;
      int64_t nearest = kNone;
      if (next < end) nearest = columns_.rows[next] - y;
      if (next > begin) nearest = std::min<int64_t>(nearest, y - columns_.rows[next - 1]);
      vertical_[x] = nearest;
    }
    envelope_made_ = false;
  }

  /// For few questions a row: walks outwards until no column further away can be nearer.
  int64_t by_walking(int x) const {
    const int width = static_cast<int>(vertical_.size());
    int64_t best = squared(x, x);
    for (int64_t d = 1; d * d < best && (x - d >= 0 || x + d < width); ++d) {
      if (x - d >= 0) best = std::min(best, squared(x, x - d));
      if (x + d < width) best = std::min(best, squared(x, x + d));
    }
    return best;
  }

  /// For many questions a row: the lower envelope of the columns' parabolas.
  int64_t by_envelope(int x) {
    if (!envelope_made_) make_envelope();
    const auto after = std::upper_bound(from_.begin(), from_.end(), x);
    return squared(x, column_[after - from_.begin() - 1]);
  }

 private:
  static constexpr int64_t kNone = int64_t{1} << 30;

  int64_t squared(int64_t x, int64_t column) const {
    return vertical_[column] == kNone ? kInfinitelyFar
                                      : (x - column) * (x - column) + vertical_[column] * vertical_[column];
  }

  /// The first x from which column b > a is nearer than a.
  int64_t takes_over(int64_t a, int64_t b) const {
    const int64_t high = b * b - a * a + vertical_[b] * vertical_[b] - vertical_[a] * vertical_[a];
    const int64_t low = 2 * (b - a);
    return (high >= 0 ? high / low : -((-high + low - 1) / low)) + 1;
  }

  void make_envelope() {
    column_.clear();
    from_.clear();
    const int64_t width = static_cast<int64_t>(vertical_.size());
    for (int64_t x = 0; x < width; ++x) {
      if (vertical_[x] == kNone) continue;
      int64_t from = 0;
      while (!column_.empty() &&
             (from = std::max<int64_t>(0, takes_over(column_.back(), x))) <= from_.back()) {
        column_.pop_back();
        from_.pop_back();
      }
      if (column_.empty()) from = 0;
      if (from >= width) continue;
      column_.push_back(x);
      from_.push_back(from);
    }
    envelope_made_ = true;
  }

  ColumnLists columns_;
  std::vector<uint32_t> next_;     ///< For each column, its first true pixel not above the row.
  std::vector<int64_t> vertical_;  ///< For each column, the distance to its nearest true pixel.
  std::vector<int64_t> column_, from_;
  bool envelope_made_ = false;
};

/// The false pixels with a true one above, below, left or right: the nearest false pixel to a true one is
/// always among them.
LineMap background_beside_lines(const LineMap& map) {
  LineMap beside(map.width_px(), map.height_px());
  const int words = map.words_per_row();
  const uint64_t last_mask = ~uint64_t{0} >> (63 - (map.width_px() + 63) % 64);
  for (int y = 0; y < map.height_px(); ++y) {
    const std::span<const uint64_t> row = map.row(y);
    for (int w = 0; w < words; ++w) {
      uint64_t reached = row[w] << 1 | row[w] >> 1;
      if (w > 0) reached |= row[w - 1] >> 63;
      if (w + 1 < words) reached |= row[w + 1] << 63;
      if (y > 0) reached |= map.row(y - 1)[w];
      if (y + 1 < map.height_px()) reached |= map.row(y + 1)[w];
      beside.row(y)[w] = reached & ~row[w] & (w + 1 == words ? last_mask : ~uint64_t{0});
    }
  }
  return beside;
}

/// Offsets within kNearLimitPx by rising distance, for looking around a pixel.
struct Offset {
  int dx, dy, squared;
};

std::vector<Offset> make_offsets() {
  std::vector<Offset> offsets;
  for (int dy = -kNearLimitPx; dy <= kNearLimitPx; ++dy) {
    for (int dx = -kNearLimitPx; dx <= kNearLimitPx; ++dx) {
      if (dx * dx + dy * dy <= kNearLimitSquared) offsets.push_back({dx, dy, dx * dx + dy * dy});
    }
  }
  std::stable_sort(offsets.begin(), offsets.end(),
                   [](const Offset& a, const Offset& b) { return a.squared < b.squared; });
  return offsets;
}

/// The squared distance to the nearest false pixel within reach; kInfinitelyFar where all are true.
int64_t look_around(const LineMap& map, const Pixel& pixel, std::span<const Offset> offsets) {
  for (const Offset& offset : offsets) {
    const int x = pixel.x + offset.dx, y = pixel.y + offset.dy;
    if (map.contains(x, y) && !map.at(x, y)) return offset.squared;
  }
  return kInfinitelyFar;
}

}  // namespace

void near_distances(const LineMap& to, int first_row, int end_row, std::vector<uint8_t>& out) {
  const VerticalDistances vertical(to, first_row, end_row);
  const size_t width = to.width_px();
  out.assign(width * (end_row - first_row), kNearLimitSquared);
  std::vector<uint8_t> squares(width + 2 * kNearLimitPx);
  for (int row = 0; row < end_row - first_row; ++row) {
    const std::span<const uint8_t> distances = vertical.padded_row(row);
    if (std::all_of(distances.begin(), distances.end(), [](uint8_t d) { return d == kNearLimitPx; }))
      continue;
    for (size_t x = 0; x < squares.size(); ++x)
      squares[x] = static_cast<uint8_t>(distances[x] * distances[x]);
    uint8_t* nearest = &out[width * row];
    for (int dx = -kNearLimitPx; dx <= kNearLimitPx; ++dx) {
      const uint8_t* shifted = &squares[kNearLimitPx + dx];
      const auto add = static_cast<uint8_t>(dx * dx);  // 100 + 100 still fits a byte
      for (size_t x = 0; x < width; ++x) {
        const auto d = static_cast<uint8_t>(shifted[x] + add);
        nearest[x] = d < nearest[x] ? d : nearest[x];
      }
    }
  }
}

std::vector<int64_t> squared_distances(std::span<const Pixel> from, const LineMap& to) {
  constexpr size_t kFew = 16;
  std::vector<int64_t> result(from.size(), kInfinitelyFar);
  if (from.empty()) return result;
  RowDistances distances(to);
  if (distances.nothing()) return result;
  for (size_t begin = 0, end = 0; begin < from.size(); begin = end) {
    while (end < from.size() && from[end].y == from[begin].y) ++end;
    distances.go_to_row(from[begin].y);
    for (size_t i = begin; i < end; ++i) {
      result[i] = end - begin <= kFew ? distances.by_walking(from[i].x) : distances.by_envelope(from[i].x);
    }
  }
  return result;
}

std::vector<int64_t> squared_distances_to_background(std::span<const Pixel> from, const LineMap& map) {
  static const std::vector<Offset> offsets = make_offsets();
  std::vector<int64_t> result;
  result.reserve(from.size());
  std::vector<Pixel> far;
  std::vector<size_t> far_numbers;
  for (const Pixel& pixel : from) {
    result.push_back(look_around(map, pixel, offsets));
    if (result.back() != kInfinitelyFar) continue;
    far.push_back(pixel);
    far_numbers.push_back(result.size() - 1);
  }
  if (far.empty()) return result;
  const std::vector<int64_t> distances = squared_distances(far, background_beside_lines(map));
  for (size_t i = 0; i < far.size(); ++i) result[far_numbers[i]] = distances[i];
  return result;
}

}  // namespace inkbench
