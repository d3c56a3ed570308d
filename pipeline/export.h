// Buffers to image files that know where they came from: every file carries all parameters and the version.
#pragma once

#include <filesystem>
#include <string>

#include "pipeline/flow/buffer_names.h"
#include "pipeline/image/image_file.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// The metadata of an exported buffer: version, buffer and all settings.
ImageText export_text(const Settings& settings, BufferName buffer);

/// What an exported image says of itself.
struct ImageOrigin {
  Settings settings;
  BufferName buffer = BufferName::final;
  std::string version;
};

/// Whether the image carries parameters. Errors (input): not an image.
bool has_origin(const std::filesystem::path& image);

/// Errors (input): not an image, or one without our metadata.
ImageOrigin read_origin(const std::filesystem::path& image);

}  // namespace inkbench
