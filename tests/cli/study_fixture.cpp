// SPDX-License-Identifier: MIT
#include "tests/cli/study_fixture.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <set>
#include <sstream>

#include "pipeline/image/image_file.h"

namespace inkbench {
namespace {

/// The fields of one CSV line; quotes around a field are taken off.
std::vector<std::string> csv_fields(const std::string& line) {
  std::vector<std::string> fields{""};
  bool quoted = false;
  for (size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[i++];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

std::vector<std::string> whole_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t start = 0, end; (end = text.find('\n', start)) != std::string::npos; start = end + 1) {
    lines.push_back(text.substr(start, end - start));
  }
  return lines;
}

std::string without_times(const std::string& manifest) {
  nlohmann::ordered_json content = nlohmann::ordered_json::parse(manifest);
  content.erase("times");
  return content.dump(2);
}

bool is_unfinished(const std::string& name) {
  return name.find(".part") != std::string::npos;
}

void expect_lines_of(const std::string& name, const std::string& content, const std::string& expected) {
  const std::vector<std::string> lines = whole_lines(expected);
  const std::set<std::string> known(lines.begin(), lines.end());
  for (const std::string& line : whole_lines(content))
    EXPECT_TRUE(known.contains(line)) << name << ": " << line;
}

}  // namespace

std::vector<std::string> StudyTable::column(const std::string& name) const {
  std::vector<std::string> values;
  for (const auto& row : rows) values.push_back(row.contains(name) ? row.at(name) : "no such column");
  return values;
}

StudyTest::StudyTest() {
  write("scene.toml", small_scene());
}

void StudyTest::write_spec(const std::string& name, const std::string& body) const {
  write(name + ".toml", "title = \"A small study\"\nscene = \"scene.toml\"\n" + body);
}

CommandResult StudyTest::study(const std::string& name, const std::string& out, std::vector<std::string> more,
                               const CommandOptions& options) const {
  more.insert(more.begin(), {"study", name + ".toml", "--out", out});
  return inkbench(more, options);
}

StudyTable StudyTest::table(const std::string& out) const {
  StudyTable table;
  for (const std::string& line : whole_lines(content_of(file(out) / "data.csv"))) {
    const std::vector<std::string> fields = csv_fields(line);
    if (table.columns.empty()) {
      table.columns = fields;
      continue;
    }
    EXPECT_EQ(fields.size(), table.columns.size()) << line;
    auto& row = table.rows.emplace_back();
    for (size_t i = 0; i < std::min(fields.size(), table.columns.size()); ++i)
      row[table.columns[i]] = fields[i];
  }
  return table;
}

std::string threshold_axis(int count) {
  return fmt::format("[[axis]]\nkey = \"combine.k_normal\"\nfrom = 0.001\nto = 0.5\ncount = {}\n", count);
}

namespace {

/// ISA-L now and then packs the same grid with another byte: its pixels are what lasts.
std::string pixels_of(const fs::path& png) {
  const Picture picture = read_picture(png, 3);
  return std::to_string(picture.width_px) + " " + std::string(picture.samples.begin(), picture.samples.end());
}

std::string without_hash_of_grids(const std::string& manifest) {
  nlohmann::json json = nlohmann::json::parse(manifest);
  for (nlohmann::json& file : json["files"]) {
    if (file.at("name").get<std::string>().starts_with("grid")) file = file.at("name");
  }
  return json.dump();
}

}  // namespace

FolderContent lasting_content(const fs::path& folder) {
  FolderContent content = folder_content(folder);
  for (auto& [name, text] : content) {
    if (fs::path(name).filename() == "manifest.json") text = without_hash_of_grids(without_times(text));
    if (name.starts_with("grid") && name.ends_with(".png")) text = pixels_of(folder / name);
  }
  return content;
}

std::string difference(const FolderContent& a, const FolderContent& b) {
  std::string text;
  for (const auto& [name, content] : a) {
    if (!b.contains(name)) text += name + " is only in the first; ";
    if (b.contains(name) && b.at(name) != content) text += name + " differs; ";
  }
  for (const auto& [name, content] : b) {
    if (!a.contains(name)) text += name + " is only in the second; ";
  }
  return text.empty() ? "same" : text;
}

void expect_no_half_written_files(const fs::path& folder, const FolderContent& expected) {
  if (!fs::exists(folder)) return;
  for (const auto& [name, content] : folder_content(folder)) {
    if (is_unfinished(name)) continue;
    ASSERT_TRUE(expected.contains(name)) << name;
    if (name.starts_with("grid") && name.ends_with(".png")) {
      EXPECT_TRUE(pixels_of(folder / name) == expected.at(name)) << name << " is not the finished study's";
    } else if (name.ends_with(".png")) {
      EXPECT_TRUE(content == expected.at(name)) << name << " is not the finished study's";
    } else if (name.ends_with(".json")) {
      EXPECT_TRUE(nlohmann::json::accept(content)) << name;
    } else {
      expect_lines_of(name, content, expected.at(name));
    }
  }
}

CommandOptions signal_after(const fs::path& out, size_t pictures, int signal) {
  CommandOptions options;
  options.signal_when = [out, pictures, signal](double) {
    std::error_code error;
    size_t count = 0;
    for (fs::directory_iterator entry(out / "cells", error), end; !error && entry != end;
         entry.increment(error)) {
      count += entry->path().extension() == ".png" ? 1 : 0;
    }
    return count >= pictures ? signal : 0;
  };
  return options;
}

}  // namespace inkbench
