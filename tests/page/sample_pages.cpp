// SPDX-License-Identifier: MIT
// Writes report pages that no bundled study has: `sample_pages full FOLDER` one with everything (three axes,
// two views, reference lines, charts, failed and missing cells, texts that try to break out);
// `sample_pages large FOLDER` one of 10,000 cells.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/image/image_file.h"
#include "studies/report/page.h"
#include "studies/report/thumbnail.h"

namespace inkbench {
namespace {

constexpr int kWidthPx = 240;
constexpr int kHeightPx = 160;
constexpr size_t kRings = 25;
constexpr const char* kHostile =
    "</script><script>window.broken = 1</script><img src=x onerror='window.broken = 1'> \"quoted\" & <b>bold";

/// A ring whose size says which cell it is, in one of two drawings.
Picture ring(size_t cell, size_t picture) {
  const bool is_dark = picture % 2 == 1;
  Picture result(kWidthPx, kHeightPx, 3, is_dark ? 0 : 255);
  const double radius = 20.0 + static_cast<double>(cell % kRings) * 2 + (picture >= 2 ? 5 : 0);
  for (int y = 0; y < kHeightPx; ++y) {
    for (int x = 0; x < kWidthPx; ++x) {
      const double distance = std::hypot(x + 0.5 - kWidthPx / 2.0, y + 0.5 - kHeightPx / 2.0);
      if (std::abs(distance - radius) > 1.5) continue;
      for (int i = 0; i < 3; ++i) result.at(x, y, i) = is_dark ? 255 : 0;
    }
  }
  return result;
}

std::string overlay_svg(int radius) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
      "<g fill=\"none\" stroke=\"#000000\"><circle cx=\"{2}\" cy=\"{3}\" r=\"{4}\"/></g>\n"
      "<g fill=\"none\" stroke=\"#0072b2\"><path d=\"M20 20L{2} {3}\"/></g>\n</svg>\n",
      kWidthPx, kHeightPx, kWidthPx / 2, kHeightPx / 2, radius);
}

std::string chart_svg() {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 480 300\" width=\"480\" height=\"300\">"
         "<path d=\"M40 20V260H460\" fill=\"none\" stroke=\"#444\"/>"
         "<path d=\"M60 230L160 150L260 170L360 90L440 60\" fill=\"none\" stroke=\"#0072b2\" "
         "stroke-width=\"2\"/></svg>";
}

PageCell picture_cell(const fs::path& folder, size_t index) {
  PageCell cell;
  for (size_t i = 0; i < 4; ++i) {
    const char* names[] = {"front_final", "front_edges", "back_final", "back_edges"};
    cell.pictures.push_back(fmt::format("cells/{:04}_{}.png", index + 1, names[i]));
    const Picture picture = ring(index, i);
    write_png(folder / cell.pictures.back(), picture, {});
    cell.thumbnails.push_back(thumbnail(picture, plan_thumbnails(24, 4, 1'000'000)));
  }
  cell.overlays = {fmt::format("reference/{:016x}.svg", index % 3), ""};
  cell.causes = {fmt::format("causes/{:016x}.png", 0), ""};
  return cell;
}

StudyPage frame(const std::string& title, size_t columns, size_t rows, size_t pages) {
  StudyPage page;
  page.title = title;
  page.purpose = "A page with everything that a page can have";
  page.width_px = kWidthPx;
  page.height_px = kHeightPx;
  page.axes = {{"k depth", {}}, {"k normal", {}}, {"light", {}}};
  for (size_t i = 0; i < columns; ++i) page.axes[0].values.push_back(fmt::format("{}", 0.001 * (i + 1)));
  for (size_t i = 0; i < rows; ++i) page.axes[1].values.push_back(fmt::format("{}", 0.01 * (i + 1)));
  for (size_t i = 0; i < pages; ++i) page.axes[2].values.push_back(fmt::format("from {}", i + 1));
  if (pages == 1) page.axes.pop_back();
  page.cell_count = columns * rows * pages;
  page.facts = {fmt::format("{} cells", page.cell_count), "240 × 160 px", "finished"};
  page.columns = {{"cell", ColumnKind::cell},
                  {"combine.k_depth", ColumnKind::parameter},
                  {"combine.k_normal", ColumnKind::parameter},
                  {"light.key.direction", ColumnKind::parameter},
                  {"f1", ColumnKind::number},
                  {"breaks_per_100px", ColumnKind::number},
                  {"error", ColumnKind::error}};
  page.command = "inkbench study 'sample \"1\".toml'";
  page.versions = {{"inkbench", INKBENCH_VERSION}};
  page.spec_name = "sample.toml";
  return page;
}

/// Numbers whose order as text is another than as numbers; one is missing, one not a number.
std::vector<std::string> row(const StudyPage& page, size_t index, const std::string& error) {
  const size_t columns = page.axes[0].values.size();
  const std::string f1 = index == 4 ? "" : index == 5 ? "nan" : fmt::format("{}", std::pow(0.5, index % 9));
  return {std::to_string(index + 1),
          page.axes[0].values[index % columns],
          page.axes[1].values[index / columns % page.axes[1].values.size()],
          "[1, 1, 0.5]",
          error.empty() ? f1 : "",
          error.empty() ? fmt::format("{}", (index * 37) % 101 * 1.25) : "",
          error};
}

StudyPage full_page(const fs::path& folder) {
  StudyPage page = frame(kHostile, 4, 3, 2);
  page.spec_text = fmt::format("title = '''{}'''\n# <!-- \u2028 \xff\n", kHostile);
  page.views = {"front", "back"};
  page.buffers = {"final", "edges"};
  page.overlay_classes = {{"silhouette", "#000000"}, {"crease", "#0072b2"}};
  for (int i = 0; i < 3; ++i)
    write_file_atomically(folder / fmt::format("reference/{:016x}.svg", i), overlay_svg(30 + 10 * i));
  page.causes = {{"false: grazing", "#d55e00", "The depth term sees a slope."}};
  Picture dots(kWidthPx, kHeightPx, 4);
  for (int c = 0; c < 4; ++c) dots.at(40, 30, c) = 255;
  write_png(folder / fmt::format("causes/{:016x}.png", 0), dots, {});
  for (size_t i = 0; i < page.cell_count; ++i) {
    PageCell cell = i == 6 || i == 7 ? PageCell{} : picture_cell(folder, i);
    if (i == 6) cell.error = kHostile;
    if (i != 7) cell.row = row(page, i, cell.error);
    cell.name = fmt::format("k_depth = {}, cell {}", page.axes[0].values[i % 4], i == 2 ? kHostile : "plain");
    page.cells.push_back(std::move(cell));
  }
  page.charts = {{"f1 against k depth", chart_svg(), {{"chart.svg", "chart.svg"}}},
                 {kHostile, chart_svg(), {{"script", "charts/a b.gp"}}}};
  page.links = {{"data.csv", "data.csv"}, {"manifest.json", "manifest.json"}};
  return page;
}

StudyPage large_page() {
  StudyPage page = frame("Ten thousand cells", 100, 100, 1);
  page.views = {""};
  page.buffers = {"final"};
  for (size_t i = 0; i < page.cell_count; ++i) {
    PageCell cell;
    cell.name = fmt::format("k_depth = {}, k_normal = {}", i % 100, i / 100);
    cell.pictures = {fmt::format("cells/{:05}_final.png", i + 1)};
    cell.row = row(page, i, "");
    page.cells.push_back(std::move(cell));
  }
  const ThumbnailPlan plan = plan_thumbnails(page.cell_count, 1, thumbnail_room(page));
  std::vector<std::string> thumbnails;
  for (size_t i = 0; i < kRings; ++i) thumbnails.push_back(thumbnail(ring(i, 0), plan));
  for (size_t i = 0; i < page.cell_count; ++i) page.cells[i].thumbnails = {thumbnails[i % kRings]};
  return page;
}

int write_page(const std::string& kind, const fs::path& folder) {
  try {
    make_folder(folder);
    write_file_atomically(folder / "index.html",
                          page_html(kind == "large" ? large_page() : full_page(folder)));
    return 0;
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}

}  // namespace
}  // namespace inkbench

int main(int count, char** arguments) {
  if (count != 3) return 2;
  return inkbench::write_page(arguments[1], arguments[2]);
}
