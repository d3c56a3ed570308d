// The numbers of one cell: its ink, and where the spec asks for them the measures of its lines against the
// reference.
#pragma once

#include <string>
#include <vector>

#include "studies/reference/buffer_source.h"
#include "studies/sweep/spec.h"

namespace inkbench {

/// One text for each of `number_columns`; empty where a measure has no value (a recall over no lines).
std::vector<std::string> cell_numbers(BufferSource& buffers, const StudySpec& spec, const Settings& settings);

}  // namespace inkbench
