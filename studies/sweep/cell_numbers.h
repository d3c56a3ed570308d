// The numbers of one cell: its ink, and where the spec asks for them the measures of its lines against the
// reference.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/measures/ladder_measures.h"
#include "studies/reference/buffer_source.h"
#include "studies/sweep/spec.h"

namespace inkbench {

class CellMeter {
 public:
  CellMeter(BufferSource& buffers, const StudySpec& spec) : buffers_(buffers), spec_(spec) {}

  /// One text for each of `number_columns`; empty where a measure has no value (a recall over no lines).
  std::vector<std::string> numbers(const Settings& settings);

 private:
  /// The view of the full mesh under the same settings, kept while only the mesh's level changes.
  const LineView& full_view(const Settings& settings);

  BufferSource& buffers_;
  const StudySpec& spec_;
  Stage<LineView> full_;
};

}  // namespace inkbench
