// SPDX-License-Identifier: MIT
// The record as such, its file, and the cache under damage and races.
#include "pipeline/mesh/levels/collapse_record_file.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/cache_folder.h"
#include "pipeline/base/files.h"
#include "pipeline/base/log.h"
#include "pipeline/mesh/levels/decimation.h"
#include "pipeline/mesh/shapes/primitives.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using testing::HasSubstr;

/// Sets environment variables (nullptr: unsets) and puts back what was there.
class Environment {
 public:
  Environment(std::initializer_list<std::pair<std::string, const char*>> values) {
    for (const auto& [name, value] : values) {
      const char* const old = std::getenv(name.c_str());
      old_.push_back({name, old != nullptr, old != nullptr ? old : ""});
      set(name, value);
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
  ~Environment() {
    for (const Old& old : old_) set(old.name, old.was_set ? old.value.c_str() : nullptr);
  }

 private:
  struct Old {
    std::string name;
    bool was_set;
    std::string value;
  };
  static void set(const std::string& name, const char* value) {
    if (value == nullptr) {
      unsetenv(name.c_str());
    } else {
      setenv(name.c_str(), value, 1);
    }
  }
  std::vector<Old> old_;
};

TEST(CollapseRecord, the_level_is_the_nearest_not_above) {
  CollapseRecord record;
  record.faces = {10, 8, 6, 5, 3};
  record.collapses.resize(4);
  EXPECT_EQ(collapses_for(record, 12), 0U);
  EXPECT_EQ(collapses_for(record, 10), 0U);
  EXPECT_EQ(collapses_for(record, 9), 1U);
  EXPECT_EQ(collapses_for(record, 6), 2U);
  EXPECT_EQ(collapses_for(record, 4), 4U);
  EXPECT_EQ(collapses_for(record, 2), 4U) << "the fewest there are";
}

TEST(CollapseRecord, as_many_as_loaded_or_zero_is_the_mesh_itself) {
  const Mesh box = make_box(2);
  const CollapseRecord record = record_collapses(box);
  for (const size_t asked : {size_t{0}, box.triangles.size(), box.triangles.size() + 5}) {
    const Mesh level = mesh_at_level(box, record, asked);
    EXPECT_EQ(level.positions, box.positions);
    EXPECT_EQ(level.triangles, box.triangles);
    EXPECT_TRUE(level.notes.empty());
  }
}

TEST(CollapseRecord, a_count_below_the_minimum_is_noted) {
  const Mesh box = make_box(4);
  const Mesh level = mesh_at_level(box, record_collapses(box), 1);
  EXPECT_EQ(level.triangles.size(), 4U);
  ASSERT_EQ(level.notes.size(), 1U);
  EXPECT_THAT(level.notes[0], HasSubstr("ends at 4 faces; 1 were asked for"));
}

TEST(CollapseRecord, a_file_reads_back_equal) {
  for (const Mesh& mesh : {make_box(3), make_torus(12, 0.3F), make_plane(5)}) {
    const CollapseRecord record = record_collapses(mesh);
    const Key key = collapse_record_key(mesh);
    EXPECT_EQ(read_collapse_record(write_collapse_record(record, key), mesh, key), record);
  }
}

TEST(CollapseRecord, the_key_is_of_positions_and_triangles) {
  const Mesh box = make_box(2);
  const Key key = collapse_record_key(box);
  Mesh other = box;
  other.normals[0] = -other.normals[0];
  other.notes.push_back("x");
  EXPECT_EQ(collapse_record_key(other), key);
  other.positions[3].x += 1e-6F;
  EXPECT_NE(collapse_record_key(other), key);
  other = box;
  std::swap(other.triangles[0], other.triangles[1]);
  EXPECT_NE(collapse_record_key(other), key);
}

TEST(CollapseRecord, any_changed_byte_and_any_missing_end_is_found) {
  const Mesh mesh = make_box(1);
  const Key key = collapse_record_key(mesh);
  const std::string good = write_collapse_record(record_collapses(mesh), key);
  ASSERT_TRUE(read_collapse_record(good, mesh, key).has_value());
  for (size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x11);
    EXPECT_FALSE(read_collapse_record(bad, mesh, key).has_value()) << i;
    EXPECT_FALSE(read_collapse_record(std::string_view(good).substr(0, i), mesh, key).has_value()) << i;
  }
  EXPECT_FALSE(read_collapse_record(good + "x", mesh, key).has_value());
}

TEST(CollapseRecord, a_record_of_another_mesh_is_refused) {
  const Mesh mesh = make_box(2);
  Mesh other = mesh;
  other.positions[0] += glm::vec3(0.01F);
  const CollapseRecord record = record_collapses(mesh);
  EXPECT_TRUE(is_record_of(record, mesh));
  EXPECT_FALSE(is_record_of(record, other));
  EXPECT_FALSE(is_record_of(record, make_box(3)));
}

TEST(CollapseRecord, what_cannot_be_replayed_is_refused) {
  const Mesh mesh = make_box(2);
  const CollapseRecord good = record_collapses(mesh);
  ASSERT_TRUE(is_record_of(good, mesh));
  const auto is_refused = [&](const auto& damage) {
    CollapseRecord bad = good;
    damage(bad);
    return !is_record_of(bad, mesh);
  };
  EXPECT_TRUE(
      is_refused([](CollapseRecord& r) { r.corners[1][2] = static_cast<uint32_t>(r.origin.size()); }));
  EXPECT_TRUE(is_refused([](CollapseRecord& r) { r.corners[0] = {CollapseRecord::kLeftOut, 0, 1}; }));
  EXPECT_TRUE(is_refused([](CollapseRecord& r) { std::swap(r.corners[0][0], r.corners[0][1]); }));
  EXPECT_TRUE(is_refused([](CollapseRecord& r) { r.origin[3] = 1'000'000; }));
  EXPECT_TRUE(is_refused([](CollapseRecord& r) { r.next_equal[0] = 1'000'000; }));
  EXPECT_TRUE(is_refused([](CollapseRecord& r) { r.next_equal[0] = r.next_equal[1]; }));
  EXPECT_TRUE(is_refused([](CollapseRecord& r) { r.collapses[0].removed = 1'000'000; }));
  EXPECT_TRUE(is_refused([](CollapseRecord& r) { r.collapses[0].kept = r.collapses[0].removed; }));
  EXPECT_TRUE(is_refused([](CollapseRecord& r) { r.collapses[2].kept = r.collapses[0].removed; }));
  EXPECT_TRUE(is_refused([](CollapseRecord& r) { r.collapses.back() = r.collapses.front(); }));
  EXPECT_TRUE(is_refused([](CollapseRecord& r) { r.faces[1] = r.faces[0]; }));
  EXPECT_TRUE(is_refused([](CollapseRecord& r) { r.faces.back() -= 1; }));
  EXPECT_TRUE(is_refused([](CollapseRecord& r) { r.faces.pop_back(); }));
  EXPECT_TRUE(is_refused([](CollapseRecord& r) { r.faces.clear(); }));
}

TEST(CollapseRecordCache, lies_where_the_environment_says) {
  const Environment home({{"HOME", "/h"}, {"XDG_CACHE_HOME", nullptr}, {"INKBENCH_CACHE", nullptr}});
  EXPECT_EQ(cache_folder(), "/h/.cache/inkbench");
  {
    const Environment xdg({{"XDG_CACHE_HOME", "/x"}});
    EXPECT_EQ(cache_folder(), "/x/inkbench");
    const Environment own({{"INKBENCH_CACHE", "/o"}});
    EXPECT_EQ(cache_folder(), "/o");
    const Environment none({{"INKBENCH_CACHE", ""}});
    EXPECT_EQ(cache_folder(), "");
  }
  const Environment relative({{"XDG_CACHE_HOME", "x"}});
  EXPECT_EQ(cache_folder(), "/h/.cache/inkbench");
}

TEST(CollapseRecordCache, a_record_is_kept_and_used) {
  const TemporaryFolder folder;
  const Environment cache({{"INKBENCH_CACHE", folder.path().c_str()}});
  const Mesh mesh = make_torus(12, 0.3F);
  const CollapseRecord record = cached_collapse_record(mesh);
  EXPECT_EQ(record, record_collapses(mesh));
  // A sound record that the decimation would not make shows which of the two is returned.
  const Key key = collapse_record_key(mesh);
  CollapseRecord shorter = record;
  shorter.collapses.pop_back();
  shorter.faces.pop_back();
  ASSERT_TRUE(fs::exists(collapse_record_path(key)));
  write_file_atomically(collapse_record_path(key), write_collapse_record(shorter, key));
  EXPECT_EQ(cached_collapse_record(mesh), shorter);
}

TEST(CollapseRecordCache, a_damaged_file_is_ignored_and_replaced) {
  const TemporaryFolder folder;
  const Environment cache({{"INKBENCH_CACHE", folder.path().c_str()}});
  const Mesh mesh = make_torus(12, 0.3F);
  const CollapseRecord record = record_collapses(mesh);
  const Key key = collapse_record_key(mesh);
  const std::string good = write_collapse_record(record, key);
  for (const std::string& bad : {std::string(), good.substr(0, good.size() / 2), std::string(500, 'x')}) {
    write_file_atomically(collapse_record_path(key), bad);
    EXPECT_EQ(cached_collapse_record(mesh), record);
    EXPECT_EQ(read_file(collapse_record_path(key)), good);
  }
}

TEST(CollapseRecordCache, a_place_that_cannot_be_written_to_is_a_note_and_no_error) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("file", "");
  const Environment cache({{"INKBENCH_CACHE", file.c_str()}});
  std::vector<std::string> notes;
  const LogSink before = set_log_sink([&](const std::string& note) { notes.push_back(note); });
  const Mesh mesh = make_box(2);
  EXPECT_EQ(cached_collapse_record(mesh), record_collapses(mesh));
  set_log_sink(before);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], HasSubstr("not kept"));
}

TEST(CollapseRecordCache, no_place_keeps_nothing) {
  const TemporaryFolder folder;
  const Environment cache({{"INKBENCH_CACHE", ""}, {"XDG_CACHE_HOME", folder.path().c_str()}});
  const Mesh mesh = make_box(2);
  EXPECT_EQ(cached_collapse_record(mesh), record_collapses(mesh));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(CollapseRecordCache, racing_processes_all_get_the_record) {
  const TemporaryFolder folder;
  const Environment cache({{"INKBENCH_CACHE", folder.path().c_str()}});
  const Mesh mesh = make_torus(16, 0.3F);
  const CollapseRecord record = record_collapses(mesh);
  const fs::path file = collapse_record_path(collapse_record_key(mesh));
  std::vector<pid_t> children;
  for (int child = 0; child < 4; ++child) {
    const pid_t pid = fork();
    ASSERT_GE(pid, 0);
    if (pid == 0) {
      bool good = true;
      for (int round = 0; round < 20; ++round) {
        good = good && cached_collapse_record(mesh) == record;
        std::error_code error;
        if (round % 4 == child) fs::remove(file, error);
      }
      _exit(good ? 0 : 1);
    }
    children.push_back(pid);
  }
  for (const pid_t child : children) {
    int status = -1;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  }
  EXPECT_EQ(cached_collapse_record(mesh), record);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1)
      << "no temporary file is left";
}

}  // namespace
}  // namespace inkbench
