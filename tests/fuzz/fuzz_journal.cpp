// SPDX-License-Identifier: MIT
// Bytes as the journal of a study: what a damaged one says is never trusted further than the files on the
// disk bear it out. The first byte chooses: the bytes are the journal, or patches to a good one.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/scratch_folder.h"
#include "studies/sweep/study_folder.h"

namespace inkbench {
namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

constexpr const char* kSpec =
    "show = [\"final\"]\nmeasure = [\"f1\"]\n[[view]]\nname = \"front\"\n[[view]]\nname = "
    "\"side\"\n[view.set]\ncamera.fov = 30\n"
    "[[axis]]\nkey = \"combine.k_depth\"\nvalues = [0.25, 0.5, 1]\n";

/// A finished study of three cells in two views, in memory where the system has such a place.
struct FinishedStudy {
  ScratchFolder scratch{memory_place()};
  const fs::path& folder = scratch.path();
  StudySpec spec = parse_spec(kSpec, "/studies/s.toml", {});
  std::vector<CellKeys> keys;
  std::string journal;

  FinishedStudy() {
    for (size_t i = 0; i < cell_count(spec); ++i) {
      const Key key = KeyBuilder().add(std::to_string(i)).key();
      keys.push_back({key, key});
    }
    StudyFolder study(spec, folder, keys, {"drawing", "measuring", "renderer"}, false);
    for (size_t i = 0; i < keys.size(); ++i) finish_cell(study, i);
    study.finish();
    journal = read_file(folder / "journal.jsonl");
  }

  void finish_cell(StudyFolder& study, size_t index) const {
    std::vector<std::string> overlays;
    for (size_t view = 0; view < view_count(spec); ++view) {
      for (const BufferName buffer : spec.show)
        write_file_atomically(folder / study.cell_file(index, view, buffer),
                              fmt::format("{} {}", index, view));
      overlays.push_back(fmt::format("reference/{:016x}.svg", view));
      write_file_atomically(folder / overlays.back(), "lines");
    }
    study.add(index, {"0.5", "100", "0.25"}, overlays);
  }
};

FinishedStudy& finished_study() {
  static FinishedStudy study;
  return study;
}

/// A record that was read is written as a line that reads back equal.
void check_lines(const fs::path& journal) {
  const std::map<size_t, CellRecord> records = read_journal(journal).cells;
  std::string text;
  for (const auto& [index, record] : records) {
    require(record.index == index);
    text += journal_line(record);
  }
  write_file_atomically(journal, text);
  const std::map<size_t, CellRecord> again = read_journal(journal).cells;
  require(again.size() == records.size());
  for (const auto& [index, record] : records) require(journal_line(again.at(index)) == journal_line(record));
}

/// What is taken as done is what was done; then the study is made whole again for the next input.
void check_resume(FinishedStudy& good) {
  StudyFolder study(good.spec, good.folder, good.keys, {"drawing", "measuring", "renderer"}, false);
  for (size_t i = 0; i < good.keys.size(); ++i) {
    if (!study.is_done(i)) {
      good.finish_cell(study, i);
      continue;
    }
    for (size_t view = 0; view < view_count(good.spec); ++view)
      require(fs::is_regular_file(good.folder / study.overlay_file(i, view)));
  }
  study.finish();
  for (const char* folder : {"cells", "reference"}) {
    const auto files = std::distance(fs::directory_iterator(good.folder / folder), fs::directory_iterator());
    require(files == (folder[0] == 'c' ? 6 : 2));
  }
}

std::string patched(std::string text, std::span<const uint8_t> patches) {
  for (; patches.size() >= 3; patches = patches.subspan(3))
    text[(patches[0] | patches[1] << 8) % text.size()] = static_cast<char>(patches[2]);
  return text;
}

void feed(uint8_t choice, std::span<const uint8_t> content) {
  FinishedStudy& good = finished_study();
  const std::string text =
      choice % 2 == 0 ? std::string(content.begin(), content.end()) : patched(good.journal, content);
  const fs::path journal = good.folder / "journal.jsonl";
  write_file_atomically(journal, text);
  check_lines(journal);
  write_file_atomically(journal, text);
  check_resume(good);
}

}  // namespace
}  // namespace inkbench

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  // No Error may pass: whatever the journal says, the study goes on.
  try {
    inkbench::feed(data[0], {data + 1, size - 1});
  } catch (const inkbench::Error&) {
    std::abort();
  }
  return 0;
}
