// SPDX-License-Identifier: MIT
#include "app/workbench/curve_words.h"

#include <fmt/format.h>

#include <algorithm>

namespace inkbench {
namespace {

/// "apparent ridge" for `apparent_ridge`; the name of the class `object` says too little.
std::string plain_name(CurveClass curve_class) {
  if (curve_class == CurveClass::object) return "object outline";
  std::string name(name_of(curve_class));
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string what(const Curve& curve, std::string_view object) {
  std::string text = plain_name(curve.curve_class);
  if (!object.empty()) text += fmt::format(" of {}", object);
  if (curve.is_traced) text += ", traced in the picture";
  return text;
}

std::string covering(const Curve& curve) {
  if (curve.is_traced || curve.covered == 0) return "visible";
  return fmt::format("covered by {} surface{}", curve.covered, curve.covered == 1 ? "" : "s");
}

std::string_view behind(Behind what_lies_there) {
  switch (what_lies_there) {
    case Behind::same_object:
      return "the same object behind it";
    case Behind::other_object:
      return "another object behind it";
    case Behind::nothing:
      return "nothing behind it";
    case Behind::unknown:
      break;
  }
  return "";
}

std::string_view end_words(CurveEnd end) {
  switch (end) {
    case CurveEnd::junction:
      return "a junction";
    case CurveEnd::crossing:
      return "a nearer outline";
    case CurveEnd::cusp:
      return "a cusp";
    case CurveEnd::frame:
      return "the image's border";
    case CurveEnd::other_class:
      return "another class";
    case CurveEnd::free:
    case CurveEnd::closed:
      break;
  }
  return "a free end";
}

std::string ends(const Curve& curve) {
  if (curve.start == CurveEnd::closed || curve.is_closed()) return "closed";
  return fmt::format("from {} to {}", end_words(curve.start), end_words(curve.end));
}

}  // namespace

std::vector<std::string> curve_words(const Curve& curve, std::string_view object) {
  std::vector<std::string> lines{what(curve, object),
                                 fmt::format("{:.1f} px, {}", length_px(curve), covering(curve))};
  if (const std::string_view there = behind(curve.behind); !there.empty()) lines.emplace_back(there);
  lines.push_back(ends(curve));
  return lines;
}

}  // namespace inkbench
