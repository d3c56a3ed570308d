// SPDX-License-Identifier: MIT
#include "studies/sweep/cell_keys.h"

#include <algorithm>

#include "pipeline/settings/settings_file.h"
#include "studies/sweep/number_columns.h"
#include "studies/sweep/view_frames.h"

namespace inkbench {
namespace {

bool shows_lines(const StudySpec& spec) {
  return std::find(spec.show.begin(), spec.show.end(), BufferName::reference) != spec.show.end();
}

std::string text_without_judge(Settings settings) {
  settings.judge = {};
  return settings_text(settings);
}

}  // namespace

bool finds_lines(const StudySpec& spec) {
  return shows_lines(spec) || needs_of(spec).reference_lines();
}

bool finds_causes(const StudySpec& spec) {
  return needs_of(spec).causes;
}

size_t overlay_count(const StudySpec& spec) {
  return view_count(spec) * ((finds_lines(spec) ? 1 : 0) + (finds_causes(spec) ? 1 : 0)) +
         (spec.curves ? 1 : 0);
}

CellKeys cell_keys(Pipeline& pipeline, const StudySpec& spec, const Cell& cell, const ResultOrigin& origin) {
  DrawingMeter meter(pipeline, needs_of(spec));
  ViewFrames frames(pipeline, spec);
  KeyBuilder pictures, numbers;
  pictures.add(origin.drawing_sources).add(origin.renderer);
  numbers.add(origin.drawing_sources).add(origin.measuring_sources).add(origin.renderer);
  for (size_t view = 0; view < view_count(spec); ++view) {
    const ViewFrame place = frames.at(cell, view);
    const Frame& frame = place.frame;
    pictures.add(text_without_judge(frame.settings()));
    for (const BufferName buffer : spec.show) pictures.add(name_of(buffer)).add(frame.picture_key(buffer));
    numbers.add(meter.key(frame, place.past()));
    if (finds_lines(spec)) numbers.add(frame.key(BufferName::reference));  // they lie beside the numbers
  }
  for (const std::string& column : number_columns(spec)) numbers.add(column);
  return {pictures.key(), numbers.key()};
}

}  // namespace inkbench
