// SPDX-License-Identifier: MIT
// Buffers as 8-bit pictures, with the display gains.
#pragma once

#include "pipeline/gl/program.h"

namespace inkbench {

/// What of a buffer a picture shows.
struct PictureView {
  float gain = 1.0F;
  int channel = kColour;  ///< 0 to 3 shows that channel as grey.
  float low = 0.0F;       ///< Subtracted before the gain: the value that is shown as black.

  static constexpr int kColour = -1;     ///< The first three channels as colour.
  static constexpr int kObjectId = -2;   ///< Red as an object's id, each in a colour of its own.
  static constexpr int kOffset = -3;     ///< Red and green as signed lengths: half is 0.
  static constexpr int kEdgeClass = -4;  ///< Red as a class of lines.
  static constexpr int kAlphaId = -5;    ///< As kObjectId, alpha.
};

class PicturePass {
 public:
  explicit PicturePass(const GeneratedSources& generated);
  /// Out: rgba8; (value - low) * gain, clamped to 0 to 1; of offsets 0.5 more.
  Texture run(const PictureView& view, const Texture& buffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
