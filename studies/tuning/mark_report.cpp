// SPDX-License-Identifier: MIT
#include "studies/tuning/mark_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/lines/drawing.h"

namespace inkbench {
namespace {

constexpr size_t kMostNamed = 5;  // strokes and methods in a sentence

/// The strokes' places, "at (120, 88), (40, 60)".
std::string places_text(const std::vector<const MarkedStroke*>& strokes) {
  std::string text;
  for (size_t i = 0; i < std::min(strokes.size(), kMostNamed); ++i)
    text += fmt::format("{}({}, {})", i == 0 ? "" : ", ", strokes[i]->centre.x, strokes[i]->centre.y);
  return text + (strokes.size() > kMostNamed ? ", ..." : "");
}

/// "1 of 3 wanted strokes is missed, at (120, 88)"; "" where all are as they were asked for.
std::string kind_text(const PictureStrokes& picture, bool is_wanted) {
  size_t count = 0;
  std::vector<const MarkedStroke*> failed;
  for (const MarkedStroke& stroke : picture.strokes) {
    if (stroke.is_wanted != is_wanted) continue;
    ++count;
    if (!stroke.is_satisfied()) failed.push_back(&stroke);
  }
  if (failed.empty()) return "";
  const bool is_one = failed.size() == 1;
  return fmt::format("{} of {} {}, at {}", failed.size(),
                     counted(count, is_wanted ? "wanted stroke" : "unwanted stroke",
                             is_wanted ? "wanted strokes" : "unwanted strokes"),
                     is_wanted ? (is_one ? "is missed" : "are missed") : (is_one ? "remains" : "remain"),
                     places_text(failed));
}

std::string picture_sentence(const PictureStrokes& picture) {
  std::vector<std::string> parts;
  for (const bool is_wanted : {true, false}) {
    if (std::string text = kind_text(picture, is_wanted); !text.empty()) parts.push_back(std::move(text));
  }
  if (parts.empty()) return "";
  return (picture.picture.empty() ? "" : picture.picture + ": ") + join(parts, "; ") + ".";
}

std::string satisfied_text(const Compliance& drawing) {
  return fmt::format("{} of {}", drawing.satisfied(), drawing.strokes());
}

std::string methods_sentence(const MarkReport& report) {
  const std::vector<const Compliance*> better = report.better();
  if (better.empty()) return "No other method, with the scene's own values, satisfies more strokes.";
  std::string text = "With the scene's own values, ";
  for (size_t i = 0; i < std::min(better.size(), kMostNamed); ++i)
    text += (i == 0 ? "" : ", ") + better[i]->name + " (" + satisfied_text(*better[i]) + " strokes)";
  return text + (better.size() == 1 ? " satisfies more." : " satisfy more.");
}

std::string share_text(const ShareCounts& counts) {
  return counts.share() ? fmt::format("{:.3f}", *counts.share()) : "";
}

class MarkLooker {
 public:
  MarkLooker(Pipeline& pipeline, const TuneSpec& spec)
      : pipeline_(pipeline), spec_(spec), marks_(pipeline, spec) {}

  /// The drawing that these settings give of each picture.
  Compliance look(const std::string& name, const std::function<Settings(Settings)>& change) {
    Compliance drawing{name, {}, {}};
    for (size_t p = 0; p < spec_.pictures.size(); ++p) {
      const PictureMarks::Entry* entry = marks_.find(p);
      if (entry == nullptr) continue;
      const Settings settings = change(picture_settings(spec_, spec_.pictures[p]));
      check_settings(settings);
      const LineMap drawn = line_map_from(pipeline_.at(settings).raw(BufferName::lines));
      drawing.tally.add(tally_marks(entry->counted, drawn));
      drawing.pictures.push_back({name_of(spec_.pictures[p]), look_at_strokes(entry->marks, drawn)});
    }
    return drawing;
  }

 private:
  /// "" for the only picture of a spec without views and groups.
  static std::string name_of(const TunePicture& picture) {
    return picture.of_group.empty() && picture.of_view.empty() ? "" : picture.name;
  }

  Pipeline& pipeline_;
  const TuneSpec& spec_;
  PictureMarks marks_;
};

}  // namespace

size_t Compliance::strokes() const {
  size_t count = 0;
  for (const PictureStrokes& picture : pictures) count += picture.strokes.size();
  return count;
}

size_t Compliance::satisfied() const {
  size_t count = 0;
  for (const PictureStrokes& picture : pictures)
    count +=
        static_cast<size_t>(std::count_if(picture.strokes.begin(), picture.strokes.end(),
                                          [](const MarkedStroke& stroke) { return stroke.is_satisfied(); }));
  return count;
}

std::vector<const Compliance*> MarkReport::better() const {
  std::vector<const Compliance*> result;
  for (const Compliance& method : methods) {
    if (method.satisfied() > tuned.satisfied()) result.push_back(&method);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Compliance* a, const Compliance* b) { return a->satisfied() > b->satisfied(); });
  return result;
}

MarkReport look_at_marks(Pipeline& pipeline, const TuneSpec& spec, const TuneResult& result) {
  constexpr const char* kMethod = "edges.method";
  MarkLooker looker(pipeline, spec);
  const auto with = [&](const Values& values) {
    return [&](const Settings& settings) { return with_values(settings, spec.space, values); };
  };
  MarkReport report{looker.look("default", with(result.initial().values)),
                    looker.look("tuned", with(result.tuned().values)),
                    {}};
  if (result.stopped) return report;
  const Settings tuned = with_values(spec.base, spec.space, result.tuned().values);
  const ConstParam own = find_param(tuned, kMethod, kMethod);
  for (const std::string_view choice : own.field->choices) {
    const Value method = std::string(choice);
    if (method == own.value()) continue;
    try {
      report.methods.push_back(looker.look(std::string(choice), [&](Settings settings) {
        find_param(settings, kMethod, kMethod).set(method, kMethod);
        return settings;
      }));
    } catch (const Error&) {
      continue;  // it cannot draw this scene
    }
  }
  return report;
}

std::vector<std::string> mark_sentences(const MarkReport& report) {
  std::vector<std::string> sentences;
  for (const PictureStrokes& picture : report.tuned.pictures) {
    if (std::string sentence = picture_sentence(picture); !sentence.empty())
      sentences.push_back(std::move(sentence));
  }
  if (sentences.empty())
    return {"All that was marked is as it was asked for: " + satisfied_text(report.tuned) + " strokes."};
  if (!report.methods.empty()) sentences.push_back(methods_sentence(report));
  return sentences;
}

PageTable mark_table(const MarkReport& report) {
  PageTable table{"Marks",
                  join(mark_sentences(report), " ") +
                      " A stroke is satisfied when most of it is as it was asked for. The methods have the "
                      "scene's own values.",
                  {"drawing", "strokes satisfied", "marks", "wanted, drawn", "unwanted, gone"},
                  {}};
  const auto row = [&](const Compliance& drawing) {
    const std::optional<double> value = drawing.tally.value();
    table.rows.push_back({drawing.name, satisfied_text(drawing), value ? fmt::format("{:.3f}", *value) : "",
                          share_text(drawing.tally.wanted), share_text(drawing.tally.unwanted)});
  };
  row(report.initial);
  row(report.tuned);
  for (const Compliance& method : report.methods) row(method);
  return table;
}

}  // namespace inkbench
