// SPDX-License-Identifier: MIT
// Images to and from files: read, and written as EXR, through OpenImageIO, which stays behind image_codecs.h
// and is loaded by the first call here; PNG is written by png_file.h. Every file is written whole or not at
// all, and carries `text` entries (parameters, version) in its metadata. All functions may run on several
// threads at once and use no threads of their own. Errors (work) of all: the image module is missing.
#pragma once

#include <filesystem>
#include <string>

#include "pipeline/image/image.h"
#include "pipeline/image/png_file.h"

namespace inkbench {

/// 32-bit float EXR (ZIP compressed) with 1 (Y), 3 (R, G, B) or 4 channels (R, G, B, A); values are stored as
/// they are, NaN and infinities included. Errors (work): as `write_file_atomically`.
void write_exr(const std::filesystem::path& path, const Image& image, const ImageText& text);

/// Reads a PNG, JPEG, EXR, TIFF, PGM or PPM file, whatever its name, as 8-bit with `channels` channels (1, 3
/// or 4). Grey is spread, colour becomes its Rec. 709 luma, alpha is dropped or set opaque; floats of 0 to 1
/// become 0 to 255 as they are. Errors (input): missing, empty, not an image, cut off in the middle, more
/// than 2^30 samples or 131,072 px a side, not 1 to 4 channels.
Picture read_picture(const std::filesystem::path& path, int channels);

/// Reads an image file as floats, with the file's own 1 to 4 channels; whole numbers become 0 to 1. Errors
/// as `read_picture`.
Image read_image(const std::filesystem::path& path);

/// Reads an image file as one channel of floats, over white where it is transparent: Rec. 709 luma of its
/// colours as they are stored, 1 is white. Errors as `read_picture`.
Image read_grey_over_white(const std::filesystem::path& path);

/// The same over nothing: where the image has transparency, two channels, luma times alpha and alpha; else
/// one. Errors as `read_picture`.
Image read_grey_and_alpha(const std::filesystem::path& path);

/// 1 to 4. Errors as `read_picture`.
int image_channels(const std::filesystem::path& path);

/// The metadata entry `name`; "" where the image has none. Errors as `read_picture`.
std::string read_image_text(const std::filesystem::path& path, const std::string& name);

}  // namespace inkbench
