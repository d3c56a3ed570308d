#include "pipeline/image/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <span>
#include <string_view>
#include <utility>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/image/image_codecs.h"
#include "pipeline/image/image_content.h"
#include "pipeline/image/png_chunks.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;

constexpr size_t kBufferBytes = size_t{1} << 18;

std::span<const uint8_t> as_bytes(std::string_view text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

/// Takes a PNG as libpng writes it, sets our text chunks behind its head and hands all to a pending file.
/// Errors are kept for `check`, since none may pass through libpng's C frames.
class PngFile {
 public:
  PngFile(const fs::path& path, const ImageText& text) : file_(path) {
    for (const auto& [name, value] : text) chunks_ += png_text_chunk(name, value);
  }
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  /// Holds this file's address.
  ByteSink sink() {
    return {this, [](void* owner, std::string_view bytes) noexcept {
              return static_cast<PngFile*>(owner)->take(bytes);
            }};
  }

  void check() const {
    if (failure_) std::rethrow_exception(failure_);
  }
  void commit() {
    flush_buffer();
    check();
    file_.commit();
  }

 private:
  bool take(std::string_view bytes) noexcept {
    try {
      const size_t before_text =
          position_ < kPngHeadBytes ? std::min(bytes.size(), kPngHeadBytes - position_) : 0;
      position_ += bytes.size();
      buffer_ += bytes.substr(0, before_text);
      if (before_text > 0 && position_ >= kPngHeadBytes) buffer_ += chunks_;
      buffer_ += bytes.substr(before_text);
      if (buffer_.size() >= kBufferBytes) flush_buffer();
    } catch (...) {
      failure_ = std::current_exception();
    }
    return !failure_;
  }
  void flush_buffer() {
    try {
      if (!failure_) file_.append(as_bytes(buffer_));
    } catch (...) {
      failure_ = std::current_exception();
    }
    buffer_.clear();
  }

  PendingFile file_;
  std::string chunks_;
  std::string buffer_;
  size_t position_ = 0;  // of what libpng wrote, our chunks not counted
  std::exception_ptr failure_;
};

Error encoding_error(const std::string& name, const std::string& problem) {
  return work_error(name, "cannot be encoded", problem);
}

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
  std::string content = read_file(path);
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

template <class Sample>
ImageOf<Sample> decode(const fs::path& path, const OpenImage& image, SampleType type) {
  const ImageShape shape = image.shape();
  std::string problem;
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

uint8_t luma(const uint8_t* rgb) {
  return static_cast<uint8_t>(std::lround(0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]));
}

/// One pixel of `have` channels (grey, grey and alpha, RGB, RGBA) to `want` channels.
void convert_pixel(const uint8_t* from, int have, uint8_t* to, int want) {
  const bool grey = have <= 2;
  if (want == 1) {
    to[0] = grey ? from[0] : luma(from);
    return;
  }
  for (int i = 0; i < 3; ++i) to[i] = from[grey ? 0 : i];
  if (want == 4) to[3] = have % 2 == 0 ? from[have - 1] : 255;
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

struct PngStripWriter::State {
  fs::path path;
  int width_px, height_px, channels;
  PngFile file;
  // After `file`, which it writes to until it is gone.
  std::unique_ptr<PngEncoder, void (*)(PngEncoder*)> encoder{nullptr, image_codecs().close_png};
  int rows_written = 0;

  /// A failure of the file goes before the encoder's, which it caused.
  void check(bool good, const std::string& problem) const {
    file.check();
    if (!good) throw encoding_error(path.string(), problem);
  }
};

PngStripWriter::PngStripWriter(const fs::path& path, int width_px, int height_px, int channels,
                               const ImageText& text) {
  assert(width_px > 0 && height_px > 0 && (channels == 1 || channels == 3 || channels == 4));
  if (path.has_parent_path()) make_folder(path.parent_path());
  state_.reset(new State{path, width_px, height_px, channels, PngFile(path, text)});
  std::string problem;
  state_->encoder.reset(image_codecs().start_png({width_px, height_px, 1, channels}, state_->file.sink(),
                                                 path.string(), problem));
  if (!state_->encoder) throw encoding_error(path.string(), problem);
}

PngStripWriter::~PngStripWriter() = default;

void PngStripWriter::write(const Picture& strip) {
  State& s = *state_;
  assert(strip.width_px == s.width_px && strip.channels == s.channels);
  assert(s.rows_written + strip.height_px <= s.height_px);
  // A few rows at a time: OpenImageIO copies what it is given before it encodes it.
  constexpr int kRows = 64;
  for (int row = 0; row < strip.height_px; row += kRows) {
    const int end = s.rows_written + std::min(kRows, strip.height_px - row);
    std::string problem;
    const uint8_t* from = &strip.samples[strip.index(0, row)];
    const bool good = image_codecs().write_rows(*s.encoder, s.rows_written, end, from, problem);
    s.check(good, problem);
    s.rows_written = end;
  }
}

void PngStripWriter::finish() {
  State& s = *state_;
  assert(s.rows_written == s.height_px);
  std::string problem;
  const bool good = image_codecs().finish_png(*s.encoder, problem);
  s.check(good, problem);
  s.file.commit();
}

void write_png(const fs::path& path, const Picture& picture, const ImageText& text) {
  PngStripWriter writer(path, picture.width_px, picture.height_px, picture.channels, text);
  writer.write(picture);
  writer.finish();
}

void write_exr(const fs::path& path, const Image& image, const ImageText& text) {
  assert(image.channels == 1 || image.channels == 3 || image.channels == 4);
  const ImageShape shape{image.width_px, image.height_px, 1, image.channels};
  // In memory first: OpenEXR goes back to fill in its table of offsets.
  std::string encoded, problem;
  if (!image_codecs().encode_exr(shape, image.samples.data(), text, path.string(), encoded, problem))
    throw encoding_error(path.string(), problem);
  write_file_atomically(path, encoded);
}

std::string encode_webp(const Picture& picture, int quality) {
  assert(picture.channels == 3);
  const ImageShape shape{picture.width_px, picture.height_px, 1, picture.channels};
  std::string encoded, problem;
  if (!image_codecs().encode_webp(shape, picture.samples.data(), quality, encoded, problem))
    throw encoding_error("thumbnail.webp", problem);
  return encoded;
}

Picture read_picture(const fs::path& path, int channels) {
  assert(channels == 1 || channels == 3 || channels == 4);
  return with_channels(decode<uint8_t>(path, open_image(path), SampleType::byte), channels);
}

Image read_image(const fs::path& path) {
  return decode<float>(path, open_image(path), SampleType::real);
}

std::string read_image_text(const fs::path& path, const std::string& name) {
  return image_codecs().text(*open_image(path).decoder, name);
}

}  // namespace inkbench
