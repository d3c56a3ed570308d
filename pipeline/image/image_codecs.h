// SPDX-License-Identifier: MIT
// Encoders and decoders on memory, as the module pipeline/image/codecs gives them. OpenImageIO brings 260
// shared libraries, which take a fifth of a second to load: the module is opened when the first image is read
// or written, and nothing else knows of OpenImageIO. Only plain calls, standard types and standard exceptions
// cross over.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace inkbench {

struct ImageDecoder;  ///< The module's own.

/// The type that samples are handed over as: `byte` uint8_t, `real` float.
enum class SampleType { byte, real };

/// As a file's header says, sound or not.
struct ImageShape {
  int width_px = 0;
  int height_px = 0;
  int depth = 1;
  int channels = 0;
  bool premultiplied = false;  ///< Of what is decoded: alpha is multiplied into the colours.
};

/// Where a function tells of a `problem`, that is the library's own text in one line, and the function gives
/// nullptr or false. All may run on several threads at once and use no threads of their own.
struct ImageCodecs {
  /// `format` as `image_format` names it; `content` must outlive the decoder; `name` is for problems.
  ImageDecoder* (*open)(std::string_view format, std::string_view content, const std::string& name,
                        std::string& problem);
  void (*close)(ImageDecoder* decoder);
  ImageShape (*shape)(const ImageDecoder& decoder);
  /// The metadata entry; "" where there is none.
  std::string (*text)(const ImageDecoder& decoder, const std::string& entry);
  /// All rows from the top, channels interleaved. May throw what is a std::exception.
  bool (*decode)(ImageDecoder& decoder, SampleType type, void* samples, std::string& problem);

  /// A whole file in memory, as `write_exr` says.
  bool (*encode_exr)(const ImageShape& shape, const float* samples,
                     const std::map<std::string, std::string>& text, const std::string& name,
                     std::string& encoded, std::string& problem);
};

/// Opens the module at the first call. Errors (work): it is missing or cannot be opened.
const ImageCodecs& image_codecs();

}  // namespace inkbench

/// What the module exports.
extern "C" const inkbench::ImageCodecs* inkbench_image_codecs();
