#include "app/window/pictures.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include "pipeline/gl/context.h"
#include "pipeline/image/finite_range.h"

namespace inkbench {
namespace {

/// Pictures of more pixels may take seconds each.
constexpr int64_t kLargePixels = 2 << 20;
constexpr std::chrono::milliseconds kMoment(100);

bool is_large(const Settings& settings) {
  return int64_t{settings.image.width} * settings.image.height > kLargePixels;
}

size_t place_of(BufferName buffer) {
  return static_cast<size_t>(buffer);
}

Texture copy_of(const Texture& from) {
  Texture copy("pinned picture", from.format(), from.width_px(), from.height_px());
  glCopyImageSubData(from.id(), GL_TEXTURE_2D, 0, 0, 0, 0, copy.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                     from.width_px(), from.height_px(), 1);
  return copy;
}

ShownRange range_of(const Image& image) {
  const std::optional<FiniteRange> range = finite_range(image);
  if (!range) return {0.0F, 1.0F};
  if (!(range->low < range->high)) return {std::min(range->low, 0.0F), std::max(range->high, 1.0F)};
  return {range->low, range->high};
}

}  // namespace

void toggle_fit(PictureChoice& choice) {
  const bool fitted = choice.kind == PictureChoice::Kind::fitted;
  choice.kind = fitted ? PictureChoice::Kind::gains : PictureChoice::Kind::fitted;
}

const ShownPicture& Pictures::shown(BufferName buffer, bool pinned) const {
  return pinned ? pinned_[place_of(buffer)] : now_[place_of(buffer)];
}

bool Pictures::has_late() const {
  for (size_t i = 0; i < kBufferCount; ++i) {
    // The lines tell when they are there.
    if (now_[i].is_late && i != place_of(BufferName::reference)) return true;
  }
  return false;
}

ShownRange Pictures::fitted_range(const Settings& settings, BufferName buffer) {
  return ranges_[place_of(buffer)].get(pipeline_.buffer_key(settings, buffer),
                                       [&] { return range_of(pipeline_.raw(settings, buffer)); });
}

void Pictures::refresh_reference(const Settings& settings) {
  reference_.refresh(settings);
  ShownPicture& shown = now_[place_of(BufferName::reference)];
  if (reference_.now() != nullptr)
    shown = {&reference_.picture(), reference_.now()->key, std::nullopt, false};
  shown.is_late = reference_.is_behind();
}

void Pictures::refresh_one(const Settings& settings, BufferName buffer) {
  if (buffer == BufferName::reference) return refresh_reference(settings);
  const PictureChoice& choice = choices_[place_of(buffer)];
  std::optional<ShownRange> range;
  if (choice.kind == PictureChoice::Kind::fitted) range = fitted_range(settings, buffer);
  if (choice.kind == PictureChoice::Kind::fixed) range = choice.fixed;
  const PictureTexture picture = pipeline_.picture_texture(settings, buffer, range);
  now_[place_of(buffer)] = {picture.texture, picture.key, range, false};
}

/// OpenGL may put work off until something waits for it, so that only finished pictures tell their time.
void Pictures::refresh_large(const Settings& settings, std::span<const BufferName> buffers) {
  const auto start = std::chrono::steady_clock::now();
  bool is_over = false;
  for (const BufferName buffer : buffers) {
    ShownPicture& shown = now_[place_of(buffer)];
    if (is_over) {
      shown.is_late = true;
      continue;
    }
    const Key before = shown.key;
    refresh_one(settings, buffer);
    if (shown.key == before) continue;
    glFinish();
    is_over = std::chrono::steady_clock::now() - start > kMoment;
  }
}

void Pictures::refresh(const Settings& settings, const std::array<bool, kBufferCount>& wanted,
                       BufferName first) {
  std::vector<BufferName> buffers;
  for (size_t i = 0; i < kBufferCount; ++i) {
    now_[i].is_late = false;  // also of those that are no longer looked at: nothing waits for them
    if (wanted[i]) buffers.push_back(static_cast<BufferName>(i));
  }
  if (is_large(settings)) {
    std::stable_partition(buffers.begin(), buffers.end(), [&](BufferName buffer) { return buffer == first; });
    return refresh_large(settings, buffers);
  }
  for (const BufferName buffer : buffers) refresh_one(settings, buffer);
}

void Pictures::pin(const Settings& settings) {
  reference_.finish(settings);
  for (size_t i = 0; i < kBufferCount; ++i) {
    refresh_one(settings, static_cast<BufferName>(i));
    pinned_textures_[i] = copy_of(*now_[i].texture);
    pinned_[i] = now_[i];
    pinned_[i].texture = &pinned_textures_[i];
    pinned_[i].key = KeyBuilder().add("pinned").add(now_[i].key).key();
  }
  pinned_view_ = {std::make_shared<Image>(pipeline_.raw(settings, BufferName::combined_edges)),
                  reference_.now()->lines};
  pinned_settings_ = settings;
  throw_gl_errors("pinning the pictures");
}

void Pictures::unpin() {
  pinned_ = {};
  for (Texture& texture : pinned_textures_) texture = Texture();
  pinned_view_ = {};
  pinned_settings_.reset();
}

}  // namespace inkbench
