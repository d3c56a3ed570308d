// SPDX-License-Identifier: MIT
#include "app/workbench/folder_listing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "pipeline/base/text.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;

bool is_wanted(const fs::path& name, std::span<const std::string_view> extensions) {
  return extensions.empty() ||
         std::find(extensions.begin(), extensions.end(), lower_extension(name)) != extensions.end();
}

void add_entry(FolderListing& listing, const fs::directory_entry& entry,
               std::span<const std::string_view> extensions) {
  const std::string name = entry.path().filename().string();
  if (name.empty() || name[0] == '.' || !is_utf8(name)) return;
  std::error_code error;
  const bool is_folder = entry.is_directory(error);
  if (!is_folder && (!entry.is_regular_file(error) || !is_wanted(entry.path(), extensions))) return;
  std::uintmax_t bytes = is_folder ? 0 : entry.file_size(error);
  if (error) bytes = 0;
  listing.entries.push_back({name, is_folder, bytes});
}

int digit_of(char c) {
  const int lowered = std::tolower(static_cast<unsigned char>(c));
  if (lowered >= '0' && lowered <= '9') return lowered - '0';
  return lowered >= 'a' && lowered <= 'f' ? lowered - 'a' + 10 : -1;
}

std::string percent_decoded(std::string_view text) {
  std::string result;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool coded =
        text[i] == '%' && i + 2 < text.size() && digit_of(text[i + 1]) >= 0 && digit_of(text[i + 2]) >= 0;
    if (coded) {
      result += static_cast<char>(16 * digit_of(text[i + 1]) + digit_of(text[i + 2]));
      i += 2;
    } else {
      result += text[i];
    }
  }
  return result;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return "";
  text = text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
  const bool quoted = text.size() > 1 && (text[0] == '"' || text[0] == '\'') && text.back() == text[0];
  return quoted ? text.substr(1, text.size() - 2) : text;
}

}  // namespace

std::string lower_extension(const fs::path& path) {
  return lower_case(path.extension().string());
}

FolderListing list_folder(const fs::path& folder, std::span<const std::string_view> extensions) {
  FolderListing listing{folder, {}, ""};
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    if (listing.entries.size() >= kMaxListed) {
      listing.problem = fmt::format("only {} of the files are listed; type the name", kMaxListed);
      break;
    }
    add_entry(listing, *entry, extensions);
  }
  if (error) listing.problem = error.message();
  std::sort(listing.entries.begin(), listing.entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
    if (a.is_folder != b.is_folder) return a.is_folder;
    const std::string left = lower_case(a.name);
    const std::string right = lower_case(b.name);
    return left != right ? left < right : a.name < b.name;
  });
  return listing;
}

fs::path path_from_text(std::string_view text, const fs::path& folder) {
  constexpr std::string_view kScheme = "file://";
  std::string plain(trimmed(text));
  if (plain.empty()) return {};
  if (plain.starts_with(kScheme)) plain = percent_decoded(std::string_view(plain).substr(kScheme.size()));
  const char* home = std::getenv("HOME");
  if (home != nullptr && (plain == "~" || plain.starts_with("~/"))) plain = home + plain.substr(1);
  return (folder / plain).lexically_normal();
}

std::string path_text(const fs::path& path) {
  std::string text = path.string();
  const char* variable = std::getenv("HOME");
  const std::string home = variable == nullptr ? "" : fs::path(variable).lexically_normal().string();
  if (home.size() > 1 && (text == home || text.starts_with(home + "/"))) text.replace(0, home.size(), "~");
  return text;
}

}  // namespace inkbench
