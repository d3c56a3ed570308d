// SPDX-License-Identifier: MIT
// Buffers to image files that know where they came from: every file carries all parameters and the version.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/image/image_file.h"
#include "pipeline/pipeline.h"

namespace inkbench {

/// The metadata entry that names the buffer.
inline constexpr std::string_view kBufferEntry = "inkbench:buffer";
/// Of `reference`, the one that says which classes its pixels' bits stand for.
inline constexpr std::string_view kClassesEntry = "inkbench:classes";

/// The metadata of an exported buffer: version, buffer, all settings and the files behind them; of
/// `reference` its classes, too.
ImageText export_text(const Settings& settings, BufferName buffer, const std::vector<UsedFile>& files = {});

/// What an exported image says of itself.
struct ImageOrigin {
  Settings settings;
  BufferName buffer = BufferName::final;
  std::string version;
  std::vector<UsedFile> files;  ///< Without paths; none in images of earlier versions.
};

/// For each file behind the image that is another one now, though `now` (the image's settings, perhaps with
/// changes) names it as the image does: a sentence with the file, the parameter and the image.
std::vector<std::string> notes_on_changed_files(const std::filesystem::path& image, const ImageOrigin& origin,
                                                const Settings& now);

/// Whether the image carries parameters. Errors (input): not an image.
bool has_origin(const std::filesystem::path& image);

/// Errors (input): not an image, or one without our metadata.
ImageOrigin read_origin(const std::filesystem::path& image);

/// Writes the frame's buffer as a file, by the path's ending: `.png` is its picture, `.exr` its raw values,
/// `.svg` and `.pdf` the lines of `reference`, `curves` or `strokes`. Errors (input): another ending, `.svg`
/// or `.pdf` of another buffer; as `Frame::picture`; (work): the file cannot be written, there is no
/// rsvg-convert for a `.pdf`.
void write_buffer(const Frame& frame, BufferName buffer, const std::filesystem::path& path);

}  // namespace inkbench
