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

/// A study of a single cell is laid out by buffer and view; else a cell holds them all, side by side.
bool cell_is_the_grid(const StudySpec& spec) {
  return cell_count(spec) == 1 && picture_count(spec) > 1;
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
  if (spec.views.size() > 1) layout.subtitle += ", from left to right: " + join(names_of(spec.views), ", ");
  layout.columns = grid_axis(spec, 0);
  layout.rows = grid_axis(spec, 1);
  layout.pages = grid_axis(spec, 2);
}

/// Of a cell's pictures side by side, as they are.
int cell_width_px(const StudySpec& spec) {
  const int count = cell_is_the_grid(spec) ? 1 : static_cast<int>(picture_count(spec));
  return spec.base.image.width * count + kGapPx * (count - 1);
}

GridLayout make_layout(const StudySpec& spec) {
  GridLayout layout;
  layout.title = spec.title;
  label_axes(spec, layout);
  const int count = cell_is_the_grid(spec) ? 1 : static_cast<int>(picture_count(spec));
  const ImageParams& image = spec.base.image;
  const double side = std::max(image.width, image.height);
  const double scale = spec.grid_px == 0 ? 1.0 : std::min(1.0, spec.grid_px / side);
  layout.cell_width_px = std::max(1, static_cast<int>(std::lround(scale * cell_width_px(spec))));
  layout.cell_height_px = std::max(1, static_cast<int>(std::lround(scale * image.height)));
  layout.min_cell_px *= count;
  return layout;
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

CellLayout cell_layout(const StudySpec& spec) {
  const GridPlan plan = plan_grid(make_layout(spec));
  CellLayout layout;
  layout.one_picture = cell_is_the_grid(spec);
  layout.pictures = layout.one_picture ? 1 : picture_count(spec);
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
  const int first = layout.one_picture ? 0 : static_cast<int>(shown) * pitch;
  const bool is_last = layout.one_picture || shown + 1 == layout.pictures;
  return {width, height, drawn.width_px, drawn.height_px, first, is_last ? width : first + pitch};
}

std::string text_of(const CellLayout& layout, size_t shown) {
  const std::string room = fmt::format("{} x {}", layout.room_width_px, layout.room_height_px);
  if (layout.one_picture) return room;
  return fmt::format("{} of {}, {} wide, {} x {} to {}", shown, layout.pictures, layout.picture_width_px,
                     layout.width_px, layout.height_px, room);
}

std::vector<std::filesystem::path> write_study_grid(const StudySpec& spec, const StudyFolder& folder,
                                                    const TileSource& tile) {
  const GridLayout layout = make_layout(spec);
  const auto cell_picture = [&](int column, int row, int page) -> std::optional<Picture> {
    const size_t columns = layout.columns.values.size();
    const size_t index = (static_cast<size_t>(page) * layout.rows.values.size() + row) * columns + column;
    if (!folder.is_done(cell_is_the_grid(spec) ? 0 : index)) return std::nullopt;
    std::vector<Tile> tiles;
    if (cell_is_the_grid(spec)) {
      tiles.push_back(tile(0, index).tile);  // a view a row, a buffer a column
    } else {
      for (size_t shown = 0; shown < picture_count(spec); ++shown) tiles.push_back(tile(index, shown).tile);
    }
    return joined(std::move(tiles));
  };
  remove_further_pages(folder.path());
  const ImageText text{{"Software", "inkbench " INKBENCH_VERSION},
                       {"inkbench:version", INKBENCH_VERSION},
                       {"inkbench:spec", spec.text}};
  return write_grid(folder.path(), layout, cell_picture, text);
}

}  // namespace inkbench
