// SPDX-License-Identifier: MIT
// What made a study's results beside their settings: the code that computes, and the renderer.
#pragma once

#include <string>

namespace inkbench {

/// Hashes of the sources that draw and of those that measure, comments and help texts left out; the build
/// makes them (scripts/code_hash).
extern const char* const kDrawingSources;
extern const char* const kMeasuringSources;
extern const char* const kTileSources;  ///< Tiles that an earlier run kept count only while it is the same.

struct ResultOrigin {
  std::string drawing_sources, measuring_sources;
  std::string renderer;

  bool operator==(const ResultOrigin&) const = default;
};

/// This build's, with the current context's renderer.
ResultOrigin this_origin();

}  // namespace inkbench
