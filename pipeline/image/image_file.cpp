// SPDX-License-Identifier: MIT
#include "pipeline/image/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <string_view>
#include <utility>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/memory_room.h"
#include "pipeline/image/image_codecs.h"
#include "pipeline/image/image_content.h"
#include "pipeline/image/png_chunks.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;

/// A decoder and the file's bytes, which it reads from.
struct OpenImage {
  std::unique_ptr<const std::string> content;
  std::unique_ptr<ImageDecoder, void (*)(ImageDecoder*)> decoder{nullptr, image_codecs().close};

  ImageShape shape() const { return image_codecs().shape(*decoder); }
};

Error size_error(const fs::path& path, const std::string& size) {
  return input_error(path.string(), "its header asks for " + size + " samples",
                     fmt::format("at most 2^30 are read, and {} px a side", kMaxSidePx));
}

void check_size(const fs::path& path, std::string_view content, const ImageShape& shape) {
  const uint64_t pixels = static_cast<uint64_t>(shape.width_px) * shape.height_px;
  const std::string size = fmt::format("{} x {}", shape.width_px, shape.height_px);
  const bool sides_are_sound = shape.width_px > 0 && shape.height_px > 0 && shape.depth <= 1 &&
                               shape.width_px <= kMaxSidePx && shape.height_px <= kMaxSidePx;
  if (!sides_are_sound || pixels > kMaxSamples) {
    throw size_error(path, fmt::format("{} x {}", size, shape.channels));
  }
  if (shape.channels < 1 || shape.channels > 4) {
    throw input_error(path.string(), "has " + std::to_string(shape.channels) + " channels",
                      "1 to 4 are read");
  }
  if (pixels * shape.channels > kMaxSamples)
    throw size_error(path, fmt::format("{} x {}", size, shape.channels));
  if (!can_hold(image_format(content), content.size(), pixels)) {
    throw input_error(path.string(), "is damaged or cut off",
                      fmt::format("{} px do not fit into its {} bytes", size, content.size()));
  }
}

/// Before any decoder is let near it.
void check_content(const fs::path& path, std::string_view content) {
  if (content.empty()) throw input_error(path.string(), "is empty", "an image is needed");
  if (image_format(content).empty()) {
    throw input_error(path.string(), "is not an image that can be read",
                      "PNG, JPEG, EXR, TIFF, PGM and PPM are");
  }
  if (is_cut_off(content)) throw input_error(path.string(), "is cut off: the end of the image is missing");
  if (is_png(content) && !png_sums_are_right(content))
    throw input_error(path.string(), "is damaged: a check sum is wrong");
  if (image_format(content) == "openexr" && !exr_size_is_sound(content)) throw size_error(path, "too many");
}

OpenImage open_image(const fs::path& path) {
  std::string content = read_file(path, kMostImageBytes);
  check_content(path, content);
  // Whatever moves, the decoder's view of the bytes must stay.
  OpenImage image{std::make_unique<const std::string>(std::move(content))};
  std::string problem;
  image.decoder.reset(
      image_codecs().open(image_format(*image.content), *image.content, path.string(), problem));
  if (!image.decoder) throw input_error(path.string(), "is not an image that can be read", problem);
  check_size(path, *image.content, image.shape());
  return image;
}

/// Of the samples: what a decoder holds, what it hands over, and with other channels.
constexpr double kCopies = 3;

template <class Sample>
ImageOf<Sample> decode(const fs::path& path, const OpenImage& image, SampleType type) {
  const ImageShape shape = image.shape();
  std::string problem;
  const double samples = static_cast<double>(shape.width_px) * shape.height_px * shape.channels;
  check_memory(kCopies * sizeof(Sample) * samples, path.string(),
               fmt::format("reading {} x {} px", shape.width_px, shape.height_px), "choose a smaller image");
  try {
    ImageOf<Sample> result(shape.width_px, shape.height_px, shape.channels);
    if (image_codecs().decode(*image.decoder, type, result.samples.data(), problem)) return result;
  } catch (const std::bad_alloc&) {
    throw work_error(path.string(), "does not fit into memory");
  } catch (const std::exception& error) {
    problem = error.what();
    std::replace(problem.begin(), problem.end(), '\n', ' ');
  }
  throw input_error(path.string(), "is damaged or cut off", problem);
}

/// Rec. 709.
template <class Sample>
double luma(const Sample* rgb) {
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

/// One pixel of `have` channels (grey, grey and alpha, RGB, RGBA) to `want` channels.
void convert_pixel(const uint8_t* from, int have, uint8_t* to, int want) {
  const bool grey = have <= 2;
  if (want == 1) {
    to[0] = grey ? from[0] : static_cast<uint8_t>(std::lround(luma(from)));
    return;
  }
  for (int i = 0; i < 3; ++i) to[i] = from[grey ? 0 : i];
  if (want == 4) to[3] = have % 2 == 0 ? from[have - 1] : 255;
}

/// One pixel of 2 or 4 channels, the last one alpha: its grey times that.
double grey_times_alpha(const float* from, int channels, bool premultiplied) {
  const double grey = channels == 2 ? from[0] : luma(from);
  return premultiplied ? grey : grey * static_cast<double>(from[channels - 1]);
}

Picture with_channels(Picture picture, int channels) {
  if (picture.channels == channels) return picture;
  Picture result(picture.width_px, picture.height_px, channels);
  const size_t pixels = static_cast<size_t>(picture.width_px) * picture.height_px;
  for (size_t i = 0; i < pixels; ++i) {
    convert_pixel(&picture.samples[i * picture.channels], picture.channels, &result.samples[i * channels],
                  channels);
  }
  return result;
}

}  // namespace

void write_exr(const fs::path& path, const Image& image, const ImageText& text) {
  assert(image.channels == 1 || image.channels == 3 || image.channels == 4);
  const ImageShape shape{image.width_px, image.height_px, 1, image.channels};
  // In memory first: OpenEXR goes back to fill in its table of offsets.
  std::string encoded, problem;
  if (!image_codecs().encode_exr(shape, image.samples.data(), text, path.string(), encoded, problem))
    throw work_error(path.string(), "cannot be encoded", problem);
  write_file_atomically(path, encoded);
}

Picture read_picture(const fs::path& path, int channels) {
  assert(channels == 1 || channels == 3 || channels == 4);
  return with_channels(decode<uint8_t>(path, open_image(path), SampleType::byte), channels);
}

Image read_image(const fs::path& path) {
  return decode<float>(path, open_image(path), SampleType::real);
}

Image read_grey_and_alpha(const fs::path& path) {
  const OpenImage file = open_image(path);
  Image image = decode<float>(path, file, SampleType::real);
  if (image.channels == 1) return image;
  const bool has_alpha = image.channels % 2 == 0, premultiplied = file.shape().premultiplied;
  Image grey(image.width_px, image.height_px, has_alpha ? 2 : 1);
  const size_t pixels = static_cast<size_t>(image.width_px) * image.height_px;
  for (size_t i = 0; i < pixels; ++i) {
    const float* from = &image.samples[i * image.channels];
    float* to = &grey.samples[i * grey.channels];
    to[0] =
        static_cast<float>(has_alpha ? grey_times_alpha(from, image.channels, premultiplied) : luma(from));
    if (has_alpha) to[1] = from[image.channels - 1];
  }
  return grey;
}

Image read_grey_over_white(const fs::path& path) {
  Image image = read_grey_and_alpha(path);
  if (image.channels == 1) return image;
  Image grey(image.width_px, image.height_px, 1);
  for (size_t i = 0; i < grey.samples.size(); ++i)
    grey.samples[i] = image.samples[2 * i] + (1.0F - image.samples[2 * i + 1]);
  return grey;
}

int image_channels(const fs::path& path) {
  return open_image(path).shape().channels;
}

std::string read_image_text(const fs::path& path, const std::string& name) {
  return image_codecs().text(*open_image(path).decoder, name);
}

}  // namespace inkbench
