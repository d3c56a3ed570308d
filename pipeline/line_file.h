// SPDX-License-Identifier: MIT
// Image files to line maps. In: drawings of any program, light on dark or dark on light, and what inkbench
// exports, which says itself how it reads. Out: the lines, and what was decided on the way.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/flow/buffer_name.h"
#include "pipeline/lines/line_map.h"
#include "pipeline/settings/judge_params.h"

namespace inkbench {

/// Whether lines are dark on light. `automatic`: whichever has less ink, light lines where both have the
/// same.
enum class Invert { automatic, yes, no };

struct LineFileOptions {
  Invert invert = Invert::automatic;
  std::optional<double> cut;  ///< Of `LineCut`, 0 to 1; without it 0.5, or what the file's buffer says.
};

/// Lines by class, from a file of the buffer `reference`.
struct ClassedLines {
  Picture pixels;     ///< As `class_pixels`.
  JudgeParams judge;  ///< Of the settings that the file was made from.
};

struct LineFile {
  LineMap lines;                     ///< With classes those of tier 1.
  LineCut cut;                       ///< Which values were taken; of no meaning with classes.
  std::optional<BufferName> buffer;  ///< Of a file that inkbench exported.
  std::optional<ClassedLines> classes;
  std::vector<std::string> notes;  ///< What a person should know, each with the file's name.
};

/// The buffer that the file says it is of; none for other images and for buffers that are not known here.
/// Errors (input): as `read_picture`.
std::optional<BufferName> exported_buffer(const std::filesystem::path& path);

/// A file that inkbench exported reads as its buffer says: `lines` light on dark, `combined_edges` wherever
/// it is not 0, `reference` by class, whatever `options` say of those; the others are no lines. Any other
/// image is cut at a grey (`read_grey_over_white`). Errors (input): as `read_picture`; a buffer without
/// lines; a `reference` that an older inkbench wrote or that was changed since.
LineFile read_line_file(const std::filesystem::path& path, const LineFileOptions& options = {});

}  // namespace inkbench
