// SPDX-License-Identifier: MIT
#include "studies/tuning/trial_journal.h"

#include <nlohmann/json.hpp>

#include <string_view>

#include "pipeline/base/files.h"

namespace inkbench {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Histogram& histogram) {
  Json pairs = Json::array();
  for (const auto& [value, count] : histogram.counts()) pairs.push_back({value, count});
  return pairs;
}

Histogram histogram_of(const Json& json) {
  Histogram histogram;
  for (const Json& pair : json) histogram.add(pair.at(0), pair.at(1));
  return histogram;
}

Json json_of(const MatchCounts& counts) {
  return {counts.matched, counts.allowed};
}

MatchCounts matches_of(const Json& json) {
  return {json.at(0), json.at(1)};
}

Json json_of(const LineTally& lines) {
  return {{"inside", lines.inside_pixels},
          {"predicted", lines.predicted},
          {"referenced", lines.referenced},
          {"at_tolerance", json_of(lines.at_tolerance)},
          {"at_1px", json_of(lines.at_1px)},
          {"at_diagonal", json_of(lines.at_diagonal)},
          {"to_reference", json_of(lines.to_reference)},
          {"to_prediction", json_of(lines.to_prediction)},
          {"baddeley", lines.baddeley_sum},
          {"gaps", {lines.gaps, lines.gap_pixels}},
          {"components", lines.components},
          {"ends", lines.ends},
          {"to_background", json_of(lines.to_background)},
          {"offsets", {lines.offsets.samples, lines.offsets.sum, lines.offsets.squared_wobble_sum}}};
}

LineTally lines_of(const Json& json) {
  LineTally lines;
  lines.inside_pixels = json.at("inside");
  lines.predicted = json.at("predicted");
  lines.referenced = json.at("referenced");
  lines.at_tolerance = matches_of(json.at("at_tolerance"));
  lines.at_1px = matches_of(json.at("at_1px"));
  lines.at_diagonal = matches_of(json.at("at_diagonal"));
  lines.to_reference = histogram_of(json.at("to_reference"));
  lines.to_prediction = histogram_of(json.at("to_prediction"));
  lines.baddeley_sum = json.at("baddeley");
  lines.gaps = json.at("gaps").at(0);
  lines.gap_pixels = json.at("gaps").at(1);
  lines.components = json.at("components");
  lines.ends = json.at("ends");
  lines.to_background = histogram_of(json.at("to_background"));
  const Json& offsets = json.at("offsets");
  lines.offsets = {offsets.at(0), offsets.at(1), offsets.at(2)};
  return lines;
}

Json json_of(const MarkTally& marks) {
  return {marks.wanted.matched, marks.wanted.total, marks.unwanted.matched, marks.unwanted.total};
}

Json json_of(const DrawingTally& tally) {
  Json recall = Json::array();
  for (const ShareCounts& share : tally.recall) recall.push_back({share.matched, share.total});
  return {{"pixels", tally.pixels}, {"ink", tally.ink},
          {"faces", tally.faces},   {"lines", json_of(tally.lines)},
          {"recall", recall},       {"marks", tally.marks ? json_of(*tally.marks) : Json()}};
}

DrawingTally tally_of(const Json& json) {
  DrawingTally tally;
  tally.pixels = json.at("pixels");
  tally.ink = json.at("ink");
  tally.faces = json.at("faces");
  tally.lines = lines_of(json.at("lines"));
  for (size_t i = 0; i < tally.recall.size(); ++i)
    tally.recall[i] = {json.at("recall").at(i).at(0), json.at("recall").at(i).at(1)};
  if (const Json& marks = json.at("marks"); !marks.is_null())
    tally.marks = MarkTally{{marks.at(0), marks.at(1)}, {marks.at(2), marks.at(3)}};
  return tally;
}

/// KEY SUM TALLY: the hash of the tally's text tells a damaged line.
std::string line_of(const Key& key, const std::string& tally) {
  return key.text() + " " + KeyBuilder().add(key.text()).add(tally).key().text() + " " + tally + "\n";
}

}  // namespace

std::string tally_text(const DrawingTally& tally) {
  return json_of(tally).dump();
}

std::optional<DrawingTally> tally_from(const std::string& text) {
  try {
    return tally_of(Json::parse(text));
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

TrialJournal::TrialJournal(fs::path path) : path_(std::move(path)) {
  std::error_code error;
  if (path_.empty()) return;
  if (!fs::exists(path_, error)) write_file_atomically(path_, "");
  constexpr size_t kKeyChars = 32;
  const std::string content = read_file(path_);
  std::string whole;
  std::string_view rest = content;
  for (size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
    const std::string line(rest.substr(0, end));
    rest.remove_prefix(end + 1);
    if (line.size() < 2 * kKeyChars + 2) continue;
    const std::optional<Key> key = key_from(line.substr(0, kKeyChars));
    const std::string text = line.substr(2 * kKeyChars + 2);
    if (!key || line_of(*key, text) != line + "\n") continue;
    if (std::optional<DrawingTally> tally = tally_from(text)) known_[*key] = std::move(*tally);
    whole += line + "\n";
  }
  if (whole.size() != content.size())
    write_file_atomically(path_, whole);  // or the next line joins a torn one
}

const DrawingTally* TrialJournal::find(const Key& key) const {
  const auto found = known_.find(key);
  return found == known_.end() ? nullptr : &found->second;
}

void TrialJournal::add(const Key& key, const DrawingTally& tally) {
  known_[key] = tally;
  if (path_.empty()) return;
  append_to_file(path_, line_of(key, tally_text(tally)));
}

}  // namespace inkbench
