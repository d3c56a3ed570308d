// SPDX-License-Identifier: MIT
// Work that fails: a cell is recorded and the rest go on; a disk that is full or refuses loses nothing.
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "tests/cli/study_fixture.h"
#include "tests/cli/written_mesh.h"
#include "tests/places.h"

namespace inkbench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class StudyFailure : public StudyTest {
 protected:
  /// Five cells over a mesh, of which the second is not one.
  StudyFailure() {
    for (const std::string name : {"a", "c", "d", "e"}) write(name + ".off", cube_off(1.0, 0.0));
    write("broken.off", "this is no mesh");
    write("scene.toml", small_scene() + "[[model]]\nname = \"thing\"\nmesh = \"a.off\"\nsize = 1\n");
    write_spec("s",
               "[[axis]]\nkey = \"model.thing.mesh\"\nvalues = [\"a.off\", \"broken.off\", \"c.off\", "
               "\"d.off\", \"e.off\"]\n");
  }
  nlohmann::json manifest(const std::string& out) const {
    return nlohmann::json::parse(content_of(file(out) / "manifest.json"));
  }
};

/// Every picture under its final name is whole and that of the finished study.
void expect_pictures_of(const fs::path& folder, const FolderContent& finished) {
  for (const auto& [name, content] : folder_content(folder)) {
    EXPECT_TRUE(!name.ends_with(".png") || content == finished.at(name)) << name;
  }
}

TEST_F(StudyFailure, failed_cell_is_recorded_and_the_rest_go_on) {
  const CommandResult result = study("s", "out");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("4 / 5 cells, 1 failed"));
  EXPECT_THAT(result.err, HasSubstr("inkbench: error: cell 2 (mesh = broken.off): "));
  EXPECT_THAT(result.err, HasSubstr("1 of 5 cells failed; the same command tries them again"));
  const StudyTable data = table("out");
  EXPECT_THAT(data.column("cell"), ElementsAre("1", "2", "3", "4", "5"));
  EXPECT_THAT(data.rows[1].at("error"), HasSubstr("broken.off"));
  EXPECT_EQ(data.rows[1].at("ink"), "");
  EXPECT_EQ(data.rows[1].at("FILE_final"), "");
  for (const size_t good : {0, 2, 3, 4}) {
    EXPECT_EQ(data.rows[good].at("error"), "");
    EXPECT_TRUE(fs::exists(file("out") / data.rows[good].at("FILE_final")));
  }
  EXPECT_TRUE(fs::exists(file("out/grid.png"))) << "with the failed cell marked";
  EXPECT_EQ(manifest("out").at("failures").size(), 1U);
}

TEST_F(StudyFailure, fixed_cell_alone_is_tried_again_and_the_end_is_the_same) {
  EXPECT_EQ(study("s", "out").status, 1);
  write("broken.off", cube_off(1.0, 0.0));
  EXPECT_TRUE(succeeds(study("s", "out")));
  EXPECT_EQ(manifest("out").at("times").at("cells_drawn"), 1);
  EXPECT_TRUE(succeeds(study("s", "reference")));
  EXPECT_EQ(difference(lasting_content(file("reference")), lasting_content(file("out"))), "same");
}

TEST_F(StudyFailure, fail_fast_stops_at_the_first) {
  const CommandResult result = study("s", "out", {"--fail-fast"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("broken.off"));
  EXPECT_LT(table("out").rows.size(), 5U);
  EXPECT_FALSE(fs::exists(file("out/cells/0005_final.png")));
}

TEST_F(StudyFailure, one_failing_study_of_a_folder_does_not_stop_the_others) {
  fs::create_directories(file("specs"));
  fs::rename(file("s.toml"), file("specs/a_fails.toml"));
  for (const std::string name : {"a.off", "broken.off", "c.off", "d.off", "e.off", "scene.toml"})
    fs::copy(file(name), file("specs") / name);
  fs::rename(file("specs/scene.toml"), file("specs/scene.scene"));
  std::string spec = content_of(file("specs/a_fails.toml"));
  spec.replace(spec.find("scene.toml"), 10, "scene.scene");
  write("specs/a_fails.toml", spec);
  write("specs/b_works.toml", "scene = \"scene.scene\"\n");
  EXPECT_EQ(inkbench({"study", "specs", "--out", "out"}).status, 1);
  EXPECT_TRUE(fs::exists(file("out/b_works/grid.png")));
}

TEST_F(StudyFailure, full_disk_leaves_nothing_half_written_and_the_next_run_ends_well) {
  write_spec("big", "size = [200, 150]\nshow = [\"normal\"]\n" + threshold_axis(4));
  ASSERT_TRUE(succeeds(study("big", "reference")));
  const FolderContent reference = lasting_content(file("reference"));
  const uint64_t cell_bytes = fs::file_size(file("reference/cells/0001_normal.png"));
  // Too little for a cell; for the grid; for the manifest, the first file of all.
  for (const uint64_t limit : {cell_bytes / 2, cell_bytes + 500, uint64_t{700}}) {
    const std::string out = "out" + std::to_string(limit);
    CommandOptions full;
    full.file_size_limit_bytes = limit;
    const CommandResult result = study("big", out, {}, full);
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_EQ(result.signal, 0);
    EXPECT_THAT(result.err, HasSubstr("inkbench: error: "));
    EXPECT_THAT(unfinished_files(file(out)), IsEmpty());
    expect_pictures_of(file(out), reference);
    ASSERT_TRUE(succeeds(study("big", out)));
    EXPECT_EQ(difference(reference, lasting_content(file(out))), "same");
  }
}

/// Runs a shell script as a user who may mount a small disk; the status is 77 where the system does not allow
/// that.
CommandResult run_with_small_disk(const fs::path& folder, const std::string& size,
                                  const std::string& script) {
  CommandOptions options;
  options.working_folder = folder;
  fs::create_directories(folder / "disk");
  return run_command({"/usr/bin/env", "unshare", "-rm", "sh", "-c",
                      "mount -t tmpfs -o size=" + size + " none disk || exit 77; " + script},
                     options);
}

TEST_F(StudyFailure, disk_that_fills_up_leaves_nothing_half_written_and_the_next_run_ends_well) {
  write_spec("big", "size = [200, 150]\nshow = [\"normal\"]\n" + threshold_axis(8));
  ASSERT_TRUE(succeeds(study("big", "reference")));
  const FolderContent reference = lasting_content(file("reference"));
  const std::string run =
      inkbench_program() + " study big.toml --out disk/out; status=$?; cp -r disk/out out; exit $status";
  if (run_with_small_disk(file(""), "100k", "exit 0").status != 0)
    GTEST_SKIP() << "no disk can be mounted here";
  const CommandResult result = run_with_small_disk(file(""), "100k", run);
  EXPECT_EQ(result.status, 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr("the disk is full"));
  EXPECT_THAT(unfinished_files(file("out")), IsEmpty());
  expect_pictures_of(file("out"), reference);
  ASSERT_TRUE(succeeds(study("big", "out")));
  EXPECT_EQ(difference(reference, lasting_content(file("out"))), "same");
}

class Unwritable : public CliTest {
 protected:
  Unwritable() { write("scene.toml", small_scene()); }
};

TEST_F(Unwritable, image_that_does_not_fit_is_not_left_behind) {
  for (const std::string format : {"png", "exr"}) {
    CommandOptions full;
    full.file_size_limit_bytes = 600;
    const CommandResult result = inkbench({"render", "--scene", "scene.toml", "--out", "out", "--size",
                                           "200x200", "--buffers", "normal", "--format", format},
                                          full);
    EXPECT_TRUE(is_work_error(result, {"out/normal." + format, "file size"}));
    EXPECT_TRUE(fs::is_empty(file("out")));
  }
}

TEST_F(Unwritable, image_that_does_not_fit_leaves_the_old_one) {
  ASSERT_TRUE(succeeds(inkbench({"render", "--scene", "scene.toml", "--out", "out"})));
  const FolderContent before = folder_content(file("out"));
  CommandOptions full;
  full.file_size_limit_bytes = 600;
  EXPECT_EQ(inkbench({"render", "--scene", "scene.toml", "--out", "out", "--size", "200x200"}, full).status,
            1);
  EXPECT_EQ(folder_content(file("out")), before);
}

TEST_F(Unwritable, folder_below_a_file_is_refused) {
  write("file.txt", "x");
  EXPECT_TRUE(is_work_error(inkbench({"render", "--scene", "scene.toml", "--out", "file.txt"}),
                            {"file.txt", "folder"}));
  EXPECT_TRUE(is_work_error(inkbench({"render", "--scene", "scene.toml", "--out", "file.txt/out"}),
                            {"file.txt/out", "folder"}));
  write("s.toml", "scene = \"scene.toml\"\n");
  EXPECT_TRUE(
      is_work_error(inkbench({"study", "s.toml", "--out", "file.txt/out"}), {"file.txt/out", "folder"}));
  EXPECT_EQ(content_of(file("file.txt")), "x");
}

TEST_F(Unwritable, file_system_that_refuses_is_named) {
  EXPECT_TRUE(is_work_error(inkbench({"render", "--scene", "scene.toml", "--out", "/proc/inkbench"}),
                            {"/proc/inkbench"}));
  EXPECT_TRUE(is_work_error(inkbench({"render", "--scene", "scene.toml", "--out", "/proc"}),
                            {"/proc/final.png", "cannot be written"}));
}

TEST_F(Unwritable, folder_without_permission_is_named) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  fs::create_directories(file("locked"));
  fs::permissions(file("locked"), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_TRUE(is_work_error(inkbench({"render", "--scene", "scene.toml", "--out", "locked"}),
                            {"locked", "permission"}));
  fs::permissions(file("locked"), fs::perms::owner_all);
}

TEST_F(Unwritable, closed_output_is_no_crash) {
  const CommandResult result = run_command({"/bin/sh", "-c", inkbench_program() + " params | head -n 1"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.err, IsEmpty());
}

}  // namespace
}  // namespace inkbench
