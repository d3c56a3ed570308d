// SPDX-License-Identifier: MIT
#include "app/window/word_list.h"

#include <algorithm>

#include "pipeline/base/text.h"

namespace inkbench {

bool has_word(const std::string& words, std::string_view word) {
  const std::vector<std::string> all = split(words, ' ');
  return std::find(all.begin(), all.end(), word) != all.end();
}

std::string with_word(const std::string& words, std::string_view word, bool present) {
  std::vector<std::string> kept;
  for (const std::string& one : split(words, ' ')) {
    if (!one.empty() && one != word) kept.push_back(one);
  }
  if (present) kept.emplace_back(word);
  return join(kept, " ");
}

}  // namespace inkbench
