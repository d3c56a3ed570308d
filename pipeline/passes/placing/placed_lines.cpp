// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/placed_lines.h"

#include "pipeline/flow/describe_choice.h"
#include "pipeline/passes/placing/dihedral_place.h"
#include "pipeline/passes/placing/place.h"

namespace inkbench {

size_t PlacedLines::chosen(const Settings& settings) {
  return settings.edges.method == EdgeMethod::dihedral ? 1 : 0;
}

const PassKind& PlacedLines::kind() {
  static const PassKind kKind = describe_choice<PlacedLines, PlacePass, DihedralPlacePass>(
      "placed", EdgesParams::description().group, {});
  return kKind;
}

}  // namespace inkbench
