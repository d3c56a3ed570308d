// SPDX-License-Identifier: MIT
#include "app/window/view_state.h"

#include <algorithm>

namespace inkbench {
namespace {

constexpr double kLargestPixel = 64.0;  // window pixels a picture pixel
constexpr double kSmallestZoom = 0.25;

double fit_magnification(const TileFrame& frame) {
  return std::min(frame.width / frame.picture_width, frame.height / frame.picture_height);
}

/// From a quarter of the fitted size, or one to one where that is smaller, to `kLargestPixel`.
double allowed_zoom(double zoom, const TileFrame& frame) {
  const double one_to_one = 1.0 / std::max(fit_magnification(frame), 1e-6);
  return std::clamp(zoom, std::min(kSmallestZoom, one_to_one), std::max(1.0, kLargestPixel * one_to_one));
}

/// Keeps the picture in sight: in the middle where it is smaller than the tile, else without a gap.
double kept_in_sight(double centre, double shown_share) {
  if (shown_share >= 1.0) return 0.5;
  return std::clamp(centre, shown_share / 2.0, 1.0 - shown_share / 2.0);
}

void keep_in_sight(ViewState& view, const TileFrame& frame) {
  const double scale = magnification(view, frame);
  view.centre_x = kept_in_sight(view.centre_x, frame.width / (scale * frame.picture_width));
  view.centre_y = kept_in_sight(view.centre_y, frame.height / (scale * frame.picture_height));
}

}  // namespace

bool asks_pinned(const ViewState& view) {
  const Comparison& comparison = view.comparison;
  if (!view.marked || !comparison.active) return false;
  if (comparison.flips) return (comparison.shows_b ? comparison.b : comparison.a).pinned;
  return view.marked->pinned && (comparison.a.pinned || comparison.b.pinned);
}

double magnification(const ViewState& view, const TileFrame& frame) {
  return std::max(fit_magnification(frame) * view.zoom, 1e-6);
}

PicturePoint point_under(const ViewState& view, const TileFrame& frame, double window_x, double window_y) {
  const double scale = magnification(view, frame);
  return {view.centre_x * frame.picture_width + (window_x - frame.left - frame.width / 2.0) / scale,
          view.centre_y * frame.picture_height + (window_y - frame.top - frame.height / 2.0) / scale};
}

PicturePoint point_over(const ViewState& view, const TileFrame& frame, double picture_x, double picture_y) {
  const double scale = magnification(view, frame);
  return {frame.left + frame.width / 2.0 + (picture_x - view.centre_x * frame.picture_width) * scale,
          frame.top + frame.height / 2.0 + (picture_y - view.centre_y * frame.picture_height) * scale};
}

void zoom_about(ViewState& view, const TileFrame& frame, double window_x, double window_y, double factor) {
  const PicturePoint before = point_under(view, frame, window_x, window_y);
  view.zoom = allowed_zoom(view.zoom * factor, frame);
  const PicturePoint after = point_under(view, frame, window_x, window_y);
  view.centre_x += (before.x - after.x) / frame.picture_width;
  view.centre_y += (before.y - after.y) / frame.picture_height;
  keep_in_sight(view, frame);
}

void pan_by(ViewState& view, const TileFrame& frame, double dx, double dy) {
  const double scale = magnification(view, frame);
  view.centre_x -= dx / (scale * frame.picture_width);
  view.centre_y -= dy / (scale * frame.picture_height);
  keep_in_sight(view, frame);
}

void set_magnification(ViewState& view, const TileFrame& frame, double size) {
  view.zoom = allowed_zoom(size / std::max(fit_magnification(frame), 1e-6), frame);
  keep_in_sight(view, frame);
}

}  // namespace inkbench
