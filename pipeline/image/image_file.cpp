#include "pipeline/image/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
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
#include "pipeline/image/image_content.h"
#include "pipeline/image/png_chunks.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;
using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

// Measured on three cartoon pictures of 1024 x 1024 x 3 (flat, smooth, normal-mapped), one core: level 5
// without row filters takes 9, 13, 23 ms and packs 102:1, 28:1, 14:1. Level 6 costs up to 33 % more time for
// 4 to 22 % fewer bytes. Row filters hide the repeats that flat colour has: the default (level 6, all
// filters) takes 22, 72, 98 ms and packs smooth shading worse, 20:1.
constexpr int kPngLevel = 5;
constexpr int kPngFilterNone = 8;  // libpng's PNG_FILTER_NONE

constexpr size_t kBufferBytes = size_t{1} << 18;

/// Keeps OpenImageIO and OpenEXR on the calling thread; else each starts a pool of a thread per core, and our
/// workers, one picture each, would fight over them.
void use_calling_thread_only() {
  static const bool done = [] {
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
    return true;
  }();
  static_cast<void>(done);
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

std::span<const uint8_t> as_bytes(std::string_view text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

/// Takes a PNG as libpng writes it, sets our text chunks behind its head and hands all to a pending file.
/// Errors are kept for `check`, since none may pass through libpng's C frames.
class PngFile final : public OIIO::Filesystem::IOProxy {
 public:
  PngFile(const fs::path& path, const ImageText& text) : IOProxy(path.string(), Write), file_(path) {
    for (const auto& [name, value] : text) chunks_ += png_text_chunk(name, value);
  }

  const char* proxytype() const override { return "inkbench"; }
  using IOProxy::write;  // The span overload, which this class does not replace.
  size_t write(const void* data, size_t size) override {
    const std::string_view bytes(static_cast<const char*>(data), size);
    const size_t before_text = position_ < kPngHeadBytes ? std::min(size, kPngHeadBytes - position_) : 0;
    position_ += size;
    buffer_ += bytes.substr(0, before_text);
    if (before_text > 0 && position_ >= kPngHeadBytes) buffer_ += chunks_;
    buffer_ += bytes.substr(before_text);
    if (buffer_.size() >= kBufferBytes) flush_buffer();
    return failure_ ? 0 : size;
  }
  int64_t tell() override { return static_cast<int64_t>(position_); }

  void check() const {
    if (failure_) std::rethrow_exception(failure_);
  }
  void commit() {
    flush_buffer();
    check();
    file_.commit();
  }

 private:
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

void open_output(ImageOutput* output, const fs::path& path, ImageSpec spec,
                 OIIO::Filesystem::IOProxy* proxy) {
  void* pointer = proxy;
  spec.attribute("oiio:ioproxy", TypeDesc::PTR, &pointer);
  if (output == nullptr || !output->open(path.string(), spec)) {
    throw work_error(path.string(), "cannot be encoded",
                     one_line(output ? output->geterror() : OIIO::geterror()));
  }
}

/// A decoder and the file's bytes, which it reads from.
struct OpenImage {
  std::string content;
  OIIO::Filesystem::IOMemReader reader;
  std::unique_ptr<ImageInput> input;

  explicit OpenImage(std::string bytes) : content(std::move(bytes)), reader(content.data(), content.size()) {}
  const ImageSpec& spec() const { return input->spec(); }
};

Error size_error(const fs::path& path, const std::string& size) {
  return input_error(path.string(), "its header asks for " + size + " samples",
                     fmt::format("at most 2^30 are read, and {} px a side", kMaxSidePx));
}

void check_size(const fs::path& path, std::string_view content, const ImageSpec& spec) {
  const uint64_t pixels = static_cast<uint64_t>(spec.width) * spec.height;
  const std::string size = fmt::format("{} x {}", spec.width, spec.height);
  const bool sides_are_sound = spec.width > 0 && spec.height > 0 && spec.depth <= 1 &&
                               spec.width <= kMaxSidePx && spec.height <= kMaxSidePx;
  if (!sides_are_sound || pixels > kMaxSamples) {
    throw size_error(path, fmt::format("{} x {}", size, spec.nchannels));
  }
  if (spec.nchannels < 1 || spec.nchannels > 4) {
    throw input_error(path.string(), "has " + std::to_string(spec.nchannels) + " channels",
                      "1 to 4 are read");
  }
  if (pixels * spec.nchannels > kMaxSamples)
    throw size_error(path, fmt::format("{} x {}", size, spec.nchannels));
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

std::unique_ptr<OpenImage> open_image(const fs::path& path) {
  use_calling_thread_only();
  auto image = std::make_unique<OpenImage>(read_file(path));
  check_content(path, image->content);
  ImageSpec config, spec;
  config.attribute("oiio:UnassociatedAlpha", 1);
  image->input = ImageInput::create(std::string(image_format(image->content)));
  image->input->set_ioproxy(&image->reader);
  bool is_open = false;
  try {
    is_open = image->input->open(path.string(), spec, config);
  } catch (const std::exception&) {
    // Room for what the header asks could not be made.
  }
  if (!is_open)
    throw input_error(path.string(), "is not an image that can be read", one_line(image->input->geterror()));
  check_size(path, image->content, spec);
  return image;
}

template <class Sample>
ImageOf<Sample> decode(const fs::path& path, OpenImage& image, TypeDesc type) {
  const ImageSpec spec = image.spec();
  try {
    ImageOf<Sample> result(spec.width, spec.height, spec.nchannels);
    if (image.input->read_image(0, 0, 0, spec.nchannels, type, result.samples.data())) return result;
  } catch (const std::bad_alloc&) {
    throw work_error(path.string(), "does not fit into memory");
  } catch (const std::exception& error) {
    throw input_error(path.string(), "is damaged or cut off", one_line(error.what()));
  }
  throw input_error(path.string(), "is damaged or cut off", one_line(image.input->geterror()));
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
  PngFile file;
  std::unique_ptr<ImageOutput> output;  // After `file`, which it writes to until it is gone.
  int width_px, height_px, channels;
  int rows_written = 0;
};

PngStripWriter::PngStripWriter(const fs::path& path, int width_px, int height_px, int channels,
                               const ImageText& text) {
  assert(width_px > 0 && height_px > 0 && (channels == 1 || channels == 3 || channels == 4));
  use_calling_thread_only();
  if (path.has_parent_path()) make_folder(path.parent_path());
  state_.reset(
      new State{path, PngFile(path, text), ImageOutput::create("png"), width_px, height_px, channels});
  ImageSpec spec(width_px, height_px, channels, TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("png:compressionLevel", kPngLevel);
  spec.attribute("png:filter", kPngFilterNone);
  open_output(state_->output.get(), path, spec, &state_->file);
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
    const uint8_t* from = &strip.samples[strip.index(0, row)];
    const bool good = s.output->write_scanlines(s.rows_written, end, 0, TypeDesc::UINT8, from);
    s.file.check();
    if (!good) throw work_error(s.path.string(), "cannot be encoded", one_line(s.output->geterror()));
    s.rows_written = end;
  }
}

void PngStripWriter::finish() {
  State& s = *state_;
  assert(s.rows_written == s.height_px);
  const bool good = s.output->close();
  s.file.check();
  if (!good) throw work_error(s.path.string(), "cannot be encoded", one_line(s.output->geterror()));
  s.file.commit();
}

void write_png(const fs::path& path, const Picture& picture, const ImageText& text) {
  PngStripWriter writer(path, picture.width_px, picture.height_px, picture.channels, text);
  writer.write(picture);
  writer.finish();
}

void write_exr(const fs::path& path, const Image& image, const ImageText& text) {
  assert(image.channels == 1 || image.channels == 3 || image.channels == 4);
  use_calling_thread_only();
  ImageSpec spec(image.width_px, image.height_px, image.channels, TypeDesc::FLOAT);
  spec.channelnames = {"R", "G", "B", "A"};
  if (image.channels == 1) spec.channelnames = {"Y"};
  spec.channelnames.resize(image.channels);
  spec.attribute("DateTime",
                 "");  // Else OpenImageIO puts the time of writing there, and no two files are alike.
  for (const auto& [name, value] : text) spec.attribute(name, value);
  spec.attribute("compression", "zip");
  // In memory first: OpenEXR goes back to fill in its table of offsets.
  std::vector<unsigned char> encoded;
  OIIO::Filesystem::IOVecOutput memory(encoded);
  const std::unique_ptr<ImageOutput> output = ImageOutput::create("openexr");
  open_output(output.get(), path, spec, &memory);
  if (!output->write_image(TypeDesc::FLOAT, image.samples.data()) || !output->close()) {
    throw work_error(path.string(), "cannot be encoded", one_line(output->geterror()));
  }
  write_file_atomically(path, {reinterpret_cast<const char*>(encoded.data()), encoded.size()});
}

std::string encode_webp(const Picture& picture, int quality) {
  assert(picture.channels == 3);
  use_calling_thread_only();
  ImageSpec spec(picture.width_px, picture.height_px, 3, TypeDesc::UINT8);
  spec.attribute("Compression", "webp:" + std::to_string(quality));
  std::vector<unsigned char> encoded;
  OIIO::Filesystem::IOVecOutput memory(encoded);
  const std::unique_ptr<ImageOutput> output = ImageOutput::create("webp");
  open_output(output.get(), "thumbnail.webp", spec, &memory);
  if (!output->write_image(TypeDesc::UINT8, picture.samples.data()) || !output->close()) {
    throw work_error("thumbnail.webp", "cannot be encoded", one_line(output->geterror()));
  }
  return {encoded.begin(), encoded.end()};
}

Picture read_picture(const fs::path& path, int channels) {
  assert(channels == 1 || channels == 3 || channels == 4);
  const std::unique_ptr<OpenImage> image = open_image(path);
  return with_channels(decode<uint8_t>(path, *image, TypeDesc::UINT8), channels);
}

Image read_image(const fs::path& path) {
  const std::unique_ptr<OpenImage> image = open_image(path);
  return decode<float>(path, *image, TypeDesc::FLOAT);
}

std::string read_image_text(const fs::path& path, const std::string& name) {
  // OpenImageIO reads these three under names of its own.
  static const std::map<std::string, std::string> kRenamed = {
      {"Author", "Artist"}, {"Description", "ImageDescription"}, {"Title", "DocumentName"}};
  const std::unique_ptr<OpenImage> image = open_image(path);
  const auto renamed = kRenamed.find(name);
  const std::string other_name = renamed != kRenamed.end() ? renamed->second : name;
  return std::string(
      image->spec().get_string_attribute(name, image->spec().get_string_attribute(other_name)));
}

}  // namespace inkbench
