#include "studies/sweep/cell_numbers.h"

#include <algorithm>
#include <map>

#include "pipeline/base/text.h"
#include "studies/measures/measures.h"
#include "studies/reference/measured_lines.h"

namespace inkbench {
namespace {

std::string recall_text(const LineMap& drawn, const LineMap& lines) {
  const RecallCounts counts = tally_recall(drawn, lines, kTolerancePx);
  if (counts.referenced == 0) return "";
  return shortest(static_cast<double>(counts.matched) / static_cast<double>(counts.referenced));
}

using Texts = std::map<std::string, std::string, std::less<>>;

Texts measure_texts(const LineView& view, const ReferenceLines& lines) {
  const Measures measures = measure_view(view, lines);
  Texts texts{{"empty", measures.empty ? "true" : "false"}, {"f1_detector", shortest(measures.f1)}};
  for (const MeasureInfo& info : measure_list()) texts.emplace(info.key, measure_text(info, measures));
  for (const LineClass line_class : kLineClasses) {
    texts.emplace("recall_" + std::string(name_of(line_class)),
                  recall_text(view.drawn, class_map(lines, line_class)));
  }
  return texts;
}

std::string optional_text(const std::optional<double>& value) {
  return value ? shortest(*value) : "";
}

void add_ladder_texts(const LadderMeasures& measures, Texts& texts) {
  texts.emplace("f1_geometry", shortest(measures.f1_geometry));
  texts.emplace("f1_end_to_end", shortest(measures.f1_end_to_end));
  texts.emplace("internal_kept", optional_text(measures.internal_kept));
  texts.emplace("internal_new", optional_text(measures.internal_new));
}

}  // namespace

const LineView& CellMeter::full_view(const Settings& settings) {
  Settings full = settings;
  full.mesh = MeshParams{};
  const PassKeys keys = buffers_.pipeline().keys(full);
  return full_.get(KeyBuilder().add(keys.gbuffer).add(keys.combine).key(), [&] {
    const LineMap drawn = drawn_lines(buffers_.raw(full, BufferName::combined_edges));
    return line_view(drawn, buffers_.reference(full));
  });
}

std::vector<std::string> CellMeter::numbers(const Settings& settings) {
  const Image edges = buffers_.raw(settings, BufferName::combined_edges);
  const auto inked =
      std::count_if(edges.samples.begin(), edges.samples.end(), [](float e) { return e > 0.0F; });
  std::vector<std::string> numbers{
      shortest(static_cast<double>(inked) / static_cast<double>(edges.samples.size())),
      std::to_string(inked)};
  if (spec_.measures.empty()) return numbers;
  const ReferenceLines& lines = buffers_.reference(settings);
  const LineView view = line_view(drawn_lines(edges), lines);
  Texts texts = measure_texts(view, lines);
  const bool wants_ladder = std::any_of(spec_.measures.begin(), spec_.measures.end(),
                                        [&](const std::string& name) { return !texts.contains(name); });
  if (wants_ladder) add_ladder_texts(measure_against_full(view, full_view(settings)), texts);
  for (const std::string& name : spec_.measures) numbers.push_back(texts.at(name));
  return numbers;
}

}  // namespace inkbench
