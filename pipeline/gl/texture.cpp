// SPDX-License-Identifier: MIT
#include "pipeline/gl/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstring>

#include "pipeline/base/error.h"
#include "pipeline/gl/gl_context.h"

namespace inkbench {
namespace {

struct FormatInfo {
  GLenum internal, external, type;
  int channels;
};

FormatInfo info_of(TextureFormat format) {
  switch (format) {
    case TextureFormat::r32f:
      return {GL_R32F, GL_RED, GL_FLOAT, 1};
    case TextureFormat::rg32f:
      return {GL_RG32F, GL_RG, GL_FLOAT, 2};
    case TextureFormat::rgba32f:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 4};
    case TextureFormat::rgba16f:
      return {GL_RGBA16F, GL_RGBA, GL_FLOAT, 4};
    case TextureFormat::r8:
      return {GL_R8, GL_RED, GL_FLOAT, 1};
    case TextureFormat::rg8:
      return {GL_RG8, GL_RG, GL_FLOAT, 2};
    case TextureFormat::rgba8:
      return {GL_RGBA8, GL_RGBA, GL_FLOAT, 4};
    case TextureFormat::rg32ui:
      return {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, 2};
    case TextureFormat::depth32f:
      return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 1};
  }
  return {};
}

/// Rows from the bottom up, as OpenGL gives them, as an image of some of their channels.
Image upright(const std::vector<float>& raw, int raw_channels, int width_px, int height_px, int first,
              int channels) {
  Image image(width_px, height_px, channels);
  for (int y = 0; y < height_px; ++y) {
    const float* from = &raw[static_cast<size_t>(height_px - 1 - y) * width_px * raw_channels];
    for (int x = 0; x < width_px; ++x)
      std::copy_n(from + x * raw_channels + first, channels, &image.at(x, y));
  }
  return image;
}

}  // namespace

GLenum internal_format(TextureFormat format) {
  return info_of(format).internal;
}

Texture::Texture(const std::string& label, TextureFormat format, int width_px, int height_px) {
  GLint max_side = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &max_side);
  if (width_px < 1 || height_px < 1 || width_px > max_side || height_px > max_side) {
    throw input_error("image size", fmt::format("{} x {} px cannot be drawn", width_px, height_px),
                      fmt::format("this renderer's sides are from 1 to {} px", max_side));
  }
  storage_ = GlContext::current().textures().take(format, width_px, height_px);
  label_object(GL_TEXTURE, storage_.id, label);
}

Texture::Texture(Texture&& other) noexcept : storage_(std::exchange(other.storage_, {})) {}

Texture& Texture::operator=(Texture&& other) noexcept {
  std::swap(storage_, other.storage_);
  return *this;
}

Texture::~Texture() {
  if (storage_.pool != nullptr) storage_.pool->give_back(storage_);
}

// It changes what the texture holds. NOLINTNEXTLINE(readability-make-member-function-const)
void Texture::upload(const Image& image) {
  const FormatInfo info = info_of(format());
  assert(image.width_px == width_px() && image.height_px == height_px() && image.channels == info.channels);
  Image flipped = image;
  const size_t row = static_cast<size_t>(width_px()) * info.channels;
  for (int y = 0; y < height_px(); ++y) {
    std::copy_n(&image.samples[y * row], row, &flipped.samples[(height_px() - 1 - y) * row]);
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(id(), 0, 0, 0, width_px(), height_px(), info.external, GL_FLOAT,
                      flipped.samples.data());
}

Image Texture::read(int first, int channels) const {
  const FormatInfo info = info_of(format());
  assert(first + channels <= info.channels);
  std::vector<float> raw(static_cast<size_t>(width_px()) * height_px() * info.channels);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(id(), 0, info.external, GL_FLOAT, static_cast<GLsizei>(raw.size() * sizeof(float)),
                    raw.data());
  return upright(raw, info.channels, width_px(), height_px(), first, channels);
}

Image Texture::read_part(int x, int y, int width_px, int height_px, int first, int channels) const {
  const FormatInfo info = info_of(format());
  assert(first + channels <= info.channels && x >= 0 && x + width_px <= storage_.width_px && y >= 0 &&
         y + height_px <= storage_.height_px);
  std::vector<float> raw(static_cast<size_t>(width_px) * height_px * info.channels);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureSubImage(id(), 0, x, storage_.height_px - y - height_px, 0, width_px, height_px, 1,
                       info.external, GL_FLOAT, static_cast<GLsizei>(raw.size() * sizeof(float)), raw.data());
  return upright(raw, info.channels, width_px, height_px, first, channels);
}

Picture Texture::read_picture() const {
  assert(format() == TextureFormat::rgba8);
  std::vector<uint8_t> raw(static_cast<size_t>(width_px()) * height_px() * 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(raw.size()), raw.data());
  Picture picture(width_px(), height_px(), 3);
  for (int y = 0; y < height_px(); ++y) {
    const uint8_t* from = &raw[static_cast<size_t>(height_px() - 1 - y) * width_px() * 4];
    uint8_t* to = &picture.at(0, y);
    for (int x = 0; x < width_px(); ++x) std::memcpy(to + x * 3, from + x * 4, 3);
  }
  return picture;
}

}  // namespace inkbench
