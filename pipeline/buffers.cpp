// SPDX-License-Identifier: MIT
#include "pipeline/buffers.h"

#include <algorithm>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/pass_list.h"

namespace inkbench {
namespace {

int rank_of(BufferName buffer) {
  const int key = buffer.info().number_key;
  return key < 0 ? 11 : key == 0 ? 10 : key;
}

}  // namespace

std::vector<BufferName> all_buffers() {
  std::vector<BufferName> buffers;
  for (const PassKind* pass : all_passes())
    buffers.insert(buffers.end(), pass->buffers.begin(), pass->buffers.end());
  std::stable_sort(buffers.begin(), buffers.end(),
                   [](BufferName a, BufferName b) { return rank_of(a) < rank_of(b); });
  return buffers;
}

std::string lacking_for(BufferName buffer, const Settings& settings) {
  const BufferInfo& info = buffer.info();
  if (!all_met(settings, parse_conditions(info.matters_when))) return std::string(info.matters_when);
  return info.looks_back ? "a frame before" : "";
}

std::string buffer_list() {
  std::string text;
  for (const BufferName buffer : all_buffers())
    text += (text.empty() ? "" : ", ") + std::string(name_of(buffer));
  return text;
}

std::vector<BufferName> parse_buffers(const std::vector<std::string>& names, const std::string& where) {
  const std::vector<BufferName> known = all_buffers();
  std::vector<BufferName> buffers;
  const auto add = [&](BufferName buffer) {
    if (std::find(buffers.begin(), buffers.end(), buffer) == buffers.end()) buffers.push_back(buffer);
  };
  for (const std::string& raw : names) {
    const std::string_view name = trim(raw);
    const auto found =
        std::find_if(known.begin(), known.end(), [&](BufferName buffer) { return name_of(buffer) == name; });
    if (name == "all") {
      for (const BufferName buffer : known) add(buffer);
    } else if (found != known.end()) {
      add(*found);
    } else {
      std::vector<std::string> words{"all"};
      for (const BufferName buffer : known) words.emplace_back(name_of(buffer));
      throw input_error(where, "unknown buffer '" + std::string(name) + "'", suggest(name, words));
    }
  }
  if (buffers.empty()) throw input_error(where, "names no buffer", "for example: final, combined_edges");
  return buffers;
}

}  // namespace inkbench
