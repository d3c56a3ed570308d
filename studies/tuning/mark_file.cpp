// SPDX-License-Identifier: MIT
#include "studies/tuning/mark_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pipeline/base/error.h"
#include "pipeline/image/image_file.h"

namespace inkbench {
namespace {

constexpr int kFull = 255, kDark = 128;
constexpr int kLeastAlpha = 64, kLeastDark = 96, kLeastFull = 192;

/// How strong a channel is above all others; 0 where it does not stand out.
int strength_of(int channel, int other, int another) {
  return channel >= kLeastDark && 3 * std::max(other, another) <= channel ? channel : 0;
}

void check_size(const std::filesystem::path& path, const Picture& picture, int width_px, int height_px) {
  if (picture.width_px == width_px && picture.height_px == height_px) return;
  throw input_error(path.string(),
                    fmt::format("is {} x {} px, and its view is {} x {} px", picture.width_px,
                                picture.height_px, width_px, height_px),
                    "paint marks over a picture of the view's own size");
}

void paint(Picture& picture, int x, int y, const std::array<int, 3>& colour) {
  for (int c = 0; c < 3; ++c) picture.at(x, y, c) = static_cast<uint8_t>(colour[c]);
  picture.at(x, y, 3) = kFull;
}

}  // namespace

MarkFile read_marks(const std::filesystem::path& path, int width_px, int height_px) {
  const Picture picture = read_picture(path, 4);
  check_size(path, picture, width_px, height_px);
  const LineMap none(width_px, height_px);
  MarkFile file{{none, none, none}, false};
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; ++x) {
      if (picture.at(x, y, 3) < kLeastAlpha) continue;
      const int red = picture.at(x, y, 0), green = picture.at(x, y, 1), blue = picture.at(x, y, 2);
      const int wanted = strength_of(red, green, blue), unwanted = strength_of(blue, red, green);
      if (wanted > 0) file.marks.wanted.set(x, y);
      if (unwanted > 0) file.marks.unwanted.set(x, y);
      const int strength = std::max(wanted, unwanted);
      if (strength > 0 && strength < kLeastFull) file.marks.drawn.set(x, y);
    }
  }
  if (file.marks.empty())
    throw input_error(path.string(), "has no marks: no pixel is red or blue",
                      "paint what is wanted in red (255, 0, 0) and what is not in blue (0, 0, 255)");
  file.keeps_drawing = file.marks.drawn.count() > 0;
  return file;
}

void write_marks(const std::filesystem::path& path, const MarkMaps& marks) {
  Picture picture(marks.wanted.width_px(), marks.wanted.height_px(), 4);
  const auto strength = [&](int x, int y) { return marks.drawn.at(x, y) ? kDark : kFull; };
  for_each_pixel(marks.drawn, [&](int x, int y) { paint(picture, x, y, {0, 0, 0}); });
  for_each_pixel(marks.wanted, [&](int x, int y) { paint(picture, x, y, {strength(x, y), 0, 0}); });
  for_each_pixel(marks.unwanted, [&](int x, int y) { paint(picture, x, y, {0, 0, strength(x, y)}); });
  write_png(path, picture, {});
}

}  // namespace inkbench
