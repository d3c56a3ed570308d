// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/placed_lines.h"

#include <cmath>

#include "pipeline/flow/describe_choice.h"
#include "pipeline/passes/placing/dihedral_place.h"
#include "pipeline/passes/placing/place.h"

namespace inkbench {

PlacedLine placed_at(const Image& packed, int x, int y) {
  const auto offset = [&](int c) { return (packed.at(x, y, c) * 255.0F - 127.0F) / 254.0F; };
  const auto line_class = static_cast<EdgeClass>(std::lround(packed.at(x, y, 2) * 255.0F));
  if (line_class == EdgeClass::none) return {0, 0, EdgeClass::none, 0};
  return {offset(0), offset(1), line_class, packed.at(x, y, 3)};
}

PlacedLine placed_at(const Picture& packed, int x, int y) {
  const auto line_class = static_cast<EdgeClass>(packed.at(x, y, 2));
  if (line_class == EdgeClass::none) return {0, 0, EdgeClass::none, 0};
  const auto offset = [&](int c) { return (static_cast<float>(packed.at(x, y, c)) - 127.0F) / 254.0F; };
  return {offset(0), offset(1), line_class, 1};
}

void set_placed(Image& packed, int x, int y, const PlacedLine& line) {
  const bool is_line = line.line_class != EdgeClass::none;
  packed.at(x, y, 0) = is_line ? std::round(line.offset_x * 254.0F + 127.0F) / 255.0F : 0.0F;
  packed.at(x, y, 1) = is_line ? std::round(line.offset_y * 254.0F + 127.0F) / 255.0F : 0.0F;
  packed.at(x, y, 2) = static_cast<float>(line.line_class) / 255.0F;
  packed.at(x, y, 3) = is_line ? line.share : 0.0F;
}

size_t PlacedLines::chosen(const Settings& settings) {
  return settings.edges.method == EdgeMethod::dihedral ? 1 : 0;
}

const PassKind& PlacedLines::kind() {
  static const PassKind kKind = describe_choice<PlacedLines, PlacePass, DihedralPlacePass>(
      "placed", EdgesParams::description().group, {});
  return kKind;
}

}  // namespace inkbench
