// SPDX-License-Identifier: MIT
// What commands do where outputs are closed or full, inputs are no files, names are hostile, memory is short,
// and where somebody has had enough.
#include <fmt/format.h>
#include <sys/stat.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/cli/study_fixture.h"
#include "tests/places.h"

namespace inkbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Reliability : public StudyTest {
 protected:
  /// A line of shell, in the test's folder, where $I is inkbench.
  CommandResult shell(const std::string& line, CommandOptions options = {}) const {
    options.working_folder = file("");
    options.environment["I"] = inkbench_program();
    return run_command({"/bin/bash", "-c", line}, options);
  }

  std::string state_of(const std::string& out) const {
    return nlohmann::json::parse(content_of(file(out) / "manifest.json")).at("state");
  }

  /// A gnuplot that is found before the real one.
  CommandOptions with_gnuplot(const std::string& script) const {
    write("bin/gnuplot", "#!/bin/sh\n" + script);
    fs::permissions(file("bin/gnuplot"), fs::perms::owner_all);
    CommandOptions options;
    options.environment["PATH"] = file("bin").string() + ":/usr/bin:/bin";
    return options;
  }

  void write_study_with_chart() const {
    write_spec("s",
               threshold_axis(3) + "[[chart]]\nname = \"c\"\nx = \"combine.k_normal\"\ny = \"ink_px\"\n");
  }
};

TEST_F(Reliability, standard_output_that_takes_nothing_is_status_1) {
  const CommandResult result = shell("\"$I\" params > /dev/full");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("standard output: cannot be written; the disk is full"));
}

TEST_F(Reliability, closed_standard_descriptors_lose_nothing) {
  const std::string render = "\"$I\" render --scene scene.toml --mesh box.obj --out ";
  write("box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  EXPECT_EQ(shell(render + "usual").status, 0);
  for (const char* closed : {"<&- >&- 2>&-", ">&-", "2>&-"}) {
    fs::remove_all(file("out"));
    EXPECT_EQ(shell(render + "out " + closed).status, 0) << closed;
    EXPECT_EQ(folder_content(file("out")), folder_content(file("usual"))) << closed;
  }
}

TEST_F(Reliability, names_and_titles_do_nothing_to_a_terminal) {
  const std::string named =
      "no\x1b[31m\xc2\x9b"
      "2J\xff.obj";
  const CommandResult render = inkbench({"render", "--mesh", named, "--out", "out"});
  EXPECT_THAT(render.err, AllOf(HasSubstr("no\\u001b[31m\\u009b2J\\xff.obj"), Not(HasSubstr("\x1b"))));
  write("s.toml",
        "title = \"evil \\u001b[2J\\nsecond\"\nscene = \"scene.toml\"\n[[axis]]\nkey = "
        "\"combine.k_normal\"\nvalues = [1]\nlabels = [\"\\u001b[2J\"]\n");
  const CommandResult unknown = inkbench({"study", "s.toml", "--dry-run"});
  EXPECT_THAT(unknown.out + unknown.err, Not(HasSubstr("\x1b")));
  write_spec("t", "");
  write("t.toml", "title = \"evil \\u001b[2J\\nsecond\"\nscene = \"scene.toml\"\n");
  EXPECT_THAT(inkbench({"study", "t.toml", "--dry-run"}).out,
              HasSubstr("evil \\u001b[2J\\u000asecond: 1 cell"));
}

TEST_F(Reliability, pipes_and_files_of_proc_are_no_scenes_specs_or_images) {
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
  for (const auto& [path, words] :
       {std::pair{"pipe", "is not a regular file"}, {"/proc/self/status", "bytes"}}) {
    EXPECT_TRUE(is_input_error(inkbench({"render", "--scene", path, "--out", "out"}), {path, words}));
    EXPECT_TRUE(is_input_error(inkbench({"study", path, "--out", "out"}), {path, words}));
    EXPECT_TRUE(is_input_error(inkbench({"score", path, path}), {path, words}));
  }
}

TEST_F(Reliability, a_file_in_a_folder_that_is_not_named_in_utf8_is_refused) {
  write("bad\xff/box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_TRUE(is_input_error(
      inkbench({"render", "--scene", "scene.toml", "--mesh", "bad\xff/box.obj", "--out", "out"}),
      {"bad\\xff/box.obj", "is not UTF-8"}));
  write("bad\xff.toml", "title = \"x\"\nscene = \"scene.toml\"\n");
  EXPECT_TRUE(
      is_input_error(inkbench({"study", "bad\xff.toml", "--out", "out"}), {"bad\\xff.toml", "UTF-8"}));
}

TEST_F(Reliability, numbers_that_are_none_are_refused) {
  for (const char* number : {"nan", "-nan", "inf", "1e999", "-1", "x", ""}) {
    const CommandResult result =
        inkbench({"decimate", "rabbit", "--faces", "9", "--out", "out", "--weld", number});
    EXPECT_TRUE(is_input_error(result, {"--weld"})) << number;
  }
}

TEST_F(Reliability, pictures_that_cannot_fit_into_memory_are_refused_with_the_numbers) {
  CommandOptions options;
  options.environment["INKBENCH_RENDERER"] = "software";
  const CommandResult result =
      shell("ulimit -v 5000000; \"$I\" render --scene scene.toml --size 8192x8192 --out out", options);
  EXPECT_TRUE(is_work_error(result, {"8192 x 8192 px needs about 5.9 GB of memory", "GB can be had"}));
}

TEST_F(Reliability, subdivision_that_cannot_fit_into_memory_is_refused_with_the_numbers) {
  CommandOptions options;
  options.environment["INKBENCH_RENDERER"] = "software";
  const CommandResult result =
      shell("ulimit -v 2000000; \"$I\" render --size 64x64 --set mesh.subdivide=4 --out out", options);
  EXPECT_TRUE(
      is_work_error(result, {"mesh.subdivide", "faces needs about", "can be had; take fewer rounds"}));
}

TEST_F(Reliability, a_chart_that_the_plotting_program_left_cut_off_does_not_get_its_name) {
  write_study_with_chart();
  for (const char* ending : {"png", "svg"}) {
    const CommandResult result =
        study("s", "out", {},
              with_gnuplot(fmt::format("/usr/bin/gnuplot \"$@\"; truncate -s -9 '{}'/out/charts/"
                                       "inkbench_*/c.{}\n",
                                       file("").string(), ending)));
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.err, HasSubstr(fmt::format("gnuplot left c.{} cut off", ending)));
    EXPECT_FALSE(fs::exists(file("out/charts/c.png")) || fs::exists(file("out/charts/c.svg")));
  }
}

TEST_F(Reliability, charts_need_no_room_in_the_temporary_folder) {
  write_study_with_chart();
  CommandOptions options;
  options.environment["TMPDIR"] = "/nowhere";
  EXPECT_TRUE(succeeds(study("s", "out", {}, options)));
  EXPECT_TRUE(fs::exists(file("out/charts/c.png")));
}

TEST_F(Reliability, sigterm_is_heard_while_a_chart_is_drawn_and_the_manifest_says_stopped) {
  write_study_with_chart();
  CommandOptions options = with_gnuplot("touch '" + file("began").string() + "'; exec sleep 500\n");
  options.signal_when = [&](double) { return fs::exists(file("began")) ? SIGTERM : 0; };
  const CommandResult result = study("s", "out", {}, options);
  EXPECT_FALSE(result.timed_out);
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("stopped"));
  EXPECT_EQ(state_of("out"), "stopped");
  EXPECT_THAT(unfinished_files(file("out")), IsEmpty());
}

TEST_F(Reliability, after_a_full_disk_the_manifest_says_stopped) {
  write_spec("s", threshold_axis(12));
  CommandOptions options;
  options.file_size_limit_bytes = 20'000;  // each picture has room, their grid has none
  EXPECT_EQ(study("s", "out", {}, options).status, 1);
  EXPECT_EQ(state_of("out"), "stopped");
}

TEST_F(Reliability, results_are_not_written_through_a_planted_link) {
  write_spec("s", threshold_axis(2));
  for (const char* inner : {"cells", "tiles", "charts"}) {
    fs::remove_all(file("out"));
    fs::create_directories(file("out"));
    fs::create_directories(file("elsewhere"));
    fs::create_symlink(file("elsewhere"), file("out") / inner);
    EXPECT_TRUE(is_work_error(study("s", "out"), {inner, "is a link"}));
    EXPECT_TRUE(fs::is_empty(file("elsewhere")));
  }
  fs::remove_all(file("out"));
  fs::create_directories(file("out"));
  write("theirs", "theirs");
  for (const char* name : {"grid.png", "data.csv", "journal.jsonl", "index.html", "manifest.json"})
    fs::create_symlink(file("theirs"), file("out") / name);
  EXPECT_TRUE(succeeds(study("s", "out")));
  EXPECT_EQ(content_of(file("theirs")), "theirs");
}

TEST_F(Reliability, verify_finds_what_was_changed_and_nothing_else) {
  write_study_with_chart();
  ASSERT_TRUE(succeeds(study("s", "good")));
  const CommandResult good = inkbench({"study", "verify", "good"});
  EXPECT_TRUE(succeeds(good));
  EXPECT_THAT(good.out, AllOf(HasSubstr("good: finished, 3 cells"), HasSubstr(" 0 problems")));
  for (const char* name : {"data.csv", "journal.jsonl", "grid.png", "index.html", "charts/c.svg",
                           "charts/c.png", "cells/0002_final.png"}) {
    fs::remove_all(file("out"));
    fs::copy(file("good"), file("out"), fs::copy_options::recursive);
    std::string content = content_of(file("out") / name);
    content[content.size() / 2] ^= 1;
    write(std::string("out/") + name, content);
    const CommandResult result = inkbench({"study", "verify", "out"});
    EXPECT_EQ(result.status, 1) << name;
    EXPECT_THAT(result.out, HasSubstr(std::string(name) + " was changed")) << name;
  }
  fs::remove(file("out/cells/0001_final.png"));
  EXPECT_THAT(inkbench({"study", "verify", "out"}).out, HasSubstr("cells/0001_final.png is missing"));
  EXPECT_TRUE(is_input_error(inkbench({"study", "verify", "bin"}), {"bin", "is no folder"}));
  EXPECT_TRUE(is_input_error(inkbench({"study", "verify"}), {"which folder"}));
}

TEST_F(Reliability, texts_like_formulas_are_guarded_in_the_table_and_plain_in_charts) {
  write_spec("s",
             threshold_axis(2) +
                 "[[variant]]\nname = \"=1+1\"\nset = {}\n[[variant]]\nname = \"-b\"\nset = {}\n"
                 "[[chart]]\nname = \"c\"\nx = \"combine.k_normal\"\ny = \"ink_px\"\nby = \"variant\"\n");
  EXPECT_TRUE(succeeds(study("s", "out")));
  EXPECT_THAT(content_of(file("out/data.csv")), AllOf(HasSubstr("\n1,'=1+1,"), HasSubstr(",'-b,")));
  EXPECT_THAT(content_of(file("out/charts/c.svg")), AllOf(HasSubstr(">=1+1<"), Not(HasSubstr("'=1+1"))));
}

}  // namespace
}  // namespace inkbench
