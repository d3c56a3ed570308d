// SPDX-License-Identifier: MIT
#include "app/workbench/fit_result.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "studies/report/csv.h"
#include "studies/tuning/tuner.h"

namespace inkbench {
namespace {

using FitJson = nlohmann::json;

constexpr double kCold = 0.1;  // so much below the best

std::optional<double> objective_in(const FitJson& score) {
  if (!score.is_object()) return std::nullopt;
  return score.at("objective").get<double>();
}

/// Falls from the plateau's edge on.
double warmth_of(const std::string& objective, double best) {
  if (objective.empty()) return 0;
  const double loss = best - std::strtod(objective.c_str(), nullptr);
  return std::clamp(1 - (loss - kPlateau) / (kCold - kPlateau), 0.0, 1.0);
}

/// Of a number's values, the others as found; none for choices, and where there was no budget to look.
std::optional<ValueHeat> heat_in(const CsvTable& profiles, const std::string& key, double found,
                                 double best) {
  const size_t parameter = profiles.column("parameter"), from = profiles.column("from"),
               value = profiles.column("value"), objective = profiles.column("objective");
  ValueHeat heat;
  for (const std::vector<std::string>& row : profiles.rows) {
    if (row[parameter] != key || row[from] != "tuned") continue;
    char* end = nullptr;
    const double number = std::strtod(row[value].c_str(), &end);
    if (end == row[value].c_str()) return std::nullopt;
    heat.points.push_back({number, warmth_of(row[objective], best)});
  }
  if (heat.points.size() < 2) return std::nullopt;
  heat.points.push_back({found, 1});
  std::sort(heat.points.begin(), heat.points.end(),
            [](const ValueHeat::Point& a, const ValueHeat::Point& b) { return a.value < b.value; });
  return heat;
}

void read_worth(const FitJson& json, FitResult& result) {
  for (const FitJson& entry : json.at("parameters")) {
    const std::string key = entry.at("parameter").get<std::string>();
    for (FittedParameter& fitted : result.parameters) {
      if (fitted.key != key) continue;
      // A search that was stopped may have looked at too little of it to say so.
      fitted.matters = result.stopped || entry.at("matters").get<bool>();
      const auto good = entry.find("equally_good");
      if (fitted.heat && good != entry.end())
        fitted.heat->equally_good = std::pair(good->at(0).get<double>(), good->at(1).get<double>());
    }
  }
}

FitResult result_in(const FitJson& json, const CsvTable& profiles) {
  FitResult result;
  result.before = objective_in(json.at("default"));
  result.after = objective_in(json.at("tuned"));
  result.left_out = objective_in(json.at("leave_one_out"));
  result.is_gain = json.at("gained").is_null() || json.at("gained").get<bool>();
  result.stopped = json.at("stopped").get<bool>();
  result.candidates = json.at("cost").at("candidates").get<size_t>();
  for (const auto& [key, value] : json.at("tuned").at("values").items()) {
    const auto text = value.get<std::string>();
    const double found = std::strtod(text.c_str(), nullptr);
    result.parameters.push_back({key, text, true, heat_in(profiles, key, found, result.after.value_or(0))});
  }
  read_worth(json, result);
  if (const auto marks = json.find("marks"); marks != json.end())
    result.marks = marks->at("sentences").get<std::vector<std::string>>();
  return result;
}

std::string last_part(const std::string& key) {
  return key.substr(key.rfind('.') + 1);
}

}  // namespace

FitResult read_fit_result(const fs::path& folder) {
  const fs::path file = folder / "tuning.json";
  const CsvTable profiles = parse_csv(read_file(folder / "profiles.csv"));
  const std::string text = read_file(file);
  try {
    return result_in(FitJson::parse(text), profiles);
  } catch (const FitJson::exception& problem) {
    throw input_error(file.string(), std::string("is not a search's result: ") + problem.what(),
                      "fit once more");
  }
}

Settings with_fit(const Settings& settings, const FitResult& result) {
  Settings next = settings;
  for (const FittedParameter& fitted : result.parameters)
    set_param_text(next, fitted.key, fitted.value, "fit");
  return next;
}

std::string indifferent_text(const FitResult& result) {
  std::vector<std::string> names;
  for (const FittedParameter& fitted : result.parameters) {
    if (!fitted.matters) names.push_back(last_part(fitted.key));
  }
  if (names.empty()) return "";
  return join(names, " and ") + (names.size() == 1 ? " does" : " do") + " not matter here";
}

}  // namespace inkbench
