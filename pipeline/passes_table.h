// SPDX-License-Identifier: MIT
// The passes for people: what each takes, gives and costs. In: the list of passes. Out: a table, or a graph.
#pragma once

#include <string>

namespace inkbench {

enum class PassesFormat { text, markdown, dot };

/// `dot`: a directed graph in Graphviz' language, from parameters over passes to buffers.
std::string passes_table(PassesFormat format);

}  // namespace inkbench
