// SPDX-License-Identifier: MIT
// Textures that hold one image each: framebuffers between passes, and uploaded data. Row 0 of the texture is
// the image's bottom row (OpenGL's way); reading and uploading turn it over, so that images have row 0 on
// top.
#pragma once

#include <string>

#include "pipeline/gl/object.h"
#include "pipeline/image/image.h"

namespace inkbench {

enum class TextureFormat { r32f, rg32f, rgba32f, rgba16f, r8, rg8, rgba8, rg32ui, depth32f };

/// OpenGL's word for the format.
GLenum internal_format(TextureFormat format);

class TexturePool;

/// What a texture takes from its context's pool and gives back to it.
struct TextureStorage {
  GLuint id = 0;
  TextureFormat format = TextureFormat::r32f;
  int width_px = 0, height_px = 0;
  TexturePool* pool = nullptr;
  int user = 0;  ///< Whom the pool keeps it for.
};

class Texture {
 public:
  Texture() = default;
  /// From the pool of this thread's context. Errors (input): larger than the driver allows.
  Texture(const std::string& label, TextureFormat format, int width_px, int height_px);
  Texture(Texture&& other) noexcept;
  Texture& operator=(Texture&& other) noexcept;
  ~Texture();

  GLuint id() const { return storage_.id; }
  TextureFormat format() const { return storage_.format; }
  int width_px() const { return storage_.width_px; }
  int height_px() const { return storage_.height_px; }

  /// Fills the texture; the image has its size and its number of channels.
  void upload(const Image& image);
  /// `channels` channels from `first` on, as floats: 8-bit values come back as n / 255. Not of whole numbers,
  /// which floats cannot hold (rg32ui).
  Image read(int first, int channels) const;
  /// The same of a rectangle inside the texture, from its top left pixel; row 0 on top.
  Image read_part(int x, int y, int width_px, int height_px, int first, int channels) const;
  /// The red, green and blue of an rgba8 texture.
  Picture read_picture() const;

 private:
  TextureStorage storage_;
};

}  // namespace inkbench
