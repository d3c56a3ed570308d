// SPDX-License-Identifier: MIT
#include "app/workbench/painted_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/workbench/unknown_entries.h"
#include "pipeline/base/error.h"
#include "pipeline/params/toml_reader.h"
#include "pipeline/params/toml_value.h"
#include "pipeline/settings/settings.h"
#include "studies/tuning/mark_file.h"

namespace inkbench {
namespace {

constexpr std::string_view kLetters = ".wuWU";
constexpr int kMostSidePx = 16384;

char letter_at(const MarkMaps& marks, int x, int y) {
  const bool is_drawn = marks.drawn.at(x, y);
  if (marks.wanted.at(x, y)) return is_drawn ? 'W' : 'w';
  if (marks.unwanted.at(x, y)) return is_drawn ? 'U' : 'u';
  return '.';
}

MarkMaps empty_maps(int width_px, int height_px) {
  const LineMap none(width_px, height_px);
  return {none, none, none};
}

bool is_of(const CameraMarks& marks, const CameraParams& camera, int width_px, int height_px) {
  return marks.width_px == width_px && marks.height_px == height_px && same_camera(marks.camera, camera);
}

double squared_distance(double x, double y, const BrushPoint& a, const BrushPoint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
  const double along = length > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / length, 0.0, 1.0) : 0;
  const double ox = x - a.x - along * dx, oy = y - a.y - along * dy;
  return ox * ox + oy * oy;
}

void add_segment(LineMap& map, const BrushPoint& a, const BrushPoint& b, double radius) {
  const auto first = [](double low) { return std::max(0, static_cast<int>(std::floor(low))); };
  const auto last = [](double high, int size) {
    return std::min(size - 1, static_cast<int>(std::ceil(high)));
  };
  for (int y = first(std::min(a.y, b.y) - radius); y <= last(std::max(a.y, b.y) + radius, map.height_px());
       ++y) {
    for (int x = first(std::min(a.x, b.x) - radius); x <= last(std::max(a.x, b.x) + radius, map.width_px());
         ++x) {
      if (squared_distance(x + 0.5, y + 0.5, a, b) <= radius * radius) map.set(x, y);
    }
  }
}

int whole_entry(const TomlReader& toml, const TomlNode& node, const std::string& key) {
  const double number = toml.number_of(node, key);
  if (number >= 1 && number <= kMostSidePx && number == std::floor(number)) return static_cast<int>(number);
  throw input_error(toml.at(node), key + " is no side of a picture", "a whole number from 1 to 16384");
}

}  // namespace

bool same_marks(const PaintedMarks& a, const PaintedMarks& b) {
  return marks_text(a) == marks_text(b);
}

bool same_camera(const CameraParams& a, const CameraParams& b) {
  const std::vector<Field>& fields = CameraParams::description().fields;
  return std::all_of(fields.begin(), fields.end(),
                     [&](const Field& field) { return field.get(&a) == field.get(&b); });
}

std::string runs_of(const MarkMaps& marks) {
  std::string text;
  char letter = 0;
  int64_t length = 0;
  const auto end_run = [&] {
    if (length > 1) text += std::to_string(length);
    if (length > 0) text += letter;
  };
  for (int y = 0; y < marks.wanted.height_px(); ++y) {
    for (int x = 0; x < marks.wanted.width_px(); ++x) {
      const char here = letter_at(marks, x, y);
      if (here != letter) {
        end_run();
        length = 0;
      }
      letter = here;
      ++length;
    }
  }
  end_run();
  return text;
}

MarkMaps marks_from_runs(const std::string& runs, int width_px, int height_px, const std::string& where) {
  MarkMaps marks = empty_maps(width_px, height_px);
  const int64_t pixels = int64_t{width_px} * height_px;
  int64_t place = 0, length = 0;
  const auto refuse = [&] {
    throw input_error(
        where, "the runs of marks are damaged",
        fmt::format("lengths and the letters {}, for {} x {} px", kLetters, width_px, height_px));
  };
  for (const char letter : runs) {
    if (letter >= '0' && letter <= '9') {
      length = 10 * length + (letter - '0');
      if (length > pixels) refuse();
      continue;
    }
    if (kLetters.find(letter) == std::string_view::npos) refuse();
    length = std::max<int64_t>(length, 1);
    if (place + length > pixels) refuse();
    for (int64_t end = place + length; place < end; ++place) {
      if (letter == '.') continue;
      const auto x = static_cast<int>(place % width_px), y = static_cast<int>(place / width_px);
      (letter == 'w' || letter == 'W' ? marks.wanted : marks.unwanted).set(x, y);
      if (letter == 'W' || letter == 'U') marks.drawn.set(x, y);
    }
    length = 0;
  }
  if (place != pixels || length != 0) refuse();
  return marks;
}

const CameraMarks* find_marks(const PaintedMarks& marks, const CameraParams& camera, int width_px,
                              int height_px) {
  const auto found = std::find_if(marks.begin(), marks.end(), [&](const CameraMarks& one) {
    return is_of(one, camera, width_px, height_px);
  });
  return found == marks.end() ? nullptr : &*found;
}

MarkMaps maps_for(const PaintedMarks& marks, const CameraParams& camera, int width_px, int height_px) {
  const CameraMarks* found = find_marks(marks, camera, width_px, height_px);
  return found == nullptr ? empty_maps(width_px, height_px)
                          : marks_from_runs(found->runs, width_px, height_px, "marks");
}

PaintedMarks with_maps(PaintedMarks marks, const CameraParams& camera, const MarkMaps& maps) {
  const int width_px = maps.wanted.width_px(), height_px = maps.wanted.height_px();
  std::erase_if(marks, [&](const CameraMarks& one) { return is_of(one, camera, width_px, height_px); });
  if (!maps.empty()) marks.push_back({camera, width_px, height_px, runs_of(maps)});
  return marks;
}

LineMap pixels_of(const BrushStroke& stroke, int width_px, int height_px) {
  LineMap map(width_px, height_px);
  for (size_t i = 0; i < stroke.points.size(); ++i) {
    const BrushPoint& point = stroke.points[i];
    add_segment(map, stroke.points[i > 0 ? i - 1 : 0], point, stroke.radius_px);
    const int x = static_cast<int>(std::floor(point.x)), y = static_cast<int>(std::floor(point.y));
    if (map.contains(x, y)) map.set(x, y);
  }
  return map;
}

void paint(MarkMaps& marks, const BrushStroke& stroke, const LineMap& drawn) {
  for_each_pixel(pixels_of(stroke, marks.wanted.width_px(), marks.wanted.height_px()), [&](int x, int y) {
    marks.wanted.set(x, y, stroke.brush == MarkBrush::wanted);
    marks.unwanted.set(x, y, stroke.brush == MarkBrush::unwanted);
    marks.drawn.set(x, y, stroke.brush != MarkBrush::eraser && drawn.at(x, y));
  });
}

std::string marks_text(const PaintedMarks& marks, const std::string& table) {
  std::string text;
  for (const CameraMarks& one : marks)
    text += fmt::format("[[{}]]\nwidth = {}\nheight = {}\nruns = \"{}\"\n", table, one.width_px,
                        one.height_px, one.runs) +
            group_text(one.camera);
  return text;
}

CameraMarks read_camera_marks(const TomlNode& table, const std::string& name,
                              std::vector<std::string>& left_out) {
  const TomlReader toml(name);
  CameraMarks marks;
  for (const auto& [key, node] : toml.entries_of(table, "marks")) {
    if (key == "width" || key == "height") {
      (key == "width" ? marks.width_px : marks.height_px) = whole_entry(toml, node, key);
      continue;
    }
    if (key == "runs") {
      marks.runs = toml.text_of(node, key);
      continue;
    }
    const auto& fields = CameraParams::description().fields;
    const auto field = std::find_if(fields.begin(), fields.end(),
                                    [&, &key_ = key](const Field& one) { return one.name == key_; });
    if (field == fields.end()) {
      left_out.push_back(left_out_name("marks." + key, node));
      continue;
    }
    const Param param{"marks." + key, &*field, &marks.camera};
    param.set(value_from_toml(param, node, toml.at(node), "/"), toml.at(node));
  }
  marks_from_runs(marks.runs, marks.width_px, marks.height_px, toml.at(table));  // or they are damaged
  return marks;
}

PaintedMarks parse_marks(const std::string& text, const std::string& name) {
  PaintedMarks marks;
  std::vector<std::string> left_out;
  const TomlNode document = parse_toml(text, name);
  for (const TomlNode* table : TomlReader(name).tables(document, "marks"))
    marks.push_back(read_camera_marks(*table, name, left_out));
  return marks;
}

std::string write_mark_files(const std::filesystem::path& folder, const PaintedMarks& marks,
                             std::span<const MarkedView> views, int width_px, int height_px) {
  std::string tables;
  int number = 0;
  for (const MarkedView& view : views) {
    if (find_marks(marks, view.camera, width_px, height_px) == nullptr) continue;
    const std::string file = fmt::format("marks_{}.png", ++number);
    write_marks(folder / file, maps_for(marks, view.camera, width_px, height_px));
    tables += "[[marks]]\n";
    if (!view.name.empty()) tables += "view = " + to_text(Value(view.name)) + "\n";
    tables += "file = \"" + file + "\"\n";
  }
  return tables;
}

}  // namespace inkbench
