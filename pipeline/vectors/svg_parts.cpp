// SPDX-License-Identifier: MIT
#include "pipeline/vectors/svg_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "pipeline/base/text.h"

namespace inkbench {
namespace {

/// A place on the grid, or a step between two.
struct GridPoint {
  int64_t x = 0, y = 0;

  bool operator==(const GridPoint&) const = default;
  GridPoint operator-(const GridPoint& other) const { return {x - other.x, y - other.y}; }
};

std::string grid_number(int64_t value, int digits) {
  int64_t unit = 1;
  for (int i = 0; i < digits; ++i) unit *= 10;
  const int64_t size = std::abs(value), whole = size / unit;
  std::string rest = size % unit == 0 ? "" : fmt::format(".{:0{}d}", size % unit, digits);
  while (rest.ends_with('0')) rest.pop_back();
  const std::string before = whole != 0 || rest.empty() ? std::to_string(whole) : "";
  return (value < 0 ? "-" : "") + before + rest;
}

class PathWriter {
 public:
  explicit PathWriter(int digits) : digits_(digits), unit_(std::pow(10.0, digits)) {}

  void add(const CubicPath& path) {
    const GridPoint start = on_grid(path.start);
    bool is_begun = false;
    at_ = start;
    for (size_t i = 0; i < path.pieces.size(); ++i) {
      const bool closes = path.is_closed && i + 1 == path.pieces.size();
      const PathPiece& piece = path.pieces[i];
      if (is_point(piece) || (closes && piece.is_line && is_begun)) continue;
      if (!is_begun) move_to(start);
      is_begun = true;
      piece.is_line ? line_to(on_grid(piece.end)) : curve_to(piece);
    }
    if (is_begun && path.is_closed) command('z');
  }

  std::string take() { return std::move(data_); }

 private:
  GridPoint on_grid(const glm::dvec2& point) const {
    return {std::llround(point.x * unit_), std::llround(point.y * unit_)};
  }

  bool is_point(const PathPiece& piece) const {
    return on_grid(piece.end) == at_ &&
           (piece.is_line || (on_grid(piece.leave) == at_ && on_grid(piece.enter) == at_));
  }

  void command(char letter) {
    data_ += letter;
    last_ = letter;
    needs_space_ = false;
  }
  void command_unless_same(char letter) {
    if (letter != last_) command(letter);
  }

  void number(int64_t value) {
    if (needs_space_ && value >= 0) data_ += ' ';
    data_ += grid_number(value, digits_);
    needs_space_ = true;
  }
  void point(const GridPoint& point) {
    number(point.x);
    number(point.y);
  }

  void move_to(const GridPoint& to) {
    command('M');
    point(to);
  }

  void line_to(const GridPoint& to) {
    const GridPoint step = to - at_;
    if (step.y == 0) {
      command_unless_same('h');
      number(step.x);
    } else if (step.x == 0) {
      command_unless_same('v');
      number(step.y);
    } else {
      command_unless_same('l');
      point(step);
    }
    at_ = to;
  }

  void curve_to(const PathPiece& piece) {
    command_unless_same('c');
    for (const glm::dvec2& to : {piece.leave, piece.enter, piece.end}) point(on_grid(to) - at_);
    at_ = on_grid(piece.end);
  }

  int digits_;
  double unit_;
  GridPoint at_;
  std::string data_;
  char last_ = ' ';
  bool needs_space_ = false;
};

}  // namespace

std::string xml_text(std::string_view text) {
  std::string result;
  for (const char c : printable(text, true)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string id_part(std::string_view name) {
  std::string id(name);
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  std::replace_if(
      id.begin(), id.end(), [&](char c) { return kPlain.find(c) == std::string_view::npos; }, '_');
  return id;
}

std::string svg_number(double value, int digits) {
  return grid_number(std::llround(value * std::pow(10.0, digits)), digits);
}

std::string svg_colour(const glm::vec3& colour) {
  const auto byte = [](float value) { return std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.x), byte(colour.y), byte(colour.z));
}

std::string path_data(std::span<const CubicPath> paths, int digits) {
  PathWriter writer(digits);
  for (const CubicPath& path : paths) writer.add(path);
  return writer.take();
}

}  // namespace inkbench
