// SPDX-License-Identifier: MIT
// Bytes as a scene, as a study's spec and as a `--set`: nothing but an inkbench::Error may come out besides
// settings that survive being written and read again. The first byte chooses.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "pipeline/base/error.h"
#include "pipeline/base/scratch_folder.h"
#include "pipeline/base/text.h"
#include "pipeline/params/toml_value.h"
#include "pipeline/settings/settings_file.h"
#include "studies/sweep/data_columns.h"
#include "studies/sweep/spec.h"

namespace inkbench {
namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

/// An empty folder for the whole run: what inputs refer to is not there. An Error ends the run.
const fs::path& empty_folder() noexcept {
  static const ScratchFolder scratch;
  return scratch.path();
}

/// Reading what was accepted cannot fail: an Error here is a finding, so none may pass.
void check_survives(Settings settings) {
  try {
    const std::string text = settings_text(settings);
    Settings again = parse_settings(text, "again.toml", "/elsewhere");
    require(settings_text(again) == text);
    const std::vector<Param> before = list_params(settings);
    const std::vector<Param> after = list_params(again);
    require(before.size() == after.size());
    for (size_t i = 0; i < before.size(); ++i) {
      require(before[i].key == after[i].key && before[i].value() == after[i].value());
    }
  } catch (const Error&) {
    require(false);
  }
}

void read_scene(std::string_view text) {
  check_survives(parse_settings(text, "fuzz.toml", empty_folder()));
}

/// Charts that were accepted can be drawn from any numbers.
void write_charts(const StudySpec& spec) {
  CsvTable table = planned_table(spec);
  for (size_t i = 0; i < table.rows.size(); ++i) {
    for (std::string& field : table.rows[i]) {
      if (field.empty() && i % 3 != 0) field = shortest((static_cast<double>(i) - 5) * 1e3);
    }
  }
  for (const Chart& chart : spec.charts) chart_script(chart, table);
}

void read_spec(const std::string& text) {
  const StudySpec spec = parse_spec(text, empty_folder() / "fuzz.toml", {});
  const size_t count = cell_count(spec);
  require(count > 0 && !spec.show.empty() && spec.axes.size() <= 3);
  for (const size_t index : {size_t{0}, count / 2, count - 1}) {
    const Cell cell = make_cell(spec, index);
    require(cell.index == index);
    check_survives(cell_settings(spec, cell));
  }
  if (!spec.charts.empty() && count <= 100) write_charts(spec);
}

/// "KEY=VALUE" on a scene with a model and a light.
void set_value(const std::string& assignment) {
  Settings settings;
  settings.models.emplace_back().name = "m";
  settings.lights.emplace_back().name = "l";
  apply_assignment(settings, assignment);
  check_survives(settings);
  const size_t equals = assignment.find('=');
  const Param param = find_param(settings, std::string(trim(assignment.substr(0, equals))), "");
  require(value_from_text(param, to_text(param.value()), "") == param.value());
}

void feed(uint8_t choice, const std::string& text) {
  switch (choice % 3) {
    case 0:
      return read_scene(text);
    case 1:
      return read_spec(text);
    default:
      return set_value(text);
  }
}

}  // namespace
}  // namespace inkbench

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  try {
    inkbench::feed(data[0], std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  } catch (const inkbench::Error&) {
    // Refusing bad input is right.
  }
  return 0;
}
