// SPDX-License-Identifier: MIT
#include "pipeline/line_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/export.h"
#include "pipeline/image/image_content.h"
#include "pipeline/image/image_file.h"
#include "pipeline/lines/class_pixels.h"

namespace inkbench {
namespace {

double share(const LineMap& map) {
  const double pixels = static_cast<double>(map.width_px()) * map.height_px();
  return static_cast<double>(map.count()) / pixels;
}

[[noreturn]] void throw_changed(const fs::path& path, const std::string& why) {
  throw input_error(path.string(), "says that it is inkbench's reference, but " + why + ": it was changed",
                    "write it again with `inkbench render --buffers reference`");
}

/// Where a pixel holds what no classes have, the file is not as it was written.
[[noreturn]] void throw_changed_pixel(const fs::path& path, size_t pixel, int width_px) {
  const auto width = static_cast<size_t>(width_px);
  throw_changed(path, fmt::format("pixel {}, {} has the colour of no class", pixel % width, pixel / width));
}

Picture pixels_of_colours(const fs::path& path) {
  const Picture picture = read_picture(path, 3);
  Picture pixels(picture.width_px, picture.height_px, 1);
  for (size_t i = 0; i < pixels.samples.size(); ++i) {
    const uint8_t* from = &picture.samples[3 * i];
    const std::optional<ClassBits> classes = classes_of_colour({from[0], from[1], from[2]});
    if (!classes) throw_changed_pixel(path, i, picture.width_px);
    pixels.samples[i] = *classes;
  }
  return pixels;
}

Picture pixels_of_numbers(const fs::path& path) {
  const Image image = read_image(path);
  Picture pixels(image.width_px, image.height_px, 1);
  for (size_t i = 0; i < pixels.samples.size(); ++i) {
    const std::optional<ClassBits> classes = classes_of_number(image.samples[i]);
    if (!classes) throw_changed_pixel(path, i, image.width_px);
    pixels.samples[i] = *classes;
  }
  return pixels;
}

/// EXR files of one channel hold numbers, and all others colours: a number that was clamped or a colour that
/// became grey looks like classes and is none.
Picture read_class_pixels(const fs::path& path) {
  const int channels = image_channels(path);
  const bool is_exr = image_format(read_file(path)) == "openexr";
  if (is_exr && channels == 1) return pixels_of_numbers(path);
  if (channels < 3) throw_changed(path, "it is grey");
  return pixels_of_colours(path);
}

LineFile read_classes(const fs::path& path) {
  if (read_image_text(path, std::string(kClassesEntry)) != class_bit_names()) {
    throw input_error(path.string(),
                      "is a reference that another version wrote, which does not say all classes",
                      "write it again with `inkbench render --buffers reference --from` this file");
  }
  LineFile file{.buffer = BufferName::reference};
  file.classes = {read_class_pixels(path), read_origin(path).settings.judge};
  file.lines = tier_map(file.classes->pixels, file.classes->judge, 1);
  if (file.lines.count() == 0) file.notes.push_back(path.string() + " has no line that is wanted");
  return file;
}

float largest_strength(const Image& grey, bool inverted) {
  float largest = 0;
  for (const float sample : grey.samples) largest = std::max(largest, inverted ? 1.0F - sample : sample);
  return largest;
}

/// As light lines, or as dark ones where those are less ink.
LineMap with_less_ink(const fs::path& path, const Image& grey, LineFile& file) {
  LineMap light = line_map_from(grey, file.cut);
  const LineMap dark = line_map_from(grey, {file.cut.value, true});
  if (dark.count() >= light.count()) return light;
  file.cut.inverted = true;
  file.notes.push_back(
      fmt::format("{} is read as dark lines on light: {:.1f} % of it is light, {:.1f} % dark; --invert no "
                  "takes the light",
                  path.string(), 100 * share(light), 100 * share(dark)));
  return dark;
}

void note_odd_shares(const fs::path& path, const Image& grey, LineFile& file) {
  const std::string cut = shortest(file.cut.value);
  if (file.lines.count() == 0) {
    const float largest = largest_strength(grey, file.cut.inverted);
    file.notes.push_back(fmt::format("{} has no line: its {} pixel has {:.3g}, and the cut is {}",
                                     path.string(), file.cut.inverted ? "darkest (inverted)" : "lightest",
                                     largest, cut));
  } else if (share(file.lines) > 0.5) {
    file.notes.push_back(fmt::format("{} is more than half line ({:.1f} % of its pixels)", path.string(),
                                     100 * share(file.lines)));
  }
}

}  // namespace

std::optional<BufferName> exported_buffer(const fs::path& path) {
  if (!has_origin(path)) return std::nullopt;
  const std::string name = read_image_text(path, std::string(kBufferEntry));
  for (const BufferName buffer : all_buffers()) {
    if (name_of(buffer) == name) return buffer;
  }
  return std::nullopt;
}

LineFile read_line_file(const fs::path& path, const LineFileOptions& options) {
  const std::optional<BufferName> buffer = exported_buffer(path);
  const ReadAsLines as_lines = buffer ? buffer->info().as_lines : ReadAsLines::at_cut;
  if (as_lines == ReadAsLines::no) {
    throw input_error(path.string(),
                      fmt::format("is the buffer {}, which is no map of lines", name_of(*buffer)),
                      "give its drawn lines: `inkbench render --buffers lines --from` this file");
  }
  if (as_lines == ReadAsLines::classes) return read_classes(path);
  const Image grey = read_grey_over_white(path);
  LineFile file{.buffer = buffer};
  file.cut.value = options.cut.value_or(as_lines == ReadAsLines::above_0 ? 0.0 : 0.5);
  file.cut.inverted = options.invert == Invert::yes;
  const bool is_open = !buffer && options.invert == Invert::automatic;
  file.lines = is_open ? with_less_ink(path, grey, file) : line_map_from(grey, file.cut);
  note_odd_shares(path, grey, file);
  return file;
}

}  // namespace inkbench
