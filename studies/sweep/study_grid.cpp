// SPDX-License-Identifier: MIT
#include "studies/sweep/study_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/base/text.h"
#include "studies/report/grid.h"
#include "studies/report/grid_plan.h"

namespace inkbench {
namespace {

constexpr int kGapPx = 4;  ///< Between the pictures of one cell.

std::vector<std::string> names_of(const std::vector<NamedSet>& sets) {
  std::vector<std::string> names;
  for (const NamedSet& set : sets) names.push_back(set.name);
  return names.empty() ? std::vector<std::string>{""} : names;
}

/// Frames of a path that the grid shows at most: of a single cell, and beside each other in rows.
constexpr size_t kMostFrames = 36, kMostFramesInRow = 8;

/// A study of a single cell is laid out by buffer and view; else a cell holds them all, side by side.
bool cell_is_the_grid(const StudySpec& spec) {
  return !spec.camera_path && cell_count(spec) == 1 && picture_count(spec) > 1;
}

/// Of a cell of the grid.
size_t pictures_in_cell(const StudySpec& spec) {
  if (cell_is_the_grid(spec)) return 1;
  return spec.camera_path ? spec.show.size() : picture_count(spec);
}

/// The first axis, or the variants, makes rows: the pages are all that is left.
GridAxis path_pages(const StudySpec& spec) {
  const GridAxis inner = grid_axis(spec, 1), outer = grid_axis(spec, 2);
  if (outer.values.size() == 1) return inner;
  GridAxis both{inner.label + ", " + outer.label, {}};
  for (const std::string& far : outer.values) {
    for (const std::string& near : inner.values) both.values.push_back(near + ", " + far);
  }
  return both;
}

void label_path(const StudySpec& spec, GridLayout& layout) {
  const std::vector<size_t> frames = views_in_grid(spec);
  if (frames.size() < spec.views.size())
    layout.subtitle += fmt::format(", {} of {} frames", frames.size(), spec.views.size());
  layout.columns = {"turn", {}};
  for (const size_t frame : frames) layout.columns.values.push_back(view_label(spec, frame));
  layout.rows = grid_axis(spec, 0);
  layout.pages = path_pages(spec);
}

std::vector<std::string> shown_names(const StudySpec& spec) {
  std::vector<std::string> names;
  for (const BufferName buffer : spec.show) names.emplace_back(name_of(buffer));
  return names;
}

void label_axes(const StudySpec& spec, GridLayout& layout) {
  const ImageParams& image = spec.base.image;
  const std::string size = fmt::format("{} x {} px", image.width, image.height);
  if (cell_is_the_grid(spec)) {
    layout.subtitle = size;
    layout.columns = {"", shown_names(spec)};
    layout.rows = {"", names_of(spec.views)};
    layout.pages = {"", {""}};
    return;
  }
  layout.subtitle = join(shown_names(spec), ", ") + " at " + size;
  if (spec.camera_path) return label_path(spec, layout);
  if (spec.views.size() > 1) layout.subtitle += ", from left to right: " + join(names_of(spec.views), ", ");
  layout.columns = grid_axis(spec, 0);
  layout.rows = grid_axis(spec, 1);
  layout.pages = grid_axis(spec, 2);
}

/// Of a cell's pictures side by side, as they are.
int cell_width_px(const StudySpec& spec) {
  const auto count = static_cast<int>(pictures_in_cell(spec));
  return spec.base.image.width * count + kGapPx * (count - 1);
}

GridLayout make_layout(const StudySpec& spec) {
  GridLayout layout;
  layout.title = spec.title;
  label_axes(spec, layout);
  const auto count = static_cast<int>(pictures_in_cell(spec));
  const ImageParams& image = spec.base.image;
  const double side = std::max(image.width, image.height);
  const double scale = spec.grid_px == 0 ? 1.0 : std::min(1.0, spec.grid_px / side);
  layout.cell_width_px = std::max(1, static_cast<int>(std::lround(scale * cell_width_px(spec))));
  layout.cell_height_px = std::max(1, static_cast<int>(std::lround(scale * image.height)));
  layout.min_cell_px *= count;
  return layout;
}

/// What stands in a cell of the grid: a cell of the study, from the first of its pictures on.
struct GridPlace {
  size_t cell = 0, first = 0;
};
GridPlace grid_place(const StudySpec& spec, const GridLayout& layout, int column, int row, int page) {
  const size_t line = static_cast<size_t>(page) * layout.rows.values.size() + row;
  if (spec.camera_path) return {line, views_in_grid(spec)[column] * spec.show.size()};
  const size_t index = line * layout.columns.values.size() + column;
  if (cell_is_the_grid(spec)) return {0, index};  // a view a row, a buffer a column
  return {index, 0};
}

/// An earlier run may have needed more pages: grid_2.png, grid_3.png, ... without a gap.
void remove_further_pages(const std::filesystem::path& folder) {
  for (int page = 2; std::filesystem::remove(folder / ("grid_" + std::to_string(page) + ".png")); ++page) {
  }
}

}  // namespace

GridAxis grid_axis(const StudySpec& spec, size_t index) {
  if (index == spec.axes.size() && !spec.variants.empty()) return {"", names_of(spec.variants)};
  if (index >= spec.axes.size()) return {"", {""}};
  return {spec.axes[index].label, spec.axes[index].value_labels};
}

std::vector<size_t> views_in_grid(const StudySpec& spec) {
  const size_t most = !spec.camera_path       ? view_count(spec)
                      : cell_count(spec) == 1 ? kMostFrames
                                              : kMostFramesInRow;
  const size_t step = (view_count(spec) + most - 1) / most;
  std::vector<size_t> views;
  for (size_t view = 0; view < view_count(spec); view += step) views.push_back(view);
  return views;
}

bool is_in_grid(const StudySpec& spec, size_t shown) {
  const std::vector<size_t> views = views_in_grid(spec);
  return std::binary_search(views.begin(), views.end(), shown / spec.show.size());
}

std::string view_label(const StudySpec& spec, size_t view) {
  if (spec.camera_path) return fmt::format("{:.4g}°", degrees_at(*spec.camera_path, static_cast<int>(view)));
  return spec.views.empty() ? "" : spec.views[view].name;
}

CellLayout cell_layout(const StudySpec& spec) {
  const GridPlan plan = plan_grid(make_layout(spec));
  CellLayout layout;
  layout.pictures = pictures_in_cell(spec);
  layout.one_picture = cell_is_the_grid(spec) || (spec.camera_path && layout.pictures == 1);
  layout.picture_width_px = spec.base.image.width;
  layout.width_px = cell_width_px(spec);
  layout.height_px = spec.base.image.height;
  layout.room_width_px = plan.cell_width_px;
  layout.room_height_px = plan.cell_height_px;
  return layout;
}

TilePlace place_of(const CellLayout& layout, size_t shown, const Picture& picture) {
  const int width = layout.one_picture ? picture.width_px : layout.width_px;
  const int height = layout.one_picture ? picture.height_px : layout.height_px;
  const DrawnSize drawn = size_in_cell(width, height, layout.room_width_px, layout.room_height_px);
  const int pitch = layout.picture_width_px + kGapPx;
  const size_t place = shown % layout.pictures;
  const int first = static_cast<int>(place) * pitch;
  const bool is_last = place + 1 == layout.pictures;
  return {width, height, drawn.width_px, drawn.height_px, first, is_last ? width : first + pitch};
}

std::string text_of(const CellLayout& layout, size_t shown) {
  const std::string room = fmt::format("{} x {}", layout.room_width_px, layout.room_height_px);
  if (layout.one_picture) return room;
  return fmt::format("{} of {}, {} wide, {} x {} to {}", shown % layout.pictures, layout.pictures,
                     layout.picture_width_px, layout.width_px, layout.height_px, room);
}

std::vector<std::filesystem::path> write_study_grid(const StudySpec& spec, const StudyFolder& folder,
                                                    const TileSource& tile) {
  const GridLayout layout = make_layout(spec);
  const auto cell_picture = [&](int column, int row, int page) -> std::optional<Picture> {
    const GridPlace place = grid_place(spec, layout, column, row, page);
    if (!folder.is_done(place.cell)) return std::nullopt;
    std::vector<Tile> tiles;
    for (size_t i = 0; i < pictures_in_cell(spec); ++i)
      tiles.push_back(tile(place.cell, place.first + i).tile);
    return joined(std::move(tiles));
  };
  remove_further_pages(folder.path());
  const ImageText text{{"Software", "inkbench " INKBENCH_VERSION},
                       {"inkbench:version", INKBENCH_VERSION},
                       {"inkbench:spec", spec.text}};
  return write_grid(folder.path(), layout, cell_picture, text);
}

}  // namespace inkbench
