// SPDX-License-Identifier: MIT
// How the pictures are looked at: which one fills the window, zoom and pan shared by all, what is compared.
// Nothing here changes a picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/workbench/painted_marks.h"
#include "pipeline/buffers.h"

namespace inkbench {

/// One side of a comparison: a buffer now, or as it was when pinned.
struct ComparedPicture {
  BufferName buffer = BufferName::final;
  bool pinned = false;
  bool operator==(const ComparedPicture&) const = default;
};

struct Comparison {
  bool active = false;
  bool flips = false;    ///< One picture at a time instead of both sides of a line.
  bool shows_b = false;  ///< Which one, when flipping.
  double split = 0.5;    ///< Share of the width that is A's.
  ComparedPicture a, b;
};

/// The picture's pixel under the mouse.
struct HoveredPixel {
  ComparedPicture picture;
  int x = 0, y = 0;  ///< (0, 0) is the top left one.
};

/// A pixel of all pictures; (0, 0) is the top left one.
struct MarkedPixel {
  int x = 0, y = 0;
  bool pinned = false;  ///< It was clicked on a pinned picture.
  bool operator==(const MarkedPixel&) const = default;
};

/// What dragging on a picture does.
enum class MouseTool { view, camera, mark };

/// What is edited in the place of timings and log.
enum class OpenEditor { none, ramps, style };

struct ViewState {
  double zoom = 1.0;                      ///< 1 fits the picture into its tile.
  double centre_x = 0.5, centre_y = 0.5;  ///< The picture's point in the tile's middle, as shares, y down.
  BufferName selected = BufferName::final;
  std::optional<BufferName> filled;  ///< The buffer that fills the window.
  Comparison comparison;
  MouseTool tool = MouseTool::view;
  MarkBrush brush = MarkBrush::wanted;
  double brush_px = 4;                         ///< Its radius in picture pixels.
  std::optional<BrushStroke> stroke;           ///< Being painted.
  double magnification = 1.0;                  ///< Window pixels a picture pixel, as last drawn.
  std::optional<double> wanted_magnification;  ///< To set when tiles are next drawn.
  bool wireframe = false;                      ///< The meshes' edges over the pictures.
  bool camera_moving = false;                  ///< The mouse drags the camera.
  std::optional<HoveredPixel> hovered;
  std::vector<std::string> curve_words;  ///< What is said of the curve under the mouse; empty without one.
  std::optional<MarkedPixel> marked_before;  ///< What a second click brings back.
  std::optional<MarkedPixel> marked;         ///< Asked why it is as it is; shown on all pictures.
  OpenEditor editor = OpenEditor::none;

  /// Closes the one that is open.
  void toggle(OpenEditor which) { editor = editor == which ? OpenEditor::none : which; }
  void fit() {
    zoom = 1.0;
    centre_x = centre_y = 0.5;
  }
};

/// Whether what is asked of the marked pixel is asked of the pinned state: that picture was clicked, or is
/// the one that is shown of the two.
bool asks_pinned(const ViewState& view);

/// A tile's rectangle in the window and the picture's size, both in pixels.
struct TileFrame {
  double left = 0, top = 0, width = 0, height = 0;
  int picture_width = 1, picture_height = 1;
};

/// Window pixels per picture pixel.
double magnification(const ViewState& view, const TileFrame& frame);

struct PicturePoint {
  double x = 0, y = 0;  ///< In picture pixels, y down; (0, 0) is the top left corner.
};

/// The picture's point under a point of the window.
PicturePoint point_under(const ViewState& view, const TileFrame& frame, double window_x, double window_y);

/// The point of the window at a picture's point: the inverse.
PicturePoint point_over(const ViewState& view, const TileFrame& frame, double picture_x, double picture_y);

/// Zooms by `factor` so that the picture's point under the given point of the window stays there.
void zoom_about(ViewState& view, const TileFrame& frame, double window_x, double window_y, double factor);

/// Moves the picture by so many window pixels.
void pan_by(ViewState& view, const TileFrame& frame, double dx, double dy);

/// Zooms so that a picture pixel is `size` window pixels large.
void set_magnification(ViewState& view, const TileFrame& frame, double size);

}  // namespace inkbench
