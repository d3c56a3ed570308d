#include "studies/sweep/study_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "studies/report/csv.h"
#include "studies/sweep/data_columns.h"
#include "studies/sweep/number_columns.h"

namespace inkbench {
namespace {

/// Whether a file in cells/ is named as a study's cell: "0001_final.png".
bool is_cell_name(const std::string& name) {
  const size_t digits = name.find_first_not_of("0123456789");
  if (digits == std::string::npos || digits < 4 || name[digits] != '_' || !name.ends_with(".png"))
    return false;
  const std::string buffer = name.substr(digits + 1, name.size() - digits - 5);
  return std::find(kBufferNames.begin(), kBufferNames.end(), buffer) != kBufferNames.end();
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

StudyFolder::StudyFolder(const StudySpec& spec, fs::path folder, std::vector<Key> keys, bool fresh)
    : spec_(spec),
      folder_(std::move(folder)),
      lock_(folder_),
      keys_(std::move(keys)),
      varied_(varied_keys(spec)),
      columns_(number_columns(spec)) {
  make_folder(folder_ / "cells");
  if (!fresh) done_ = read_journal(folder_ / "journal.jsonl");
  std::erase_if(done_, [&](const auto& entry) {
    return entry.first >= keys_.size() || entry.second.key != keys_[entry.first].text() ||
           entry.second.numbers.size() != columns_.size() || !names_its_files(entry.second) ||
           !files_intact(folder_, entry.second);
  });
  remove_stale_files();
  rewrite();
}

bool StudyFolder::is_done(size_t index) const {
  const std::lock_guard lock(mutex_);
  return done_.contains(index);
}

size_t StudyFolder::done_count() const {
  const std::lock_guard lock(mutex_);
  return done_.size();
}

std::string StudyFolder::cell_file(size_t index, BufferName buffer) const {
  const size_t digits = std::max<size_t>(4, std::to_string(keys_.size()).size());
  return fmt::format("cells/{:0{}}_{}.png", index + 1, digits, name_of(buffer));
}

bool StudyFolder::names_its_files(const CellRecord& record) const {
  return std::equal(record.files.begin(), record.files.end(), spec_.show.begin(), spec_.show.end(),
                    [&](const FileRecord& file, BufferName buffer) {
                      return file.name == cell_file(record.index, buffer);
                    });
}

std::string StudyFolder::header() const {
  std::vector<std::string> fields{"cell"};
  if (!spec_.variants.empty()) fields.emplace_back("variant");
  fields.insert(fields.end(), varied_.begin(), varied_.end());
  fields.insert(fields.end(), columns_.begin(), columns_.end());
  fields.emplace_back("error");
  for (const BufferName buffer : spec_.show) fields.push_back("FILE_" + std::string(name_of(buffer)));
  return csv_line(fields);
}

std::string StudyFolder::row(size_t index, const std::vector<std::string>& numbers,
                             const std::string& error) const {
  const Cell cell = make_cell(spec_, index);
  Settings settings = cell_settings(spec_, cell);
  std::vector<std::string> fields{std::to_string(index + 1)};
  if (!spec_.variants.empty()) fields.push_back(cell.name);
  for (const std::string& key : varied_) fields.push_back(field_text(find_param(settings, key, key).value()));
  for (size_t i = 0; i < columns_.size(); ++i) fields.push_back(i < numbers.size() ? numbers[i] : "");
  fields.push_back(error);
  for (const BufferName buffer : spec_.show) fields.push_back(error.empty() ? cell_file(index, buffer) : "");
  return csv_line(fields);
}

std::string StudyFolder::data_text() const {
  std::string text = header();
  for (size_t i = 0; i < keys_.size(); ++i) {
    if (const auto done = done_.find(i); done != done_.end()) text += row(i, done->second.numbers, "");
    if (const auto failed = failed_.find(i); failed != failed_.end()) text += row(i, {}, failed->second);
  }
  return text;
}

/// Removes the pictures of cells that are not done, and temporary files. Only names that a study gives are
/// touched.
void StudyFolder::remove_stale_files() const {
  remove_abandoned_files(folder_);
  remove_abandoned_files(folder_ / "cells");
  std::set<std::string> kept;
  for (const auto& [index, record] : done_) {
    for (const FileRecord& file : record.files) kept.insert(fs::path(file.name).filename().string());
  }
  std::vector<fs::path> stale;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "cells")) {
    const std::string name = entry.path().filename().string();
    if (is_cell_name(name) && !kept.contains(name)) stale.push_back(entry.path());
  }
  std::error_code error;
  for (const fs::path& path : stale) fs::remove(path, error);
}

void StudyFolder::rewrite() const {
  std::string journal;
  for (const auto& [index, record] : done_) journal += journal_line(record);
  write_file_atomically(folder_ / "journal.jsonl", journal);
  write_file_atomically(folder_ / "data.csv", data_text());
}

void StudyFolder::append(const fs::path& path, const std::string& line) const {
  const int descriptor = open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  const ssize_t written = descriptor < 0 ? -1 : write(descriptor, line.data(), line.size());
  const int number = errno;
  if (descriptor >= 0) close(descriptor);
  if (written != static_cast<ssize_t>(line.size())) {
    throw work_error(path.string(), "a row could not be added: " +
                                        std::string(std::strerror(written < 0 ? number : ENOSPC)));
  }
}

void StudyFolder::add(size_t index, std::vector<std::string> numbers) {
  CellRecord record{index, keys_[index].text(), std::move(numbers), {}};
  for (const BufferName buffer : spec_.show)
    record.files.push_back(record_file(folder_, cell_file(index, buffer)));
  const std::lock_guard lock(mutex_);
  append(folder_ / "data.csv", row(index, record.numbers, ""));
  append(folder_ / "journal.jsonl", journal_line(record));
  done_[index] = std::move(record);
}

void StudyFolder::add_failure(size_t index, const std::string& message) {
  const std::lock_guard lock(mutex_);
  failed_[index] = message;
  append(folder_ / "data.csv", row(index, {}, message));
}

void StudyFolder::finish() {
  const std::lock_guard lock(mutex_);
  rewrite();
}

}  // namespace inkbench
