#include "studies/sweep/study_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/base/text.h"
#include "pipeline/image/image_file.h"
#include "studies/report/grid.h"

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

/// Copies a picture into another at x; a picture of another size (an axis may vary it) is cut.
void paste(Picture& target, const Picture& source, int x) {
  const int width = std::min(source.width_px, target.width_px - x);
  for (int y = 0; y < std::min(source.height_px, target.height_px); ++y) {
    std::copy_n(&source.at(0, y), static_cast<size_t>(width) * 3, &target.at(x, y));
  }
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
  GridAxis labels{spec.axes[index].label, {}};
  for (const Value& value : spec.axes[index].values) labels.values.push_back(label_text(value));
  return labels;
}

std::vector<std::filesystem::path> write_study_grid(const StudySpec& spec, const StudyFolder& folder,
                                                    const PictureSink& on_picture) {
  const GridLayout layout = make_layout(spec);
  const auto read = [&](size_t index, size_t shown) {
    const std::vector<std::string> files = folder.picture_files(index);
    Picture picture = read_picture(folder.path() / files[shown], 3);
    on_picture(index, shown, picture);
    return picture;
  };
  const auto cell_picture = [&](int column, int row, int page) -> std::optional<Picture> {
    const size_t columns = layout.columns.values.size();
    const size_t index = (static_cast<size_t>(page) * layout.rows.values.size() + row) * columns + column;
    if (!folder.is_done(cell_is_the_grid(spec) ? 0 : index)) return std::nullopt;
    if (cell_is_the_grid(spec)) return read(0, index);  // a view a row, a buffer a column
    Picture picture(cell_width_px(spec), spec.base.image.height, 3, 255);
    int x = 0;
    for (size_t shown = 0; shown < picture_count(spec); ++shown) {
      paste(picture, read(index, shown), x);
      x += spec.base.image.width + kGapPx;
    }
    return picture;
  };
  remove_further_pages(folder.path());
  const ImageText text{{"Software", "inkbench " INKBENCH_VERSION},
                       {"inkbench:version", INKBENCH_VERSION},
                       {"inkbench:spec", spec.text}};
  return write_grid(folder.path(), layout, cell_picture, text);
}

}  // namespace inkbench
