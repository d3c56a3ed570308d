// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/placed_lines.h"

#include "pipeline/flow/describe_choice.h"
#include "pipeline/passes/placing/place.h"

namespace inkbench {

size_t PlacedLines::chosen(const Settings&) {
  return 0;
}

const PassKind& PlacedLines::kind() {
  static const PassKind kKind =
      describe_choice<PlacedLines, PlacePass>("placed", EdgesParams::description().group, {});
  return kKind;
}

}  // namespace inkbench
