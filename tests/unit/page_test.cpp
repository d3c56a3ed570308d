// SPDX-License-Identifier: MIT
#include "studies/report/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "studies/report/html_text.h"
#include "studies/report/page_data.h"

namespace inkbench {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kHostile =
    "</script><script>alert(1)</script><!-- \"double\" 'single' & \n {{data}} \xe2\x80\xa8 \xff";

PageCell cell(const std::string& number) {
  return {"cell " + number,   "", {"cells/" + number + "_final.png"}, {"QUJD"}, {"reference/a b#.svg"},
          {number, "0.5", ""}};
}

StudyPage page_of(const std::vector<PageCell>& cells) {
  StudyPage page;
  page.title = "K";
  page.width_px = 64;
  page.height_px = 48;
  page.views = {""};
  page.buffers = {"final"};
  page.columns = {{"cell", ColumnKind::cell}, {"f1", ColumnKind::number}, {"error", ColumnKind::error}};
  page.cells = cells;
  page.cell_count = cells.size();
  return page;
}

/// What the script will read, from the finished page.
json data_of(const std::string& html) {
  const std::string open = "<script type=\"application/json\" id=\"study\">";
  const size_t begin = html.find(open) + open.size();
  return json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

/// As data.js does it.
std::string picture_url(const json& data, size_t cell_index, size_t slot) {
  const json& files = data.at("cells").at(cell_index).at("files");
  const json& pattern = data.at("files").at(slot);
  return pattern.at(0).get<std::string>() + (files.is_array() ? files.at(slot) : files).get<std::string>() +
         pattern.at(1).get<std::string>();
}

size_t times_in(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(HtmlText, markup_quotes_and_broken_bytes_become_text) {
  EXPECT_EQ(html_text("<a href=\"x\">'&'</a>"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
  EXPECT_EQ(html_text("a\nb\tc"), "a\nb\tc");
  EXPECT_EQ(html_text(std::string("\0\x1b\x7f\r", 4)), "\ufffd\ufffd\ufffd\ufffd");
  EXPECT_EQ(html_text("\xff\xc3(\xe2\x80"), "\ufffd\ufffd(\ufffd");
  EXPECT_EQ(html_text("\u2028 é 漢 🐇"), "\u2028 é 漢 🐇");
}

TEST(HtmlText, path_becomes_a_url_that_cannot_leave_the_folder) {
  EXPECT_EQ(url_path("cells/0001_final.png"), "cells/0001_final.png");
  EXPECT_EQ(url_path("a b#?%é.png"), "a%20b%23%3F%25%C3%A9.png");
  EXPECT_EQ(url_path("javascript:alert(1)"), "javascript%3Aalert%281%29");
}

TEST(HtmlText, json_text_reads_back_and_ends_no_script) {
  const std::string text = json_text(kHostile);
  EXPECT_THAT(text, Not(HasSubstr("<")));
  EXPECT_EQ(json::parse(text).get<std::string>(),
            "</script><script>alert(1)</script><!-- \"double\" 'single' & \n {{data}} \u2028 \ufffd");
}

TEST(HtmlText, base64_as_in_rfc_4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Page, columns_carry_their_meaning) {
  StudyPage page = page_of({cell("1")});
  page.columns[1].help = "Plain words.";
  const json columns = data_of(page_html(page)).at("columns");
  EXPECT_EQ(columns.at(1).at("help"), "Plain words.");
  EXPECT_FALSE(columns.at(0).contains("help"));
}

TEST(Page, hostile_texts_stay_texts_everywhere) {
  StudyPage page = page_of({cell("1")});
  page.title = page.purpose = page.command = page.spec_name = page.spec_text = kHostile;
  page.facts = page.buffers = page.views = {kHostile};
  page.axes = {{kHostile, {kHostile}}};
  page.cells[0].name = page.cells[0].error = kHostile;
  page.cells[0].row = {"1", kHostile, kHostile};
  page.cells[0].overlays = page.cells[0].pictures = {kHostile};
  page.charts = {{kHostile, std::string("<svg>") + kHostile + "</svg>", {{kHostile, kHostile}}}};
  page.columns[1].name = page.columns[1].help = kHostile;
  page.versions = {{kHostile, kHostile}};
  page.links = {{kHostile, kHostile}};
  const std::string html = page_html(page);
  const std::string plain = page_html(page_of({cell("1")}));
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_EQ(times_in(html, "<script"), times_in(plain, "<script"));
  EXPECT_EQ(times_in(html, "</script"), times_in(plain, "</script"));
  EXPECT_EQ(times_in(html, "<!--"), times_in(plain, "<!--"));
  EXPECT_THAT(html, Not(HasSubstr("\xff")));
  EXPECT_EQ(times_in(html, "\"columns\":"), 1U) << "a field's text is not filled again";
  EXPECT_EQ(data_of(html).at("cells").at(0).at("error"), json::parse(json_text(kHostile)));
}

TEST(Page, paths_come_back_from_their_patterns) {
  StudyPage page = page_of({cell("0001"), cell("0002"), cell("0012")});
  EXPECT_EQ(picture_url(data_of(page_html(page)), 2, 0), "cells/0012_final.png");
  EXPECT_EQ(data_of(page_html(page)).at("files").at(0), json({"cells/00", "_final.png"}));
  page.buffers = {"final", "depth"};
  const std::vector<std::vector<std::string>> paths{
      {"aa.png", "x.png"}, {"a.png", "a b.png"}, {"aaa.png", "\xc3\xa9.png"}};
  for (size_t i = 0; i < 3; ++i) page.cells[i].pictures = paths[i];
  const json data = data_of(page_html(page));
  for (size_t i = 0; i < 3; ++i) {
    for (size_t slot = 0; slot < 2; ++slot)
      EXPECT_EQ(picture_url(data, i, slot), url_path(paths[i][slot])) << i << " " << slot;
  }
}

TEST(Page, overlays_that_cells_share_stand_there_once) {
  StudyPage page = page_of({cell("1"), cell("2"), cell("3")});
  page.cells[1].overlays = {""};
  page.cells[2].overlays = {"b.svg"};
  const json data = data_of(page_html(page));
  EXPECT_EQ(data.at("overlays"), json({"reference/a%20b%23.svg", "b.svg"}));
  EXPECT_EQ(data.at("cells").at(0).at("overlays"), json::array({0}));
  EXPECT_EQ(data.at("cells").at(1).at("overlays"), json::array({-1}));
  EXPECT_EQ(data.at("cells").at(2).at("overlays"), json::array({1}));
}

TEST(Page, causes_lie_over_cells_beside_the_reference_lines_with_a_legend_that_says_what_they_are) {
  StudyPage page = page_of({cell("1"), cell("2")});
  page.causes = {{"false: grazing", "#d55e00", "A <b> slope"}};
  page.cells[1].causes = {"causes/c.png"};
  const json data = data_of(page_html(page));
  EXPECT_EQ(data.at("causes"), json::array({{"false: grazing", "#d55e00", "A <b> slope"}}));
  EXPECT_FALSE(data.at("cells").at(0).contains("causes"));
  const int index = data.at("cells").at(1).at("causes").at(0);
  EXPECT_EQ(data.at("overlays").at(index), "causes/c.png");
}

TEST(Page, failed_cells_are_named_up_to_twenty) {
  std::vector<PageCell> cells(25);
  for (size_t i = 0; i < 23; ++i) cells[i + 2].error = "lost the mesh";
  const std::string html = page_html(page_of(cells));
  EXPECT_THAT(html, HasSubstr("23 cells failed"));
  EXPECT_THAT(html, HasSubstr("<a href=\"#cell=3\">Cell 3</a>: lost the mesh"));
  EXPECT_THAT(html, HasSubstr("and 3 more"));
  EXPECT_THAT(page_html(page_of({cell("1")})), Not(HasSubstr("failed</h2>")));
}

TEST(Page, needs_nothing_from_the_network) {
  const std::string html = page_html(page_of({cell("1")}));
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  EXPECT_EQ(times_in(html, "http://") + times_in(html, "https://"),
            times_in(html, "http://www.w3.org/2000/svg"));
}

TEST(Page, part_of_a_large_study_says_so) {
  StudyPage page = page_of({cell("1")});
  page.cell_count = 12345;
  EXPECT_THAT(page_html(page), HasSubstr("the first 1 of 12,345 cells"));
}

TEST(Page, same_page_gives_the_same_text) {
  EXPECT_EQ(page_html(page_of({cell("1"), cell("2")})), page_html(page_of({cell("1"), cell("2")})));
}

TEST(Page, empty_page_is_whole) {
  const std::string html = page_html(page_of({}));
  EXPECT_EQ(data_of(html).at("cells").size(), 0U);
  EXPECT_THAT(html, HasSubstr("</html>"));
}

}  // namespace
}  // namespace inkbench
