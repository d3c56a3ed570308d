// SPDX-License-Identifier: MIT
// All parameters as a table: what `inkbench params` prints and the documentation shows.
#pragma once

#include <string>

namespace inkbench {

enum class TableFormat { text, markdown, json };

/// Every parameter with key, type, default, limits, unit and help. Models and lights stand under `<name>`.
std::string params_table(TableFormat format);

}  // namespace inkbench
