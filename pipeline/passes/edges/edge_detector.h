// SPDX-License-Identifier: MIT
// What finds lines in an image: maps in, their strength and class out, and for any pixel why. Detectors are
// listed here; each is a file of its own beside the passes that it runs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/flow/buffer_name.h"
#include "pipeline/image/image.h"
#include "pipeline/passes/edges/explanation.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

class EdgeDetector {
 public:
  virtual ~EdgeDetector() = default;
  virtual std::string_view name() const = 0;
  virtual std::string_view help() const = 0;  ///< One sentence for a person.

  /// The maps that decide, and how far from a pixel they are looked at.
  virtual std::vector<BufferName> maps() const = 0;
  virtual int reach_px() const = 0;

  /// The buffer that holds what it decided, H x W x 1: its strength, or what the paper's stores of it.
  virtual BufferName decided() const { return BufferName::edge_strength; }

  /// Why the pixel (x, y) of `maps` is a line or not. They are the raw values of `maps()`, all of one size,
  /// of which the image's edges are edges only. `drawn` is left 0.
  virtual Explanation explain(const PerBuffer<Image>& maps, const Settings& settings, int x, int y) const = 0;

  /// The parameters that decide by the same maps whether a pixel is a line, by their keys: numbers, which
  /// must do so from some value on, and switches of terms.
  virtual std::vector<std::string> deciding_parameters() const = 0;

  // --- what its lines can come from, for finding out why one is false (studies/judging/cause_finder.h) ---

  /// Does it look at shading normals?
  virtual bool has_normal_term(const Settings& settings) const = 0;
  /// Does it see edges of the mesh that bend a little, by flat faces' normals or by the surface itself?
  virtual bool sees_facets(const Settings& settings) const;
  /// Does it draw where two objects meet because they are two?
  virtual bool tells_objects(const Settings& settings) const = 0;
  /// The settings without what makes lines of differences in depth alone; nothing where it has no such term.
  virtual std::optional<Settings> without_depth_term(const Settings& settings) const = 0;
};

/// All of them, in the order of EdgeMethod.
std::vector<const EdgeDetector*> edge_detectors();

/// The one that the settings draw with.
const EdgeDetector& edge_detector(const Settings& settings);

}  // namespace inkbench
