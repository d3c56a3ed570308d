// The numbers of a cell in data.csv: their columns' names.
#pragma once

#include <string>
#include <vector>

namespace inkbench {

struct StudySpec;

/// What `measure` in a spec may name: `faces` (triangles of the main model as drawn), `empty`, the measures
/// of docs/measures.md but `ink`, which every study has, `recall_<class>` for each class of reference lines,
/// and the measures of a level against the full mesh.
std::vector<std::string> known_measures();

/// `ink` and `ink_px`, then the spec's measures.
std::vector<std::string> number_columns(const StudySpec& spec);

}  // namespace inkbench
