#include "pipeline/gl/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstring>

#include "pipeline/base/error.h"

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
    case TextureFormat::r8:
      return {GL_R8, GL_RED, GL_FLOAT, 1};
    case TextureFormat::rg8:
      return {GL_RG8, GL_RG, GL_FLOAT, 2};
    case TextureFormat::rgba8:
      return {GL_RGBA8, GL_RGBA, GL_FLOAT, 4};
    case TextureFormat::depth32f:
      return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 1};
  }
  return {};
}

/// Storage that a finished pass gave back. A sweep makes the same textures thousands of times, and fresh
/// pages cost the software renderer as much as a pass.
struct Idle {
  GLuint id;
  TextureFormat format;
  int width_px, height_px;
};
constexpr size_t kMaxIdle = 12;

std::vector<Idle>& idle_textures() {
  static thread_local std::vector<Idle> idle;
  return idle;
}

GLuint take_idle(TextureFormat format, int width_px, int height_px) {
  std::vector<Idle>& idle = idle_textures();
  const auto match = std::find_if(idle.begin(), idle.end(), [&](const Idle& entry) {
    return entry.format == format && entry.width_px == width_px && entry.height_px == height_px;
  });
  if (match == idle.end()) return 0;
  const GLuint id = match->id;
  idle.erase(match);
  return id;
}

void give_back(const Idle& texture) {
  std::vector<Idle>& idle = idle_textures();
  if (idle.size() >= kMaxIdle) {
    glDeleteTextures(1, &idle.front().id);
    idle.erase(idle.begin());
  }
  idle.push_back(texture);
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

Texture::Texture(const std::string& label, TextureFormat format, int width_px, int height_px)
    : format_(format), width_px_(width_px), height_px_(height_px) {
  GLint max_side = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &max_side);
  if (width_px < 1 || height_px < 1 || width_px > max_side || height_px > max_side) {
    throw input_error("image size", fmt::format("{} x {} px cannot be drawn", width_px, height_px),
                      fmt::format("this renderer's sides are from 1 to {} px", max_side));
  }
  id_ = take_idle(format, width_px, height_px);
  if (id_ == 0) {
    glCreateTextures(GL_TEXTURE_2D, 1, &id_);
    glTextureStorage2D(id_, 1, info_of(format).internal, width_px, height_px);
    glTextureParameteri(id_, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(id_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTextureParameteri(id_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  label_object(GL_TEXTURE, id_, label);
}

Texture::Texture(Texture&& other) noexcept
    : id_(std::exchange(other.id_, 0)),
      format_(other.format_),
      width_px_(other.width_px_),
      height_px_(other.height_px_) {}

Texture& Texture::operator=(Texture&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(format_, other.format_);
  std::swap(width_px_, other.width_px_);
  std::swap(height_px_, other.height_px_);
  return *this;
}

Texture::~Texture() {
  if (id_ != 0) give_back({id_, format_, width_px_, height_px_});
}

void Texture::upload(const Image& image) {
  const FormatInfo info = info_of(format_);
  assert(image.width_px == width_px_ && image.height_px == height_px_ && image.channels == info.channels);
  Image flipped = image;
  const size_t row = static_cast<size_t>(width_px_) * info.channels;
  for (int y = 0; y < height_px_; ++y) {
    std::copy_n(&image.samples[y * row], row, &flipped.samples[(height_px_ - 1 - y) * row]);
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(id_, 0, 0, 0, width_px_, height_px_, info.external, GL_FLOAT, flipped.samples.data());
}

Image Texture::read(int first, int channels) const {
  const FormatInfo info = info_of(format_);
  assert(first + channels <= info.channels);
  std::vector<float> raw(static_cast<size_t>(width_px_) * height_px_ * info.channels);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(id_, 0, info.external, GL_FLOAT, static_cast<GLsizei>(raw.size() * sizeof(float)),
                    raw.data());
  return upright(raw, info.channels, width_px_, height_px_, first, channels);
}

Image Texture::read_part(int x, int y, int width_px, int height_px, int first, int channels) const {
  const FormatInfo info = info_of(format_);
  assert(first + channels <= info.channels && x >= 0 && x + width_px <= width_px_ && y >= 0 &&
         y + height_px <= height_px_);
  std::vector<float> raw(static_cast<size_t>(width_px) * height_px * info.channels);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureSubImage(id_, 0, x, height_px_ - y - height_px, 0, width_px, height_px, 1, info.external,
                       GL_FLOAT, static_cast<GLsizei>(raw.size() * sizeof(float)), raw.data());
  return upright(raw, info.channels, width_px, height_px, first, channels);
}

Picture Texture::read_picture() const {
  assert(format_ == TextureFormat::rgba8);
  std::vector<uint8_t> raw(static_cast<size_t>(width_px_) * height_px_ * 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(id_, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(raw.size()), raw.data());
  Picture picture(width_px_, height_px_, 3);
  for (int y = 0; y < height_px_; ++y) {
    const uint8_t* from = &raw[static_cast<size_t>(height_px_ - 1 - y) * width_px_ * 4];
    uint8_t* to = &picture.at(0, y);
    for (int x = 0; x < width_px_; ++x) std::memcpy(to + x * 3, from + x * 4, 3);
  }
  return picture;
}

void clear_texture_pool() {
  for (const Idle& texture : idle_textures()) glDeleteTextures(1, &texture.id);
  idle_textures().clear();
}

}  // namespace inkbench
