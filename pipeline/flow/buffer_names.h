// The buffers by the names that files, specs and the command line use.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace inkbench {

enum class BufferName {
  normal,          ///< 0.5 N + 0.5, world space; 3 channels (3.4.1).
  depth,           ///< Linear depth / far, 0 to 1, 1 where no model is (3.4.2).
  normal_edges,    ///< Mean of the normal map's three gradients (3.4.3).
  depth_edges,     ///< Gradient of the depth map (3.4.3).
  combined_edges,  ///< 0, or the sum of both terms clamped to 1 (3.4.4).
  shaded,          ///< Light through the ramps, no ink; 3 channels (3.1, 3.2).
  final,           ///< Ink over the shading; 3 channels (3.5).
  blinn_phong,     ///< Plain Blinn-Phong, whatever the ramps; 3 channels (3.1).
  object_id,       ///< 1, 2, ... in the scene's order of models, 0 where there is none.
  reference,       ///< Lines in object space, by class; made beside the pipeline (studies/reference).
};

constexpr std::array<std::string_view, 10> kBufferNames{
    "normal", "depth", "normal_edges", "depth_edges", "combined_edges",
    "shaded", "final", "blinn_phong",  "object_id",   "reference"};

/// The first ones, which the pipeline draws.
constexpr size_t kFramebufferCount = 9;

inline std::string_view name_of(BufferName buffer) {
  return kBufferNames[static_cast<size_t>(buffer)];
}

/// "a,b" or "all" as buffers, each once, in the order given. Errors (input): an unknown name, with the
/// nearest one.
std::vector<BufferName> parse_buffers(const std::vector<std::string>& names, const std::string& where);

}  // namespace inkbench
