// SPDX-License-Identifier: MIT
// What a search has measured, one line a drawing, appended as it goes: a search that was cut off and starts
// again finds here what it measured, so that it takes the same way without drawing.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "pipeline/base/key.h"
#include "studies/measures/drawing_tally.h"

namespace inkbench {

/// A tally as one JSON object and back, without loss. Of what a search can ask for: ink, lines, recall by
/// class, marks. Nothing where the text is none.
std::string tally_text(const DrawingTally& tally);
std::optional<DrawingTally> tally_from(const std::string& text);

class TrialJournal {
 public:
  /// Reads what is there; lines that are torn or damaged do not count. An empty path keeps nothing.
  explicit TrialJournal(std::filesystem::path path);

  /// Null where it does not know.
  const DrawingTally* find(const Key& key) const;
  size_t size() const { return known_.size(); }

  /// Errors (work): the file cannot be written.
  void add(const Key& key, const DrawingTally& tally);

 private:
  std::filesystem::path path_;
  std::map<Key, DrawingTally> known_;
};

}  // namespace inkbench
