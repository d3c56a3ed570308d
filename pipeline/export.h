// Buffers to image files that know where they came from: every file carries all parameters and the version.
#pragma once

#include <filesystem>
#include <string>

#include "pipeline/image/image_file.h"
#include "pipeline/passes/buffer_names.h"
#include "pipeline/pipeline.h"
#include "pipeline/scene/settings.h"

namespace inkbench {

enum class ExportFormat { png, exr };

/// The metadata of an exported buffer: version, buffer and all settings.
ImageText export_text(const Settings& settings, BufferName buffer);

/// Draws the buffer and writes `folder/<buffer>.<format>`; returns its path. A PNG holds the picture, an EXR
/// the raw values. Errors: as `Pipeline::picture` and `write_png`.
std::filesystem::path export_buffer(Pipeline& pipeline, const Settings& settings, BufferName buffer,
                                    const std::filesystem::path& folder, ExportFormat format);

/// What an exported image says of itself.
struct ImageOrigin {
  Settings settings;
  BufferName buffer = BufferName::final;
  std::string version;
};

/// Errors (input): not an image, or one without our metadata.
ImageOrigin read_origin(const std::filesystem::path& image);

}  // namespace inkbench
