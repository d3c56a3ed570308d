// SPDX-License-Identifier: MIT
// Text in pictures: how wide it is, where it breaks, which size fits, and drawing it. DejaVu Sans through
// FreeType, which stays behind lettering.cpp (Debian 12's OpenImageIO draws text too, but decodes ASCII only:
// of a degree sign it makes "0"). In: UTF-8 text and sizes in pixels per em. Used by the image grid. All
// functions throw a work error that names the package where the font is missing.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/image/image.h"

namespace inkbench {

enum class Face { regular, bold };

/// The distance from one line's baseline to the next.
int line_height_px(int size_px);

/// From the top of a line's box, `line_height_px` high, to its baseline.
int baseline_px(int size_px);

/// How far the pen moves over `line`.
int text_width_px(std::string_view line, int size_px, Face face);

/// The width of the widest word of `text`.
int widest_word_px(std::string_view text, int size_px, Face face);

/// `line` with a box (U+25A1) for each character that the font lacks.
std::string with_boxes(std::string_view line);

/// Breaks at line ends and spaces so that no line is wider than `width_px`; inside a word only where the word
/// alone is wider. At least one line, which may be empty.
std::vector<std::string> wrapped(std::string_view text, int width_px, int size_px, Face face);

/// What `fitted` may do: wrap into up to `max_lines` lines, and go from `largest_px` down to `smallest_px`.
struct FitLimits {
  int width_px = 0;
  int largest_px = 0;
  int smallest_px = 0;
  int max_lines = 1;
};

/// One size for all `texts` with which each fits the limits with whole words. A little smaller (to 7/10) is
/// preferred to one line more. Where nothing fits, the smallest size, at which the caller wraps with broken
/// words.
int fitted_size_px(std::span<const std::string> texts, const FitLimits& limits, Face face);

struct TextStyle {
  int size_px = 14;
  Face face = Face::regular;
  std::array<uint8_t, 3> colour = {0, 0, 0};
};

/// Draws one line on a picture of 3 channels, its baseline from (x, y) to the right or, `upwards`, from (x,
/// y) to the top (turned by 90 degrees). What lies outside the picture is left out.
void draw_text(Picture& picture, int x, int y, std::string_view line, const TextStyle& style,
               bool upwards = false);

}  // namespace inkbench
