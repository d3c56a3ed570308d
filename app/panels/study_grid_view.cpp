#include "app/panels/study_grid_view.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "app/panels/fitted_picture.h"
#include "app/panels/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

constexpr float kSmallestCell = 44, kLargestCell = 640, kWidestValue = 110;
constexpr int kUsualDigits = 3, kMostDigits = 9;

/// A single row that is long runs on like text: each cell then has its value above it.
struct GridPlan {
  size_t columns = 1, rows = 1;  ///< As laid out.
  size_t count = 1;              ///< Cells of the page.
  bool flows = false;
  ImVec2 cell;  ///< Of a picture, in pixels.
  float gap = 0, value_height = 0, caption_height = 0;
  int digits = 1;           ///< That the columns' values need to differ.
  float left = 0, top = 0;  ///< Where the cells begin: what labels take.

  float across() const { return cell.x + gap; }
  float down() const { return cell.y + caption_height + (flows ? value_height : 0) + gap; }
  ImVec2 size() const {
    return {left + across() * static_cast<float>(columns) - gap,
            top + down() * static_cast<float>(rows) - gap};
  }
};

float text_width(const std::string& text) {
  return ImGui::CalcTextSize(text.c_str()).x;
}

bool is_labelled(const GridAxis& axis) {
  return axis.values.size() > 1 || !axis.values.front().empty();
}

float widest_value(const GridAxis& axis) {
  float widest = 0;
  const size_t step = std::max<size_t>(1, axis.values.size() / 500);
  for (size_t i = 0; i < axis.values.size(); i += step) widest = std::max(widest, text_width(axis.values[i]));
  return widest;
}

std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size()) return std::nullopt;
  return value;
}

std::string with_digits(double value, int digits) {
  return fmt::format("{:.{}g}", value, digits);
}

/// The fewest digits with which neighbours in the axis still differ.
int least_digits(const GridAxis& axis) {
  const auto differ = [&](int digits) {
    std::string before;
    for (const std::string& text : axis.values) {
      const std::optional<double> value = number_in(text);
      if (!value) continue;
      std::string shown = with_digits(*value, digits);
      if (shown == before) return false;
      before = std::move(shown);
    }
    return true;
  };
  int digits = 1;
  while (digits < kMostDigits && !differ(digits)) ++digits;
  return digits;
}

/// A value with as many digits as there is room for, and no fewer than `least`.
std::string fitting_value(const std::string& text, float width, int least) {
  const std::optional<double> value = number_in(text);
  std::string shown = text;
  for (int digits = std::max(kUsualDigits, least); value && digits >= least && text_width(shown) > width;
       --digits)
    shown = with_digits(*value, digits);
  return shown;
}

/// That numbers above the columns still differ in.
float narrowest_cell(const GridAxis& columns, int digits) {
  float widest = scaled(kSmallestCell);
  const size_t step = std::max<size_t>(1, columns.values.size() / 500);
  for (size_t i = 0; i < columns.values.size(); i += step) {
    if (const auto value = number_in(columns.values[i]))
      widest = std::max(widest, text_width(with_digits(*value, digits)) + scaled(2));
  }
  return std::min(widest, std::max(scaled(kWidestValue), scaled(kSmallestCell)));
}

float fitting_width(const GridPlan& plan, ImVec2 room, float aspect) {
  const auto columns = static_cast<float>(plan.columns), rows = static_cast<float>(plan.rows);
  const float across = (room.x - plan.left + plan.gap) / columns - plan.gap;
  const float down = (room.y - plan.top + plan.gap) / rows - plan.gap - plan.caption_height -
                     (plan.flows ? plan.value_height : 0);
  return std::min(across, down * aspect);
}

/// The number of columns with the largest cells.
void flow(GridPlan& plan, ImVec2 room, float aspect) {
  size_t best = 1;
  float widest = 0;
  for (size_t columns = 1; columns <= std::min<size_t>(plan.count, 64); ++columns) {
    plan.columns = columns;
    plan.rows = (plan.count + columns - 1) / columns;
    const float width = fitting_width(plan, room, aspect);
    if (width <= widest) continue;
    widest = width;
    best = columns;
  }
  plan.columns = best;
  plan.rows = (plan.count + best - 1) / best;
}

/// Rows of cells so wide, no longer than the room; what is below it is scrolled to.
void wrap(GridPlan& plan, ImVec2 room, float width) {
  const float scroll_bar = ImGui::GetStyle().ScrollbarSize;
  const float across = room.x - plan.left - scroll_bar + plan.gap;
  const float columns = std::floor(across / (std::floor(width) + plan.gap));
  plan.columns = static_cast<size_t>(std::clamp(columns, 1.0F, static_cast<float>(plan.count)));
  plan.rows = (plan.count + plan.columns - 1) / plan.columns;
}

GridPlan plan_of(const StudyResults& results, const GridChoice& choice, ImVec2 room) {
  const GridAxis& columns = results.columns();
  const GridAxis& rows = results.rows();
  GridPlan plan{.columns = columns.values.size(), .rows = rows.values.size()};
  plan.count = plan.columns * plan.rows;
  plan.gap = scaled(6);
  plan.value_height = ImGui::GetTextLineHeight() + scaled(3);
  plan.caption_height = choice.number ? ImGui::GetTextLineHeight() + scaled(2) : 0;
  plan.flows = !is_labelled(rows) && columns.values.size() > 3;
  if (is_labelled(rows))
    plan.left = std::min(std::max(widest_value(rows), text_width(rows.label)), scaled(130)) + scaled(10);
  if (is_labelled(columns) || !columns.label.empty() || is_labelled(rows))
    plan.top = plan.value_height * (plan.flows ? 1.0F : 2.0F);
  const ImageParams& image = results.spec().base.image;
  const float aspect = static_cast<float>(image.width) / static_cast<float>(image.height);
  if (plan.flows) flow(plan, room, aspect);
  const float fit = fitting_width(plan, room, aspect);
  plan.digits = least_digits(columns);
  const float least = narrowest_cell(columns, plan.digits);
  const float width = std::min(std::max(fit, least) * choice.zoom, scaled(kLargestCell));
  if (plan.flows && width > fit) wrap(plan, room, width);
  plan.cell = {std::floor(width), std::max(1.0F, std::floor(width / aspect))};
  return plan;
}

void draw_waiting(ImDrawList& list, ImVec2 low, ImVec2 high) {
  list.AddRectFilled(low, high, theme().field);
}

/// Hatched, as in grid.png.
void draw_failed(ImDrawList& list, ImVec2 low, ImVec2 high) {
  list.AddRectFilled(low, high, theme().field);
  list.PushClipRect(low, high, true);
  const float height = high.y - low.y;
  for (float x = low.x - height; x < high.x; x += scaled(9))
    list.AddLine({x, high.y}, {x + height, low.y}, theme().line);
  list.PopClipRect();
  const ImVec2 size = ImGui::CalcTextSize("failed");
  list.AddText({(low.x + high.x - size.x) / 2, (low.y + high.y - size.y) / 2}, theme().error, "failed");
}

void draw_thumbnail(const StudyResults& results, size_t cell, const GridChoice& choice,
                    Thumbnails& thumbnails, ImVec2 low, ImVec2 high) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::filesystem::path file = results.picture(cell, choice.picture);
  if (file.empty())
    return results.error(cell).empty() ? draw_waiting(list, low, high) : draw_failed(list, low, high);
  const ImVec2 room{high.x - low.x, high.y - low.y};
  const Texture* texture = thumbnails.get(file, static_cast<int>(room.x), static_cast<int>(room.y));
  if (texture != nullptr) return draw_fitted_picture(list, *texture, low, room);
  draw_waiting(list, low, high);
  if (!thumbnails.problem(file).empty())
    list.AddText({low.x + scaled(4), low.y + scaled(4)}, theme().error, "?");
}

void tooltip_line(const std::string& name, const std::string& value, float column) {
  faint_text(name);
  ImGui::SameLine(column);
  ImGui::TextUnformatted(value.c_str());
}

void draw_numbers(const StudyResults& results, size_t cell, float column) {
  constexpr size_t kMost = 14;
  size_t shown = 0;
  for (size_t i = 0; i < results.numbers().size() && shown < kMost; ++i) {
    const std::string& text = results.number(cell, i);
    if (text.empty()) continue;
    tooltip_line(results.numbers()[i], short_number(text), column);
    ++shown;
  }
}

/// Larger than in the grid, where its cells are small.
void draw_preview(const StudyResults& results, size_t cell, const GridChoice& choice, Thumbnails& thumbnails,
                  ImVec2 cell_size) {
  const float width = scaled(240);
  const std::filesystem::path file = results.picture(cell, choice.picture);
  if (file.empty() || cell_size.x > width * 0.75F) return;
  const ImVec2 room{std::floor(width), std::floor(width * cell_size.y / cell_size.x)};
  const Texture* texture = thumbnails.get(file, static_cast<int>(room.x), static_cast<int>(room.y), 1);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::Dummy(room);
  if (texture != nullptr) draw_fitted_picture(*ImGui::GetWindowDrawList(), *texture, low, room);
}

/// Nothing where the sizes are the same.
std::string size_note(const ImageParams& now, const ImageParams& taken) {
  const bool same = now.width == taken.width && now.height == taken.height;
  return same ? "" : fmt::format(" and {} × {} px", taken.width, taken.height);
}

/// `now`: the window's own.
void cell_tooltip(const StudyResults& results, size_t cell, const GridChoice& choice, Thumbnails& thumbnails,
                  ImVec2 cell_size, const ImageParams& now) {
  const StudySpec& spec = results.spec();
  const Cell made = make_cell(spec, cell);
  float column = 0;
  for (const Assignment& one : made.set) column = std::max(column, text_width(one.key));
  for (const std::string& name : results.numbers()) column = std::max(column, text_width(name));
  column = std::min(column, scaled(220)) + scaled(18);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(scaled(460));
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted(
      fmt::format("Cell {}{}{}", cell + 1, made.variant.empty() ? "" : "  ", made.variant).c_str());
  ImGui::PopFont();
  for (const Assignment& one : made.set) tooltip_line(one.key, label_text(one.value), column);
  if (results.has(cell) && results.error(cell).empty()) {
    ImGui::Dummy({0, scaled(2)});
    draw_numbers(results, cell, column);
    draw_preview(results, cell, choice, thumbnails, cell_size);
    faint_text("Click takes over these parameters" + size_note(now, results.image(cell, choice.picture)) +
               ".");
  } else if (results.has(cell)) {
    coloured_text(theme().error, results.error(cell));
  } else {
    faint_text("Not drawn yet.");
  }
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void draw_centred(ImDrawList& list, ImVec2 low, float width, ImU32 colour, const std::string& text) {
  const float own = text_width(text);
  if (own <= width) {
    list.AddText({std::floor(low.x + (width - own) / 2), low.y}, colour, text.c_str());
  } else {
    draw_fitted_text(list, low, width, colour, text);
  }
}

class GridView {
 public:
  GridView(Workbench& bench, const StudyResults& results, GridChoice& choice, Thumbnails& thumbnails)
      : bench_(bench), results_(results), choice_(choice), thumbnails_(thumbnails) {}

  GridMouse draw() {
    room_ = ImGui::GetContentRegionAvail();
    plan_ = plan_of(results_, choice_, room_);
    ImGui::SetNextWindowContentSize(plan_.size());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::BeginChild("grid", {0, 0}, false,
                      ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoBackground);
    ImGui::PopStyleVar();
    zoom_by_wheel();
    window_ = ImGui::GetWindowPos();
    inner_ = {ImGui::GetWindowContentRegionMax().x + ImGui::GetScrollX(), ImGui::GetWindowHeight()};
    origin_ = ImGui::GetCursorScreenPos();
    // A grid that is smaller than the room stands in its middle.
    origin_.x += std::max(0.0F, std::floor((room_.x - plan_.size().x) / 2));
    draw_cells();
    draw_labels();
    ImGui::EndChild();
    return mouse_;
  }

 private:
  void zoom_by_wheel() {
    const ImGuiIO& io = ImGui::GetIO();
    if (!ImGui::IsWindowHovered() || !io.KeyCtrl || io.MouseWheel == 0) return;
    choice_.zoom = std::clamp(choice_.zoom * std::pow(1.2F, io.MouseWheel), 1.0F, kLargestGrid);
  }

  std::pair<size_t, size_t> in_sight(float begin, float first, float step, float low, float high,
                                     size_t count) const {
    const float from = std::floor((low - begin - first) / step),
                to = std::ceil((high - begin - first) / step);
    const auto clamp = [&](float value) {
      return static_cast<size_t>(std::clamp(value, 0.0F, static_cast<float>(count)));
    };
    return {clamp(from), clamp(to)};
  }

  void draw_cells() {
    const ImVec2 end{window_.x + ImGui::GetWindowWidth(), window_.y + ImGui::GetWindowHeight()};
    const auto [first_row, last_row] =
        in_sight(origin_.y, plan_.top, plan_.down(), window_.y, end.y, plan_.rows);
    const auto [first_column, last_column] =
        in_sight(origin_.x, plan_.left, plan_.across(), window_.x, end.x, plan_.columns);
    columns_ = {first_column, last_column};
    rows_ = {first_row, last_row};
    for (size_t row = first_row; row < last_row; ++row) {
      for (size_t column = first_column; column < last_column; ++column) {
        const size_t place = row * plan_.columns + column;
        if (place < plan_.count) draw_cell(row, column, results_.cell_at(0, 0, choice_.page) + place);
      }
    }
  }

  ImVec2 corner(size_t row, size_t column) const {
    return {origin_.x + plan_.left + plan_.across() * static_cast<float>(column),
            origin_.y + plan_.top + plan_.down() * static_cast<float>(row) +
                (plan_.flows ? plan_.value_height : 0)};
  }

  void draw_cell(size_t row, size_t column, size_t cell) {
    const ImVec2 low = corner(row, column);
    const ImVec2 high{low.x + plan_.cell.x, low.y + plan_.cell.y};
    ImGui::SetCursorScreenPos(low);
    ImGui::PushID(static_cast<int>(cell));
    const bool pressed = ImGui::InvisibleButton("cell", plan_.cell);
    bench_.ui_map.mark_item("cell:" + std::to_string(cell + 1));
    const bool hot = ImGui::IsItemHovered();
    if (pressed && results_.has(cell)) mouse_.clicked = cell;
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) mouse_.menu = cell;
    draw_thumbnail(results_, cell, choice_, thumbnails_, low, high);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool taken = choice_.taken == cell;
    if (hot || taken) {
      const float out = taken ? scaled(1) : 0;
      list.AddRect({low.x - out, low.y - out}, {high.x + out, high.y + out}, theme().accent, 0, 0,
                   taken ? scaled(2) : 1.0F);
    } else {
      list.AddRect(low, high, theme().line);
    }
    if (plan_.flows)
      draw_centred(
          list, {low.x, low.y - plan_.value_height}, plan_.cell.x, theme().faint,
          fitting_value(results_.columns().values[row * plan_.columns + column], plan_.cell.x, plan_.digits));
    if (choice_.number)
      draw_centred(list, {low.x, high.y + scaled(1)}, plan_.cell.x, theme().text,
                   short_number(results_.number(cell, *choice_.number)));
    if (hot) cell_tooltip(results_, cell, choice_, thumbnails_, plan_.cell, bench_.settings().image);
    ImGui::PopID();
  }

  /// They stay in sight when the cells are scrolled.
  void draw_labels() {
    if (plan_.top == 0) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float width = ImGui::GetWindowWidth(), height = ImGui::GetWindowHeight();
    const GridAxis& columns = results_.columns();
    const bool scrolls_up = ImGui::GetScrollMaxY() > 0, scrolls_across = ImGui::GetScrollMaxX() > 0;
    const float top = scrolls_up ? window_.y : origin_.y;
    if (scrolls_up) list.AddRectFilled(window_, {window_.x + width, window_.y + plan_.top}, theme().panel);
    const float cells_left = origin_.x + plan_.left;
    const float shown_width = std::min(plan_.size().x - plan_.left, width - plan_.left);
    const ImVec2 title{std::max(cells_left, window_.x + plan_.left), top};
    draw_centred(list, title, shown_width, theme().text, columns.label);
    if (!plan_.flows) {
      for (size_t column = columns_.first; column < columns_.second; ++column)
        draw_centred(list, {corner(0, column).x, top + plan_.value_height}, plan_.cell.x, theme().faint,
                     fitting_value(columns.values[column], plan_.cell.x, plan_.digits));
    }
    if (plan_.left == 0) return;
    const GridAxis& rows = results_.rows();
    const float left = scrolls_across ? window_.x : origin_.x;
    if (scrolls_across)
      list.AddRectFilled(window_, {window_.x + plan_.left - scaled(2), window_.y + height}, theme().panel);
    const float room = plan_.left - scaled(8);
    for (size_t row = rows_.first; row < rows_.second; ++row) {
      const float middle = corner(row, 0).y + (plan_.cell.y - ImGui::GetTextLineHeight()) / 2;
      const std::string& value = rows.values[row];
      const float own = std::min(text_width(value), room);
      draw_fitted_text(list, {left + room - own, middle}, room, theme().faint, value);
    }
    if (scrolls_up || scrolls_across)
      list.AddRectFilled({left, top}, {left + plan_.left - scaled(2), top + plan_.top}, theme().panel);
    const float own = std::min(text_width(rows.label), room);
    draw_fitted_text(list, {left + room - own, top + plan_.value_height}, room, theme().text, rows.label);
  }

  Workbench& bench_;
  const StudyResults& results_;
  GridChoice& choice_;
  Thumbnails& thumbnails_;
  GridPlan plan_;
  GridMouse mouse_;
  ImVec2 room_, window_, inner_, origin_;
  std::pair<size_t, size_t> columns_, rows_;
};

}  // namespace

GridMouse draw_study_grid(Workbench& bench, const StudyResults& results, GridChoice& choice,
                          Thumbnails& thumbnails) {
  return GridView(bench, results, choice, thumbnails).draw();
}

}  // namespace inkbench
