// SPDX-License-Identifier: MIT
// Why a pixel of a frame is a line or not. In: a frame and a pixel. Out: what its detector says, and the same
// as text or JSON.
#pragma once

#include <string>

#include "pipeline/passes/edges/explanation.h"
#include "pipeline/pipeline.h"

namespace inkbench {

/// Reads a few pixels of the detector's maps. Errors (input): the pixel is not inside the image; as
/// `Frame::raw_part`.
Explanation explain_pixel(const Frame& frame, int x, int y);

/// What explains any pixel of a frame that is gone: its settings and raw values.
struct KeptMaps {
  Settings settings;
  PerBuffer<Image> raw;  ///< Of the detector's maps and of all buffers whose values people read.
  BufferName decided;    ///< The detector's (EdgeDetector::decided).
};

/// Reads whole buffers. Errors: as `Frame::raw`.
KeptMaps keep_maps(const Frame& frame);

/// As of the frame itself.
Explanation explain_pixel(const KeptMaps& maps, int x, int y);

/// For a person: the verdict, each term with its inputs and cause, and what would change it.
std::string explanation_text(const Explanation& explanation);

/// One JSON object on one line.
std::string explanation_json(const Explanation& explanation);

}  // namespace inkbench
