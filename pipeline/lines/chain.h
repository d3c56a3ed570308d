// SPDX-License-Identifier: MIT
// Loose pieces joined end to end. In: points and links between them (mesh edges, or a curve's steps through
// faces). Out: chains that use each link once.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace inkbench {

/// Two different points, by index.
using Link = std::array<uint32_t, 2>;

/// Points in order, 2 or more; a closed chain repeats its first point at the end.
using Chain = std::vector<uint32_t>;

/// At a meeting of several lines those go on that turn less than this. Silhouettes always go on: on a closed
/// mesh an even number meets at each point, and they are closed.
inline constexpr double kMaxTurnDeg = 60.0, kAnyTurnDeg = 180.0;

/// Where exactly two links meet, a chain goes on. Where more do, the straightest pair goes on, then the
/// straightest of the rest, as long as the turn is at most `max_turn_deg` (180: any); the others end. Where
/// more than 32 meet, all end. The order depends on the links' order alone.
std::vector<Chain> chain_links(std::span<const glm::dvec3> positions, std::span<const Link> links,
                               double max_turn_deg);

/// A chain that says which links it uses.
struct LinkedChain {
  Chain points;
  std::vector<uint32_t> links;  ///< From each point to the next.
};
std::vector<LinkedChain> linked_chains(std::span<const glm::dvec3> positions, std::span<const Link> links,
                                       double max_turn_deg);

}  // namespace inkbench
