// SPDX-License-Identifier: MIT
// What a person paints over the pictures: strokes of wanted and unwanted, for each camera. In: strokes, and
// what is drawn under them. Out: marks as a value that undo, the session and a search's spec can hold.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pipeline/params/toml_document.h"
#include "pipeline/settings/camera.h"
#include "studies/measures/marks.h"

namespace inkbench {

enum class MarkBrush { wanted, unwanted, eraser };

/// The marks of one camera's picture. Small: a run of equal pixels is a few letters.
struct CameraMarks {
  CameraParams camera;
  int width_px = 0, height_px = 0;
  std::string runs;  ///< As `runs_of` gives them.
};

/// Each camera and size once, none of them empty.
using PaintedMarks = std::vector<CameraMarks>;

bool same_marks(const PaintedMarks& a, const PaintedMarks& b);
bool same_camera(const CameraParams& a, const CameraParams& b);

/// The pixels row by row: a letter for each run, after the run's length where it is not 1. "." none, "w"
/// wanted, "u" unwanted, capitals where a line was drawn there.
std::string runs_of(const MarkMaps& marks);
/// Errors (input), with `where`: a letter that is none of these, runs that do not fill the picture.
MarkMaps marks_from_runs(const std::string& runs, int width_px, int height_px, const std::string& where);

/// Those of the camera at that size; null where it has none.
const CameraMarks* find_marks(const PaintedMarks& marks, const CameraParams& camera, int width_px,
                              int height_px);
/// Its maps; all empty where it has none.
MarkMaps maps_for(const PaintedMarks& marks, const CameraParams& camera, int width_px, int height_px);
/// With these maps instead of what the camera had at their size.
PaintedMarks with_maps(PaintedMarks marks, const CameraParams& camera, const MarkMaps& maps);

/// One stroke of a round brush: through these points of the picture, in pixels, y down.
struct BrushPoint {
  double x = 0, y = 0;
};
struct BrushStroke {
  MarkBrush brush = MarkBrush::wanted;
  double radius_px = 4;
  std::vector<BrushPoint> points;
};

inline constexpr double kLeastBrushPx = 1, kMostBrushPx = 60;

/// The pixels whose centres the brush goes over, at least the one below each point.
LineMap pixels_of(const BrushStroke& stroke, int width_px, int height_px);

/// Paints over what is there. `drawn`: the lines now, which the marked pixels keep.
void paint(MarkMaps& marks, const BrushStroke& stroke, const LineMap& drawn);

/// As [[`table`]] of a TOML document.
std::string marks_text(const PaintedMarks& marks, const std::string& table = "marks");
/// One of them. Errors (input): `name:line` of what is broken in it.
CameraMarks read_camera_marks(const TomlNode& table, const std::string& name,
                              std::vector<std::string>& left_out);
/// A document of nothing else. Errors (input): the same, and broken TOML.
PaintedMarks parse_marks(const std::string& text, const std::string& name);

/// A view of a search.
struct MarkedView {
  std::string name;
  CameraParams camera;
};

/// Writes marks_1.png, ... for those views that have marks at that size into the folder, which is there.
/// Returns the [[marks]] tables that name them in a spec beside them; "" where there are none. Errors (work):
/// as `write_marks`.
std::string write_mark_files(const std::filesystem::path& folder, const PaintedMarks& marks,
                             std::span<const MarkedView> views, int width_px, int height_px);

}  // namespace inkbench
