// SPDX-License-Identifier: MIT
#include "pipeline/strength_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/image/bsds_file.h"
#include "pipeline/image/image_content.h"
#include "pipeline/image/image_file.h"
#include "pipeline/line_file.h"
#include "pipeline/lines/class_pixels.h"

namespace inkbench {
namespace {

/// How far beyond 0 and 1 rounding may carry a strength.
constexpr float kOvershoot = 1e-3F;

bool is_mat(const fs::path& path) {
  return lower_case(path.extension().string()) == ".mat";
}

[[noreturn]] void throw_bad_sample(const fs::path& path, const Image& image, size_t sample) {
  const size_t pixel = sample / image.channels, width = static_cast<size_t>(image.width_px);
  const float value = image.samples[sample];
  const std::string place = fmt::format("pixel {}, {}", pixel % width, pixel / width);
  if (std::isnan(value))
    throw input_error(path.string(), place + " is not a number (NaN)", "strengths are 0 to 1");
  throw input_error(path.string(), fmt::format("{} has the strength {}", place, shortest(value)),
                    "strengths are 0 to 1: divide by the largest, or take s/(1 + s)");
}

/// Grey and, where there is one, alpha, all of 0 to 1.
Image sound_grey(const fs::path& path) {
  Image image = read_grey_and_alpha(path);
  for (size_t i = 0; i < image.samples.size(); ++i) {
    float& sample = image.samples[i];
    if (!(sample >= -kOvershoot && sample <= 1.0F + kOvershoot)) throw_bad_sample(path, image, i);
    sample = std::clamp(sample, 0.0F, 1.0F);
  }
  return image;
}

Image strengths_of_grey(const Image& image, bool inverted) {
  const int channels = image.channels;
  Image strengths(image.width_px, image.height_px, 1);
  for (size_t i = 0; i < strengths.samples.size(); ++i) {
    const float light = image.samples[i * channels];
    const float alpha = channels == 2 ? image.samples[i * channels + 1] : 1.0F;
    strengths.samples[i] = inverted ? std::max(0.0F, alpha - light) : light;
  }
  return strengths;
}

int64_t ink_256ths(const Image& strengths) {
  double sum = 0;
  for (const float strength : strengths.samples) sum += static_cast<double>(strength);
  return std::llround(256 * sum);
}

/// Raw values of `edge_strength`.
Image sound_unbounded(const fs::path& path) {
  if (image_format(read_file(path, kMostImageBytes)) != "openexr")
    throw input_error(path.string(), "is a picture of edge_strength, in which strong lines end at white",
                      "write the values: `inkbench render --buffers edge_strength --format exr`");
  Image image = read_image(path);
  for (size_t i = 0; i < image.samples.size(); ++i) {
    if (!(image.samples[i] >= 0)) throw_bad_sample(path, image, i);
  }
  return image;
}

Image strengths_of_lines(const LineMap& lines) {
  Image strengths(lines.width_px(), lines.height_px(), 1);
  for_each_pixel(lines, [&](int x, int y) { strengths.at(x, y) = 1.0F; });
  return strengths;
}

LineMap lines_of(const Picture& picture) {
  LineMap map(picture.width_px, picture.height_px);
  for (int y = 0; y < picture.height_px; ++y) {
    for (int x = 0; x < picture.width_px; ++x) map.set(x, y, picture.at(x, y) != 0);
  }
  return map;
}

/// Whether the file reads as `read_line_file` decides, without a strength.
bool is_lines_alone(const SurveyedFile& file) {
  return file.buffer && (file.buffer->info().as_lines == ReadAsLines::above_0 ||
                         file.buffer->info().as_lines == ReadAsLines::classes);
}

}  // namespace

SurveyedFile survey_strengths(const fs::path& path) {
  SurveyedFile file{.path = path};
  file.buffer = exported_buffer(path);
  file.says_itself = file.buffer.has_value();
  const Image strengths = file.buffer ? read_strengths(file, false) : sound_grey(path);
  file.width_px = strengths.width_px;
  file.height_px = strengths.height_px;
  if (file.says_itself) return file;
  file.light = ink_256ths(strengths_of_grey(strengths, false));
  file.dark = ink_256ths(strengths_of_grey(strengths, true));
  file.clear = int64_t{256} * file.width_px * file.height_px - file.light - file.dark;
  return file;
}

SurveyedFile survey_drawings(const fs::path& path) {
  if (!is_mat(path)) return survey_strengths(path);
  const std::vector<Picture> drawings = read_bsds_boundaries(path);
  return {.path = path,
          .width_px = drawings.front().width_px,
          .height_px = drawings.front().height_px,
          .drawings = static_cast<int>(drawings.size()),
          .says_itself = true};
}

Image read_strengths(const SurveyedFile& file, bool inverted) {
  if (file.buffer == BufferName::edge_strength) return bounded_strengths(sound_unbounded(file.path));
  const bool has_lines = !file.buffer || file.buffer->info().as_lines == ReadAsLines::at_cut;
  if (has_lines) return strengths_of_grey(sound_grey(file.path), inverted);
  return strengths_of_lines(read_line_file(file.path).lines);
}

std::vector<TieredLines> read_drawings(const SurveyedFile& file, bool inverted) {
  std::vector<TieredLines> drawings;
  if (is_mat(file.path)) {
    for (const Picture& picture : read_bsds_boundaries(file.path))
      drawings.push_back({lines_of(picture), {}});
  } else if (is_lines_alone(file)) {
    LineFile lines = read_line_file(file.path);
    drawings.push_back({std::move(lines.lines), {}});
    if (lines.classes) drawings.back().allowed = tier_map(lines.classes->pixels, lines.classes->judge, 2);
  } else {
    drawings.push_back({line_map_from(read_strengths(file, inverted)), {}});
  }
  return drawings;
}

Image bounded_strengths(Image strengths) {
  for (float& strength : strengths.samples)
    strength = static_cast<float>(1.0 - 1.0 / (1.0 + static_cast<double>(strength)));
  return strengths;
}

}  // namespace inkbench
