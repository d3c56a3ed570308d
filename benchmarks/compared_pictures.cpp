// SPDX-License-Identifier: MIT
#include "benchmarks/compared_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "pipeline/base/error.h"
#include "pipeline/image/image_file.h"
#include "pipeline/image/png_file.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;

Picture compared_picture(Pipeline& pipeline, Settings settings, std::string_view method, BufferName buffer) {
  settings.image.width = 960;
  settings.image.height = 540;
  return pipeline.at(with_method(settings, method)).picture(buffer);
}

fs::path picture_file(const std::string& folder, std::string_view method, BufferName buffer) {
  return fs::path(folder) / fmt::format("{}_{}.png", method, buffer.info().name);
}

/// Pixels of which a channel differs by more than rounding and filtering explain.
int differing_pixels(const Picture& a, const Picture& b) {
  constexpr int kUnseen = 16;  // of 255
  if (a.width_px != b.width_px || a.height_px != b.height_px)
    throw input_error("--against", "the pictures there have another size", "write them again");
  int count = 0;
  for (int y = 0; y < a.height_px; ++y) {
    for (int x = 0; x < a.width_px; ++x) {
      int most = 0;
      for (int c = 0; c < a.channels; ++c) most = std::max(most, std::abs(a.at(x, y, c) - b.at(x, y, c)));
      count += most > kUnseen;
    }
  }
  return count;
}

}  // namespace

Settings with_method(Settings settings, std::string_view method) {
  set_param_text(settings, "edges.method", std::string(method), "benchmark");
  return settings;
}

void write_pictures(Pipeline& pipeline, const Settings& settings, const std::string& folder) {
  fs::create_directories(folder);
  for (const std::string_view method : ChoiceNames<EdgeMethod>::names) {
    for (const BufferName buffer : {BufferName::lines, BufferName::final})
      write_png(picture_file(folder, method, buffer), compared_picture(pipeline, settings, method, buffer),
                {});
  }
}

bool draws_as_written(Pipeline& pipeline, const Settings& settings, const std::string& folder,
                      double tolerance) {
  fmt::print("\npixels unlike {}, as a share of its line pixels; at most {} %\n", folder, 100 * tolerance);
  bool all_alike = true;
  for (const std::string_view method : ChoiceNames<EdgeMethod>::names) {
    const auto other = [&](BufferName buffer) {
      return read_picture(picture_file(folder, method, buffer), 3);
    };
    const Picture lines = other(BufferName::lines);
    const auto line_pixels = std::max<std::ptrdiff_t>(
        std::ranges::count_if(lines.samples, [](uint8_t value) { return value > 127; }) / 3, 1);
    for (const BufferName buffer : {BufferName::lines, BufferName::final}) {
      const int differing =
          differing_pixels(compared_picture(pipeline, settings, method, buffer), other(buffer));
      const double share = static_cast<double>(differing) / static_cast<double>(line_pixels);
      const bool is_alike = share <= tolerance;
      fmt::print("{:<16} {:<6} {:8.3f} %  ({} of {}){}\n", method, buffer.info().name, 100 * share, differing,
                 line_pixels, is_alike ? "" : "  too many");
      all_alike &= is_alike;
    }
  }
  return all_alike;
}

}  // namespace inkbench
