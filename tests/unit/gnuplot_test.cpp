// SPDX-License-Identifier: MIT
// gnuplot as a program: charts of odd tables are drawn without a word, bad endings are told, text is never
// run.
#include "studies/report/gnuplot.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cstdlib>

#include "pipeline/base/files.h"
#include "pipeline/image/image_file.h"
#include "studies/report/svg_text.h"
#include "tests/unit/chart_support.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

/// A study's folder with one chart in it, drawn from `table` and a last column of files, which every study
/// has.
struct Drawing {
  TemporaryFolder folder;
  std::string said, svg;

  Drawing(const Chart& chart, std::string table) {
    for (size_t at = 0; (at = table.find('\n', at)) != std::string::npos; at += 3) table.insert(at, ",f");
    folder.write("data.csv", table);
    folder.write("charts/" + chart.name + ".gp", chart_script(chart, parse_csv(table)));
    said = run_gnuplot(folder.path() / "charts" / (chart.name + ".gp"), folder.path(), 60s);
    svg = read_file(folder.path() / (chart.name + ".svg"));
  }
  Picture png() const { return read_picture(folder.path() / "c.png", 3); }
};

size_t count(const std::string& text, const std::string& part) {
  size_t found = 0;
  for (size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
  return found;
}

/// Lines and a heat map of a, b and f1 in all their forms.
std::vector<Chart> charts_of_all_kinds() {
  Chart plain = lines_chart(number("a", Scale::log));
  Chart curves = lines_chart(number("a"));
  curves.by = number("b");
  curves.scale_y = Scale::log;
  Chart panels = lines_chart(names("a"));
  panels.panel = number("b");
  Chart best = lines_chart(number("a", Scale::log));
  best.best_of = measured("f1");
  Chart heat = heat_chart(number("a"), number("b"));
  Chart heat_panels = heat_chart(number("a"), names("error"));
  heat_panels.panel = names("b");
  heat_panels.mark_least = true;
  Chart best_heat = heat_chart(number("a"), number("b"));
  best_heat.best_of = measured("f1");
  return {plain, curves, panels, best, heat, heat_panels, best_heat};
}

TEST(Gnuplot, draws_both_pictures_of_every_kind) {
  for (const Chart& chart : charts_of_all_kinds()) {
    const Drawing drawing(chart, "a,b,f1,error\n1,1,0.5,\n10,1,0.25,\n100,1,0.75,\n");
    EXPECT_EQ(drawing.said, "");
    EXPECT_EQ(drawing.png().width_px, 1200);
    EXPECT_GE(drawing.png().height_px, 800);
    EXPECT_THAT(drawing.svg, AllOf(HasSubstr("viewBox=\"0 0 1200 "), HasSubstr("sans-serif"),
                                   HasSubstr("<text>"), EndsWith("</svg>\n\n")));
  }
}

TEST(Gnuplot, draws_odd_tables_without_a_word) {
  const std::string head = "a,b,f1,error\n";
  const std::string rows[] = {"",
                              "1,1,0.5,\n",
                              "1,1,,\n2,1,,\n",
                              "1,1,nan,\n2,2,inf,\n",
                              "1,1,1,\n2,1,1,\n3,1,1,\n",
                              "0,1,0,\n1,1,-1,\n2,1,-2,\n",
                              "0,0,1,\n",
                              "-3,1,1e-300,\n5,1,1e300,\n",
                              "1,1,0.5,\"broken, by \"\"it\"\"\"\n2,1,0.5,\n",
                              "3,1,0.1,\n1,1,0.2,\n2,1,,\n",
                              ",,0.5,\n1,,0.25,\n"};
  for (const std::string& row : rows) {
    for (const Chart& chart : charts_of_all_kinds()) EXPECT_EQ(Drawing(chart, head + row).said, "") << row;
  }
}

TEST(Gnuplot, a_gap_is_not_zero_and_not_bridged) {
  const Chart chart = lines_chart(number("a"));
  const std::string whole = Drawing(chart, "a,f1,error\n1,0.5,\n2,0.6,\n3,0.7,\n").svg;
  const std::string gap = Drawing(chart, "a,f1,error\n1,0.5,\n2,,\n3,0.7,\n").svg;
  const std::string zero = Drawing(chart, "a,f1,error\n1,0.5,\n2,0,\n3,0.7,\n").svg;
  const std::string own = Drawing(chart, "a,f1,error\n3,0.7,\n1,0.5,\n2,,\n").svg;
  const std::string mark = "<use xlink:href='#gpPt6'";
  EXPECT_EQ(count(whole, mark), 3U);
  EXPECT_EQ(count(zero, mark), 3U);
  EXPECT_EQ(count(gap, mark), 2U);
  EXPECT_EQ(count(own, mark), 2U);
  const auto segments = [](const std::string& svg) {
    const size_t start = svg.find("stroke='rgb( 10,  34, 114)'  d='");
    return start == std::string::npos ? 0 : count(svg.substr(start, svg.find("/>", start) - start), "L");
  };
  EXPECT_EQ(segments(whole), 2U);
  EXPECT_EQ(segments(gap), 0U);
  EXPECT_EQ(segments(own), 0U);
}

TEST(Gnuplot, a_chart_read_from_the_file_is_the_one_with_its_own_data) {
  Chart chart = heat_chart(number("a"), number("b"));
  const std::string rows = "1,1,0.5,\n2,1,0.25,\n1,2,0.125,\n2,2,,\n";
  const std::string broken = "9,9,1,\"a \"\"broken\"\" cell\"\n";
  const std::string from_file = Drawing(chart, "a,b,f1,error\n" + rows).svg;
  EXPECT_TRUE(from_file == Drawing(chart, "a,b,f1,error\n" + rows + broken).svg);
  for (const char* value : {"<text>0.500<", "<text>0.250<", "<text>0.125<"})
    EXPECT_EQ(count(from_file, value), 1U);
  chart = lines_chart(number("a"));
  chart.by = number("b");
  EXPECT_TRUE(Drawing(chart, "a,b,f1,error\n" + rows).svg ==
              Drawing(chart, "a,b,f1,error\n" + rows + broken).svg);
}

TEST(Gnuplot, the_same_data_give_the_same_bytes) {
  for (const Chart& chart : charts_of_all_kinds()) {
    const std::string table = "a,b,f1,error\n1,1,0.5,\n10,1,0.25,\n100,1,0.75,\n";
    const Drawing first(chart, table);
    const Drawing second(chart, table);
    EXPECT_TRUE(first.svg == second.svg);
    EXPECT_TRUE(read_file(first.folder.path() / "c.png") == read_file(second.folder.path() / "c.png"));
  }
}

TEST(Gnuplot, text_is_shown_and_never_acted_on) {
  const TemporaryFolder trap;
  const std::string nasty =
      "it's \"a\" {b}_c^d @x 50% %s \\n \\ <&> `touch " + (trap.path() / "sprung").string() + "` '' \"";
  Chart chart = lines_chart(names("a"));
  chart.title = nasty;
  chart.study = nasty + "\\";
  chart.x_label = chart.y_label = nasty;
  chart.y.push_back(measured("g"));
  chart.y[0].label = nasty;
  chart.by = names("b");
  chart.by->label = nasty;
  std::string field = nasty;
  for (size_t at = 0; (at = field.find('"', at)) != std::string::npos; at += 2) field.insert(at, "\"");
  const Drawing lines(chart,
                      "a,b,f1,g,error\n\"" + field + "\",\"" + field + "\",0.5,0.5,\nx,`y`,0.25,0.25,\n");
  EXPECT_EQ(lines.said, "");
  EXPECT_THAT(lines.svg, AllOf(HasSubstr("it's \"a\" {b}_c^d @x 50% %s \\n \\"), HasSubstr("&lt;&amp;>")));
  Chart heat = heat_chart(names("a"), names("b"));
  heat.panel = names("c");
  EXPECT_EQ(Drawing(heat, "a,b,c,f1,error\nit's `touch " + (trap.path() / "sprung").string() +
                              "`,@b,'c',0.5,\nd,e,f,1,\n")
                .said,
            "");
  EXPECT_FALSE(fs::exists(trap.path() / "sprung"));
}

TEST(Gnuplot, characters_that_the_font_lacks_are_boxes_in_the_png_alone) {
  Chart chart = lines_chart(number("a"));
  chart.title = "\u65e5\u672c";
  const Drawing drawing(chart, "a,f1,error\n1,0.5,\n2,1,\n");
  EXPECT_THAT(drawing.svg, HasSubstr("\u65e5\u672c"));
  Chart boxes = chart;
  boxes.title = "\u25a1\u25a1";
  EXPECT_TRUE(drawing.png().samples == Drawing(boxes, "a,f1,error\n1,0.5,\n2,1,\n").png().samples);
}

TEST(Gnuplot, a_script_that_fails_is_told_with_its_line) {
  const TemporaryFolder folder;
  const fs::path script = folder.write("bad.gp", "x = 1\nset nonsense\n");
  EXPECT_THAT(error_of([&] { run_gnuplot(script, folder.path(), 10s); }, ErrorKind::work),
              AllOf(HasSubstr("bad.gp: gnuplot failed"), HasSubstr("line 2: "),
                    HasSubstr("unrecognized option"), Not(HasSubstr("\n"))));
}

/// Puts a folder with a program of our own named gnuplot, or with none, before everything else.
class FakeGnuplot {
 public:
  explicit FakeGnuplot(const std::string& program) {
    if (!program.empty()) chmod(folder_.write("gnuplot", "#!/bin/sh\n" + program + "\n").c_str(), 0755);
    setenv("PATH", (folder_.path().string() + (program.empty() ? "" : ":" + path_)).c_str(), 1);
  }
  FakeGnuplot(const FakeGnuplot&) = delete;
  FakeGnuplot& operator=(const FakeGnuplot&) = delete;
  ~FakeGnuplot() { setenv("PATH", path_.c_str(), 1); }

  std::string error(std::chrono::milliseconds limit = 10s) const {
    const fs::path script = folder_.write("s.gp", "");
    return error_of([&] { run_gnuplot(script, folder_.path(), limit); }, ErrorKind::work);
  }

 private:
  TemporaryFolder folder_;
  std::string path_ = std::getenv("PATH");
};

TEST(Gnuplot, where_it_is_missing_its_package_is_named) {
  EXPECT_EQ(FakeGnuplot("").error(),
            "gnuplot: was not found; install the package gnuplot-nox, which draws the charts");
}

TEST(Gnuplot, one_that_hangs_is_ended_with_all_that_it_started) {
  EXPECT_THAT(FakeGnuplot("sleep 3600 & wait").error(300ms), HasSubstr("gnuplot did not end within 0.3 s"));
  EXPECT_THAT(FakeGnuplot("exec >&- 2>&-; sleep 3600").error(300ms), HasSubstr("did not end within 0.3 s"));
}

TEST(Gnuplot, one_that_dies_or_floods_is_told) {
  EXPECT_THAT(FakeGnuplot("kill -9 $$").error(), HasSubstr("gnuplot was ended by signal 9"));
  EXPECT_THAT(FakeGnuplot("exit 3").error(), HasSubstr("gnuplot failed; it said nothing"));
  const std::string flood = FakeGnuplot("head -c 3000000 /dev/zero | tr '\\0' x; exit 1").error();
  EXPECT_LT(flood.size(), 1000U);
  EXPECT_THAT(flood, HasSubstr("xxx ..."));
}

TEST(SvgText, ids_and_references_are_scoped_and_text_is_left_alone) {
  EXPECT_EQ(
      scoped_svg("<svg><title>n</title><g id=\"a\"/><path id='b'/><use xlink:href='#b' fill=\"url(#a)\"/>"
                 "<text>id='c' url(#d)</text></svg>",
                 "s", "A & <B>"),
      "<svg><title>A &amp; &lt;B&gt;</title><g id=\"s-a\"/><path id='s-b'/><use xlink:href='#s-b' "
      "fill=\"url(#s-a)\"/><text>id='c' url(#d)</text></svg>");
  EXPECT_EQ(scoped_svg("", "s", "t"), "");
  EXPECT_EQ(scoped_svg("<g id='a", "s", "t"), "<g id='s-a");
}

}  // namespace
}  // namespace inkbench
