// SPDX-License-Identifier: MIT
// Studies with several views: broken off and taken up again they end with the same bytes, and what they pool
// is the sum of what each view gives alone, checked against `inkbench score`.
#include <fmt/format.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/study_fixture.h"

namespace inkbench {
namespace {

using Row = std::map<std::string, std::string>;

constexpr const char* kFront = "[[view]]\nname = \"front\"\n[view.set]\ncamera.fov = 50\n";
constexpr const char* kSide = "[[view]]\nname = \"side\"\n[view.set]\ncamera.eye = [6, 2, 5]\n";
constexpr const char* kSize = "[[axis]]\nkey = \"model.box.size\"\nvalues = [1.4, 2]\n";
constexpr int kViewCells = 6;

std::string thresholds(int count) {
  return fmt::format("[[axis]]\nkey = \"combine.k_normal\"\nfrom = 0.002\nto = 0.6\ncount = {}\n", count);
}

class StudyViews : public StudyTest {
 protected:
  StudyViews() { write_views(std::string(kFront) + kSide); }

  /// Three thresholds for each of two sizes of the box.
  void write_views(const std::string& views) const {
    write_spec(
        "s",
        "size = [96, 72]\nshow = [\"final\"]\nmeasure = [\"f1\", \"recall_silhouette\", \"f1_geometry\"]\n" +
            thresholds(kViewCells / 2) + kSize + views);
  }
  /// The study as it is without a break, in a folder of its own.
  FolderContent unbroken() {
    const CommandResult result = study("s", "unbroken", {"--fresh"});
    EXPECT_TRUE(succeeds(result));
    seconds_ = result.seconds;
    return lasting_content(file("unbroken"));
  }
  /// Runs it to the end; returns how many cells this run drew, or measured without drawing.
  int finish(const FolderContent& expected, const char* count = "cells_drawn") const {
    EXPECT_TRUE(succeeds(study("s", "out")));
    EXPECT_EQ(difference(expected, lasting_content(file("out"))), "same");
    return nlohmann::json::parse(content_of(file("out/manifest.json"))).at("times").at(count);
  }
  std::vector<fs::path> overlays() const {
    std::vector<fs::path> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(file("out/reference")))
      paths.push_back(entry.path());
    return paths;
  }

  double seconds_ = 0;
};

TEST_F(StudyViews, killed_at_any_moment_it_ends_with_the_same_bytes) {
  const FolderContent expected = unbroken();
  constexpr int kMoments = 5;
  int killed = 0;
  for (int moment = 1; moment <= kMoments; ++moment) {
    CommandOptions options;
    options.signal_when = [&](double seconds) {
      return seconds >= seconds_ * (moment + 2) / (kMoments + 3) ? SIGKILL : 0;
    };
    killed += study("s", "out", {}, options).signal == SIGKILL ? 1 : 0;
    expect_no_half_written_files(file("out"), expected);
    finish(expected);
    fs::remove_all(file("out"));
  }
  EXPECT_GE(killed, 2) << "some kills came while it ran";
}

TEST_F(StudyViews, pictures_of_a_cell_that_was_not_finished_are_not_trusted) {
  const FolderContent expected = unbroken();
  fs::copy(file("unbroken"), file("out"), fs::copy_options::recursive);
  const std::string journal = content_of(file("out/journal.jsonl"));
  write("out/journal.jsonl", journal.substr(0, journal.rfind("{\"cell\"")));
  fs::copy_file(file("out/cells/0001_front_final.png"), file("out/cells/0006_front_final.png"),
                fs::copy_options::overwrite_existing);
  EXPECT_EQ(finish(expected), 1);
}

TEST_F(StudyViews, reference_lines_that_are_damaged_or_missing_are_found_again_without_drawing) {
  const FolderContent expected = unbroken();
  fs::copy(file("unbroken"), file("out"), fs::copy_options::recursive);
  ASSERT_EQ(overlays().size(), 4U) << "two sizes in two views";
  const fs::path first = overlays().front();
  const std::string content = content_of(first);
  fs::remove(first);
  EXPECT_EQ(finish(expected, "cells_measured"), kViewCells / 2) << "the cells that share it";
  std::ofstream(first) << content.substr(0, content.size() / 2);
  EXPECT_EQ(finish(expected, "cells_measured"), kViewCells / 2);
  std::ofstream(first) << std::string(content.size(), ' ');
  EXPECT_EQ(finish(expected, "cells_measured"), kViewCells / 2) << "the size alone is not enough";
  EXPECT_EQ(finish(expected, "cells_measured"), 0);
  EXPECT_EQ(finish(expected), 0);
}

TEST_F(StudyViews,
       causes_lie_beside_the_cells_where_a_measure_asks_for_them_and_damaged_ones_are_found_again) {
  write_spec("s", "size = [48, 36]\nshow = [\"final\"]\nmeasure = [\"false_bend\"]\n" + thresholds(2) +
                      std::string(kFront) + kSide);
  const FolderContent expected = unbroken();
  fs::copy(file("unbroken"), file("out"), fs::copy_options::recursive);
  std::vector<fs::path> causes;
  for (const fs::directory_entry& entry : fs::directory_iterator(file("out/causes")))
    causes.push_back(entry.path());
  ASSERT_EQ(causes.size(), 4U) << "two thresholds in two views";
  EXPECT_FALSE(fs::exists(file("out/reference")));
  std::ofstream(causes.front()) << "no picture";
  EXPECT_EQ(finish(expected, "cells_measured"), 1);
  EXPECT_EQ(finish(expected, "cells_measured"), 0);
}

TEST_F(StudyViews, changed_views_leave_nothing_of_the_old_ones) {
  ASSERT_TRUE(succeeds(study("s", "out")));
  write_views(std::string(kFront) + "[[view]]\nname = \"side\"\n[view.set]\ncamera.eye = [5, 3, 6]\n");
  EXPECT_EQ(finish(unbroken()), kViewCells) << "another camera";
  write_views(std::string(kFront) + "[[view]]\nname = \"right\"\n[view.set]\ncamera.eye = [5, 3, 6]\n");
  EXPECT_EQ(finish(unbroken()), kViewCells) << "another name";
  write_views(kFront);
  EXPECT_EQ(finish(unbroken()), kViewCells) << "one less";
}

TEST_F(StudyViews, a_longer_axis_keeps_the_cells_that_are_still_the_same) {
  const std::string head =
      "size = [96, 72]\n" + std::string(kFront) + kSide + "[[axis]]\nkey = \"model.box.size\"\nvalues = ";
  write_spec("s", head + "[1.4, 2]\n");
  ASSERT_TRUE(succeeds(study("s", "out")));
  write_spec("s", head + "[1.4, 2, 1]\n");
  EXPECT_EQ(finish(unbroken()), 1);
}

/// What one view alone gives and what both pool to, over a few thresholds.
class PooledViews : public StudyTest {
 protected:
  static constexpr int kThresholds = 4;

  /// Runs the study of both views ("both") or of one; returns its rows.
  std::vector<Row> rows(const std::string& name) const {
    const std::map<std::string, std::string> ends{{"both", std::string(kFront) + kSide},
                                                  {"front", "[set]\ncamera.fov = 50\n"},
                                                  {"side", "[set]\ncamera.eye = [6, 2, 5]\n"}};
    write_spec(name, "size = [96, 72]\nshow = [\"final\"]\nmeasure = true\n" + thresholds(kThresholds) +
                         ends.at(name));
    EXPECT_TRUE(succeeds(study(name, name)));
    return table(name).rows;
  }
};

double number(const Row& row, const std::string& column) {
  return std::stod(row.at(column));
}

/// The whole number that a share of `whole` stands for.
double part(double share, double whole) {
  const double count = share * whole;
  EXPECT_NEAR(count, std::round(count), 1e-6) << share << " of " << whole;
  return std::round(count);
}

void expect_pooled(const Row& both, const Row& a, const Row& b) {
  const auto sum = [&](const char* column) { return number(a, column) + number(b, column); };
  for (const char* column : {"matched", "predicted", "referenced", "components", "ink_px"})
    EXPECT_EQ(number(both, column), sum(column)) << column;
  const auto sum_of_parts = [&](const char* column, const char* whole, double unit) {
    return part(number(a, column) / unit, number(a, whole)) +
           part(number(b, column) / unit, number(b, whole));
  };
  const double precision = sum_of_parts("precision", "predicted", 1) / sum("predicted");
  const double recall = sum("matched") / sum("referenced");
  EXPECT_DOUBLE_EQ(number(both, "precision"), precision);
  EXPECT_DOUBLE_EQ(number(both, "recall"), recall);
  EXPECT_DOUBLE_EQ(number(both, "f1"), 2 * precision * recall / (precision + recall));
  const double gaps = sum_of_parts("breaks_per_100px", "referenced", 100);
  EXPECT_DOUBLE_EQ(number(both, "breaks_per_100px"), 100 * gaps / sum("referenced"));
  EXPECT_DOUBLE_EQ(number(both, "ends_per_100px"),
                   100 * sum_of_parts("ends_per_100px", "predicted", 100) / sum("predicted"));
  EXPECT_DOUBLE_EQ(number(both, "baddeley"),
                   std::sqrt((std::pow(number(a, "baddeley"), 2) + std::pow(number(b, "baddeley"), 2)) / 2));
}

TEST_F(PooledViews, add_up_their_counts_before_any_ratio_is_taken) {
  const std::vector<Row> both = rows("both"), front = rows("front"), side = rows("side");
  for (int i = 0; i < kThresholds; ++i) {
    SCOPED_TRACE(i);
    expect_pooled(both[i], front[i], side[i]);
    EXPECT_NE(front[i].at("f1"), side[i].at("f1")) << "else an average would do as well";
  }
}

/// A class has as many pixels in a view at every threshold, so one weight must explain all pooled recalls.
TEST_F(PooledViews, weigh_the_recall_of_a_class_by_its_pixels) {
  const std::vector<Row> all_both = rows("both"), all_front = rows("front"), all_side = rows("side");
  for (const char* column : {"recall_silhouette", "recall_crease", "recall_boundary", "recall_object"}) {
    SCOPED_TRACE(column);
    double weight = -1;  // of the front view
    int explained = 0;
    for (int i = 0; i < kThresholds; ++i) {
      const double both = number(all_both[i], column), front = number(all_front[i], column),
                   side = number(all_side[i], column);
      if (weight < 0 && front != side) weight = (both - side) / (front - side);
      if (weight < 0) continue;
      EXPECT_NEAR(both, weight * front + (1 - weight) * side, 1e-9) << i;
      ++explained;
    }
    EXPECT_TRUE(weight > 0 && weight < 1) << weight;
    EXPECT_GE(explained, 2);
  }
}

TEST_F(PooledViews, a_single_view_is_what_score_makes_of_its_maps) {
  const Row row = rows("side")[1];
  const CommandResult rendered = inkbench({"render", "--from", "side/cells/0002_final.png", "--buffers",
                                           "lines,reference", "--format", "exr", "--out", "maps"});
  ASSERT_TRUE(succeeds(rendered));
  const CommandResult result = inkbench({"score", "maps/lines.exr", "maps/reference.exr", "--json"});
  ASSERT_TRUE(succeeds(result));
  const nlohmann::json score = nlohmann::json::parse(result.out);
  for (const char* column :
       {"matched", "predicted", "referenced", "precision", "recall", "f1", "chamfer", "hd95", "baddeley",
        "breaks_per_100px", "mean_gap_px", "components", "ends_per_100px", "thickness_px", "thickness_cov"})
    EXPECT_EQ(score.at(column).get<double>(), number(row, column)) << column;
}

}  // namespace
}  // namespace inkbench
