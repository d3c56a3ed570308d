// SPDX-License-Identifier: MIT
// Strokes in colour. In: the classes' coverage, the style's colours, the maps that colours follow. Out: a
// picture to lay over another one.
#pragma once

#include <array>

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/strokes/stroke_draw.h"

namespace inkbench {

struct StrokeLook {
  StrokeColour colour = StrokeColour::ink;
  float darken = 0.0F;
  glm::vec3 ink{0.0F};
  /// The opacity of all in its own, and `colour` what the class has.
  std::array<glm::vec4, kCurveClasses> of_class{};
};

/// No surface farther than this from a pixel gives it its colour.
inline constexpr int kMostColourReachPx = 32;
/// And how far that is for strokes that are at most so wide.
float surface_reach_px(float widest_px);

class StrokeColoursPass {
 public:
  explicit StrokeColoursPass(const GeneratedSources& generated);
  /// Out: rgba32f: colour over white; alpha: how much of what lies below is hidden. Where classes overlap the
  /// earlier one is on top, and what hides is the largest share of one of them. Strokes take the colour of
  /// the nearest surface around each pixel from `albedo` or else `shaded`, with the G-buffer; where these
  /// are null they have colours of their own.
  Texture run(const StrokeLook& look, const StrokeChannels& channels, const Texture* albedo,
              const Texture* shaded, const GBuffer* gbuffer) const;
  Texture run(const StrokeLook& look, const StrokeChannels& channels) const {
    return run(look, channels, nullptr, nullptr, nullptr);
  }
  std::vector<Program*> programs() { return {&in_one_, &by_class_, &of_surface_}; }

 private:
  Program in_one_, by_class_, of_surface_;
};

/// The strokes of the view.
struct StrokeColours {
  using Value = Texture;
  using Pass = StrokeColoursPass;
  static const PassKind& kind();
};

}  // namespace inkbench
