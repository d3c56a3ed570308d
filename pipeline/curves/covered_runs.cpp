// SPDX-License-Identifier: MIT
#include "pipeline/curves/covered_runs.h"

#include <algorithm>
#include <unordered_set>

namespace inkbench {
namespace {

using Run = ViewEdge;

CurveClass class_of(const ViewLine& line, const Run& run) {
  const bool is_border =
      (line.covers || line.follows) && run.covered == 0 && run.behind == Behind::other_object;
  return is_border ? CurveClass::object : line.line_class;
}

bool is_same(const ViewLine& line, const Run& a, const Run& b) {
  return a.covered == b.covered && class_of(line, a) == class_of(line, b) && a.behind == b.behind;
}

std::vector<Run> merged(const ViewLine& line, const std::vector<Run>& runs) {
  std::vector<Run> result;
  for (const Run& run : runs) {
    if (!result.empty() && is_same(line, result.back(), run)) {
      result.back().to = run.to;
      result.back().length_px += run.length_px;
    } else {
      result.push_back(run);
    }
  }
  return result;
}

bool is_visible(const Run& run) {
  return run.covered == 0;
}

/// Runs shorter than `shortest_px` that stand out from both neighbours, as `stands_out(run, before, after)`
/// says, become as these. The shortest ones first.
template <class StandsOut>
std::vector<Run> without_short(const ViewLine& line, std::vector<Run> runs, double shortest_px,
                               const StandsOut& stands_out) {
  for (;;) {
    runs = merged(line, runs);
    size_t shortest = runs.size();
    for (size_t i = 1; i + 1 < runs.size(); ++i) {
      if (runs[i].length_px >= shortest_px || !stands_out(runs[i], runs[i - 1], runs[i + 1])) continue;
      if (shortest == runs.size() || runs[i].length_px < runs[shortest].length_px) shortest = i;
    }
    if (shortest == runs.size()) return runs;
    runs[shortest].covered = runs[shortest - 1].covered;
    runs[shortest].behind = runs[shortest - 1].behind;
  }
}

std::vector<Run> steady(const ViewLine& line, std::vector<Run> runs) {
  runs =
      without_short(line, std::move(runs), line.follows ? kShortestFollowedPx : kShortestRunPx,
                    [](const Run& run, const Run& before, const Run& after) {
                      return is_visible(before) == is_visible(after) && is_visible(run) != is_visible(before);
                    });
  return without_short(line, std::move(runs), kShortestBehindPx,
                       [](const Run& run, const Run& before, const Run& after) {
                         return run.covered == before.covered && run.covered == after.covered &&
                                before.behind == after.behind && run.behind != before.behind;
                       });
}

class CurveMaker {
 public:
  CurveMaker(const std::vector<ViewLine>& lines, std::span<const CurveModel> models, const CurveView& view)
      : lines_(lines), models_(models), view_(view) {
    find_junctions();
  }

  void add(const ViewLine& line, std::vector<Run> runs) {
    runs = steady(line, std::move(runs));
    const bool goes_around = line.is_closed && runs.size() > 1 && is_same(line, runs.front(), runs.back());
    if (goes_around) {
      runs.back().to = runs.front().to;
      runs.erase(runs.begin());
    }
    for (size_t i = 0; i < runs.size(); ++i) add_curve(line, runs, i);
    ++chain_;
  }

  std::vector<Curve> take() { return std::move(curves_); }

 private:
  /// Places at which lines end that others go through or end at, too.
  void find_junctions() {
    std::vector<uint64_t> ends;
    for (const ViewLine& line : lines_) {
      if (line.is_closed) continue;
      for (const LinePoint* point : {&line.points.front(), &line.points.back()}) {
        if (point->place != 0) ends.push_back(point->place);
      }
    }
    std::sort(ends.begin(), ends.end());
    for (size_t i = 1; i < ends.size(); ++i) {
      if (ends[i] == ends[i - 1]) junctions_.insert(ends[i]);
    }
    for (const ViewLine& line : lines_) {
      for (size_t i = line.is_closed ? 0 : 1; i + 1 < line.points.size(); ++i) {
        const LinePoint& point = line.points[i];
        if (point.place != 0 && std::binary_search(ends.begin(), ends.end(), point.place))
          junctions_.insert(point.place);
      }
    }
  }

  CurveEnd end_kind(const ViewLine& line, bool at_start) const {
    const CurveEnd kind = at_start ? line.start : line.end;
    const uint64_t place = (at_start ? line.points.front() : line.points.back()).place;
    return kind == CurveEnd::free && junctions_.contains(place) ? CurveEnd::junction : kind;
  }

  /// Between a run and the next: why the curve ends there.
  static CurveEnd change_kind(const ViewLine& line, const Run& before, const Run& after) {
    if (before.covered == after.covered) return CurveEnd::other_class;
    return line.points[before.to].change.value_or(CurveEnd::crossing);
  }

  void add_curve(const ViewLine& line, const std::vector<Run>& runs, size_t index) {
    const Run& run = runs[index];
    Curve curve;
    curve.curve_class = class_of(line, run);
    curve.object_id = models_[static_cast<size_t>(line.model)].object_id;
    curve.covered = run.covered;
    curve.behind = run.behind;
    curve.chain = chain_;
    const bool is_whole = line.is_closed && runs.size() == 1;
    const Run& previous = runs[index > 0 ? index - 1 : runs.size() - 1];
    const Run& next = runs[index + 1 < runs.size() ? index + 1 : 0];
    curve.start = is_whole                      ? CurveEnd::closed
                  : index > 0 || line.is_closed ? change_kind(line, previous, run)
                                                : end_kind(line, true);
    curve.end = is_whole                                    ? CurveEnd::closed
                : index + 1 < runs.size() || line.is_closed ? change_kind(line, run, next)
                                                            : end_kind(line, false);
    const auto last = static_cast<uint32_t>(line.points.size() - 1);
    for (uint32_t at = run.from;; at = at == last ? 1 : at + 1) {
      add_point(curve, line.points[at]);
      if (at == run.to) break;
    }
    if (curve.points.size() > 1) curves_.push_back(std::move(curve));
  }

  void add_point(Curve& curve, const LinePoint& point) const {
    const glm::vec2 at(point.pixel);
    if (!curve.points.empty() && curve.points.back() == at) return;
    curve.points.push_back(at);
    curve.depths.push_back(static_cast<float>(view_.distance(point.pixel.z)));
    curve.places.push_back(point.place);
  }

  const std::vector<ViewLine>& lines_;
  std::span<const CurveModel> models_;
  const CurveView& view_;
  std::unordered_set<uint64_t> junctions_;
  std::vector<Curve> curves_;
  uint32_t chain_ = 0;
};

}  // namespace

std::vector<Curve> curves_of(const std::vector<ViewLine>& lines, std::span<const ViewEdge> edges,
                             std::span<const CurveModel> models, const CurveView& view) {
  CurveMaker maker(lines, models, view);
  for (size_t first = 0; first < edges.size();) {
    size_t last = first;
    while (last < edges.size() && edges[last].line == edges[first].line) ++last;
    const ViewLine& line = lines[edges[first].line];
    if (line.is_drawn)
      maker.add(line, {edges.begin() + static_cast<std::ptrdiff_t>(first),
                       edges.begin() + static_cast<std::ptrdiff_t>(last)});
    first = last;
  }
  return maker.take();
}

}  // namespace inkbench
