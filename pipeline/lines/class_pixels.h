// SPDX-License-Identifier: MIT
// Reference lines as pixels, each of which says all of its classes: what the files of the buffer `reference`
// hold, so that tiers and recall by class come out of them exactly. In: reference lines, or what a file
// holds. Out: pixels of bits, their colours and numbers, and the maps of classes and tiers.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "pipeline/image/image.h"
#include "pipeline/lines/line_map.h"
#include "pipeline/lines/reference_lines.h"

namespace inkbench {

/// The classes of the lines on a pixel: bit i is `kLineClasses[i]`; 0 is no line.
using ClassBits = uint8_t;

/// H x W x 1 of `ClassBits`.
Picture class_pixels(const ReferenceLines& lines);

/// White without a line, else the colour of the first class; the j-th class (from 0), where it is another one
/// on the pixel, turns the bit (j - 1) % 2 of the channel (j - 1) / 2 over, which nobody sees.
std::array<uint8_t, 3> colour_of_classes(ClassBits classes);

/// The reverse; none for a colour that no classes have.
std::optional<ClassBits> classes_of_colour(const std::array<uint8_t, 3>& colour);

/// H x W x 3, each pixel in its `colour_of_classes`.
Picture coloured_classes(const Picture& pixels);

/// H x W x 1, each pixel's bits as a number.
Image numbered_classes(const Picture& pixels);

/// The reverse; none for a number that no classes have.
std::optional<ClassBits> classes_of_number(float number);

/// The names of the bits from the lowest on, with blanks between them.
std::string class_bit_names();

/// As `class_map` and `tier_map` of the lines that the pixels were made from.
LineMap class_map(const Picture& pixels, LineClass line_class);
LineMap tier_map(const Picture& pixels, const JudgeParams& judge, int wanted_tier);

}  // namespace inkbench
