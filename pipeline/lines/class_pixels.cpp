// SPDX-License-Identifier: MIT
#include "pipeline/lines/class_pixels.h"

#include <algorithm>
#include <bit>
#include <map>

#include "pipeline/lines/drawing.h"

namespace inkbench {
namespace {

constexpr unsigned kCombinations = 1U << kLineClasses.size();

ClassBits bit_of(LineClass line_class) {
  return static_cast<ClassBits>(1U << static_cast<size_t>(line_class));
}

LineMap map_of(const Picture& pixels, ClassBits wanted) {
  LineMap map(pixels.width_px, pixels.height_px);
  for (int y = 0; y < map.height_px(); ++y) {
    for (int x = 0; x < map.width_px(); ++x) {
      if ((pixels.at(x, y) & wanted) != 0) map.set(x, y);
    }
  }
  return map;
}

std::map<std::array<uint8_t, 3>, ClassBits> make_colours() {
  std::map<std::array<uint8_t, 3>, ClassBits> colours;
  for (unsigned classes = 0; classes < kCombinations; ++classes)
    colours.emplace(colour_of_classes(static_cast<ClassBits>(classes)), static_cast<ClassBits>(classes));
  return colours;
}

}  // namespace

Picture class_pixels(const ReferenceLines& lines) {
  Picture pixels(lines.width_px, lines.height_px, 1, 0);
  for (const LineClass line_class : kLineClasses) {
    for_each_pixel(class_map(lines, line_class),
                   [&](int x, int y) { pixels.at(x, y) |= bit_of(line_class); });
  }
  return pixels;
}

std::array<uint8_t, 3> colour_of_classes(ClassBits classes) {
  if (classes == 0) return {255, 255, 255};
  const auto first = static_cast<size_t>(std::countr_zero(classes));
  std::array<uint8_t, 3> colour = colour_of(kLineClasses[first]);
  for (size_t j = first + 1; j < kLineClasses.size(); ++j) {
    if ((classes & bit_of(kLineClasses[j])) != 0)
      colour[(j - 1) / 2] ^= static_cast<uint8_t>(1U << (j - 1) % 2);
  }
  return colour;
}

std::optional<ClassBits> classes_of_colour(const std::array<uint8_t, 3>& colour) {
  static const std::map<std::array<uint8_t, 3>, ClassBits> kColours = make_colours();
  const auto found = kColours.find(colour);
  return found == kColours.end() ? std::nullopt : std::optional(found->second);
}

Picture coloured_classes(const Picture& pixels) {
  Picture picture(pixels.width_px, pixels.height_px, 3);
  for (size_t i = 0; i < pixels.samples.size(); ++i) {
    const std::array<uint8_t, 3> colour = colour_of_classes(pixels.samples[i]);
    std::copy(colour.begin(), colour.end(), &picture.samples[3 * i]);
  }
  return picture;
}

Image numbered_classes(const Picture& pixels) {
  Image image(pixels.width_px, pixels.height_px, 1);
  std::copy(pixels.samples.begin(), pixels.samples.end(), image.samples.begin());
  return image;
}

std::optional<ClassBits> classes_of_number(float number) {
  const bool is_one = number >= 0.0F && number < static_cast<float>(kCombinations);  // false for NaN too
  const auto classes = is_one ? static_cast<ClassBits>(number) : ClassBits{0};
  return is_one && static_cast<float>(classes) == number ? std::optional(classes) : std::nullopt;
}

std::string class_bit_names() {
  std::string names;
  for (const std::string_view name : kLineClassNames) names += (names.empty() ? "" : " ") + std::string(name);
  return names;
}

LineMap class_map(const Picture& pixels, LineClass line_class) {
  return map_of(pixels, bit_of(line_class));
}

LineMap tier_map(const Picture& pixels, const JudgeParams& judge, int wanted_tier) {
  ClassBits wanted = 0;
  for (const LineClass line_class : kLineClasses) {
    if (tier(judge, line_class) == wanted_tier) wanted |= bit_of(line_class);
  }
  return map_of(pixels, wanted);
}

}  // namespace inkbench
