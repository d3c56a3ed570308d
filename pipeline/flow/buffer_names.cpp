#include "pipeline/flow/buffer_names.h"

#include <algorithm>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"

namespace inkbench {

std::vector<BufferName> parse_buffers(const std::vector<std::string>& names, const std::string& where) {
  std::vector<BufferName> buffers;
  const auto add = [&](size_t index) {
    const auto buffer = static_cast<BufferName>(index);
    if (std::find(buffers.begin(), buffers.end(), buffer) == buffers.end()) buffers.push_back(buffer);
  };
  for (const std::string& raw : names) {
    const std::string_view name = trim(raw);
    const auto found = std::find(kBufferNames.begin(), kBufferNames.end(), name);
    if (name == "all") {
      for (size_t i = 0; i < kBufferNames.size(); ++i) add(i);
    } else if (found != kBufferNames.end()) {
      add(static_cast<size_t>(found - kBufferNames.begin()));
    } else {
      std::vector<std::string> known(kBufferNames.begin(), kBufferNames.end());
      known.emplace_back("all");
      throw input_error(where, "unknown buffer '" + std::string(name) + "'", suggest(name, known));
    }
  }
  if (buffers.empty()) throw input_error(where, "names no buffer", "for example: final, combined_edges");
  return buffers;
}

}  // namespace inkbench
