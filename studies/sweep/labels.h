// SPDX-License-Identifier: MIT
// What keys and values are called where there is little room: short, and never two by one name. In: keys,
// values. Out: texts for grids, reports, charts and the window.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "pipeline/params/value.h"

namespace inkbench {

/// A value for labels: numbers with at most four digits, texts without quotes, file names without folders.
std::string label_text(const Value& value);

/// One for each value; where `label_text` would call different values the same: more digits, the folders
/// that tell files apart, numbers behind ramps ("2 stops (1)").
std::vector<std::string> label_texts(std::span<const Value> values);

/// One for each key: the fewest last parts that tell it from the others. A component's letter never stands
/// alone ("eye.y").
std::vector<std::string> key_labels(std::span<const std::string> keys);

}  // namespace inkbench
