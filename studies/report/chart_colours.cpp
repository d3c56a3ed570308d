// SPDX-License-Identifier: MIT
#include "studies/report/chart_colours.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace inkbench {
namespace {

constexpr size_t kHeatStops = 17;

double mix(double a, double b, double t) {
  return a + (b - a) * t;
}

std::array<double, 3> linear_srgb(const OkLch& colour) {
  const double hue = colour.hue_deg * std::numbers::pi / 180;
  const double a = colour.chroma * std::cos(hue);
  const double b = colour.chroma * std::sin(hue);
  const double l = std::pow(colour.lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(colour.lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(colour.lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool in_gamut(const std::array<double, 3>& rgb) {
  return std::all_of(rgb.begin(), rgb.end(), [](double v) { return v >= -1e-4 && v <= 1 + 1e-4; });
}

int encoded(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  return static_cast<int>(
      std::lround(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055)));
}

}  // namespace

std::string srgb_text(OkLch colour) {
  while (colour.chroma > 0 && !in_gamut(linear_srgb(colour)))
    colour.chroma = std::max(0.0, colour.chroma - 0.002);
  const std::array<double, 3> rgb = linear_srgb(colour);
  return fmt::format("#{:02x}{:02x}{:02x}", encoded(rgb[0]), encoded(rgb[1]), encoded(rgb[2]));
}

std::vector<std::string> curve_colours(size_t count) {
  // Few curves stay away from the light end, which is the weaker one on white.
  const double end = count <= 1 ? 0 : count == 2 ? 0.75 : 1;
  std::vector<std::string> colours;
  for (size_t i = 0; i < count; ++i) {
    const double t = count <= 1 ? 0 : end * static_cast<double>(i) / static_cast<double>(count - 1);
    colours.push_back(srgb_text({mix(0.30, 0.74, t), mix(0.14, 0.17, t), mix(265, 430, t)}));
  }
  return colours;
}

std::vector<std::string> heat_colours() {
  std::vector<std::string> colours;
  for (size_t i = 0; i < kHeatStops; ++i) {
    const double t = static_cast<double>(i) / (kHeatStops - 1);
    const double chroma = 0.03 + 0.4 * t * (1 - t) + 0.06 * t;
    colours.push_back(srgb_text({mix(0.97, 0.30, t), chroma, mix(105, 265, t)}));
  }
  return colours;
}

}  // namespace inkbench
