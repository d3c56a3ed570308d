// SPDX-License-Identifier: MIT
#include "studies/report/page.h"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <map>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "studies/report/html_text.h"
#include "studies/report/page_data.h"

namespace inkbench {
namespace {

constexpr size_t kNamedFailures = 20;

using Fields = std::map<std::string, std::string, std::less<>>;

std::string page_file(const std::string& name) {
  return read_file(project_file("studies/report/page/" + name));
}

/// The files one after the other.
std::string page_files(std::initializer_list<const char*> names) {
  std::string text;
  for (const char* name : names) text += page_file(name);
  return text;
}

/// The template with each {{name}} replaced, once: what stands in a field is never looked at again.
std::string filled(std::string_view text, const Fields& fields) {
  std::string result;
  size_t begin = 0;
  for (size_t open; (open = text.find("{{", begin)) != std::string_view::npos;) {
    const size_t close = text.find("}}", open);
    const std::string_view name =
        text.substr(open + 2, close == std::string_view::npos ? close : close - open - 2);
    const auto field = fields.find(name);
    if (field == fields.end())
      throw work_error("page.html", "has no value for {{" + std::string(name) + "}}");
    result.append(text.substr(begin, open - begin)).append(field->second);
    begin = close + 2;
  }
  return result.append(text.substr(begin));
}

std::string link_html(const PageLink& link) {
  return "<a href=\"" + url_path(link.path) + "\">" + html_text(link.text) + "</a>";
}

std::string failure_html(const PageCell& cell, size_t index) {
  const std::string number = std::to_string(index + 1);
  return "<li><a href=\"#cell=" + number + "\">Cell " + number + "</a>" +
         (cell.name.empty() ? "" : " (" + html_text(cell.name) + ")") + ": " + html_text(cell.error) +
         "</li>";
}

std::string failures_html(const StudyPage& page) {
  std::string items;
  size_t count = 0;
  for (size_t i = 0; i < page.cells.size(); ++i) {
    if (page.cells[i].error.empty()) continue;
    if (++count <= kNamedFailures) items += failure_html(page.cells[i], i);
  }
  if (count == 0) return "";
  if (count > kNamedFailures)
    items += "<li>and " + std::to_string(count - kNamedFailures) + " more, in the table</li>";
  return "<div class=\"failures\"><h2>" + std::to_string(count) + (count == 1 ? " cell" : " cells") +
         " failed</h2><ul>" + items + "</ul></div>";
}

/// Charts stand in the page as images: so their ids cannot clash, and nothing in them can run.
std::string chart_html(const PageChart& chart) {
  std::string links;
  for (const PageLink& link : chart.links) links += link_html(link);
  return "<figure><img alt=\"" + html_text(chart.title) + "\" src=\"data:image/svg+xml;base64," +
         base64(chart.svg) + "\"><figcaption><b>" + html_text(chart.title) + "</b><span>" + links +
         "</span></figcaption></figure>\n";
}

std::string charts_html(const StudyPage& page) {
  if (page.charts.empty()) return "";
  std::string figures;
  for (const PageChart& chart : page.charts) figures += chart_html(chart);
  return "<section id=\"charts\" aria-labelledby=\"charts-title\"><div class=\"section-head\">"
         "<h2 id=\"charts-title\">Charts</h2></div><div class=\"charts\">\n" +
         figures + "</div></section>";
}

std::string row_html(const std::vector<std::string>& fields, const std::string& tag) {
  std::string cells;
  for (const std::string& field : fields) cells += "<" + tag + ">" + html_text(field) + "</" + tag + ">";
  return "<tr>" + cells + "</tr>";
}

std::string rows_html(const PageTable& table) {
  std::string rows;
  for (const std::vector<std::string>& row : table.rows) rows += row_html(row, "td");
  return "<div class=\"findings-box\"><table><thead>" + row_html(table.columns, "th") + "</thead><tbody>" +
         rows + "</tbody></table></div>";
}

std::string table_html(const PageTable& table) {
  return "<section class=\"findings\"><div class=\"section-head\"><h2>" + html_text(table.title) +
         "</h2></div>" + (table.note.empty() ? "" : "<p class=\"note\">" + html_text(table.note) + "</p>") +
         (table.columns.empty() ? "" : rows_html(table)) + "</section>\n";
}

std::string tables_html(const StudyPage& page) {
  std::string text;
  for (const PageTable& table : page.tables) text += table_html(table);
  return text;
}

std::string facts_html(const StudyPage& page) {
  std::string items;
  for (const std::string& fact : page.facts) items += "<li>" + html_text(fact) + "</li>";
  return items;
}

std::string versions_html(const StudyPage& page) {
  std::string entries;
  for (const auto& [name, version] : page.versions)
    entries += "<dt>" + html_text(name) + "</dt><dd>" + html_text(version) + "</dd>";
  return entries;
}

std::string links_html(const StudyPage& page) {
  std::string items;
  for (const PageLink& link : page.links) items += "<li>" + link_html(link) + "</li>";
  return items;
}

std::string cut_note_html(const StudyPage& page) {
  if (page.cells.size() >= page.cell_count) return "";
  return "<p class=\"note\">This page shows the first " +
         with_commas(static_cast<long long>(page.cells.size())) + " of " +
         with_commas(static_cast<long long>(page.cell_count)) + " cells; " +
         link_html({page.data_path, page.data_path}) + " holds all of them.</p>";
}

Fields fields_of(const StudyPage& page) {
  return {{"version", INKBENCH_VERSION},
          {"title", html_text(page.title)},
          {"purpose", html_text(page.purpose)},
          {"kind", html_text(page.kind)},
          {"verdict", page.verdict.empty() ? "" : "<p class=\"verdict\">" + html_text(page.verdict) + "</p>"},
          {"tables", tables_html(page)},
          {"facts", facts_html(page)},
          {"charts_link", page.charts.empty() ? "" : "<a href=\"#charts\" data-scroll>Charts</a>"},
          {"failures", failures_html(page)},
          {"cut_note", cut_note_html(page)},
          {"charts", charts_html(page)},
          {"data_path", url_path(page.data_path)},
          {"command", html_text(page.command)},
          {"versions", versions_html(page)},
          {"links", links_html(page)},
          {"spec_name", html_text(page.spec_name)},
          {"spec_text", html_text(page.spec_text)},
          {"style", page_files({"page.css", "viewer.css"})},
          {"script", page_files({"data.js", "grid.js", "grid_tools.js", "table.js", "viewer.js", "zoom.js",
                                 "side.js", "keys.js", "page.js"})},
          {"data", page_data(page)}};
}

}  // namespace

size_t thumbnail_room(const StudyPage& page) {
  size_t pictures = 0;
  for (const PageCell& cell : page.cells) pictures += cell.pictures.size();
  constexpr size_t kAround = 16;  // commas, quotes, the entry's name
  const size_t used = page_html(page).size() + kAround * pictures;
  return kMaxPageChars - std::min(used, kMaxPageChars);
}

std::string page_html(const StudyPage& page) {
  return filled(page_file("page.html"), fields_of(page));
}

}  // namespace inkbench
