// SPDX-License-Identifier: MIT
// The numbers of a cell in data.csv: which columns, what they need, what stands in them.
#pragma once

#include <string>
#include <vector>

#include "studies/measures/measures.h"

namespace inkbench {

struct StudySpec;

/// What `measure` in a spec may name: all measures but those of every study and those of marks, of
/// which a study has none.
std::vector<std::string> known_measures();

/// What `measure = true` stands for: of these, those that compare frames only along a camera path, and no
/// causes, which draw each cell again a few times, nor strengths, which match each view at 99 thresholds.
std::vector<std::string> every_measure(bool along_path);

/// `ink` and `ink_px`, which every study has, then the spec's measures.
std::vector<const Measure*> study_measures(const StudySpec& spec);
std::vector<std::string> number_columns(const StudySpec& spec);

/// What must be found out for them.
MeasureNeeds needs_of(const StudySpec& spec);

/// One text for each of `number_columns`; empty where a measure has no value (a recall over no lines).
std::vector<std::string> cell_numbers(const StudySpec& spec, const DrawingTally& tally);

}  // namespace inkbench
