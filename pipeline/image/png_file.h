// SPDX-License-Identifier: MIT
// PNG files, written straight through two fast packers: libdeflate for a picture in memory, ISA-L for one
// that comes in strips. In: 8-bit pictures and text. Out: files, whole or not at all, in sRGB.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "pipeline/base/files.h"
#include "pipeline/image/image.h"

namespace inkbench {

/// Metadata entries by name, written as PNG text chunks (UTF-8) or EXR string attributes. Names are 1 to 79
/// bytes of ASCII, best "inkbench:..." (an EXR file has names of its own); no entry holds a zero byte.
using ImageText = std::map<std::string, std::string>;

/// 8-bit PNG with 1, 3 or 4 channels (alpha not multiplied in). The same picture and text give the same
/// bytes. Errors (work): as `write_file_atomically`.
void write_png(const std::filesystem::path& path, const Picture& picture, const ImageText& text,
               Sync sync = Sync::now);

/// A PNG written a strip of rows at a time, for pictures too large to hold; ten times as fast as `write_png`
/// for files up to half again as large. Nothing stands under `path` until `finish`.
class PngStripWriter {
 public:
  PngStripWriter(const std::filesystem::path& path, int width_px, int height_px, int channels,
                 const ImageText& text);
  PngStripWriter(const PngStripWriter&) = delete;
  PngStripWriter& operator=(const PngStripWriter&) = delete;
  ~PngStripWriter();  ///< Without `finish`, leaves no file.

  /// The next `strip.height_px` rows; the width and channels must be the picture's. Errors (work): full disk.
  void write(const Picture& strip);
  /// Errors (work): full disk. All rows must have been written.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace inkbench
