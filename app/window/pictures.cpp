#include "app/window/pictures.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

#include "pipeline/gl/context.h"
#include "studies/reference/drawing.h"

namespace inkbench {
namespace {

/// Lines that took longer than this are not found anew while a slider is held.
constexpr double kLongMs = 25.0;

/// Pictures of more pixels may take seconds each.
constexpr int64_t kLargePixels = 2 << 20;
constexpr std::chrono::milliseconds kMoment(100);

bool is_large(const Settings& settings) {
  return int64_t{settings.image.width} * settings.image.height > kLargePixels;
}

size_t place_of(BufferName buffer) {
  return static_cast<size_t>(buffer);
}

Texture upload_picture(const Picture& picture) {
  Image image(picture.width_px, picture.height_px, 4, 1.0F);
  for (int y = 0; y < picture.height_px; ++y) {
    for (int x = 0; x < picture.width_px; ++x) {
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = static_cast<float>(picture.at(x, y, c)) / 255.0F;
    }
  }
  Texture texture("reference picture", TextureFormat::rgba8, picture.width_px, picture.height_px);
  texture.upload(image);
  return texture;
}

Texture copy_of(const Texture& from) {
  Texture copy("pinned picture", from.format(), from.width_px(), from.height_px());
  glCopyImageSubData(from.id(), GL_TEXTURE_2D, 0, 0, 0, 0, copy.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                     from.width_px(), from.height_px(), 1);
  return copy;
}

ShownRange range_of(const Image& image) {
  float low = std::numeric_limits<float>::max();
  float high = std::numeric_limits<float>::lowest();
  for (const float value : image.samples) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (!(low < high)) return {std::min(low, 0.0F), std::max(high, 1.0F)};
  return {low, high};
}

}  // namespace

void toggle_fit(PictureChoice& choice) {
  const bool fitted = choice.kind == PictureChoice::Kind::fitted;
  choice.kind = fitted ? PictureChoice::Kind::gains : PictureChoice::Kind::fitted;
}

Pictures::Pictures() : reference_ms_(std::numeric_limits<double>::infinity()) {}

const ShownPicture& Pictures::shown(BufferName buffer, bool pinned) const {
  return pinned ? pinned_[place_of(buffer)] : now_[place_of(buffer)];
}

bool Pictures::has_late() const {
  return std::any_of(now_.begin(), now_.end(), [](const ShownPicture& picture) { return picture.is_late; });
}

ShownRange Pictures::fitted_range(const Settings& settings, BufferName buffer) {
  return ranges_[place_of(buffer)].get(pipeline_.buffer_key(settings, buffer),
                                       [&] { return range_of(pipeline_.raw(settings, buffer)); });
}

void Pictures::refresh_reference(const Settings& settings, bool hurry) {
  ShownPicture& shown = now_[place_of(BufferName::reference)];
  const Key key = pipeline_.buffer_key(settings, BufferName::reference);
  if (shown.texture != nullptr && shown.key == key) {
    shown.is_late = false;
    return;
  }
  if (hurry && reference_ms_ > kLongMs) {
    shown.is_late = true;
    return;
  }
  const auto start = std::chrono::steady_clock::now();
  const Picture picture = draw_reference(source_.reference(settings));
  reference_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  const Texture& texture = reference_.get(key, [&] { return upload_picture(picture); });
  shown = {&texture, key, std::nullopt, false};
}

void Pictures::refresh_one(const Settings& settings, BufferName buffer, bool hurry) {
  if (buffer == BufferName::reference) {
    refresh_reference(settings, hurry);
    return;
  }
  const PictureChoice& choice = choices_[place_of(buffer)];
  std::optional<ShownRange> range;
  if (choice.kind == PictureChoice::Kind::fitted) range = fitted_range(settings, buffer);
  if (choice.kind == PictureChoice::Kind::fixed) range = choice.fixed;
  const PictureTexture picture = pipeline_.picture_texture(settings, buffer, range);
  now_[place_of(buffer)] = {picture.texture, picture.key, range, false};
}

/// OpenGL may put work off until something waits for it, so that only finished pictures tell their time.
void Pictures::refresh_large(const Settings& settings, std::span<const BufferName> buffers, bool hurry) {
  const auto start = std::chrono::steady_clock::now();
  bool is_over = false;
  for (const BufferName buffer : buffers) {
    ShownPicture& shown = now_[place_of(buffer)];
    if (is_over) {
      shown.is_late = true;
      continue;
    }
    const Key before = shown.key;
    refresh_one(settings, buffer, hurry);
    if (shown.key == before) continue;
    glFinish();
    is_over = std::chrono::steady_clock::now() - start > kMoment;
  }
}

void Pictures::refresh(const Settings& settings, const std::array<bool, kBufferCount>& wanted, bool hurry,
                       BufferName first) {
  std::vector<BufferName> buffers;
  for (size_t i = 0; i < kBufferCount; ++i) {
    now_[i].is_late = false;  // also of those that are no longer looked at: nothing waits for them
    if (wanted[i]) buffers.push_back(static_cast<BufferName>(i));
  }
  if (is_large(settings)) {
    std::stable_partition(buffers.begin(), buffers.end(), [&](BufferName buffer) { return buffer == first; });
    return refresh_large(settings, buffers, hurry);
  }
  for (const BufferName buffer : buffers) refresh_one(settings, buffer, hurry);
}

void Pictures::pin(const Settings& settings) {
  for (size_t i = 0; i < kBufferCount; ++i) {
    refresh_one(settings, static_cast<BufferName>(i), false);
    pinned_textures_[i] = copy_of(*now_[i].texture);
    pinned_[i] = now_[i];
    pinned_[i].texture = &pinned_textures_[i];
    pinned_[i].key = KeyBuilder().add("pinned").add(now_[i].key).key();
  }
  pinned_settings_ = settings;
  throw_gl_errors("pinning the pictures");
}

void Pictures::unpin() {
  pinned_ = {};
  for (Texture& texture : pinned_textures_) texture = Texture();
  pinned_settings_.reset();
}

}  // namespace inkbench
