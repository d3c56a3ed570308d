// Images to and from files through OpenImageIO, which stays behind image_codecs.h and is loaded by the first
// call here. Every file is written whole or not at all, and carries `text` entries (parameters, version) in
// its metadata. All functions may run on several threads at once and use no threads of their own. Errors
// (work) of all: the image module is missing.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "pipeline/image/image.h"

namespace inkbench {

/// Metadata entries by name, written as PNG text chunks (UTF-8) or EXR string attributes. Names are 1 to 79
/// bytes of ASCII, best "inkbench:..." (an EXR file has names of its own); no entry holds a zero byte.
using ImageText = std::map<std::string, std::string>;

/// 8-bit PNG with 1, 3 or 4 channels (alpha not multiplied in). The same picture and text give the same
/// bytes. Errors (work): as `write_file_atomically`.
void write_png(const std::filesystem::path& path, const Picture& picture, const ImageText& text);

/// 32-bit float EXR (ZIP compressed) with 1 (Y), 3 (R, G, B) or 4 channels (R, G, B, A); values are stored as
/// they are, NaN and infinities included. Errors (work): as `write_file_atomically`.
void write_exr(const std::filesystem::path& path, const Image& image, const ImageText& text);

/// A lossy WebP file in memory, for small pictures inside other files; 1 to 16,383 px a side, 3 channels,
/// `quality` 1 to 100. The same picture gives the same bytes. Errors (work): it cannot be encoded.
std::string encode_webp(const Picture& picture, int quality);

/// A PNG written a strip of rows at a time, for pictures too large to hold. Nothing stands under `path` until
/// `finish`.
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

/// Reads a PNG, JPEG, EXR, TIFF, PGM or PPM file, whatever its name, as 8-bit with `channels` channels (1, 3
/// or 4). Grey is spread, colour becomes its Rec. 709 luma, alpha is dropped or set opaque; floats of 0 to 1
/// become 0 to 255 as they are. Errors (input): missing, empty, not an image, cut off in the middle, more
/// than 2^30 samples or 131,072 px a side, not 1 to 4 channels.
Picture read_picture(const std::filesystem::path& path, int channels);

/// Reads an image file as floats, with the file's own 1 to 4 channels; whole numbers become 0 to 1. Errors
/// as `read_picture`.
Image read_image(const std::filesystem::path& path);

/// The metadata entry `name`; "" where the image has none. Errors as `read_picture`.
std::string read_image_text(const std::filesystem::path& path, const std::string& name);

}  // namespace inkbench
