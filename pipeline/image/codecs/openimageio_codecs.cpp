// The module that holds OpenImageIO: see image_codecs.h.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <vector>

#include "pipeline/image/image_codecs.h"

using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

namespace inkbench {

struct ImageDecoder {
  OIIO::Filesystem::IOMemReader reader;
  std::unique_ptr<ImageInput> input;

  explicit ImageDecoder(std::string_view content)
      : reader(const_cast<char*>(content.data()), content.size()) {}  // it is only read
};

namespace {

/// Hands on what libpng writes.
class SinkProxy final : public OIIO::Filesystem::IOProxy {
 public:
  SinkProxy(const std::string& name, ByteSink sink) : IOProxy(name, Write), sink_(sink) {}

  const char* proxytype() const override { return "inkbench"; }
  using IOProxy::write;  // The span overload, which this class does not replace.
  size_t write(const void* data, size_t size) override {
    position_ += size;
    return sink_.take(sink_.owner, {static_cast<const char*>(data), size}) ? size : 0;
  }
  int64_t tell() override { return static_cast<int64_t>(position_); }

 private:
  ByteSink sink_;
  size_t position_ = 0;
};

}  // namespace

struct PngEncoder {
  SinkProxy sink;
  std::unique_ptr<ImageOutput> output;  // After `sink`, which it writes to until it is gone.
};

namespace {

// Measured on three cartoon pictures of 1024 x 1024 x 3 (flat, smooth, normal-mapped), one core: level 5
// without row filters takes 9, 13, 23 ms and packs 102:1, 28:1, 14:1. Level 6 costs up to 33 % more time for
// 4 to 22 % fewer bytes. Row filters hide the repeats that flat colour has: the default (level 6, all
// filters) takes 22, 72, 98 ms and packs smooth shading worse, 20:1.
constexpr int kPngLevel = 5;
constexpr int kPngFilterNone = 8;  // libpng's PNG_FILTER_NONE

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

bool open_output(ImageOutput* output, const std::string& name, ImageSpec spec,
                 OIIO::Filesystem::IOProxy* proxy, std::string& problem) {
  void* pointer = proxy;
  spec.attribute("oiio:ioproxy", TypeDesc::PTR, &pointer);
  if (output != nullptr && output->open(name, spec)) return true;
  problem = one_line(output != nullptr ? output->geterror() : OIIO::geterror());
  return false;
}

/// Where `good` is false, the problem that `source` has.
template <class Source>
bool told(bool good, const Source& source, std::string& problem) {
  if (!good) problem = one_line(source.geterror());
  return good;
}

ImageDecoder* open(std::string_view format, std::string_view content, const std::string& name,
                   std::string& problem) {
  auto decoder = std::make_unique<ImageDecoder>(content);
  ImageSpec config, spec;
  config.attribute("oiio:UnassociatedAlpha", 1);
  decoder->input = ImageInput::create(std::string(format));
  decoder->input->set_ioproxy(&decoder->reader);
  bool is_open = false;
  try {
    is_open = decoder->input->open(name, spec, config);
  } catch (const std::exception&) {
    // Room for what the header asks could not be made.
  }
  return told(is_open, *decoder->input, problem) ? decoder.release() : nullptr;
}

void close(ImageDecoder* decoder) {
  delete decoder;
}

ImageShape shape(const ImageDecoder& decoder) {
  const ImageSpec& spec = decoder.input->spec();
  return {spec.width, spec.height, spec.depth, spec.nchannels};
}

std::string text(const ImageDecoder& decoder, const std::string& entry) {
  // OpenImageIO reads these three under names of its own.
  static const std::map<std::string, std::string> kRenamed = {
      {"Author", "Artist"}, {"Description", "ImageDescription"}, {"Title", "DocumentName"}};
  const auto renamed = kRenamed.find(entry);
  const std::string other_name = renamed != kRenamed.end() ? renamed->second : entry;
  const ImageSpec& spec = decoder.input->spec();
  return std::string(spec.get_string_attribute(entry, spec.get_string_attribute(other_name)));
}

bool decode(ImageDecoder& decoder, SampleType type, void* samples, std::string& problem) {
  const TypeDesc format = type == SampleType::byte ? TypeDesc::UINT8 : TypeDesc::FLOAT;
  const int channels = decoder.input->spec().nchannels;
  return told(decoder.input->read_image(0, 0, 0, channels, format, samples), *decoder.input, problem);
}

PngEncoder* start_png(const ImageShape& shape, ByteSink sink, const std::string& name, std::string& problem) {
  auto encoder = std::make_unique<PngEncoder>(PngEncoder{{name, sink}, ImageOutput::create("png")});
  ImageSpec spec(shape.width_px, shape.height_px, shape.channels, TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("png:compressionLevel", kPngLevel);
  spec.attribute("png:filter", kPngFilterNone);
  return open_output(encoder->output.get(), name, spec, &encoder->sink, problem) ? encoder.release()
                                                                                 : nullptr;
}

bool write_rows(PngEncoder& encoder, int begin, int end, const uint8_t* samples, std::string& problem) {
  return told(encoder.output->write_scanlines(begin, end, 0, TypeDesc::UINT8, samples), *encoder.output,
              problem);
}

bool finish_png(PngEncoder& encoder, std::string& problem) {
  return told(encoder.output->close(), *encoder.output, problem);
}

void close_png(PngEncoder* encoder) {
  delete encoder;
}

/// A file that is written whole into memory, where its encoder may go back.
bool encode(const char* format, const std::string& name, const ImageSpec& spec, const void* samples,
            std::string& encoded, std::string& problem) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::unique_ptr<ImageOutput> output = ImageOutput::create(format);
  if (!open_output(output.get(), name, spec, &memory, problem)) return false;
  if (!told(output->write_image(spec.format, samples) && output->close(), *output, problem)) return false;
  encoded.assign(bytes.begin(), bytes.end());
  return true;
}

bool encode_exr(const ImageShape& shape, const float* samples, const std::map<std::string, std::string>& text,
                const std::string& name, std::string& encoded, std::string& problem) {
  ImageSpec spec(shape.width_px, shape.height_px, shape.channels, TypeDesc::FLOAT);
  spec.channelnames = {"R", "G", "B", "A"};
  if (shape.channels == 1) spec.channelnames = {"Y"};
  spec.channelnames.resize(shape.channels);
  // Else OpenImageIO puts the time of writing there, and no two files are alike.
  spec.attribute("DateTime", "");
  for (const auto& [entry, value] : text) spec.attribute(entry, value);
  spec.attribute("compression", "zip");
  return encode("openexr", name, spec, samples, encoded, problem);
}

bool encode_webp(const ImageShape& shape, const uint8_t* samples, int quality, std::string& encoded,
                 std::string& problem) {
  ImageSpec spec(shape.width_px, shape.height_px, shape.channels, TypeDesc::UINT8);
  spec.attribute("Compression", "webp:" + std::to_string(quality));
  return encode("webp", "picture.webp", spec, samples, encoded, problem);
}

constexpr ImageCodecs kCodecs = {.open = open,
                                 .close = close,
                                 .shape = shape,
                                 .text = text,
                                 .decode = decode,
                                 .start_png = start_png,
                                 .write_rows = write_rows,
                                 .finish_png = finish_png,
                                 .close_png = close_png,
                                 .encode_exr = encode_exr,
                                 .encode_webp = encode_webp};

}  // namespace
}  // namespace inkbench

extern "C" __attribute__((visibility("default"))) const inkbench::ImageCodecs* inkbench_image_codecs() {
  // On the calling thread alone; else OpenImageIO and OpenEXR each start a pool of a thread per core, and our
  // workers, one picture each, would fight over them.
  OIIO::attribute("threads", 1);
  OIIO::attribute("exr_threads", -1);
  return &inkbench::kCodecs;
}
