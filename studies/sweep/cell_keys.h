// SPDX-License-Identifier: MIT
// The keys of a study's cell: what its pictures and what its numbers depend on. Same key, same results: a
// further run keeps them.
#pragma once

#include "studies/judging/drawing_meter.h"
#include "studies/sweep/result_origin.h"
#include "studies/sweep/spec.h"

namespace inkbench {

struct CellKeys {
  Key pictures;  ///< Settings but for the judge's, passes, buffers shown, who draws.
  Key numbers;   ///< Measures, judging, the drawn lines that they are of, who draws and measures.
};

/// Whether the study's cells have reference lines: measured against them, or shown.
bool finds_lines(const StudySpec& spec);

/// Whether they have causes of false and missed lines: a measure asks for them.
bool finds_causes(const StudySpec& spec);
/// Files beside the pictures of a cell: of each view the reference lines, then of each view the causes, then
/// the counts of its curve.
size_t overlay_count(const StudySpec& spec);

/// Errors (input): a mesh or ramp cannot be read.
CellKeys cell_keys(Pipeline& pipeline, const StudySpec& spec, const Cell& cell, const ResultOrigin& origin);

}  // namespace inkbench
