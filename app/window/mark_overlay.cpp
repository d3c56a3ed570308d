// SPDX-License-Identifier: MIT
#include "app/window/mark_overlay.h"

#include "app/window/picture_upload.h"

namespace inkbench {
namespace {

void colour_pixels(Picture& picture, const LineMap& map, const MarkColour& colour) {
  for_each_pixel(map, [&](int x, int y) {
    picture.at(x, y, 0) = colour.red;
    picture.at(x, y, 1) = colour.green;
    picture.at(x, y, 2) = colour.blue;
    picture.at(x, y, 3) = kMarkAlpha;
  });
}

}  // namespace

const Texture* MarkOverlay::find(const PaintedMarks& marks, const CameraParams& camera, int width_px,
                                 int height_px) {
  const CameraMarks* found = find_marks(marks, camera, width_px, height_px);
  if (found == nullptr) return nullptr;
  const bool is_same = texture_ && found->runs == runs_ && width_px == width_px_ && height_px == height_px_;
  if (is_same) return &*texture_;
  const MarkMaps maps = marks_from_runs(found->runs, width_px, height_px, "marks");
  Picture picture(width_px, height_px, 4);
  colour_pixels(picture, maps.wanted, kWantedMark);
  colour_pixels(picture, maps.unwanted, kUnwantedMark);
  texture_ = texture_of("marks", picture);
  runs_ = found->runs;
  width_px_ = width_px;
  height_px_ = height_px;
  return &*texture_;
}

}  // namespace inkbench
