// SPDX-License-Identifier: MIT
// An SVG file round what is drawn: its size, where it came from, and groups for classes and objects, which
// Inkscape shows as layers.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "pipeline/image/png_file.h"
#include "pipeline/settings/curve_class.h"

namespace inkbench {

/// What a vector file says beside what is drawn.
struct VectorPage {
  int width_px = 0, height_px = 0;
  std::vector<std::string> object_names;  ///< Of the object ids 1, 2, ...
  ImageText about;                        ///< As PNG files carry it; entries of <metadata>.
};

/// Digits after the point of coordinates in px.
inline constexpr int kPxDigits = 2;

/// A whole file of the image's size, one user unit a pixel, no background. `note`: a sentence for who opens
/// the file, "" for none. `drawn`: elements.
std::string svg_file(const VectorPage& page, const std::string& note, const std::string& drawn);

/// The same with a size on paper: one user unit a millimetre.
std::string svg_file_mm(const VectorPage& page, double width_mm, double height_mm, const std::string& note,
                        const std::string& drawn);

/// The entry `name` of the <metadata> that such a file has; "" where there is none.
std::string svg_entry(std::string_view svg, std::string_view name);

/// A path with its group.
struct ClassItem {
  bool is_hidden = false;
  CurveClass curve_class{};
  int object_id = 0;
  std::string element;
};

/// How a class is drawn: its group's attributes, each with a space before it. What is hidden may look another
/// way.
struct ClassAttributes {
  std::array<std::string, kCurveClasses> visible, hidden;
  std::string hidden_group;
};

/// Groups `hidden` (below), then each class from the last to the first, so that the first lies on top; in
/// them groups for the objects, "silhouette-rabbit", "hidden-crease-box"; what belongs to no object stands in
/// its class. Items keep their order. Groups of nothing are left out.
std::string class_groups(const std::vector<ClassItem>& items, const ClassAttributes& attributes,
                         const std::vector<std::string>& object_names);

}  // namespace inkbench
