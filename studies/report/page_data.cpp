// SPDX-License-Identifier: MIT
#include "studies/report/page_data.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "studies/report/html_text.h"

namespace inkbench {
namespace {

template <class Items, class Text>
std::string json_list(const Items& items, const Text& text) {
  std::string result = "[";
  for (const auto& item : items) {
    if (result.size() > 1) result += ",";
    result += text(item);
  }
  return result + "]";
}

std::string json_texts(const std::vector<std::string>& texts) {
  return json_list(texts, json_text);
}

std::string_view kind_name(ColumnKind kind) {
  switch (kind) {
    case ColumnKind::cell:
      return "cell";
    case ColumnKind::name:
      return "name";
    case ColumnKind::parameter:
      return "parameter";
    case ColumnKind::number:
      return "number";
    case ColumnKind::error:
      return "error";
  }
  return "";
}

/// What the files of one picture of all cells begin and end with: "cells/" and "_final.png".
struct FilePattern {
  std::string begin, end;
  bool is_set = false;

  void take(const std::string& path) {
    if (!is_set) begin = end = path;
    is_set = true;
    const auto first = std::mismatch(begin.begin(), begin.end(), path.begin(), path.end()).first;
    begin.erase(first, begin.end());
    const auto last = std::mismatch(end.rbegin(), end.rend(), path.rbegin(), path.rend()).first;
    end.erase(end.begin(), last.base());
  }
  /// Begin and end must not overlap in any path.
  void shorten_to(size_t length) {
    if (begin.size() + end.size() > length) end = end.substr(begin.size() + end.size() - length);
  }
};

std::vector<FilePattern> file_patterns(const StudyPage& page) {
  std::vector<FilePattern> patterns(page.views.size() * page.buffers.size());
  for (const PageCell& cell : page.cells) {
    for (size_t i = 0; i < cell.pictures.size(); ++i) patterns[i].take(cell.pictures[i]);
  }
  for (const PageCell& cell : page.cells) {
    for (size_t i = 0; i < cell.pictures.size(); ++i) patterns[i].shorten_to(cell.pictures[i].size());
  }
  return patterns;
}

/// The parts of a cell's file names between their patterns; a single text where all are the same.
std::string files_json(const PageCell& cell, const std::vector<FilePattern>& patterns) {
  std::vector<std::string> parts;
  for (size_t i = 0; i < cell.pictures.size(); ++i) {
    const FilePattern& pattern = patterns[i];
    const std::string& path = cell.pictures[i];
    parts.push_back(
        url_path(path.substr(pattern.begin.size(), path.size() - pattern.begin.size() - pattern.end.size())));
  }
  if (std::adjacent_find(parts.begin(), parts.end(), std::not_equal_to<>()) == parts.end())
    return json_text(parts.front());
  return json_texts(parts);
}

/// Numbers the overlays in order of their first use.
class OverlayList {
 public:
  std::string indices_json(const std::vector<std::string>& paths) {
    return json_list(paths, [&](const std::string& path) { return std::to_string(index(path)); });
  }
  std::string json() const {
    return json_list(paths_, [](const std::string& path) { return json_text(url_path(path)); });
  }

 private:
  int index(const std::string& path) {
    if (path.empty()) return -1;
    const auto [entry, is_new] = indices_.emplace(path, static_cast<int>(paths_.size()));
    if (is_new) paths_.push_back(path);
    return entry->second;
  }

  std::map<std::string, int> indices_;
  std::vector<std::string> paths_;
};

std::string cell_json(const PageCell& cell, const std::vector<FilePattern>& patterns, OverlayList& overlays) {
  std::string json = "{\"name\":" + json_text(cell.name);
  if (!cell.error.empty()) json += ",\"error\":" + json_text(cell.error);
  if (!cell.pictures.empty()) json += ",\"files\":" + files_json(cell, patterns);
  if (!cell.thumbnails.empty()) json += ",\"thumbs\":" + json_texts(cell.thumbnails);
  if (!cell.overlays.empty()) json += ",\"overlays\":" + overlays.indices_json(cell.overlays);
  if (!cell.causes.empty()) json += ",\"causes\":" + overlays.indices_json(cell.causes);
  if (!cell.row.empty()) json += ",\"row\":" + json_texts(cell.row);
  return json + "}";
}

std::string axis_json(const PageAxis& axis) {
  return "{\"label\":" + json_text(axis.label) + ",\"values\":" + json_texts(axis.values) + "}";
}

std::string column_json(const PageColumn& column) {
  const std::string help = column.help.empty() ? "" : ",\"help\":" + json_text(column.help);
  return "{\"name\":" + json_text(column.name) + ",\"kind\":" + json_text(kind_name(column.kind)) + help +
         "}";
}

}  // namespace

std::string page_data(const StudyPage& page) {
  const std::vector<FilePattern> patterns = file_patterns(page);
  OverlayList overlays;
  std::string json = "{\"title\":" + json_text(page.title);
  json += ",\"size\":[" + std::to_string(page.width_px) + "," + std::to_string(page.height_px) + "]";
  json += ",\"views\":" + json_texts(page.views);
  json += ",\"buffers\":" + json_texts(page.buffers);
  json += ",\"axes\":" + json_list(page.axes, axis_json);
  json += ",\"columns\":" + json_list(page.columns, column_json);
  json += ",\"files\":" + json_list(patterns, [](const FilePattern& pattern) {
            return json_texts({url_path(pattern.begin), url_path(pattern.end)});
          });
  json += ",\"cells\":" + json_list(page.cells, [&](const PageCell& cell) {
            return "\n" + cell_json(cell, patterns, overlays);
          });
  json += ",\"overlays\":" + overlays.json();
  json += ",\"legend\":" + json_list(page.overlay_classes, [](const auto& entry) {
            return json_texts({entry.first, entry.second});
          });
  json += ",\"causes\":" + json_list(page.causes, [](const PageCause& cause) {
            return json_texts({cause.name, cause.colour, cause.help});
          });
  return json + "}";
}

}  // namespace inkbench
