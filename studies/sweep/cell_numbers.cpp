#include "studies/sweep/cell_numbers.h"

#include <algorithm>
#include <map>

#include "pipeline/base/text.h"
#include "pipeline/passes/lines/reference.h"
#include "studies/judging/measured_lines.h"
#include "studies/measures/measures.h"

namespace inkbench {
namespace {

constexpr int64_t kKeptDrawingsBytes = 64 << 20;

std::string optional_text(const std::optional<double>& value) {
  return value ? shortest(*value) : "";
}

using Texts = std::map<std::string, std::string, std::less<>>;

Texts measure_texts(const CellTally& tally) {
  const Measures measures = measures_of(tally.lines);
  const LadderMeasures ladder = measures_of(tally.ladder, tally.inner);
  Texts texts{{"empty", measures.empty ? "true" : "false"},
              {"faces", std::to_string(tally.faces)},
              {"f1_detector", shortest(measures.f1)}};
  for (const LadderMeasureInfo& info : ladder_measure_list())
    texts.emplace(info.key, optional_text(info.value(ladder)));
  for (const MeasureInfo& info : measure_list()) texts.emplace(info.key, measure_text(info, measures));
  for (size_t i = 0; i < kLineClasses.size(); ++i) {
    texts.emplace("recall_" + std::string(kLineClassNames[i]), optional_text(tally.recall[i].share()));
  }
  return texts;
}

}  // namespace

void CellTally::add(const CellTally& other) {
  pixels += other.pixels;
  inked += other.inked;
  if (faces == 0) faces = other.faces;
  lines.add(other.lines);
  for (size_t i = 0; i < recall.size(); ++i) recall[i].add(other.recall[i]);
  ladder.add(other.ladder);
  inner.add(other.inner);
}

CellMeter::CellMeter(Pipeline& pipeline, const StudySpec& spec)
    : pipeline_(pipeline), spec_(spec), full_views_(view_count(spec)) {
  wants_lines_ = wants("empty") || wants("f1_detector");
  for (const MeasureInfo& info : measure_list()) wants_lines_ = wants_lines_ || wants(info.key);
  wants_inner_ = wants("internal_kept") || wants("internal_new");
  wants_ladder_ = wants("f1_geometry") || wants("f1_end_to_end");
}

bool CellMeter::wants(std::string_view measure) const {
  return std::find(spec_.measures.begin(), spec_.measures.end(), measure) != spec_.measures.end();
}

/// The full mesh has its own level's normals and the cell's other settings.
const LineMap& CellMeter::full_drawing(const Frame& full) {
  const Key key = full.key(BufferName::combined_edges);
  if (const auto kept = full_drawings_.find(key); kept != full_drawings_.end()) return kept->second;
  const int64_t bytes = int64_t{full.settings().image.width} * full.settings().image.height / 8;
  if (static_cast<int64_t>(full_drawings_.size() + 1) * bytes > kKeptDrawingsBytes) full_drawings_.clear();
  return full_drawings_[key] = drawn_lines(full.raw(BufferName::combined_edges));
}

void CellMeter::add_ladder(const Settings& settings, size_t view, const LineView& level, CellTally& tally) {
  Settings full_settings = settings;
  full_settings.mesh = MeshParams{};
  const Frame full = pipeline_.at(full_settings);
  const LineView& full_lines = full_views_[view].get(
      full.key(BufferName::reference), [&] { return line_view({}, *full.value<ReferencePass>()); });
  if (wants_ladder_) tally.ladder = tally_against_full(level, full_lines);
  if (!wants_inner_) return;
  LineView full_view = full_lines;
  full_view.drawn = full_drawing(full);
  tally.inner = tally_inner(level, full_view);
}

CellTally CellMeter::tally(const Frame& frame, size_t view) {
  const Settings& settings = frame.settings();
  const Image edges = frame.raw(BufferName::combined_edges);
  CellTally tally;
  tally.pixels = static_cast<int64_t>(edges.samples.size());
  tally.inked = std::count_if(edges.samples.begin(), edges.samples.end(), [](float e) { return e > 0.0F; });
  if (spec_.measures.empty()) return tally;
  if (const auto model = main_model_index(settings)) {
    MeshStore& meshes = pipeline_.meshes();
    tally.faces = meshes.get(settings.models[*model], level_of(settings, *model))->face_count();
  }
  const std::shared_ptr<const ReferenceLines> found = frame.value<ReferencePass>();
  const ReferenceLines& lines = *found;
  const LineView level = line_view(drawn_lines(edges), lines);
  if (wants_lines_) tally.lines = tally_view(level, lines);
  for (size_t i = 0; i < kLineClasses.size(); ++i) {
    if (!wants("recall_" + std::string(kLineClassNames[i]))) continue;
    tally.recall[i] = tally_recall(level.drawn, class_map(lines, kLineClasses[i]), kTolerancePx);
  }
  if (wants_ladder_ || wants_inner_) add_ladder(settings, view, level, tally);
  return tally;
}

std::vector<std::string> CellMeter::numbers(const CellTally& tally) const {
  std::vector<std::string> numbers{
      shortest(static_cast<double>(tally.inked) / static_cast<double>(tally.pixels)),
      std::to_string(tally.inked)};
  if (spec_.measures.empty()) return numbers;
  const Texts texts = measure_texts(tally);
  for (const std::string& name : spec_.measures) numbers.push_back(texts.at(name));
  return numbers;
}

}  // namespace inkbench
