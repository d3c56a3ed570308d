// SPDX-License-Identifier: MIT
// The report page of a study: one HTML file that shows its grid, charts, table and how it was made, and opens
// from disk. In: a StudyPage, plain data. Out: the text of index.html. Its look and behaviour are the files
// in studies/report/page/.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace inkbench {

/// An axis of the grid, as people read it.
struct PageAxis {
  std::string label;
  std::vector<std::string> values;  ///< At least one.
};

struct PageLink {
  std::string text;
  std::string path;  ///< Relative to the page.
};

struct PageChart {
  std::string title;
  std::string svg;              ///< An SVG document.
  std::vector<PageLink> links;  ///< The chart as files, its script.
};

/// How a column of the table is used. The first one, `cell`, holds the cell's number.
enum class ColumnKind { cell, name, parameter, number, error };

struct PageColumn {
  std::string name;
  ColumnKind kind = ColumnKind::number;
  std::string help;  ///< In plain words; may be empty.
};

/// One cell of the grid. It has a picture for each view and buffer, all buffers of the first view first.
struct PageCell {
  std::string name;
  std::string error;                    ///< Why it failed; empty for a cell that worked or was not drawn.
  std::vector<std::string> pictures;    ///< Paths relative to the page; empty where there are none.
  std::vector<std::string> thumbnails;  ///< As `thumbnail` makes them, for the first pictures or all.
  std::vector<std::string> overlays;    ///< For each view the path of an SVG file or ""; may be empty.
  std::vector<std::string> row;         ///< A field for each column; empty where the table has no such row.
  std::vector<std::string> causes;      ///< As overlays, of PNG files that show why lines are wrong.
};

/// A cause of false or missed lines, for the legend.
struct PageCause {
  std::string name;
  std::string colour;  ///< "#rrggbb"
  std::string help;
};

/// A small table of its own, beside that of the cells.
struct PageTable {
  std::string title;
  std::string note;                            ///< What it says, in a sentence or two; may be empty.
  std::vector<std::string> columns;            ///< Without any there is the note alone.
  std::vector<std::vector<std::string>> rows;  ///< A field for each column.
};

struct StudyPage {
  std::string kind = "study";  ///< What made it: "inkbench study".
  std::string title;
  std::string purpose;
  std::string verdict;             ///< What came out, in a sentence, first of all; may be empty.
  std::vector<std::string> facts;  ///< Short ones, for one line.
  int width_px = 0;                ///< Of a picture.
  int height_px = 0;
  std::vector<std::string> views;    ///< At least one; a single one may have no name.
  std::vector<std::string> buffers;  ///< At least one.
  /// Columns, rows, pages: at most three. Cells are in order of page, row, column. Without axes each cell
  /// stands under its name.
  std::vector<PageAxis> axes;
  std::vector<PageCell> cells;  ///< All of them, or as many as the page shows: the first ones.
  size_t cell_count = 0;        ///< Of the study.
  std::vector<std::pair<std::string, std::string>> overlay_classes;  ///< Name and "#rrggbb", for the legend.
  std::vector<PageCause> causes;                                     ///< Empty where no cell has any.
  std::vector<PageTable> tables;
  std::vector<PageChart> charts;
  std::vector<PageColumn> columns;
  std::string data_path = "data.csv";
  std::string command;
  std::vector<std::pair<std::string, std::string>> versions;
  std::string spec_name;  ///< The spec's file.
  std::string spec_text;
  std::vector<PageLink> links;
};

/// No more cells than this belong into a page: browsers would be slow, and no thumbnail would be seen.
inline constexpr size_t kMaxPageCells = 10'000;

/// Of the page's text: it stays under 12 MB.
inline constexpr size_t kMaxPageChars = 11'500'000;

/// The room that thumbnails may take, in characters, so that the page keeps to `kMaxPageChars`: what all else
/// in `page` leaves.
size_t thumbnail_room(const StudyPage& page);

/// All texts are made safe. The same page gives the same text. Errors (work): the files of the page's look
/// are missing.
std::string page_html(const StudyPage& page);

}  // namespace inkbench
