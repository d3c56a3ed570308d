#include "studies/measures/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "pipeline/base/text.h"
#include "studies/measures/distance.h"

namespace inkbench {
namespace {

double ratio(double part, double whole) {
  return whole == 0 ? 0 : part / whole;
}

double ratio(int64_t part, int64_t whole) {
  return ratio(static_cast<double>(part), static_cast<double>(whole));
}

double harmonic_mean(double precision, double recall) {
  return ratio(2 * precision * recall, precision + recall);
}

double f1_at(const LineTally& tally, const MatchCounts& counts) {
  return f1_of({tally.predicted, tally.referenced, counts});
}

double root(int64_t squared) {
  return squared == kInfinitelyFar ? INFINITY : std::sqrt(static_cast<double>(squared));
}

double truncated_root(int64_t squared) {
  return std::min<double>(root(squared), kNearLimitPx);
}

double thickness(int64_t squared) {
  return 2 * root(squared) - 1;
}

double chamfer_of(const LineTally& tally) {
  if (tally.empty()) return 0;
  if (tally.predicted == 0 || tally.referenced == 0) return kNearLimitPx;
  return (tally.to_reference.mean(truncated_root) + tally.to_prediction.mean(truncated_root)) / 2;
}

std::optional<double> hd95_of(const LineTally& tally) {
  const double distance =
      std::max(tally.to_reference.quantile(0.95, root), tally.to_prediction.quantile(0.95, root));
  return std::isinf(distance) ? std::nullopt : std::optional(distance);
}

void set_offsets(const LineOffsets& offsets, Measures& measures) {
  if (offsets.samples == 0) return;
  const auto samples = static_cast<double>(offsets.samples);
  measures.jaggedness_px = std::sqrt(offsets.squared_wobble_sum / samples);
  measures.bias_px = offsets.sum / samples;
}

template <auto member>
std::optional<double> value_of(const Measures& measures) {
  const auto value = measures.*member;
  if constexpr (std::is_same_v<decltype(measures.*member), const std::optional<double>&>) {
    return value;
  } else {
    return static_cast<double>(value);
  }
}

template <auto member>
constexpr MeasureInfo count(std::string_view key, std::string_view help) {
  return {key, help, true, value_of<member>};
}

template <auto member>
constexpr MeasureInfo number(std::string_view key, std::string_view help) {
  return {key, help, false, value_of<member>};
}

using M = Measures;
constexpr std::array kMeasures = {
    count<&M::matched>("matched", "pairs of prediction and reference pixels, one to one"),
    count<&M::predicted>("predicted", "pixels of the thinned prediction"),
    count<&M::referenced>("referenced", "pixels of the thinned reference"),
    number<&M::precision>("precision", "share of the predicted pixels that are right"),
    number<&M::recall>("recall", "share of the reference pixels that were found"),
    number<&M::f1>("f1", "harmonic mean of precision and recall"),
    number<&M::f1_t1>("f1_t1", "f1 at a tolerance of 1 px"),
    number<&M::f1_diag>("f1_diag", "f1 at a tolerance of 0.0075 x image diagonal"),
    number<&M::chamfer>("chamfer", "mean distance to the other lines, px, each at most 10"),
    number<&M::hd95>("hd95", "95th percentile of the distance, px, the worse direction"),
    number<&M::baddeley>("baddeley", "RMS difference of the distance maps, px"),
    number<&M::breaks_per_100px>("breaks_per_100px", "missed stretches per 100 px of reference"),
    number<&M::mean_gap_px>("mean_gap_px", "mean size of a missed stretch, px"),
    count<&M::components>("components", "connected parts of the prediction"),
    number<&M::ends_per_100px>("ends_per_100px", "line ends per 100 px of prediction"),
    number<&M::thickness_px>("thickness_px", "median thickness of the drawn lines, px"),
    number<&M::thickness_cov>("thickness_cov", "standard deviation of the thickness / its mean"),
    number<&M::jaggedness_px>("jaggedness_px", "RMS wobble of the ink along the reference, px"),
    number<&M::bias_px>("bias_px", "mean offset of the ink from the reference, px"),
    number<&M::ink>("ink", "share of the image that is ink"),
};

}  // namespace

Measures measures_of(const LineTally& tally) {
  Measures m;
  m.empty = tally.empty();
  m.matched = tally.at_tolerance.matched;
  m.predicted = tally.predicted;
  m.referenced = tally.referenced;
  m.precision = m.empty ? 1 : ratio(tally.at_tolerance.allowed, tally.predicted);
  m.recall = m.empty ? 1 : ratio(tally.at_tolerance.matched, tally.referenced);
  m.f1 = f1_at(tally, tally.at_tolerance);
  m.f1_t1 = f1_at(tally, tally.at_1px);
  m.f1_diag = f1_at(tally, tally.at_diagonal);
  m.chamfer = chamfer_of(tally);
  m.hd95 = hd95_of(tally);
  m.baddeley = std::sqrt(ratio(tally.baddeley_sum, static_cast<double>(tally.inside_pixels)));
  m.breaks_per_100px = 100 * ratio(tally.gaps, tally.referenced);
  m.mean_gap_px = ratio(tally.gap_pixels, tally.gaps);
  m.components = tally.components;
  m.ends_per_100px = 100 * ratio(tally.ends, tally.predicted);
  m.thickness_px = tally.to_background.quantile(0.5, thickness);
  m.thickness_cov = ratio(tally.to_background.deviation(thickness), tally.to_background.mean(thickness));
  set_offsets(tally.offsets, m);
  m.ink = ratio(tally.ink, tally.pixels);
  return m;
}

double f1_of(const F1Counts& counts) {
  if (counts.predicted == 0 && counts.referenced == 0) return 1;
  return harmonic_mean(ratio(counts.at_tolerance.allowed, counts.predicted),
                       ratio(counts.at_tolerance.matched, counts.referenced));
}

std::span<const MeasureInfo> measure_list() {
  return kMeasures;
}

std::string measure_text(const MeasureInfo& info, const Measures& measures) {
  const std::optional<double> value = info.value(measures);
  if (!value) return "";
  return info.is_count ? fmt::format("{:.0f}", *value) : shortest(*value);
}

std::string measures_json(const Measures& measures) {
  std::string json = fmt::format("{{\"empty\": {}", measures.empty);
  for (const MeasureInfo& info : kMeasures) {
    const std::string text = measure_text(info, measures);
    json += fmt::format(", \"{}\": {}", info.key, text.empty() ? "null" : text);
  }
  return json + "}";
}

std::string measures_table(const Measures& measures) {
  std::string table;
  for (const MeasureInfo& info : kMeasures) {
    const std::optional<double> value = info.value(measures);
    const std::string text = !value          ? "-"
                             : info.is_count ? with_commas(static_cast<long long>(*value))
                                             : fmt::format("{:.4f}", *value);
    table += fmt::format("{:<17}{:>11}  {}\n", info.key, text, info.help);
  }
  return table;
}

}  // namespace inkbench
