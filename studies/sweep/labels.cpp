// SPDX-License-Identifier: MIT
#include "studies/sweep/labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <unordered_map>
#include <unordered_set>

#include "pipeline/base/text.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;

/// Nine digits tell any two floats apart.
constexpr int kDigits = 4, kMostDigits = 9;
/// Rounds of more detail before values are numbered: more than a path has folders to tell apart.
constexpr int kMostDetail = 32;

/// The last part of the path, and `more` before it.
std::string path_end(const std::string& path, int more) {
  fs::path end, rest(path);
  for (int i = 0; i <= more && rest.has_relative_path(); ++i) {
    end = end.empty() ? rest.filename() : rest.filename() / end;
    rest = rest.parent_path();
  }
  return end.empty() ? path : end.string();
}

/// `detail` 0 is the shortest label.
struct LabelWriter {
  int detail = 0;

  std::string number(float value) const {
    return fmt::format("{:.{}g}", value, std::min(kDigits + detail, kMostDigits));
  }
  std::string operator()(bool value) const { return to_text(Value(value)); }
  std::string operator()(int value) const { return to_text(Value(value)); }
  std::string operator()(float value) const { return number(value); }
  std::string operator()(const glm::vec3& value) const {
    return number(value.x) + ", " + number(value.y) + ", " + number(value.z);
  }
  std::string operator()(const std::string& value) const { return path_end(value, detail); }
  std::string operator()(const Ramp& value) const {
    return value.image.empty() ? fmt::format("{} stops", value.stops.size()) : path_end(value.image, detail);
  }
};

/// Labels that stand for several values.
std::unordered_set<std::string> shared_labels(std::span<const Value> values,
                                              const std::vector<std::string>& labels) {
  std::unordered_map<std::string, size_t> first;
  std::unordered_set<std::string> shared;
  for (size_t i = 0; i < values.size(); ++i) {
    const auto [entry, is_new] = first.emplace(labels[i], i);
    if (!is_new && values[entry->second] != values[i]) shared.insert(labels[i]);
  }
  return shared;
}

/// Puts the place among the different values of one label behind it.
void number_labels(std::span<const Value> values, const std::unordered_set<std::string>& shared,
                   std::vector<std::string>& labels) {
  std::unordered_map<std::string, std::vector<const Value*>> seen;
  for (size_t i = 0; i < values.size(); ++i) {
    if (!shared.contains(labels[i])) continue;
    std::vector<const Value*>& others = seen[labels[i]];
    auto place =
        std::find_if(others.begin(), others.end(), [&](const Value* other) { return *other == values[i]; });
    if (place == others.end()) place = others.insert(place, &values[i]);
    labels[i] += fmt::format(" ({})", place - others.begin() + 1);
  }
}

/// The last `count` parts of a key.
std::string key_end(const std::string& key, int count) {
  size_t dot = std::string::npos;
  for (int i = 0; i < count && dot != 0; ++i) {
    dot = key.rfind('.', dot == std::string::npos ? dot : dot - 1);
    if (dot == std::string::npos) return key;
  }
  return key.substr(dot + 1);
}

std::string short_label(const std::string& key, int more) {
  const bool is_component = key.size() >= 2 && key[key.size() - 2] == '.';
  return key_end(key, 1 + more + (is_component ? 1 : 0));
}

}  // namespace

std::string label_text(const Value& value) {
  return std::visit(LabelWriter{}, value);
}

std::vector<std::string> label_texts(std::span<const Value> values) {
  std::vector<std::string> labels;
  labels.reserve(values.size());
  for (const Value& value : values) labels.push_back(label_text(value));
  for (int detail = 1; detail <= kMostDetail; ++detail) {
    const std::unordered_set<std::string> shared = shared_labels(values, labels);
    if (shared.empty()) return labels;
    for (size_t i = 0; i < values.size(); ++i) {
      if (shared.contains(labels[i])) labels[i] = std::visit(LabelWriter{detail}, values[i]);
    }
  }
  number_labels(values, shared_labels(values, labels), labels);
  return labels;
}

std::vector<std::string> key_labels(std::span<const std::string> keys) {
  std::vector<std::string> labels(keys.begin(), keys.end());
  for (size_t i = 0; i < keys.size(); ++i) {
    const auto is_taken = [&](const std::string& label, int more) {
      return std::any_of(keys.begin(), keys.end(), [&](const std::string& other) {
        return other != keys[i] && short_label(other, more) == label;
      });
    };
    int more = 0;
    while (is_taken(short_label(keys[i], more), more)) ++more;
    labels[i] = short_label(keys[i], more);
  }
  return labels;
}

}  // namespace inkbench
