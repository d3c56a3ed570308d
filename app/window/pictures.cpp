// SPDX-License-Identifier: MIT
#include "app/window/pictures.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include "pipeline/gl/gl_context.h"
#include "pipeline/image/finite_range.h"

namespace inkbench {
namespace {

/// Pictures of more pixels may take seconds each.
constexpr int64_t kLargePixels = 2 << 20;
constexpr std::chrono::milliseconds kMoment(100);

bool is_large(const Settings& settings) {
  const int64_t times = settings.image.supersample;
  return times * times * settings.image.width * settings.image.height > kLargePixels;
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
  return pinned ? pinned_[buffer] : now_[buffer];
}

bool Pictures::has_late() const {
  // The lines tell when they are there.
  return std::any_of(now_.begin(), now_.end(), [](const auto& entry) {
    return entry.second.is_late && entry.first != BufferName::reference;
  });
}

ShownRange Pictures::fitted_range(const Frame& frame, BufferName buffer) {
  return ranges_[buffer].get(frame.key(buffer), [&] { return range_of(frame.raw(buffer)); });
}

void Pictures::refresh_reference(const Frame& frame) {
  reference_.refresh(frame);
  ShownPicture& shown = now_[BufferName::reference];
  if (reference_.now() != nullptr)
    shown = {&reference_.picture(), reference_.now()->key, std::nullopt, false};
  shown.is_late = reference_.is_behind();
}

void Pictures::refresh_one(const Frame& frame, BufferName buffer) {
  if (buffer == BufferName::reference) return refresh_reference(frame);
  const PictureChoice& choice = choices_[buffer];
  std::optional<ShownRange> range;
  if (choice.kind == PictureChoice::Kind::fitted) range = fitted_range(frame, buffer);
  if (choice.kind == PictureChoice::Kind::fixed) range = choice.fixed;
  const PictureTexture picture = frame.picture_texture(buffer, range);
  now_[buffer] = {picture.texture, picture.key, range, false};
}

/// OpenGL may put work off until something waits for it, so that only finished pictures tell their time.
void Pictures::refresh_large(const Frame& frame, std::span<const BufferName> buffers) {
  const auto start = std::chrono::steady_clock::now();
  bool is_over = false;
  for (const BufferName buffer : buffers) {
    ShownPicture& shown = now_[buffer];
    if (is_over) {
      shown.is_late = true;
      continue;
    }
    const Key before = shown.key;
    refresh_one(frame, buffer);
    if (shown.key == before) continue;
    glFinish();
    is_over = std::chrono::steady_clock::now() - start > kMoment;
  }
}

void Pictures::refresh(const Frame& frame, std::vector<BufferName> wanted, BufferName first) {
  for (auto& [buffer, shown] : now_) shown.is_late = false;  // also of those that are no longer looked at
  if (is_large(frame.settings())) {
    std::stable_partition(wanted.begin(), wanted.end(), [&](BufferName buffer) { return buffer == first; });
    return refresh_large(frame, wanted);
  }
  for (const BufferName buffer : wanted) refresh_one(frame, buffer);
}

void Pictures::pin(const Frame& frame) {
  reference_.finish(frame);
  for (const BufferName buffer : all_buffers()) {
    refresh_one(frame, buffer);
    const ShownPicture& now = now_[buffer];
    pinned_textures_[buffer] = copy_of(*now.texture);
    pinned_[buffer] = now;
    pinned_[buffer].texture = &pinned_textures_[buffer];
    pinned_[buffer].key = KeyBuilder().add("pinned").add(now.key).key();
  }
  pinned_maps_ = keep_maps(frame);
  pinned_view_ = {
      {std::make_shared<Image>(frame.raw(BufferName::lines)), reference_.now()->lines},
      KeyBuilder().add(shown(BufferName::lines, true).key).add(shown(BufferName::reference, true).key).key()};
  pinned_settings_ = frame.settings();
  throw_gl_errors("pinning the pictures");
}

void Pictures::unpin() {
  pinned_ = {};
  pinned_textures_.clear();
  pinned_view_ = {};
  pinned_settings_.reset();
  pinned_maps_.reset();
}

}  // namespace inkbench
