#include "studies/sweep/cell_numbers.h"

#include <algorithm>
#include <map>

#include "pipeline/base/text.h"
#include "studies/measures/measures.h"

namespace inkbench {
namespace {

LineMap drawn_lines(const Image& combined_edges) {
  LineMap map(combined_edges.width_px, combined_edges.height_px);
  for (int y = 0; y < map.height_px(); ++y) {
    for (int x = 0; x < map.width_px(); ++x) {
      if (combined_edges.at(x, y) > 0.0F) map.set(x, y);
    }
  }
  return map;
}

/// Tier 1 without `object` lines, which are staircases along pixels: no measure of how straight ink is.
std::vector<Polyline> lines_to_follow(const ReferenceLines& lines) {
  std::vector<Polyline> result;
  std::copy_if(lines.polylines.begin(), lines.polylines.end(), std::back_inserter(result),
               [](const Polyline& line) {
                 return tier(line.line_class) == 1 && line.line_class != LineClass::object;
               });
  return result;
}

std::string recall_text(const LineMap& drawn, const LineMap& lines) {
  const RecallCounts counts = tally_recall(drawn, lines, kTolerancePx);
  if (counts.referenced == 0) return "";
  return shortest(static_cast<double>(counts.matched) / static_cast<double>(counts.referenced));
}

std::map<std::string, std::string, std::less<>> all_measures(const LineMap& drawn,
                                                             const ReferenceLines& lines) {
  const LineMap wanted = tier_map(lines, 1);
  const LineMap allowed = tier_map(lines, 2);
  const std::vector<Polyline> followed = lines_to_follow(lines);
  const Measures measures = measures_of(
      tally_lines({.prediction = drawn, .reference = wanted, .allowed = &allowed, .polylines = followed}));
  std::map<std::string, std::string, std::less<>> texts{{"empty", measures.empty ? "true" : "false"}};
  for (const MeasureInfo& info : measure_list()) texts.emplace(info.key, measure_text(info, measures));
  for (const LineClass line_class : kLineClasses) {
    texts.emplace("recall_" + std::string(name_of(line_class)),
                  recall_text(drawn, class_map(lines, line_class)));
  }
  return texts;
}

}  // namespace

std::vector<std::string> cell_numbers(BufferSource& buffers, const StudySpec& spec,
                                      const Settings& settings) {
  const Image edges = buffers.raw(settings, BufferName::combined_edges);
  const auto inked =
      std::count_if(edges.samples.begin(), edges.samples.end(), [](float e) { return e > 0.0F; });
  std::vector<std::string> numbers{
      shortest(static_cast<double>(inked) / static_cast<double>(edges.samples.size())),
      std::to_string(inked)};
  if (spec.measures.empty()) return numbers;
  const auto texts = all_measures(drawn_lines(edges), buffers.reference(settings));
  for (const std::string& name : spec.measures) numbers.push_back(texts.at(name));
  return numbers;
}

}  // namespace inkbench
