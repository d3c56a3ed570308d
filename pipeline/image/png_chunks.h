// SPDX-License-Identifier: MIT
// The chunks that a PNG file is made of, text under any name and in any script among them, and telling a
// whole file from one cut off or damaged. In and out: bytes.
#pragma once

#include <string>
#include <string_view>

namespace inkbench {

/// The signature and the IHDR chunk, which open every PNG: 8 bits a sample, 1, 3 or 4 channels.
std::string png_open(int width_px, int height_px, int channels);

/// Any chunk. `type` has four letters.
std::string make_png_chunk(std::string_view type, std::string_view body);

/// What says that samples are sRGB; with its gamma and primaries for programs that know sRGB by those alone.
/// Source: PNG specification (third edition), 11.3.2.5.
std::string png_srgb_chunks();

/// A text chunk. ASCII goes into tEXt, which every program reads; anything else into iTXt, since tEXt is
/// Latin-1. `name` is 1 to 79 bytes of ASCII. Source: PNG specification (third edition), 11.3.3.
std::string png_text_chunk(std::string_view name, std::string_view text);

/// Whether `content` opens with the PNG signature.
bool is_png(std::string_view content);

/// Whether the chain of chunks reaches IEND. Decoders return what they have of a file cut off; we refuse it.
bool png_is_whole(std::string_view content);

/// Whether each whole chunk has its check sum. libpng would find out too, but speaks to stderr then.
bool png_sums_are_right(std::string_view content);

}  // namespace inkbench
