// SPDX-License-Identifier: MIT
// Reference lines to look at. In: reference lines. Out: a picture or an SVG document, one colour a class.
#pragma once

#include <array>
#include <string>

#include "pipeline/image/image.h"
#include "pipeline/lines/reference_lines.h"

namespace inkbench {

/// From Okabe and Ito's palette, which people with the common kinds of colour blindness can tell apart.
std::array<uint8_t, 3> colour_of(LineClass line_class);

/// H x W x 3: the maps of the classes in their colours on white, earlier classes over later ones; the lowest
/// bits say which classes lie below (`colour_of_classes`).
Picture draw_reference(const ReferenceLines& lines);

/// H x W x 1: on each pixel the sum of 2^i over the classes i (from 0, in `kLineClasses`) that have a line
/// there; 0 where there is none.
Image class_image(const ReferenceLines& lines);

/// A group for each class, named by its id and drawn from the last to the first; one path for each polyline,
/// with its object in `data-object`; coordinates in px with two decimals. No background, so that it can lie
/// over a picture. The same lines give the same bytes.
std::string reference_svg(const ReferenceLines& lines);

}  // namespace inkbench
