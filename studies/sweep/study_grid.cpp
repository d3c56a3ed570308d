#include "studies/sweep/study_grid.h"

#include <algorithm>

#include "pipeline/base/text.h"
#include "pipeline/image/image_file.h"
#include "studies/report/grid.h"

namespace inkbench {
namespace {

constexpr int kGapPx = 4;  ///< Between the buffers of one cell.

GridAxis axis_labels(const StudySpec& spec, size_t index) {
  if (index >= spec.axes.size()) return {"", {""}};
  GridAxis labels{spec.axes[index].label, {}};
  for (const Value& value : spec.axes[index].values) labels.values.push_back(label_text(value));
  return labels;
}

/// A study of a single cell has its buffers for columns; else a cell holds them all, side by side.
bool buffers_are_columns(const StudySpec& spec) {
  return cell_count(spec) == 1 && spec.show.size() > 1;
}

std::vector<std::string> shown_names(const StudySpec& spec) {
  std::vector<std::string> names;
  for (const BufferName buffer : spec.show) names.emplace_back(name_of(buffer));
  return names;
}

GridLayout make_layout(const StudySpec& spec) {
  GridLayout layout;
  layout.title = spec.title;
  const ImageParams& image = spec.base.image;
  const std::string size = std::to_string(image.width) + " x " + std::to_string(image.height) + " px";
  layout.subtitle = join(shown_names(spec), ", ") + " at " + size;
  layout.columns = axis_labels(spec, 0);
  layout.rows = axis_labels(spec, 1);
  layout.pages = axis_labels(spec, 2);
  if (!spec.variants.empty()) {
    layout.columns.values.clear();
    for (const Variant& variant : spec.variants) layout.columns.values.push_back(variant.name);
  }
  const int count = buffers_are_columns(spec) ? 1 : static_cast<int>(spec.show.size());
  if (buffers_are_columns(spec)) {
    layout.columns = {"", shown_names(spec)};
    layout.subtitle = size;
  }
  layout.cell_width_px = spec.base.image.width * count + kGapPx * (count - 1);
  layout.cell_height_px = spec.base.image.height;
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

std::vector<std::filesystem::path> write_study_grid(const StudySpec& spec, const StudyFolder& folder,
                                                    const PictureSink& on_picture) {
  const GridLayout layout = make_layout(spec);
  const auto read = [&](size_t index, size_t shown) {
    Picture picture = read_picture(folder.path() / folder.cell_file(index, spec.show[shown]), 3);
    on_picture(index, shown, picture);
    return picture;
  };
  const auto cell_picture = [&](int column, int row, int page) -> std::optional<Picture> {
    const size_t columns = layout.columns.values.size();
    const size_t index = (static_cast<size_t>(page) * layout.rows.values.size() + row) * columns + column;
    if (buffers_are_columns(spec)) {
      if (!folder.is_done(0)) return std::nullopt;
      return read(0, static_cast<size_t>(column));
    }
    if (!folder.is_done(index)) return std::nullopt;
    Picture picture(layout.cell_width_px, layout.cell_height_px, 3, 255);
    int x = 0;
    for (size_t shown = 0; shown < spec.show.size(); ++shown) {
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
