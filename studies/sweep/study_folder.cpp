// SPDX-License-Identifier: MIT
#include "studies/sweep/study_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <functional>
#include <set>
#include <utility>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "studies/report/csv.h"
#include "studies/sweep/data_columns.h"
#include "studies/sweep/number_columns.h"

namespace inkbench {
namespace {

constexpr const char* kJournal = "journal.jsonl";
constexpr const char* kData = "data.csv";
/// Pictures are waited for until they are on the disk this many at a time: one by one would halve the rate.
constexpr size_t kMostUnsynced = 64;

/// Whether a file in cells/ is named as a study's cell: "0001_final.png".
bool is_cell_name(const std::string& name) {
  const size_t digits = name.find_first_not_of("0123456789");
  if (digits == std::string::npos || digits < 4 || name[digits] != '_' || !name.ends_with(".png"))
    return false;
  const std::string rest = name.substr(digits, name.size() - digits - 4);  // "_final" or "_front_final"
  const std::vector<BufferName> buffers = all_buffers();
  return std::any_of(buffers.begin(), buffers.end(),
                     [&](BufferName buffer) { return rest.ends_with("_" + std::string(name_of(buffer))); });
}

/// Removes the files in a folder of the study that it names as its own and does not use.
void remove_unused(const fs::path& folder, const std::set<std::string>& used,
                   const std::function<bool(const std::string&)>& is_own_name) {
  remove_abandoned_files(folder);
  std::vector<fs::path> stale;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool is_used = used.contains((folder.filename() / name).string());
    if (is_own_name(name) && !is_used) stale.push_back(entry.path());
  }
  std::error_code error;
  for (const fs::path& path : stale) fs::remove(path, error);
}

/// "0123456789abcdef.svg".
bool is_overlay_name(const std::string& name) {
  const auto stem = without_ending(name, ".svg");
  return stem && is_hex(*stem, 16);
}

/// "0123456789abcdef.png".
bool is_cause_name(const std::string& name) {
  const auto stem = without_ending(name, ".png");
  return stem && is_hex(*stem, 16);
}

/// "0001.csv".
bool is_curve_name(const std::string& name) {
  const auto stem = without_ending(name, ".csv");
  return stem && stem->size() >= 4 && stem->find_first_not_of("0123456789") == std::string_view::npos;
}

/// As a record names it, relative to the study's folder.
bool is_overlay_file(const std::string& name) {
  constexpr std::string_view kLines = "reference/", kCauses = "causes/", kCurves = "curves/";
  return (name.starts_with(kLines) && is_overlay_name(name.substr(kLines.size()))) ||
         (name.starts_with(kCauses) && is_cause_name(name.substr(kCauses.size()))) ||
         (name.starts_with(kCurves) && is_curve_name(name.substr(kCurves.size())));
}

/// Why keys differ between two runs, in words: by what their parts say.
std::string drawing_reason(const ResultOrigin& before, const ResultOrigin& now) {
  if (before.renderer.empty()) return "an older inkbench drew them, which did not say how";
  std::vector<std::string> reasons;
  if (before.renderer != now.renderer)
    reasons.push_back("they were drawn by another renderer (" + before.renderer + "; this is " +
                      now.renderer + ")");
  if (before.drawing_sources != now.drawing_sources) reasons.emplace_back("the sources that draw changed");
  return reasons.empty() ? "their settings or what they show changed" : join(reasons, ", and ");
}

/// The same of numbers whose pictures count: renderer and sources that draw are the same.
std::string measuring_reason(const ResultOrigin& before, const ResultOrigin& now) {
  return before.measuring_sources != now.measuring_sources ? "the sources that measure changed"
                                                           : "what is measured, or how it is judged, changed";
}

std::string file_column(const StudySpec& spec, size_t view, BufferName buffer) {
  const std::string prefix = spec.views.empty() ? "FILE_" : "FILE_" + spec.views[view].name + "_";
  return prefix + std::string(name_of(buffer));
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder) {
  make_folder(folder);
  descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(descriptor_);
    throw work_error(folder.string(), "another run is writing to this folder",
                     "wait for it, or give another folder with --out");
  }
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

StudyFolder::StudyFolder(const StudySpec& spec, fs::path folder, std::vector<CellKeys> keys,
                         ResultOrigin origin, bool fresh)
    : spec_(spec),
      folder_(std::move(folder)),
      lock_(folder_),
      keys_(std::move(keys)),
      origin_(std::move(origin)),
      varied_(varied_keys(spec)),
      numbers_(number_columns(spec)) {
  make_inner_folder(folder_ / "cells");
  // Tiles and charts are made where they are needed: here their folders are looked at alone.
  std::error_code error;
  for (const char* later : {"tiles", "charts"}) {
    if (fs::is_symlink(fs::symlink_status(folder_ / later, error))) make_inner_folder(folder_ / later);
  }
  if (finds_lines(spec_)) make_inner_folder(folder_ / "reference");
  if (finds_causes(spec_)) make_inner_folder(folder_ / "causes");
  if (spec_.curves) make_inner_folder(folder_ / "curves");
  if (!fresh) take_journal(read_journal(folder_ / kJournal));
  remove_stale_files();
  rewrite();
}

void StudyFolder::take_journal(Journal&& journal) {
  if (journal.older > 0)
    drawn_again_["an older inkbench drew them, which wrote no check sums"] = journal.older;
  if (!journal.damaged.empty()) drawn_again_["the journal's line is damaged"] = journal.damaged.size();
  for (auto& [index, record] : journal.cells) {
    if (index >= keys_.size()) continue;
    if (const std::string problem = picture_problem(record); !problem.empty()) {
      ++drawn_again_[problem];
    } else if (const std::string lack = number_problem(record); !lack.empty()) {
      ++measured_again_[lack];
      record.overlays.clear();
      unmeasured_[index] = std::move(record);
    } else {
      done_[index] = std::move(record);
    }
  }
}

std::string StudyFolder::picture_problem(const CellRecord& record) const {
  const std::vector<std::string> pictures = picture_files(record.index);
  if (record.key != keys_[record.index].pictures.text()) return drawing_reason(record.origin, origin_);
  // A study that grew may number its files with more digits, and a damaged journal may say anything.
  const bool named =
      std::equal(pictures.begin(), pictures.end(), record.files.begin(), record.files.end(),
                 [](const std::string& name, const FileRecord& file) { return file.name == name; });
  return named && files_intact(folder_, record.files) ? "" : "their files are missing or were changed";
}

std::string StudyFolder::number_problem(const CellRecord& record) const {
  if (record.numbers_key != keys_[record.index].numbers.text() || record.numbers.size() != numbers_.size())
    return measuring_reason(record.origin, origin_);
  const bool named = record.overlays.size() == overlay_count(spec_) &&
                     std::all_of(record.overlays.begin(), record.overlays.end(),
                                 [](const FileRecord& file) { return is_overlay_file(file.name); });
  return named && files_intact(folder_, record.overlays)
             ? ""
             : "their reference lines, causes or curves are missing or were changed";
}

std::vector<std::string> StudyFolder::notes() const {
  std::vector<std::string> notes;
  const auto add = [&](const std::map<std::string, size_t>& reasons, const char* what) {
    for (const auto& [reason, count] : reasons)
      notes.push_back(fmt::format("{} {} {} again: {}", with_commas(static_cast<long long>(count)),
                                  count == 1 ? "cell is" : "cells are", what, reason));
  };
  add(drawn_again_, "drawn");
  add(measured_again_, "measured");
  return notes;
}

CellWork StudyFolder::work(size_t index) const {
  const std::lock_guard lock(mutex_);
  if (done_.contains(index)) return CellWork::none;
  return unmeasured_.contains(index) ? CellWork::measure : CellWork::draw;
}

size_t StudyFolder::done_count() const {
  const std::lock_guard lock(mutex_);
  return done_.size();
}

std::vector<size_t> StudyFolder::done_cells() const {
  const std::lock_guard lock(mutex_);
  std::vector<size_t> cells;
  for (const auto& [index, record] : done_) cells.push_back(index);
  return cells;
}

std::vector<FileRecord> StudyFolder::pictures(size_t index) const {
  const std::lock_guard lock(mutex_);
  const std::vector<FileRecord>& files = done_.at(index).files;
  return {files.begin(), files.begin() + static_cast<std::ptrdiff_t>(picture_count(spec_))};
}

std::string StudyFolder::cell_number(size_t index) const {
  const size_t digits = std::max<size_t>(4, std::to_string(keys_.size()).size());
  return fmt::format("{:0{}}", index + 1, digits);
}

std::string StudyFolder::cell_file(size_t index, size_t view, BufferName buffer) const {
  const std::string view_part = spec_.views.empty() ? "" : spec_.views[view].name + "_";
  return fmt::format("cells/{}_{}{}.png", cell_number(index), view_part, name_of(buffer));
}

std::vector<std::string> StudyFolder::picture_files(size_t index) const {
  std::vector<std::string> files;
  for (size_t view = 0; view < view_count(spec_); ++view) {
    for (const BufferName buffer : spec_.show) files.push_back(cell_file(index, view, buffer));
  }
  return files;
}

std::string StudyFolder::overlay_file(size_t index, size_t view) const {
  const std::lock_guard lock(mutex_);
  return finds_lines(spec_) ? done_.at(index).overlays.at(view).name : "";
}

std::string StudyFolder::cause_file(size_t index, size_t view) const {
  const std::lock_guard lock(mutex_);
  const size_t before = finds_lines(spec_) ? view_count(spec_) : 0;
  return finds_causes(spec_) ? done_.at(index).overlays.at(before + view).name : "";
}

std::string StudyFolder::curve_file(size_t index) const {
  return fmt::format("curves/{}.csv", cell_number(index));
}

std::vector<std::string> StudyFolder::columns() const {
  std::vector<std::string> names{"cell"};
  if (!spec_.variants.empty()) names.emplace_back("variant");
  names.insert(names.end(), varied_.begin(), varied_.end());
  names.insert(names.end(), numbers_.begin(), numbers_.end());
  names.emplace_back("error");
  for (size_t view = 0; view < view_count(spec_); ++view) {
    for (const BufferName buffer : spec_.show) names.push_back(file_column(spec_, view, buffer));
  }
  return names;
}

std::vector<std::string> StudyFolder::fields(size_t index) const {
  const std::lock_guard lock(mutex_);
  if (const auto done = done_.find(index); done != done_.end()) return row(index, done->second.numbers, "");
  if (const auto failed = failed_.find(index); failed != failed_.end()) return row(index, {}, failed->second);
  return {};
}

std::vector<std::string> StudyFolder::row(size_t index, const std::vector<std::string>& numbers,
                                          const std::string& error) const {
  const Cell cell = make_cell(spec_, index);
  Settings settings = cell_settings(spec_, cell);
  std::vector<std::string> fields{std::to_string(index + 1)};
  if (!spec_.variants.empty()) fields.push_back(cell.variant);
  for (const std::string& key : varied_) fields.push_back(field_text(spec_, find_param(settings, key, key)));
  for (size_t i = 0; i < numbers_.size(); ++i) fields.push_back(i < numbers.size() ? numbers[i] : "");
  fields.push_back(error);
  for (const std::string& file : picture_files(index)) fields.push_back(error.empty() ? file : "");
  return fields;
}

std::string StudyFolder::data_text() const {
  std::string text = csv_line(columns());
  for (size_t i = 0; i < keys_.size(); ++i) {
    if (const auto done = done_.find(i); done != done_.end())
      text += csv_line(row(i, done->second.numbers, ""));
    if (const auto failed = failed_.find(i); failed != failed_.end())
      text += csv_line(row(i, {}, failed->second));
  }
  return text;
}

/// Removes the pictures of cells that are not done, and temporary files. Only names that a study gives are
/// touched.
void StudyFolder::remove_stale_files() const {
  remove_abandoned_files(folder_);
  std::set<std::string> used;
  for (const auto* records : {&done_, &unmeasured_}) {
    for (const auto& [index, record] : *records) {
      for (const auto* files : {&record.files, &record.overlays}) {
        for (const FileRecord& file : *files) used.insert(file.name);
      }
    }
  }
  remove_unused(folder_ / "cells", used, is_cell_name);
  std::error_code error;
  if (fs::is_directory(folder_ / "reference", error))
    remove_unused(folder_ / "reference", used, is_overlay_name);
  if (fs::is_directory(folder_ / "causes", error)) remove_unused(folder_ / "causes", used, is_cause_name);
  if (fs::is_directory(folder_ / "curves", error)) remove_unused(folder_ / "curves", used, is_curve_name);
}

void StudyFolder::rewrite() const {
  std::map<size_t, const CellRecord*> records;
  for (const auto* group : {&done_, &unmeasured_}) {
    for (const auto& [index, record] : *group) records[index] = &record;
  }
  std::string journal;
  for (const auto& [index, record] : records) journal += journal_line(*record);
  write_file_atomically(folder_ / kJournal, journal);
  write_file_atomically(folder_ / kData, data_text());
}

void StudyFolder::add(size_t index, std::vector<std::string> numbers,
                      const std::vector<std::string>& overlays) {
  CellRecord record{.index = index,
                    .key = keys_[index].pictures.text(),
                    .numbers_key = keys_[index].numbers.text(),
                    .origin = origin_,
                    .numbers = std::move(numbers)};
  for (const std::string& file : overlays) record.overlays.push_back(record_file(folder_, file));
  if (work(index) == CellWork::draw) {
    for (const std::string& file : picture_files(index)) record.files.push_back(record_file(folder_, file));
  }
  std::unique_lock lock(mutex_);
  if (const auto drawn = unmeasured_.find(index); drawn != unmeasured_.end()) {
    record.files = std::move(drawn->second.files);
    unmeasured_.erase(drawn);
  }
  append_to_file(folder_ / kData, csv_line(row(index, record.numbers, "")));
  append_to_file(folder_ / kJournal, journal_line(record));
  for (const auto* files : {&record.files, &record.overlays}) {
    for (const FileRecord& file : *files) unsynced_.insert(file.name);
  }
  done_[index] = std::move(record);
  if (unsynced_.size() < kMostUnsynced) return;
  const std::set<std::string> batch = std::exchange(unsynced_, {});
  lock.unlock();  // others go on meanwhile
  sync(batch);
}

void StudyFolder::sync(const std::set<std::string>& files) const {
  std::set<fs::path> folders;
  for (const std::string& file : files) {
    sync_path(folder_ / file);
    folders.insert((folder_ / file).parent_path());
  }
  for (const fs::path& folder : folders) sync_path(folder);
  sync_path(folder_ / kJournal);
  sync_path(folder_ / kData);
}

void StudyFolder::add_failure(size_t index, const std::string& message) {
  const std::lock_guard lock(mutex_);
  failed_[index] = message;
  append_to_file(folder_ / kData, csv_line(row(index, {}, message)));
}

void StudyFolder::finish() {
  const std::lock_guard lock(mutex_);
  sync(std::exchange(unsynced_, {}));
  rewrite();
}

}  // namespace inkbench
