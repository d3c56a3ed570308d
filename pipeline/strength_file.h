// SPDX-License-Identifier: MIT
// Image files to strength maps and to the drawings that those are judged by. In: maps of any program, light
// on dark or dark on light, what inkbench exports, BSDS500's ground truth. Out: strengths of 0 to 1, lines by
// tier. A side has many files and one answer to which of the two it is: files are surveyed first, read later.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "pipeline/flow/buffer_name.h"
#include "pipeline/image/image.h"
#include "pipeline/lines/tiered_lines.h"

namespace inkbench {

struct SurveyedFile {
  std::filesystem::path path;
  int width_px = 0, height_px = 0;
  int drawings = 1;                  ///< Of one image: annotators.
  bool says_itself = false;          ///< Light on dark for certain: inkbench's own, or ground truth.
  std::optional<BufferName> buffer;  ///< Of a file that inkbench exported.
  /// Where it does not say: how much of it is light, dark and transparent, in 256ths of a pixel.
  int64_t light = 0, dark = 0, clear = 0;
};

/// Reads the whole file once. Errors (input): as `read_image`; a strength that is no number, or not 0 to 1;
/// a buffer without lines; a picture of `edge_strength`, which ends at white.
SurveyedFile survey_strengths(const std::filesystem::path& path);

/// The same of a drawing, which may also be a file of `read_bsds_boundaries`.
SurveyedFile survey_drawings(const std::filesystem::path& path);

/// H x W x 1, 0 to 1. Grey as `read_grey_over_white` has it, and `inverted` 1 - grey; what is transparent is
/// no line either way. An EXR of `edge_strength` reads as `bounded_strengths`, `lines`, `coverage` and
/// `combined_edges` as they are measured.
Image read_strengths(const SurveyedFile& file, bool inverted);

/// The drawings: strengths from 0.5 on (of 8 bits: over 127); a file of `reference` by tier.
std::vector<TieredLines> read_drawings(const SurveyedFile& file, bool inverted);

/// A detector's own strengths, 1 = at its limit, 0 or more without an end: s becomes s/(1 + s), so that the
/// limit lies at 0.5.
Image bounded_strengths(Image strengths);

}  // namespace inkbench
