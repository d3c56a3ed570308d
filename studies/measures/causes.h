// SPDX-License-Identifier: MIT
// Why each false line is drawn and each missing one is not: one cause for every false and every missed pixel,
// by what the same scene draws with one thing changed. In: maps of what is right and wrong, and those
// drawings. Out: a cause for each pixel, and counts that add up to the falses and the misses. Definitions:
// docs/measures.md.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/image/image.h"
#include "studies/measures/match_maps.h"

namespace inkbench {

/// In the order in which they are tried: of false pixels, then of missed ones.
enum class Cause : uint8_t {
  none,
  doubled,
  quantised,
  seam,
  facet,
  grazing,
  bend,
  other_false,
  displaced,
  same_id,
  no_signal,
  under_the_limit,
  other_missed,
};
inline constexpr size_t kCauses = 12;  ///< Without `none`.

struct CauseInfo {
  Cause cause = Cause::none;
  std::string_view key;     ///< "false_grazing": of its measure.
  std::string_view name;    ///< "grazing"
  std::string_view help;    ///< What it is.
  std::string_view remedy;  ///< What would mend it.
  std::array<uint8_t, 3> colour{};

  bool is_of_missed() const { return cause >= Cause::displaced; }
};

/// All but `none`, in their order.
std::span<const CauseInfo, kCauses> cause_table();
inline const CauseInfo& info_of(Cause cause) {
  return cause_table()[static_cast<size_t>(cause) - 1];
}

/// What the causes are told by. All maps have the size of the drawing but one; none are thinned. What is not
/// there was not drawn since that cause does not apply.
struct CauseEvidence {
  MatchMaps maps;
  LineMap reference;                      ///< All reference lines, of both tiers.
  LineMap drawn;                          ///< The drawn lines.
  LineMap objects;                        ///< Reference lines where two objects meet.
  std::optional<LineMap> float_buffers;   ///< Drawn with float buffers.
  std::optional<LineMap> smooth_normals;  ///< Drawn with one normal a vertex, but for flat faces.
  std::optional<LineMap> slight_bends;    ///< The drawn meshes' edges that bend, creases or not.
  std::optional<LineMap> unfaceted;       ///< Drawn with smooth normals where they are flat.
  std::optional<LineMap> no_depth_term;   ///< Drawn without the detector's depth term.
  std::optional<LineMap> even;            ///< Pixels whose neighbours lie in their plane.
  std::optional<LineMap> twice_as_large;  ///< Drawn at 2W x 2H.
  std::optional<Image> strength;          ///< H x W x 1, 1 at the limit.
  bool reads_surface = false;             ///< The detector sees bends whatever the normals say.
  bool tells_objects = false;             ///< The detector knows ids.
  double tolerance_px = kTolerancePx;
};

/// H x W, each a Cause. A pixel may be a false one and a missed one.
using CauseMap = ImageOf<uint8_t>;
struct CauseMaps {
  CauseMap of_false, of_missed;
  Image missing_factor;  ///< H x W x 1: under the limit, how many times too weak; else 0.

  /// The false pixel's, where there is one.
  Cause at(int x, int y) const {
    const uint8_t first = of_false.at(x, y);
    return static_cast<Cause>(first != 0 ? first : of_missed.at(x, y));
  }
};
CauseMaps find_causes(const CauseEvidence& evidence);

/// A pixel with a cause.
struct PixelCause {
  Cause cause = Cause::none;
  int x = 0, y = 0;
  double missing_factor = 0;  ///< As in CauseMaps.
};
/// The nearest pixel with a cause, which lines drawn thick need: only their middle has one. Among equally
/// near ones the first from the top left.
std::optional<PixelCause> cause_near(const CauseMaps& causes, int x, int y, double reach_px);

/// "False line, grazing: The depth term ... What would mend it: edges.method = dihedral."
std::string cause_text(const PixelCause& found);

/// Pools by addition.
struct CauseCounts {
  std::array<int64_t, kCauses> pixels{};

  int64_t of(Cause cause) const { return pixels[static_cast<size_t>(cause) - 1]; }
  void add(const CauseCounts& other);
};
CauseCounts count_causes(const CauseMaps& causes);

/// H x W x 4: each cause's colour, opaque; clear elsewhere.
Picture cause_overlay(const CauseMaps& causes);

}  // namespace inkbench
