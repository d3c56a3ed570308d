// SPDX-License-Identifier: MIT
#include "studies/measures/tally.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "pipeline/lines/thinning.h"
#include "studies/measures/components.h"
#include "studies/measures/distance.h"
#include "studies/measures/matching.h"

namespace inkbench {
namespace {

constexpr int kBandRows = 128;  // Small enough to stay in the cache, whatever the image's size.

/// Thinned maps without borders.
struct Thinned {
  LineMap prediction, reference;
};

/// Roots of 0 to kNearLimitSquared.
std::array<double, kNearLimitSquared + 1> make_roots() {
  std::array<double, kNearLimitSquared + 1> roots{};
  for (size_t i = 0; i < roots.size(); ++i) roots[i] = std::sqrt(static_cast<double>(i));
  return roots;
}

/// The sum of squared differences of two rows of truncated distances; nearly all of them are equal.
double squared_differences(std::span<const uint8_t> a, std::span<const uint8_t> b) {
  static const std::array<double, kNearLimitSquared + 1> roots = make_roots();
  double sum = 0;
  for (size_t begin = 0; begin < a.size(); begin += 8) {
    const size_t end = std::min(begin + 8, a.size());
    if (end - begin == 8 && std::memcmp(&a[begin], &b[begin], 8) == 0) continue;
    for (size_t i = begin; i < end; ++i) {
      const double difference = roots[a[i]] - roots[b[i]];
      sum += difference * difference;
    }
  }
  return sum;
}

/// Distances from the pixels of one map to the other map: near ones from bands, the others one by one.
class DistanceTally {
 public:
  DistanceTally(const LineMap& from, const LineMap& to) : from_(from), to_(to) {}

  /// The truncated distances of a band of rows, which stay until the next call.
  std::span<const uint8_t> go_to_band(int first_row, int end_row) {
    near_distances(to_, first_row, end_row, band_);
    const std::vector<uint8_t>& band = band_;
    for (int y = first_row; y < end_row; ++y) {
      for (int w = 0; w < from_.words_per_row(); ++w) {
        for_each_bit(from_.row(y)[w], 64 * w, [&](int x) {
          const int squared = band[static_cast<size_t>(y - first_row) * from_.width_px() + x];
          note({x, y}, squared);
        });
      }
    }
    return band_;
  }

  /// Once all bands are through. Also gives the pixels of `from` further from `to` than the tolerance.
  LineMap finish(int64_t tolerance_squared, Histogram& histogram) {
    const std::vector<int64_t> distances = squared_distances(far_, to_);
    for (size_t i = 0; i < far_.size(); ++i) near_or_far_[far_numbers_[i]] = distances[i];
    LineMap beyond(from_.width_px(), from_.height_px());
    size_t number = 0;
    for_each_pixel(from_, [&](int x, int y) {
      const int64_t squared = near_or_far_[number++];
      histogram.add(squared);
      if (squared > tolerance_squared) beyond.set(x, y);
    });
    return beyond;
  }

 private:
  void note(const Pixel& pixel, int squared) {
    if (squared == kNearLimitSquared) {
      far_.push_back(pixel);
      far_numbers_.push_back(near_or_far_.size());
    }
    near_or_far_.push_back(squared);
  }

  const LineMap& from_;
  const LineMap& to_;
  std::vector<uint8_t> band_;
  std::vector<int64_t> near_or_far_;  ///< Squared distances of the pixels of `from`, in order.
  std::vector<Pixel> far_;
  std::vector<size_t> far_numbers_;
};

void tally_distances(const Thinned& lines, double tolerance_px, LineTally& tally) {
  DistanceTally from_prediction(lines.prediction, lines.reference);
  DistanceTally from_reference(lines.reference, lines.prediction);
  const int width = lines.prediction.width_px(), height = lines.prediction.height_px();
  for (int first = 0; first < height; first += kBandRows) {
    const int end = std::min(first + kBandRows, height);
    const std::span<const uint8_t> to_reference = from_prediction.go_to_band(first, end);
    const std::span<const uint8_t> to_prediction = from_reference.go_to_band(first, end);
    const int from = std::max(first, kIgnoredBorderPx), to = std::min(end, height - kIgnoredBorderPx);
    for (int y = from; y < to && width > 2 * kIgnoredBorderPx; ++y) {
      const size_t offset = static_cast<size_t>(y - first) * width + kIgnoredBorderPx;
      const size_t count = width - 2 * kIgnoredBorderPx;
      tally.baddeley_sum +=
          squared_differences(to_reference.subspan(offset, count), to_prediction.subspan(offset, count));
    }
  }
  const int64_t squared = squared_tolerance(tolerance_px);
  from_prediction.finish(squared, tally.to_reference);
  const LineMap gaps = from_reference.finish(squared, tally.to_prediction);
  tally.gaps = component_count(gaps);
  tally.gap_pixels = gaps.count();
  const bool one_empty = (tally.predicted == 0) != (tally.referenced == 0);
  if (one_empty) tally.baddeley_sum = static_cast<double>(tally.inside_pixels) * kNearLimitSquared;
}

MatchCounts match_counts(const Thinned& lines, const LineMap* both_tiers, double tolerance_px) {
  MatchCounts counts;
  counts.matched = matched_count(lines.prediction, lines.reference, tolerance_px);
  counts.allowed =
      both_tiers == nullptr ? counts.matched : matched_count(lines.prediction, *both_tiers, tolerance_px);
  return counts;
}

void tally_matches(const Thinned& lines, const LinesToMeasure& given, LineTally& tally) {
  LineMap both_tiers;
  if (given.allowed != nullptr) both_tiers = united(lines.reference, counted_lines(*given.allowed));
  const LineMap* both = given.allowed == nullptr ? nullptr : &both_tiers;
  const double diagonal_px = diagonal_tolerance_px(given.prediction.width_px(), given.prediction.height_px());
  tally.at_tolerance = match_counts(lines, both, given.tolerance_px);
  tally.at_1px = given.tolerance_px == 1 ? tally.at_tolerance : match_counts(lines, both, 1);
  tally.at_diagonal = match_counts(lines, both, diagonal_px);
}

}  // namespace

void MatchCounts::add(const MatchCounts& other) {
  matched += other.matched;
  allowed += other.allowed;
}

void LineTally::add(const LineTally& other) {
  if (other.empty()) return;
  inside_pixels += other.inside_pixels;
  predicted += other.predicted;
  referenced += other.referenced;
  at_tolerance.add(other.at_tolerance);
  at_1px.add(other.at_1px);
  at_diagonal.add(other.at_diagonal);
  to_reference.add(other.to_reference);
  to_prediction.add(other.to_prediction);
  baddeley_sum += other.baddeley_sum;
  gaps += other.gaps;
  gap_pixels += other.gap_pixels;
  components += other.components;
  ends += other.ends;
  to_background.add(other.to_background);
  offsets.add(other.offsets);
}

LineTally tally_lines(const LinesToMeasure& lines) {
  assert(lines.prediction.same_size(lines.reference));
  assert(lines.allowed == nullptr || lines.prediction.same_size(*lines.allowed));
  assert(lines.tolerance_px >= kToleranceFromPx && lines.tolerance_px <= kToleranceToPx);
  const LineMap ink = without_border(lines.prediction);
  const Thinned counted{thinned(ink), counted_lines(lines.reference)};
  const int64_t width = ink.width_px(), height = ink.height_px();

  LineTally tally;
  tally.inside_pixels = std::max<int64_t>(0, width - 2 * kIgnoredBorderPx) *
                        std::max<int64_t>(0, height - 2 * kIgnoredBorderPx);
  tally.predicted = counted.prediction.count();
  tally.referenced = counted.reference.count();
  tally_matches(counted, lines, tally);
  tally_distances(counted, lines.tolerance_px, tally);
  tally.components = component_count(counted.prediction);
  tally.ends = end_count(counted.prediction);
  const std::vector<Pixel> pixels = pixels_of(counted.prediction);
  for (const int64_t squared : squared_distances_to_background(pixels, ink)) tally.to_background.add(squared);
  tally.offsets = line_offsets(ink, lines.polylines);
  return tally;
}

LineMap counted_lines(const LineMap& map) {
  return thinned(without_border(map));
}

ShareCounts tally_recall(const LineMap& prediction, const LineMap& class_lines, double tolerance_px) {
  const LineMap lines = counted_lines(class_lines);
  return {matched_count(counted_lines(prediction), lines, tolerance_px), lines.count()};
}

CountedReference counted_reference(const LineMap& reference, const LineMap* allowed) {
  LineMap wanted = counted_lines(reference);
  LineMap both = allowed == nullptr ? wanted : united(wanted, counted_lines(*allowed));
  return {std::move(wanted), std::move(both)};
}

F1Counts tally_f1(const LineMap& prediction, const CountedReference& reference, double tolerance_px) {
  const LineMap counted = counted_lines(prediction);
  return {counted.count(),
          reference.wanted.count(),
          {matched_count(counted, reference.wanted, tolerance_px),
           matched_count(counted, reference.both_tiers, tolerance_px)}};
}

F1Counts tally_f1(const LinesToMeasure& lines) {
  return tally_f1(lines.prediction, counted_reference(lines.reference, lines.allowed), lines.tolerance_px);
}

double f1_of(const F1Counts& counts) {
  if (counts.predicted == 0 && counts.referenced == 0) return 1;
  const auto ratio = [](double part, double whole) { return whole == 0 ? 0 : part / whole; };
  const double precision =
      ratio(static_cast<double>(counts.at_tolerance.allowed), static_cast<double>(counts.predicted));
  const double recall =
      ratio(static_cast<double>(counts.at_tolerance.matched), static_cast<double>(counts.referenced));
  return ratio(2 * precision * recall, precision + recall);
}

void ShareCounts::add(const ShareCounts& other) {
  matched += other.matched;
  total += other.total;
}

std::optional<double> ShareCounts::share() const {
  if (total == 0) return std::nullopt;
  return static_cast<double>(matched) / static_cast<double>(total);
}

void F1Counts::add(const F1Counts& other) {
  predicted += other.predicted;
  referenced += other.referenced;
  at_tolerance.add(other.at_tolerance);
}

}  // namespace inkbench
