// SPDX-License-Identifier: MIT
// A frame's lines as vector files. In: a frame, which buffer, how. Out: an SVG file's text.
#pragma once

#include <optional>
#include <string>

#include "pipeline/pipeline.h"
#include "pipeline/vectors/plot_svg.h"

namespace inkbench {

/// `reference`, `curves`, `strokes`.
bool is_of_lines(BufferName buffer);

/// The buffer's lines as OpenGL draws them, with all parameters in <metadata>; `reference` without. `below`:
/// elements under curves or strokes. Errors (input): another buffer; as `Frame::picture`.
std::string vector_text(const Frame& frame, BufferName buffer, const std::string& below = "");

/// The middles of `curves` or `strokes` for a pen plotter; covered ones with `stroke.hidden`. Errors (input):
/// another buffer; as `Frame::picture`.
Plot plot_of(const Frame& frame, BufferName buffer, double width_mm);

/// The shaded picture as flat areas (`regions_svg`), traced from one of twice the size where that is at most
/// `kMostFinerPx` wide and high. Errors as `Frame::picture`.
std::string shading_regions(Pipeline& pipeline, const Settings& settings);

inline constexpr int kMostFinerPx = 8192;

}  // namespace inkbench
