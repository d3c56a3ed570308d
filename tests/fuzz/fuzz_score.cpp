// SPDX-License-Identifier: MIT
// Bytes as line maps, polylines and tolerances: every measure keeps its promises, and where a plain
// definition is short enough it gives the same.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "studies/measures/diff_picture.h"
#include "studies/measures/ladder_tally.h"
#include "studies/measures/matching.h"
#include "tests/fuzz/line_input.h"
#include "tests/fuzz/plain_lines.h"
#include "tests/unit/measured.h"

namespace inkbench {
namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

double share(int64_t part, int64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

void check_thinning(const LineMap& map) {
  const LineMap thin = counted_lines(map), inside = without_border(map);
  require(united(thin, inside) == inside && counted_lines(thin) == thin);
  require(plain_parts(thin) == plain_parts(inside));
}

void check_matching(const LineMap& a, const LineMap& b, const Tolerance& small, const Tolerance& large) {
  require(squared_tolerance(large.px) == large.squared);
  const Matching matching = matched(a, b, large.px);
  require(matching.pairs == plain_matched(a, b, large.squared));
  require(matching.pairs == matched_count(b, a, large.px));
  require(matched_count(a, b, small.px) <= matching.pairs);
  require(matched_count(a, a, small.px) == a.count());
  const std::vector<Pixel> pa = pixels_of(a), pb = pixels_of(b);
  int64_t pairs = 0;
  for (size_t i = 0; i < pa.size(); ++i) {
    const int32_t j = matching.partner_of_a.at(i);
    if (j < 0) continue;
    const int64_t dx = pa[i].x - pb.at(j).x, dy = pa[i].y - pb[j].y;
    require(dx * dx + dy * dy <= large.squared && matching.partner_of_b[j] == static_cast<int32_t>(i));
    ++pairs;
  }
  require(pairs == matching.pairs);
}

void check_empties(const Measured& m) {
  const bool one_empty = (m["predicted"] == 0) != (m["referenced"] == 0);
  require(m.empty() == (m["predicted"] == 0 && m["referenced"] == 0));
  if (m.empty()) {
    require(m["precision"] == 1 && m["recall"] == 1 && m["f1"] == 1 && m["f1_t1"] == 1 && m["f1_diag"] == 1);
    require(m["chamfer"] == 0 && m["baddeley"] == 0 && m["hd95"] == 0.0);
  }
  if (one_empty)
    require(m["recall"] == 0 && m["f1"] == 0 && m["f1_t1"] == 0 && m["f1_diag"] == 0 && m["chamfer"] == 10);
}

void check_ranges(const Measured& m) {
  for (const double value : {m["precision"], m["recall"], m["f1"], m["f1_t1"], m["f1_diag"], m["ink"]})
    require(value >= 0 && value <= 1);
  require(m["f1"] <= std::max(m["precision"], m["recall"]) + 1e-12);
  require(m["chamfer"] >= 0 && m["chamfer"] <= 10 && m["baddeley"] >= 0 && m["baddeley"] <= 10);
  require(m["matched"] <= std::min(m["predicted"], m["referenced"]));
  require(m["thickness_cov"] >= 0 && m["mean_gap_px"] >= 0 &&
          (m["predicted"] == 0 || m["thickness_px"] >= 1));
  if (m.has("jaggedness_px")) require(m["jaggedness_px"] >= 0 && std::abs(m["bias_px"]) <= 4);
  check_empties(m);
  const nlohmann::json json = nlohmann::json::parse(m.json());
  require(json.size() == measures_of_maps().size());
  for (const auto& [key, value] : json.items()) {
    const bool is_finite = value.is_number() && std::isfinite(value.get<double>());
    require(is_finite || value.is_null() || (key == "empty" && value.is_boolean()));
  }
  require(!measures_table(measures_of_maps(), m.tally()).empty());
}

/// Everything but the matchings' sizes at the fixed tolerances and the sums along polylines.
LineTally check_tally(const LinesToMeasure& lines, const Tolerance& tolerance) {
  const LineTally tally = tally_lines(lines);
  const LineMap p = counted_lines(lines.prediction), r = counted_lines(lines.reference);
  const LineMap both = lines.allowed == nullptr ? r : united(r, counted_lines(*lines.allowed));
  const Measured m(tally);
  check_ranges(m);
  require(m["predicted"] == p.count() && m["referenced"] == r.count());
  require(m["matched"] == plain_matched(p, r, tolerance.squared));
  const int64_t allowed = plain_matched(p, both, tolerance.squared);
  require(tally.at_tolerance.allowed == allowed && allowed >= m["matched"]);
  if (!m.empty())
    require(m["precision"] == share(allowed, p.count()) && m["recall"] == share(m["matched"], r.count()));
  const LineMap gaps = plain_far(r, p, tolerance.squared);
  require(tally.gap_pixels == gaps.count() && tally.gaps == plain_parts(gaps));
  require(m["components"] == plain_parts(p) && tally.ends <= p.count());
  require(tally.to_reference.total() == p.count() && tally.to_prediction.total() == r.count());
  require(tally_maps(lines).ink == lines.prediction.count());
  const F1Counts counts = tally_f1(lines);
  require(f1_of(counts) == m["f1"] && counts.predicted == m["predicted"] &&
          counts.referenced == m["referenced"]);
  const ShareCounts recall = tally_recall(lines.prediction, lines.reference, lines.tolerance_px);
  require(recall.matched == m["matched"] && recall.total == m["referenced"]);
  return tally;
}

void check_pooling(const LineTally& a, const LineTally& b) {
  LineTally sum = a;
  sum.add(b);
  const Measured m(sum);
  check_ranges(m);
  require(m["matched"] == a.at_tolerance.matched + b.at_tolerance.matched);
  require(m["predicted"] == a.predicted + b.predicted && m["referenced"] == a.referenced + b.referenced);
  if (b.empty()) require(m.json() == Measured(a).json());
  if (!m.empty()) require(m["recall"] == share(m["matched"], m["referenced"]));
}

void check_inner(const LineView& level, const LineView& full, const Tolerance& tolerance) {
  const LineMap drawn = counted_lines(level.drawn), other = counted_lines(full.drawn);
  const InnerTally inner = tally_inner(level, full, tolerance.px);
  const int64_t near = squared_tolerance(2 * tolerance.px);
  const LineMap level_inner = plain_far(drawn, level.outline, near),
                full_inner = plain_far(other, full.outline, near);
  require(inner.known.total == level_inner.count() && inner.kept.total == full_inner.count());
  require(inner.known.matched == plain_matched(level_inner, other, tolerance.squared));
  require(inner.kept.matched == plain_matched(full_inner, drawn, tolerance.squared));
  require(inner.new_share().has_value() == (inner.known.total > 0));
  if (const auto news = inner.new_share()) require(*news >= 0 && *news <= 1);
  if (const auto kept = inner.kept.share()) require(*kept >= 0 && *kept <= 1);
}

void check_ladder(const LineView& level, const LineView& full, const Tolerance& tolerance) {
  const LadderTally ladder = tally_against_full(level, full, tolerance.px);
  const LinesToMeasure geometry{.prediction = level.wanted,
                                .reference = full.wanted,
                                .allowed = &full.allowed,
                                .tolerance_px = tolerance.px};
  require(f1_of(ladder.geometry) == f1_of(tally_f1(geometry)));
  const double end_to_end = f1_of(ladder.end_to_end);
  require(end_to_end >= 0 && end_to_end <= 1);
  const LineView self{level.drawn, level.drawn, level.allowed, level.outline};
  require(f1_of(tally_against_full(self, self, tolerance.px).end_to_end) == 1);
  check_inner(level, full, tolerance);
  const InnerTally same = tally_inner(self, self, tolerance.px);
  require(same.kept.share().value_or(1) == 1 && same.new_share().value_or(0) == 0);
}

LineView read_view(Bytes& bytes, const LineMap& like) {
  LineView view;
  view.wanted = read_map(bytes, like);
  view.drawn = read_map(bytes, view.wanted);
  view.allowed = read_map(bytes, view.wanted);
  view.outline = read_map(bytes, view.drawn);
  return view;
}

LineTally check_view(const LineView& view, std::span<const Polyline> polylines, const Tolerance& tolerance,
                     bool tiers) {
  return check_tally({.prediction = view.drawn,
                      .reference = view.wanted,
                      .allowed = tiers ? &view.allowed : nullptr,
                      .polylines = polylines,
                      .tolerance_px = tolerance.px},
                     tolerance);
}

void feed(Bytes bytes) {
  Tolerance small = read_tolerance(bytes), large = read_tolerance(bytes);
  if (small.squared > large.squared) std::swap(small, large);
  const bool tiers = bytes.byte() % 2 == 1;
  const LineMap size = read_size(bytes);
  const LineView level = read_view(bytes, size), full = read_view(bytes, level.drawn);
  const LineView other = read_view(bytes, read_size(bytes));
  const std::vector<Polyline> polylines = read_polylines(bytes);
  check_thinning(level.drawn);
  check_matching(level.drawn, level.wanted, small, large);
  const LineTally first = check_view(level, polylines, large, tiers);
  const LineTally second = check_view(other, polylines, small, tiers);
  check_pooling(first, second);
  check_pooling(second, first);
  check_ladder(level, full, small);
  if (size.width_px() > 0 && size.height_px() > 0) {
    const Picture picture = diff_picture(level.drawn, level.wanted, large.px);
    require(picture.width_px == size.width_px() && picture.height_px >= size.height_px());
  }
}

}  // namespace
}  // namespace inkbench

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  inkbench::feed(inkbench::Bytes({data, size}));
  return 0;
}
