// SPDX-License-Identifier: MIT
#include "studies/sweep/kept_picture.h"

#include <cstring>
#include <stdexcept>
#include <utility>

#include "pipeline/base/key.h"
#include "pipeline/image/fast_packing.h"

namespace inkbench {
namespace {

constexpr size_t kSumChars = 32;

std::string sum_of(std::string_view body) {
  return KeyBuilder().add(body).key().text();
}

class Writer {
 public:
  void number(int value) { body_.append(reinterpret_cast<const char*>(&value), sizeof value); }
  void bytes(std::string_view text) {
    number(static_cast<int>(text.size()));
    body_ += text;
  }
  void picture(const Picture& picture) {
    number(picture.width_px);
    number(picture.height_px);
    if (picture.width_px > 0) bytes(fast_packed(picture.samples));
  }
  std::string finished() const { return sum_of(body_) + body_; }

 private:
  std::string body_;
};

/// Errors (out_of_range): the body ends too early, or is none.
class Reader {
 public:
  explicit Reader(std::string_view body) : rest_(body) {}

  int number() {
    int value = 0;
    std::memcpy(&value, taken(sizeof value).data(), sizeof value);
    return value;
  }
  std::string_view bytes() { return taken(static_cast<size_t>(number())); }
  Picture picture() {
    Picture picture;
    picture.width_px = number();
    picture.height_px = number();
    if (picture.width_px == 0) return {};
    picture.channels = 3;
    auto samples = unpacked(bytes(), static_cast<size_t>(picture.width_px) * picture.height_px * 3);
    if (!samples) throw std::out_of_range("packed picture");
    picture.samples = std::move(*samples);
    return picture;
  }
  bool at_end() const { return rest_.empty(); }

 private:
  std::string_view taken(size_t count) {
    if (count > rest_.size()) throw std::out_of_range("bytes");
    const std::string_view part = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return part;
  }

  std::string_view rest_;
};

}  // namespace

std::string bytes_of(const KeptPicture& kept) {
  Writer writer;
  const TilePlace& place = kept.tile.place;
  for (const int value : {place.cell_width_px, place.cell_height_px, place.drawn_width_px,
                          place.drawn_height_px, place.first_px, place.end_px, kept.tile.drawn_first_px})
    writer.number(value);
  for (const Picture* picture : {&kept.tile.drawn, &kept.tile.left, &kept.tile.right})
    writer.picture(*picture);
  for (const Thumbnail& thumbnail : kept.thumbnails) {
    writer.number(thumbnail.side_px);
    writer.bytes(thumbnail.webp);
  }
  return writer.finished();
}

std::optional<KeptPicture> kept_picture(std::string_view bytes) {
  if (bytes.size() < kSumChars || bytes.substr(0, kSumChars) != sum_of(bytes.substr(kSumChars))) return {};
  try {
    Reader reader(bytes.substr(kSumChars));
    KeptPicture kept;
    TilePlace& place = kept.tile.place;
    for (int* value : {&place.cell_width_px, &place.cell_height_px, &place.drawn_width_px,
                       &place.drawn_height_px, &place.first_px, &place.end_px, &kept.tile.drawn_first_px})
      *value = reader.number();
    for (Picture* picture : {&kept.tile.drawn, &kept.tile.left, &kept.tile.right})
      *picture = reader.picture();
    while (!reader.at_end()) {
      const int side_px = reader.number();
      kept.thumbnails.push_back({side_px, std::string(reader.bytes())});
    }
    return kept;
  } catch (const std::out_of_range&) {
    return {};
  }
}

}  // namespace inkbench
