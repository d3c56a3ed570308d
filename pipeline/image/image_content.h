// SPDX-License-Identifier: MIT
// What an image file's bytes say before a decoder sees them: decoders trust headers, and a damaged one can
// make them take gigabytes, fill in what is missing without a word, or write past their buffers. In and out:
// bytes.
#pragma once

#include <cstdint>
#include <string_view>

namespace inkbench {

/// An image with more samples than this is junk: a picture of 16,384 x 16,384 with 4 channels has as many.
inline constexpr uint64_t kMaxSamples = uint64_t{1} << 30;

/// And so is one with a longer side. OpenImageIO reads 64 rows at a time, however few there are.
inline constexpr int64_t kMaxSidePx = int64_t{1} << 17;

/// By its first bytes: "png", "jpeg", "openexr", "tiff" or "pnm" (PBM, PGM, PPM with binary samples), as
/// OpenImageIO calls them; "" for anything else. Of OpenImageIO's decoders these stood up to damaged files.
std::string_view image_format(std::string_view content);

/// Whether the end is missing: of PNG and JPEG the end of the image, of EXR the end of the header.
bool is_cut_off(std::string_view content);

/// Whether an EXR's header asks for sides and a number of pixels within the limits. Others are asked once
/// they are open.
bool exr_size_is_sound(std::string_view content);

/// Whether a file of this format and that many bytes can hold that many pixels; true where no limit is known.
bool can_hold(std::string_view format, uint64_t bytes, uint64_t pixels);

}  // namespace inkbench
