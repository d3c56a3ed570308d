// SPDX-License-Identifier: MIT
// The journal: whole lines are read, damaged ones are not, and files count only as long as they are
// unchanged.
#include "studies/sweep/journal.h"

#include <gmock/gmock.h>

#include "pipeline/base/files.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

CellRecord record(size_t index) {
  return {.index = index,
          .key = "key" + std::to_string(index),
          .numbers_key = "numbers",
          .origin = {"drawing", "measuring", "renderer"},
          .numbers = {"0.25", "4096"},
          .files = {{"cells/a.png", 12, "hash"}},
          .overlays = {{"reference/a.svg", 3, "other"}}};
}

class JournalFile : public ::testing::Test {
 protected:
  Journal read_all(const std::string& content) {
    return read_journal(folder_.write("journal.jsonl", content));
  }
  std::map<size_t, CellRecord> read(const std::string& content) { return read_all(content).cells; }
  const TemporaryFolder folder_;
};

TEST_F(JournalFile, lines_read_back_as_written) {
  CellRecord awkward = record(7);
  awkward.numbers = {"a \"b\"\n\\", "caf\xc3\xa9", ""};
  awkward.files = {{"one", 0, ""}, {"two, \"three\"", 18'446'744'073'709'551'615ULL, "h"}};
  const auto records = read(journal_line(record(0)) + journal_line(awkward));
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records.at(0).key, "key0");
  EXPECT_EQ(records.at(0).numbers_key, "numbers");
  EXPECT_EQ(records.at(0).origin, record(0).origin);
  ASSERT_EQ(records.at(0).overlays.size(), 1U);
  EXPECT_EQ(records.at(0).overlays[0].name, "reference/a.svg");
  EXPECT_EQ(records.at(7).index, 7U);
  EXPECT_EQ(records.at(7).numbers, awkward.numbers);
  ASSERT_EQ(records.at(7).files.size(), 2U);
  EXPECT_EQ(records.at(7).files[1].name, awkward.files[1].name);
  EXPECT_EQ(records.at(7).files[1].bytes, awkward.files[1].bytes);
  EXPECT_EQ(records.at(7).files[1].hash, "h");
}

TEST_F(JournalFile, a_record_is_one_line) {
  CellRecord awkward = record(1);
  awkward.numbers = {"two\nlines"};
  const std::string line = journal_line(awkward);
  EXPECT_EQ(line.find('\n'), line.size() - 1);
}

TEST_F(JournalFile, a_torn_last_line_is_left_out_wherever_it_was_torn) {
  const std::string whole = journal_line(record(0));
  const std::string torn = journal_line(record(1));
  for (size_t size = 0; size + 1 < torn.size(); ++size) {
    const auto records = read(whole + torn.substr(0, size));
    ASSERT_EQ(records.size(), 1U) << "after " << size << " bytes";
    ASSERT_TRUE(records.contains(0));
  }
}

TEST_F(JournalFile, garbage_is_left_out_and_what_follows_is_read) {
  for (const std::string& garbage :
       {std::string("garbage"), std::string("{}"), std::string("[]"), std::string("null"), std::string("3"),
        std::string(), std::string("{\"cell\":\"0\",\"key\":\"k\",\"numbers\":[],\"files\":[]}"),
        std::string("{\"cell\":0,\"key\":0,\"numbers\":[],\"files\":[]}"),
        std::string("{\"cell\":0,\"key\":\"k\",\"numbers\":[1],\"files\":[]}"),
        std::string("{\"cell\":0,\"key\":\"k\",\"numbers\":[],\"files\":[{}]}"),
        std::string("{\"cell\":0,\"key\":\"k\",\"numbers\":[],\"files\":[1]}"),
        std::string("{\"cell\":-1,\"key\":\"k\",\"numbers\":[],\"files\":[]}"),
        std::string("{\"cell\":1.5,\"key\":\"k\",\"numbers\":[],\"files\":[]}"),
        std::string("{\"cell\":1e300,\"key\":\"k\",\"numbers\":[],\"files\":[]}"),
        std::string("{\"cell\":true,\"key\":\"k\",\"numbers\":[],\"files\":[]}"),
        std::string(
            "{\"cell\":0,\"key\":\"k\",\"numbers\":[],\"files\":[{\"name\":\"a\",\"bytes\":1e99,\"hash\":"
            "\"h\"}]}"),
        std::string("\xff\0\x01", 3), std::string(100'000, '[')}) {
    const auto records = read(garbage + "\n" + journal_line(record(3)));
    ASSERT_EQ(records.size(), 1U) << garbage.substr(0, 80);
    EXPECT_TRUE(records.contains(3));
  }
}

TEST_F(JournalFile, a_line_does_not_count_once_any_of_its_characters_is_another) {
  const std::string line = journal_line(record(3));
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    std::string changed = line;
    changed[i] = changed[i] == '7' ? '8' : '7';
    const Journal journal = read_all(changed + journal_line(record(4)));
    EXPECT_THAT(journal.damaged, ElementsAre(1U)) << "character " << i;
    EXPECT_EQ(journal.cells.size(), 1U);
  }
}

TEST_F(JournalFile, a_torn_last_line_is_no_damage) {
  const std::string line = journal_line(record(3));
  EXPECT_TRUE(read_all(line.substr(0, line.size() - 9)).damaged.empty());
}

TEST_F(JournalFile, lines_of_before_without_a_hash_are_counted_and_not_taken) {
  const Journal journal = read_all(R"({"cell":5,"key":"k","numbers":["1"],"files":[]})"
                                   "\n");
  EXPECT_EQ(journal.older, 1U);
  EXPECT_TRUE(journal.cells.empty());
}

TEST_F(JournalFile, of_two_lines_of_a_cell_the_later_counts) {
  CellRecord later = record(0);
  later.key = "later";
  EXPECT_EQ(read(journal_line(record(0)) + journal_line(later)).at(0).key, "later");
}

TEST_F(JournalFile, none_is_empty) {
  EXPECT_TRUE(read_journal(folder_.path() / "none").cells.empty());
  EXPECT_TRUE(read_journal(folder_.path()).cells.empty()) << "a folder";
  EXPECT_TRUE(read("").empty());
}

TEST_F(JournalFile, files_are_intact_until_they_change) {
  folder_.write("cells/a.png", "0123456789");
  folder_.write("cells/b.png", "");
  const std::vector<FileRecord> cell{record_file(folder_.path(), "cells/a.png"),
                                     record_file(folder_.path(), "cells/b.png")};
  EXPECT_EQ(cell[0].bytes, 10U);
  EXPECT_EQ(cell[1].bytes, 0U);
  EXPECT_NE(cell[0].hash, cell[1].hash);
  EXPECT_TRUE(files_intact(folder_.path(), cell));
  folder_.write("cells/a.png", "0123456780");
  EXPECT_FALSE(files_intact(folder_.path(), cell)) << "another byte";
  folder_.write("cells/a.png", "012345678");
  EXPECT_FALSE(files_intact(folder_.path(), cell)) << "a shorter file";
  folder_.write("cells/a.png", "0123456789");
  EXPECT_TRUE(files_intact(folder_.path(), cell));
  fs::remove(folder_.path() / "cells/b.png");
  EXPECT_FALSE(files_intact(folder_.path(), cell)) << "a missing file";
  fs::create_directory(folder_.path() / "cells/b.png");
  EXPECT_FALSE(files_intact(folder_.path(), cell)) << "a folder in its place";
}

TEST_F(JournalFile, a_record_without_files_is_intact) {
  EXPECT_TRUE(files_intact(folder_.path(), {}));
}

TEST_F(JournalFile, recording_a_missing_file_is_an_error) {
  EXPECT_THAT(error_of([&] { record_file(folder_.path(), "none.png"); }),
              HasSubstr("none.png: no such file"));
}

}  // namespace
}  // namespace inkbench
