// SPDX-License-Identifier: MIT
#include "studies/sweep/study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <thread>

#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/lines/drawing.h"
#include "studies/sweep/number_columns.h"
#include "studies/sweep/study_grid.h"

namespace inkbench {
namespace {

/// The grid's; variants without an axis are none, since each cell bears its variant's name.
std::vector<PageAxis> page_axes(const StudySpec& spec) {
  const size_t variants = spec.axes.empty() || spec.variants.empty() ? 0 : 1;
  std::vector<PageAxis> axes;
  for (size_t i = 0; i < spec.axes.size() + variants; ++i) {
    const GridAxis axis = grid_axis(spec, i);
    axes.push_back({axis.label, axis.values});
  }
  return axes;
}

/// All but the FILE_ columns, which come last: the page shows the files.
std::vector<PageColumn> page_columns(const StudySpec& spec, const StudyFolder& folder) {
  std::vector<std::string> names = folder.columns();
  names.resize(names.size() - picture_count(spec));
  const std::vector<const Measure*> numbers = study_measures(spec);
  std::vector<PageColumn> columns;
  for (const std::string& name : names) columns.push_back({name, ColumnKind::parameter});
  columns.front().kind = ColumnKind::cell;
  columns.back().kind = ColumnKind::error;
  if (!spec.variants.empty()) columns[1].kind = ColumnKind::name;
  for (size_t i = 0; i < numbers.size(); ++i) {
    PageColumn& column = columns[columns.size() - 1 - numbers.size() + i];
    column.kind = ColumnKind::number;
    column.help = numbers[i]->help;
  }
  return columns;
}

PageCell page_cell(const StudySpec& spec, const StudyFolder& folder, size_t index, size_t columns) {
  PageCell cell;
  cell.name = make_cell(spec, index).name;
  cell.row = folder.fields(index);
  if (!cell.row.empty()) cell.row.resize(columns);
  if (folder.is_done(index)) {
    cell.pictures = folder.picture_files(index);
    for (size_t view = 0; finds_lines(spec) && view < view_count(spec); ++view)
      cell.overlays.push_back(folder.overlay_file(index, view));
    for (size_t view = 0; finds_causes(spec) && view < view_count(spec); ++view)
      cell.causes.push_back(folder.cause_file(index, view));
  } else if (!cell.row.empty()) {
    cell.error = cell.row.back();
  }
  return cell;
}

std::vector<std::string> facts(const StudySpec& spec, const StudyFolder& folder, const StudyOrigin& origin) {
  std::vector<std::string> sides;
  for (const PageAxis& axis : page_axes(spec)) sides.push_back(std::to_string(axis.values.size()));
  const size_t count = cell_count(spec);
  const size_t failed = count - folder.done_count();
  const ImageParams& image = spec.base.image;
  const std::string along = spec.camera_path ? " along " + counted(view_count(spec), "frame", "frames") : "";
  return {counted(count, "cell", "cells") + (sides.size() > 1 ? " (" + join(sides, " × ") + ")" : "") + along,
          std::to_string(image.width) + " × " + std::to_string(image.height) + " px",
          spec.show.size() == 1 ? std::string(name_of(spec.show.front()))
                                : counted(spec.show.size(), "buffer", "buffers"),
          origin.renderer,
          failed == 0 ? "finished" : "finished, " + counted(failed, "cell", "cells") + " failed"};
}

std::vector<PageChart> page_charts(const std::vector<DrawnChart>& charts) {
  std::vector<PageChart> shown;
  for (const DrawnChart& chart : charts) {
    PageChart& entry = shown.emplace_back(PageChart{chart.title, read_file(chart.svg), {}});
    for (const auto& [text, file] :
         {std::pair("SVG", chart.svg), {"PNG", chart.png}, {"gnuplot", chart.script}})
      entry.links.push_back({text, ("charts" / file.filename()).string()});
  }
  return shown;
}

std::vector<PageCause> page_causes() {
  std::vector<PageCause> causes;
  for (const CauseInfo& info : cause_table()) {
    const auto [r, g, b] = info.colour;
    causes.push_back({(info.is_of_missed() ? "missed: " : "false: ") + std::string(info.name),
                      fmt::format("#{:02x}{:02x}{:02x}", r, g, b),
                      fmt::format("{} Would mend it: {}.", info.help, info.remedy)});
  }
  return causes;
}

StudyPage make_page(const StudySpec& spec, const StudyFolder& folder, const StudyOrigin& origin,
                    const std::vector<DrawnChart>& charts) {
  StudyPage page;
  page.title = spec.title;
  page.purpose = spec.purpose;
  page.facts = facts(spec, folder, origin);
  page.width_px = spec.base.image.width;
  page.height_px = spec.base.image.height;
  for (size_t view = 0; view < view_count(spec); ++view) page.views.push_back(view_label(spec, view));
  for (const BufferName buffer : spec.show) page.buffers.emplace_back(name_of(buffer));
  page.axes = page_axes(spec);
  page.columns = page_columns(spec, folder);
  page.cell_count = cell_count(spec);
  for (size_t i = 0; i < std::min(page.cell_count, kMaxPageCells); ++i)
    page.cells.push_back(page_cell(spec, folder, i, page.columns.size()));
  for (const LineClass line_class : kLineClasses) {
    const auto [r, g, b] = colour_of(line_class);
    page.overlay_classes.emplace_back(name_of(line_class), fmt::format("#{:02x}{:02x}{:02x}", r, g, b));
  }
  if (finds_causes(spec)) page.causes = page_causes();
  page.charts = page_charts(charts);
  page.kind = origin.extras.kind;
  page.verdict = origin.extras.verdict;
  page.tables = origin.extras.tables;
  page.links = origin.extras.links;
  page.command = origin.command;
  page.versions = origin.versions;
  page.spec_name = spec.path.filename().string();
  page.spec_text = spec.text;
  return page;
}

size_t worker_count() {
  return std::clamp<size_t>(std::thread::hardware_concurrency(), 1, 8);
}

}  // namespace

StudyPageWriter::StudyPageWriter(const StudySpec& spec, const StudyFolder& folder, const StudyOrigin& origin,
                                 const std::vector<DrawnChart>& charts, CellTiles& tiles)
    : folder_(folder.path()),
      tiles_(tiles),
      page_(make_page(spec, folder, origin, charts)),
      plan_(plan_thumbnails(page_.cells.size(), picture_count(spec), thumbnail_room(page_))),
      workers_(worker_count(), worker_count()) {
  for (PageCell& cell : page_.cells) cell.thumbnails.resize(std::min(cell.pictures.size(), plan_.per_cell));
}

void StudyPageWriter::add(size_t cell, size_t shown, const KeptPicture& kept) {
  if (cell >= page_.cells.size() || shown >= plan_.per_cell) return;
  if (const std::optional<std::string> text = chosen_thumbnail(kept.thumbnails, plan_)) {
    page_.cells[cell].thumbnails[shown] = *text;
  } else {
    workers_.add([this, cell, shown] { make_thumbnail(cell, shown); });
  }
}

void StudyPageWriter::make_thumbnail(size_t cell, size_t shown) {
  try {
    const Picture picture = tiles_.decode(folder_ / page_.cells[cell].pictures[shown]);
    page_.cells[cell].thumbnails[shown] = thumbnail(picture, plan_);
  } catch (...) {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
  }
}

fs::path StudyPageWriter::write(const std::vector<fs::path>& grids) {
  workers_.wait();
  if (failure_) std::rethrow_exception(failure_);
  page_.links.push_back({"data.csv", "data.csv"});
  page_.links.push_back({"manifest.json", "manifest.json"});
  for (const fs::path& grid : grids)
    page_.links.push_back({grid.filename().string(), grid.filename().string()});
  const fs::path path = folder_ / "index.html";
  write_file_atomically(path, page_html(page_));
  return path;
}

}  // namespace inkbench
