// SPDX-License-Identifier: MIT
#include "app/workbench/study_results.h"

#include <sys/stat.h>

#include <charconv>
#include <nlohmann/json.hpp>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/settings/settings_file.h"
#include "studies/report/csv.h"
#include "studies/sweep/number_columns.h"
#include "studies/sweep/study_curves.h"
#include "studies/sweep/study_grid.h"

namespace inkbench {
namespace {

const std::string kNothing;

nlohmann::json read_manifest(const fs::path& folder) {
  const fs::path path = folder / "manifest.json";
  std::error_code error;
  if (!fs::exists(path, error))
    throw input_error(folder.string(), "holds no study", "give a folder that `inkbench study` wrote");
  nlohmann::json json = nlohmann::json::parse(read_file(path), nullptr, false);
  const bool good = json.is_object() && json.contains("spec") && json["spec"].is_string() &&
                    json.value("state", nlohmann::json()).is_string();
  if (!good) throw input_error(path.string(), "is not a study's manifest");
  return json;
}

std::string text_entry(const nlohmann::json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

StudySummary summary_of(const nlohmann::json& json) {
  const auto cells = json.find("cells");
  const bool counted = cells != json.end() && cells->is_number_unsigned();
  return {text_entry(json, "title"), text_entry(json, "state"), counted ? cells->get<size_t>() : 0};
}

/// Where the spec may have lain when it ran, the likeliest first.
std::vector<fs::path> spec_places(const nlohmann::json& manifest, const fs::path& folder,
                                  const fs::path& spec) {
  const std::string name = fs::path(text_entry(manifest, "spec_file")).filename().string();
  const fs::path inside = fs::absolute(folder).lexically_normal();
  const fs::path parent = inside.has_filename() ? inside.parent_path() : inside.parent_path().parent_path();
  std::vector<fs::path> places;
  if (!spec.empty()) places.push_back(spec);
  for (const fs::path& place : {parent, project_root() / "studies", project_root() / "studies/figures"})
    places.push_back(place / (name.empty() ? "spec.toml" : name));
  return places;
}

StudySpec read_spec(const nlohmann::json& manifest, const std::vector<fs::path>& places) {
  const std::string text = text_entry(manifest, "spec");
  for (size_t i = 0; i + 1 < places.size(); ++i) {
    try {
      return parse_spec(text, places[i], {});
    } catch (const Error&) {  // it may have lain elsewhere
    }
  }
  return parse_spec(text, places.back(), {});
}

/// The spec's, unless `--set` said something else when it ran.
ImageParams base_image(const nlohmann::json& manifest, const fs::path& folder, const ImageParams& otherwise) {
  try {
    return parse_settings(text_entry(manifest, "base_settings"), "manifest.json", folder).image;
  } catch (const Error&) {
    return otherwise;
  }
}

}  // namespace

StudySummary read_summary(const fs::path& folder) {
  return summary_of(read_manifest(folder));
}

StudyResults::StudyResults(const fs::path& folder, const fs::path& spec) : folder_(folder) {
  const nlohmann::json manifest = read_manifest(folder);
  summary_ = summary_of(manifest);
  spec_text_ = text_entry(manifest, "spec");
  spec_ = read_spec(manifest, spec_places(manifest, folder, spec));
  spec_.base.image = base_image(manifest, folder, spec_.base.image);
  columns_ = grid_axis(spec_, 0);
  rows_ = grid_axis(spec_, 1);
  pages_ = grid_axis(spec_, 2);
  numbers_ = number_columns(spec_);
  for (size_t view = 0; view < view_count(spec_); ++view) {
    const std::string prefix = spec_.views.empty() ? "" : spec_.views[view].name + "_";
    for (const BufferName buffer : spec_.show) pictures_.push_back(prefix + std::string(name_of(buffer)));
  }
  read_data();
  weigh();
}

/// Once, since it looks at every file.
void StudyResults::weigh() {
  if (summary_.state != "finished") bytes_ = 0;
  if (summary_.state != "finished" || bytes_ > 0) return;
  std::error_code error;
  for (fs::recursive_directory_iterator i(folder_, error), end; !error && i != end; i.increment(error)) {
    std::error_code gone;
    if (i->is_regular_file(gone)) bytes_ += i->file_size(gone);
  }
}

std::vector<DrawnChart> StudyResults::charts() const {
  std::vector<DrawnChart> charts;
  if (summary_.state != "finished") return charts;
  for (const Chart& chart : spec_.charts) charts.push_back(chart_in(folder_, chart));
  for (DrawnChart& chart : curve_charts_in(folder_, spec_)) charts.push_back(std::move(chart));
  return charts;
}

ImageParams StudyResults::image(size_t cell, size_t picture) const {
  const size_t view = picture / spec_.show.size();
  return view_settings(spec_, make_cell(spec_, cell), view).image;
}

void StudyResults::forget_data() {
  data_read_ = 0;
  failed_ = 0;
  header_.clear();
  rows_of_data_.clear();
}

bool StudyResults::refresh() {
  bool changed = false;
  try {
    changed = read_data();
    const nlohmann::json manifest = read_manifest(folder_);
    summary_ = summary_of(manifest);
    replaced_ = text_entry(manifest, "spec") != spec_text_;
    weigh();
  } catch (const Error&) {  // gone meanwhile: what is known stays
  }
  return changed;
}

bool StudyResults::read_data() {
  const fs::path path = folder_ / "data.csv";
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return false;
  const auto bytes = static_cast<uintmax_t>(status.st_size);
  const bool is_same = status.st_ino == data_file_ && bytes >= data_read_;
  if (is_same && bytes == data_read_) return false;
  if (!is_same) forget_data();
  data_file_ = status.st_ino;
  const std::string text = read_file_part(path, data_read_);
  size_t used = 0;
  for (std::vector<std::string>& row : csv_rows(text, used)) take_row(std::move(row));
  data_read_ += used;
  return used > 0 || !is_same;
}

void StudyResults::take_row(std::vector<std::string> row) {
  if (header_.empty()) {
    for (size_t i = 0; i < row.size(); ++i) header_[row[i]] = i;
    return;
  }
  size_t number = 0;
  const char* end = row[0].data() + row[0].size();
  const auto [at, error] = std::from_chars(row[0].data(), end, number);
  const bool good = error == std::errc() && at == end && number >= 1 && number <= cell_count(spec_);
  if (!good || row.size() != header_.size()) return;
  const auto [place, is_new] = rows_of_data_.insert_or_assign(number - 1, std::move(row));
  if (is_new && !this->error(place->first).empty()) ++failed_;
}

const std::string& StudyResults::field(size_t cell, const std::string& column) const {
  const auto row = rows_of_data_.find(cell);
  const auto place = header_.find(column);
  if (row == rows_of_data_.end() || place == header_.end()) return kNothing;
  return row->second[place->second];
}

const std::string& StudyResults::error(size_t cell) const {
  return field(cell, "error");
}

fs::path StudyResults::picture(size_t cell, size_t picture) const {
  const std::string& file = field(cell, "FILE_" + pictures_.at(picture));
  return file.empty() ? fs::path() : folder_ / file;
}

const std::string& StudyResults::number(size_t cell, size_t number) const {
  return field(cell, numbers_.at(number));
}

}  // namespace inkbench
