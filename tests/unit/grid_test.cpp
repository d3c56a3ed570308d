// SPDX-License-Identifier: MIT
#include "studies/report/grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <set>
#include <utility>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "studies/report/grid_plan.h"

namespace inkbench {
namespace {

std::vector<std::string> numbers(int count) {
  std::vector<std::string> values;
  for (int i = 0; i < count; ++i) values.push_back("0." + std::to_string(100 + i));
  return values;
}

GridLayout layout_of(int columns, int rows, int width_px, int height_px) {
  GridLayout layout;
  layout.title = "K comparison: bunny, 69,666 triangles";
  layout.subtitle = "combine.k_depth against combine.k_normal";
  layout.columns = {"k depth", numbers(columns)};
  layout.rows = {"k normal", numbers(rows)};
  layout.pages = {"", {""}};
  layout.cell_width_px = width_px;
  layout.cell_height_px = height_px;
  return layout;
}

GridLayout variants(const std::vector<std::string>& names, int side_px) {
  GridLayout layout = layout_of(1, 1, side_px, side_px);
  layout.columns = {"", names};
  layout.rows = {"", {""}};
  return layout;
}

/// A picture that differs from every other cell's in every row.
Picture cell_picture(const GridLayout& layout, int column, int row, int page) {
  Picture picture(layout.cell_width_px, layout.cell_height_px, 3);
  uint32_t seed = static_cast<uint32_t>(column * 7919 + row * 104729 + page * 1299709 + 1);
  for (uint8_t& sample : picture.samples) {
    seed = seed * 1664525U + 1013904223U;
    sample = static_cast<uint8_t>(seed >> 24);
  }
  return picture;
}

Picture part_of(const Picture& picture, int x, int y, int width, int height) {
  Picture part(width, height, 3);
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width * 3; ++i) part.at(i / 3, j, i % 3) = picture.at(x + i / 3, y + j, i % 3);
  }
  return part;
}

struct Box {
  int left, top, right, bottom;
  bool overlaps(const Box& o) const {
    return left < o.right && o.left < right && top < o.bottom && o.top < bottom;
  }
};

Box box_of(const GridLine& line) {
  const int size = line.style.size_px;
  const int length = text_width_px(line.text, size, line.style.face);
  const int above = size * 3 / 4, below = size / 4;
  if (line.upwards) return {line.x_px - above, line.y_px - length, line.x_px + below, line.y_px};
  return {line.x_px, line.y_px - above, line.x_px + length, line.y_px + below};
}

/// All boxes of a sheet: texts, then cells with their frames.
std::vector<Box> boxes_of(const GridPlan& plan, const GridSheet& sheet) {
  std::vector<Box> boxes;
  for (const GridLine& line : sheet.lines) boxes.push_back(box_of(line));
  for (const GridSlot& slot : sheet.slots) {
    const int f = plan.frame_px;
    boxes.push_back({slot.x_px - f, slot.y_px - f, slot.x_px + plan.cell_width_px + f,
                     slot.y_px + plan.cell_height_px + f});
  }
  return boxes;
}

std::string all_text(const GridSheet& sheet) {
  std::string text;
  for (const GridLine& line : sheet.lines) text += line.text + "\n";
  return text;
}

struct NamedLayout {
  std::string name;
  GridLayout layout;
};

std::vector<std::string> long_names() {
  return {"defaults", "k_normal = 0.025 (too large)", "no edges at all",
          "k_depth = 0.003 and k_normal = 0.05, no normal map", "e"};
}

std::vector<NamedLayout> many_layouts() {
  std::vector<NamedLayout> all = {
      {"strip", layout_of(3, 1, 512, 512)},
      {"square", layout_of(7, 7, 512, 512)},
      {"wide_cells", layout_of(4, 3, 640, 360)},
      {"one_pixel_cells", layout_of(5, 4, 1, 1)},
      {"tiny_cells", layout_of(5, 4, 8, 8)},
      {"flat_cells", layout_of(5, 4, 300, 1)},
      {"huge_cells", layout_of(5, 3, 4096, 4096)},
      {"many", layout_of(40, 50, 256, 256)},
      {"very_many_columns", layout_of(500, 2, 64, 64)},
      {"very_many_rows", layout_of(2, 500, 64, 64)},
      {"small_sheets", layout_of(9, 9, 512, 512)},
      {"tiny_in_small_sheets", layout_of(90, 90, 3, 5)},
      {"no_title", layout_of(3, 3, 100, 100)},
      {"variants", variants(long_names(), 512)},
      {"tiny_variants", variants({"defaults", "k_normal = 0.025 (too large)", "z"}, 1)},
      {"many_variants", variants(numbers(1000), 512)},
      {"endless_words", variants({std::string(3000, 'w'), std::string(50, 'm')}, 200)},
      {"long_texts", layout_of(2, 3, 200, 200)},
      {"pages", layout_of(3, 2, 200, 200)},
      {"long_row", layout_of(12, 1, 200, 200)},
      {"long_column", layout_of(1, 30, 200, 200)},
      {"other_scripts", layout_of(2, 2, 60, 60)}};
  for (auto& [name, layout] : all) {
    if (name == "small_sheets" || name == "tiny_in_small_sheets") layout.max_side_px = 1024;
    if (name == "no_title") layout.title = layout.subtitle = layout.columns.label = "";
    if (name == "long_texts") {
      for (int i = 0; i < 40; ++i) layout.title += " and a title that goes on";
      layout.subtitle = layout.columns.label = layout.rows.label = layout.title;
      layout.rows.values[1] = layout.columns.values[0] = layout.title.substr(0, 200);
    }
    if (name == "pages") layout.pages = {"light azimuth", {"0", "45", "90 and some more"}};
    if (name == "long_row" || name == "strip") layout.rows = {"", {""}};
    if (name == "long_column") layout.columns = {"", {""}};
    if (name == "other_scripts")
      layout.columns.values = {"30\xc2\xb0 \xce\xb1 \xe7\xb7\x9a", "broken \xff\xc3"};
  }
  return all;
}

class AnyGrid : public testing::TestWithParam<NamedLayout> {
 protected:
  const GridLayout& layout() const { return GetParam().layout; }
  GridPlan plan_ = plan_grid(GetParam().layout);
};
INSTANTIATE_TEST_SUITE_P(Grid, AnyGrid, testing::ValuesIn(many_layouts()),
                         [](const auto& p) { return p.param.name; });

TEST_P(AnyGrid, no_sheet_is_longer_than_allowed) {
  for (const GridSheet& sheet : plan_.sheets) {
    EXPECT_LE(sheet.width_px, layout().max_side_px);
    EXPECT_LE(sheet.height_px, layout().max_side_px);
  }
}

TEST_P(AnyGrid, nothing_leaves_its_sheet) {
  for (const GridSheet& sheet : plan_.sheets) {
    for (const Box& box : boxes_of(plan_, sheet)) {
      ASSERT_TRUE(box.left >= 0 && box.top >= 0 && box.right <= sheet.width_px &&
                  box.bottom <= sheet.height_px)
          << box.left << ' ' << box.top << ' ' << box.right << ' ' << box.bottom;
    }
  }
}

TEST_P(AnyGrid, no_text_overlaps_text_or_cells) {
  const GridSheet& sheet = plan_.sheets.back();
  const std::vector<Box> boxes = boxes_of(plan_, sheet);
  for (size_t i = 0; i < sheet.lines.size(); ++i) {
    for (size_t j = i + 1; j < boxes.size(); ++j) {
      ASSERT_FALSE(boxes[i].overlaps(boxes[j])) << sheet.lines[i].text << " and box " << j;
    }
  }
}

TEST_P(AnyGrid, text_is_never_smaller_than_14_px) {
  for (const GridLine& line : plan_.sheets.front().lines) EXPECT_GE(line.style.size_px, 14) << line.text;
}

TEST_P(AnyGrid, every_cell_is_placed_once) {
  std::set<std::tuple<int, int, int>> seen;
  size_t placed = 0;
  for (const GridSheet& sheet : plan_.sheets) {
    for (const GridSlot& slot : sheet.slots) seen.insert({sheet.page, slot.row, slot.column});
    placed += sheet.slots.size();
  }
  const GridLayout& l = layout();
  EXPECT_EQ(placed, seen.size());
  EXPECT_EQ(placed, l.pages.values.size() * l.rows.values.size() * l.columns.values.size());
}

TEST_P(AnyGrid, cells_keep_their_aspect) {
  const double scale_x = static_cast<double>(plan_.cell_width_px) / layout().cell_width_px;
  const double scale_y = static_cast<double>(plan_.cell_height_px) / layout().cell_height_px;
  EXPECT_LE(scale_x, 1.0);
  EXPECT_NEAR(scale_x * layout().cell_height_px, scale_y * layout().cell_height_px, 1.0);
}

TEST(Grid, extreme_shapes_are_planned) {
  for (const auto& [columns, rows] : {std::pair{1, 10000}, {10000, 1}, {300, 300}, {2, 10000}}) {
    GridLayout layout = layout_of(columns, rows, 512, 512);
    if (columns == 1) layout.columns = {"", {""}};
    if (rows == 1) layout.rows = {"", {""}};
    const GridPlan plan = plan_grid(layout);
    size_t placed = 0;
    for (const GridSheet& sheet : plan.sheets) placed += sheet.slots.size();
    EXPECT_EQ(placed, static_cast<size_t>(columns) * rows);
    EXPECT_EQ(plan.cell_width_px, layout.min_cell_px);
  }
}

TEST(Grid, cells_shrink_before_the_grid_is_split) {
  GridLayout layout = layout_of(5, 5, 512, 512);
  layout.max_side_px = 1500;
  const GridPlan plan = plan_grid(layout);
  EXPECT_EQ(plan.sheets.size(), 1U);
  EXPECT_LT(plan.cell_width_px, 300);
  EXPECT_GE(plan.cell_width_px, layout.min_cell_px);
  EXPECT_GT(std::max(plan.sheets[0].width_px, plan.sheets[0].height_px), 1400);  // No smaller than needed.
}

TEST(Grid, parts_carry_the_labels_of_their_own_cells) {
  GridLayout layout = layout_of(9, 2, 512, 512);
  layout.max_side_px = 1024;
  const GridPlan plan = plan_grid(layout);
  ASSERT_GE(plan.sheets.size(), 2U);
  for (const GridSheet& sheet : plan.sheets) {
    std::set<std::string> own;
    for (const GridSlot& slot : sheet.slots) own.insert(layout.columns.values[slot.column]);
    for (const std::string& value : layout.columns.values) {
      if (layout.rows.values[0] == value || layout.rows.values[1] == value) continue;
      EXPECT_EQ(all_text(sheet).find(value) != std::string::npos, own.contains(value)) << value;
    }
    EXPECT_THAT(all_text(sheet), testing::HasSubstr("part "));
    EXPECT_THAT(all_text(sheet), testing::HasSubstr("k depth"));
  }
}

TEST(Grid, column_values_stand_centred_above_their_cells) {
  const GridLayout layout = layout_of(4, 1, 200, 200);
  const GridPlan plan = plan_grid(layout);
  for (const GridSlot& slot : plan.sheets[0].slots) {
    const auto& lines = plan.sheets[0].lines;
    const auto above = std::find_if(lines.begin(), lines.end(), [&](const GridLine& line) {
      return line.text == layout.columns.values[slot.column] && line.y_px < slot.y_px;
    });
    ASSERT_NE(above, lines.end());
    const Box box = box_of(*above);
    EXPECT_NEAR((box.left + box.right) / 2.0, slot.x_px + 100.0, 1.5);
  }
}

TEST(Grid, row_label_reads_upwards) {
  const GridPlan plan = plan_grid(layout_of(2, 2, 200, 200));
  for (const GridLine& line : plan.sheets[0].lines)
    EXPECT_EQ(line.upwards, line.text == "k normal") << line.text;
}

TEST(Grid, type_grows_with_the_sheet) {
  const GridPlan small = plan_grid(layout_of(2, 2, 256, 256)),
                 large = plan_grid(layout_of(10, 10, 1024, 1024));
  for (const GridPlan& plan : {small, large}) {
    const double share = static_cast<double>(plan.text_px) / plan.sheets[0].width_px;
    EXPECT_GT(share, 1 / 80.0);
    EXPECT_LT(share, 1 / 30.0);
  }
}

TEST(Grid, up_to_five_variants_stand_in_a_row_and_more_in_a_block) {
  const auto rows_of = [](int count) {
    const GridPlan plan = plan_grid(variants(numbers(count), 256));
    std::map<int, int> rows;
    for (const GridSlot& slot : plan.sheets[0].slots) ++rows[slot.y_px];
    std::vector<int> lengths;
    for (const auto& [y, length] : rows) lengths.push_back(length);
    return lengths;
  };
  EXPECT_EQ(rows_of(5), (std::vector{5}));
  EXPECT_EQ(rows_of(6), (std::vector{3, 3}));
  EXPECT_EQ(rows_of(9), (std::vector{3, 3, 3}));
  EXPECT_EQ(rows_of(12), (std::vector{4, 4, 4}));
}

TEST(Grid, page_is_named_on_each_sheet) {
  GridLayout layout = layout_of(2, 2, 100, 100);
  layout.pages = {"light", {"left", "right"}};
  const GridPlan plan = plan_grid(layout);
  ASSERT_EQ(plan.sheets.size(), 2U);
  EXPECT_THAT(all_text(plan.sheets[0]), testing::HasSubstr("light = left"));
  EXPECT_THAT(all_text(plan.sheets[1]), testing::HasSubstr("light = right"));
}

class WrittenGrid : public testing::Test {
 protected:
  WrittenGrid()
      : folder_(fs::path(testing::TempDir()) /
                ("grid_" + std::to_string(getpid()) +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(folder_);
  }
  ~WrittenGrid() override { fs::remove_all(folder_); }

  CellSource cells(const GridLayout& layout) {
    return [this, &layout](int column, int row, int page) {
      asked_.push_back({page, row, column});
      return cell_picture(layout, column, row, page);
    };
  }

  fs::path folder_;
  std::vector<std::tuple<int, int, int>> asked_;
};

TEST_F(WrittenGrid, cells_at_scale_one_are_copied_exactly) {
  GridLayout layout = layout_of(3, 2, 61, 47);
  layout.pages = {"p", {"1", "2"}};
  const std::vector<fs::path> paths = write_grid(folder_, layout, cells(layout), {});
  EXPECT_THAT(paths, testing::ElementsAre(folder_ / "grid.png", folder_ / "grid_2.png"));
  const GridPlan plan = plan_grid(layout);
  for (size_t i = 0; i < paths.size(); ++i) {
    const Picture sheet = read_picture(paths[i], 3);
    ASSERT_EQ(sheet.width_px, plan.sheets[i].width_px);
    ASSERT_EQ(sheet.height_px, plan.sheets[i].height_px);
    for (const GridSlot& slot : plan.sheets[i].slots) {
      EXPECT_EQ(part_of(sheet, slot.x_px, slot.y_px, 61, 47),
                cell_picture(layout, slot.column, slot.row, static_cast<int>(i)));
    }
  }
}

TEST_F(WrittenGrid, cells_are_asked_for_once_in_order) {
  GridLayout layout = layout_of(3, 2, 10, 10);
  layout.pages = {"p", {"1", "2"}};
  write_grid(folder_, layout, cells(layout), {});
  EXPECT_EQ(asked_.size(), 12U);
  EXPECT_TRUE(std::is_sorted(asked_.begin(), asked_.end()));
  EXPECT_EQ(std::adjacent_find(asked_.begin(), asked_.end()), asked_.end());
}

TEST_F(WrittenGrid, same_input_gives_same_bytes) {
  const GridLayout layout = layout_of(3, 2, 300, 200);
  const std::string first =
      read_file(write_grid(folder_, layout, cells(layout), {{"inkbench:settings", "a"}})[0]);
  EXPECT_EQ(read_file(write_grid(folder_, layout, cells(layout), {{"inkbench:settings", "a"}})[0]), first);
}

TEST_F(WrittenGrid, text_entries_are_in_every_sheet) {
  GridLayout layout = layout_of(2, 2, 20, 20);
  layout.pages = {"p", {"1", "2"}};
  for (const fs::path& path :
       write_grid(folder_, layout, cells(layout), {{"inkbench:settings", "a = 1\nb = 2"}})) {
    EXPECT_EQ(read_image_text(path, "inkbench:settings"), "a = 1\nb = 2");
  }
}

TEST_F(WrittenGrid, every_planned_text_leaves_ink_where_it_was_planned) {
  GridLayout layout = layout_of(2, 3, 40, 40);  // The row label crosses several strips.
  layout.rows.label = "a row label as long as its cells";
  const GridPlan plan = plan_grid(layout);
  const Picture sheet = read_picture(write_grid(folder_, layout, cells(layout), {})[0], 3);
  for (const GridLine& line : plan.sheets[0].lines) {
    const Box box = box_of(line);
    Picture expected(sheet.width_px, sheet.height_px, 3, 255);
    draw_text(expected, line.x_px, line.y_px, line.text, line.style, line.upwards);
    const auto part = [&](const Picture& p) {
      return part_of(p, box.left, box.top, box.right - box.left, box.bottom - box.top);
    };
    EXPECT_EQ(part(sheet), part(expected)) << line.text;
    EXPECT_NE(part(sheet), Picture(box.right - box.left, box.bottom - box.top, 3, 255)) << line.text;
  }
}

TEST_F(WrittenGrid, sheet_is_white_outside_cells_and_texts) {
  const GridLayout layout = layout_of(3, 2, 50, 50);
  const GridPlan plan = plan_grid(layout);
  Picture sheet = read_picture(write_grid(folder_, layout, cells(layout), {})[0], 3);
  for (const Box& box : boxes_of(plan, plan.sheets[0])) {
    // Letters may lean two pixels out of their box.
    for (int y = box.top - 2; y < box.bottom + 2; ++y) {
      for (int x = box.left - 2; x < box.right + 2; ++x) std::fill_n(&sheet.at(x, y), 3, 255);
    }
  }
  EXPECT_EQ(sheet, Picture(sheet.width_px, sheet.height_px, 3, 255));
}

TEST_F(WrittenGrid, failed_cells_are_light_hatching_with_a_word) {
  const GridLayout layout = layout_of(2, 2, 200, 200);
  const auto failing = [](int, int, int) { return std::optional<Picture>(); };
  const Picture sheet = read_picture(write_grid(folder_, layout, failing, {})[0], 3);
  const GridSlot slot = plan_grid(layout).sheets[0].slots[3];
  std::set<uint8_t> corner, middle;
  for (const uint8_t s : part_of(sheet, slot.x_px, slot.y_px, 50, 50).samples) corner.insert(s);
  for (const uint8_t s : part_of(sheet, slot.x_px + 75, slot.y_px + 75, 50, 50).samples) middle.insert(s);
  EXPECT_EQ(corner.size(), 2U);
  EXPECT_GT(*corner.begin(), 200);
  EXPECT_LT(*middle.begin(), 160);
}

TEST_F(WrittenGrid, picture_of_another_size_is_fitted_and_centred) {
  GridLayout layout = layout_of(1, 1, 100, 100);
  const auto wide = [](int, int, int) { return std::optional<Picture>(Picture(400, 200, 3, 0)); };
  const Picture sheet = read_picture(write_grid(folder_, layout, wide, {})[0], 3);
  const GridSlot slot = plan_grid(layout).sheets[0].slots[0];
  EXPECT_EQ(part_of(sheet, slot.x_px, slot.y_px, 100, 25), Picture(100, 25, 3, 255));
  EXPECT_EQ(part_of(sheet, slot.x_px, slot.y_px + 25, 100, 50), Picture(100, 50, 3, 0));
}

TEST_F(WrittenGrid, odd_layouts_are_written) {
  for (const auto& [name, layout] : many_layouts()) {
    if (static_cast<double>(layout.columns.values.size()) * layout.rows.values.size() > 100) continue;
    if (layout.cell_width_px > 1000) continue;  // Slow, and no different from 512.
    const std::vector<fs::path> paths = write_grid(folder_ / name, layout, cells(layout), {});
    EXPECT_EQ(paths.size(), plan_grid(layout).sheets.size()) << name;
    for (const fs::path& path : paths) EXPECT_NO_THROW(read_picture(path, 3)) << path;
  }
}

TEST_F(WrittenGrid, full_disk_is_a_work_error_and_leaves_nothing) {
  const GridLayout layout = layout_of(3, 3, 256, 256);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const rlimit limit{100000, old.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
  std::string message;
  try {
    write_grid(folder_, layout, cells(layout), {});
  } catch (const Error& error) {
    message = (error.kind() == ErrorKind::work ? "work: " : "input: ") + std::string(error.what());
  }
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_THAT(message, testing::StartsWith("work: " + (folder_ / "grid.png").string()));
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(WrittenGrid, exception_of_a_cell_passes_and_leaves_nothing) {
  const GridLayout layout = layout_of(2, 2, 64, 64);
  const auto throwing = [&](int column, int row, int page) -> std::optional<Picture> {
    if (row == 1) throw work_error("cell", "is lost");
    return cell_picture(layout, column, row, page);
  };
  EXPECT_THROW(write_grid(folder_, layout, throwing, {}), Error);
  EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace
}  // namespace inkbench
