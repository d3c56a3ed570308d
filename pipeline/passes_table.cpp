// SPDX-License-Identifier: MIT
#include "pipeline/passes_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "pipeline/base/text.h"
#include "pipeline/buffers.h"
#include "pipeline/pass_list.h"

namespace inkbench {
namespace {

struct PassRow {
  std::vector<std::string> passes, past, groups, buffers;
};

void add_once(std::vector<std::string>& words, std::string_view word) {
  if (std::find(words.begin(), words.end(), word) == words.end()) words.emplace_back(word);
}

PassRow row_of(const PassKind& pass) {
  PassRow row;
  for (const PassInput& input : pass.inputs) {
    if (input.pass == nullptr) {
      add_once(row.groups, input.group);
    } else {
      add_once(input.is_past ? row.past : row.passes, input.pass());
    }
  }
  for (const BufferName buffer : pass.buffers) row.buffers.emplace_back(name_of(buffer));
  return row;
}

std::string text_table() {
  std::string text;
  for (const PassKind* pass : all_passes()) {
    const PassRow row = row_of(*pass);
    text += fmt::format("{}\n", pass->name);
    const auto line = [&](const char* what, const std::vector<std::string>& words) {
      if (!words.empty()) text += fmt::format("  {:<18} {}\n", what, join(words, ", "));
    };
    line("takes", row.passes);
    line("of the frame before", row.past);
    line("parameters", row.groups);
    line("gives", row.buffers);
  }
  return text;
}

std::string markdown_table() {
  std::string text = "| pass | takes | parameters | gives | cost |\n|---|---|---|---|---|\n";
  for (const PassKind* pass : all_passes()) {
    const PassRow row = row_of(*pass);
    std::vector<std::string> takes = row.passes;
    for (const std::string& past : row.past) takes.push_back(past + " of the frame before");
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", pass->name, join(takes, ", "),
                        join(row.groups, ", "), join(row.buffers, ", "), pass->cost);
  }
  return text;
}

/// Of all buffers, in the order in which people see them.
std::string buffer_table() {
  std::string text = "\n| buffer | key | channels | what it shows |\n|---|---|---|---|\n";
  for (const BufferName buffer : all_buffers()) {
    const BufferInfo& info = buffer.info();
    const std::string key = info.number_key < 0 ? "" : std::to_string(info.number_key);
    text += fmt::format("| `{}` | {} | {} | {} |\n", info.name, key, info.channels, info.help);
  }
  return text;
}

/// Parameters are ellipses, passes boxes, buffers plain.
std::string dot_graph() {
  std::string text =
      "digraph passes {\n  rankdir=LR;\n  ranksep=0.45;\n  nodesep=0.16;\n"
      "  node [fontname=\"DejaVu Sans\", fontsize=11, height=0.3];\n  edge [arrowsize=0.6, "
      "color=\"#555555\"];\n";
  std::vector<std::string> groups;
  for (const PassKind* pass : all_passes()) {
    const PassRow row = row_of(*pass);
    text += fmt::format("  {} [shape=box, style=filled, fillcolor=\"#cfe3f5\", color=\"#33658a\"];\n",
                        pass->name);
    for (const std::string& from : row.passes) text += fmt::format("  {} -> {};\n", from, pass->name);
    for (const std::string& from : row.past)
      text += fmt::format("  {} -> {} [style=dashed];\n", from, pass->name);
    for (const std::string& group : row.groups) {
      add_once(groups, group);
      text += fmt::format("  p_{} -> {} [color=\"#bbbbbb\"];\n", group, pass->name);
    }
    for (const std::string& buffer : row.buffers) {
      text += fmt::format("  b_{} [label=\"{}\", shape=plaintext, fontcolor=\"#7a3b00\"];\n  {} -> b_{};\n",
                          buffer, buffer, pass->name, buffer);
    }
  }
  for (const std::string& group : groups)
    text += fmt::format("  p_{} [label=\"{}\", shape=ellipse, color=\"#999999\", fontcolor=\"#444444\"];\n",
                        group, group);
  return text + "}\n";
}

}  // namespace

std::string passes_table(PassesFormat format) {
  switch (format) {
    case PassesFormat::text:
      return text_table();
    case PassesFormat::markdown:
      return markdown_table() + buffer_table();
    case PassesFormat::dot:
      return dot_graph();
  }
  return "";
}

}  // namespace inkbench
