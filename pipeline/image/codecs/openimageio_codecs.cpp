// SPDX-License-Identifier: MIT
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
  const bool is_straight = spec.get_int_attribute("oiio:UnassociatedAlpha", 0) != 0;
  return {spec.width, spec.height, spec.depth, spec.nchannels, spec.alpha_channel >= 0 && !is_straight};
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

constexpr ImageCodecs kCodecs = {
    .open = open, .close = close, .shape = shape, .text = text, .decode = decode, .encode_exr = encode_exr};

}  // namespace
}  // namespace inkbench

extern "C" __attribute__((visibility("default"))) const inkbench::ImageCodecs* inkbench_image_codecs() {
  // On the calling thread alone; else OpenImageIO and OpenEXR each start a pool of a thread per core, and our
  // workers, one picture each, would fight over them.
  OIIO::attribute("threads", 1);
  OIIO::attribute("exr_threads", -1);
  return &inkbench::kCodecs;
}
