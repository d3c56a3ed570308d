// SPDX-License-Identifier: MIT
#include "pipeline/settings/brought_groups.h"

#include <algorithm>
#include <cassert>
#include <deque>

namespace inkbench {

std::vector<BroughtGroups::Kind>& BroughtGroups::kinds() {
  static std::vector<Kind> kinds;
  return kinds;
}

void BroughtGroups::add_kind(const Kind& kind) {
  if (place_of(*kind.description) == kinds().size()) kinds().push_back(kind);
}

size_t BroughtGroups::place_of(const Description& description) {
  const auto found = std::find_if(kinds().begin(), kinds().end(),
                                  [&](const Kind& kind) { return kind.description == &description; });
  return static_cast<size_t>(found - kinds().begin());
}

void* BroughtGroups::owner(size_t kind) {
  assert(kind < kinds().size());
  while (values_.size() <= kind) values_.push_back(kinds()[values_.size()].make());
  return kinds()[kind].address(values_[kind]);
}

const void* BroughtGroups::owner(size_t kind) const {
  assert(kind < kinds().size());
  if (kind < values_.size()) return kinds()[kind].address(const_cast<std::any&>(values_[kind]));
  static std::deque<std::any> defaults;  // a deque: the earlier ones stay where they are
  while (defaults.size() <= kind) defaults.push_back(kinds()[defaults.size()].make());
  return kinds()[kind].address(defaults[kind]);
}

}  // namespace inkbench
