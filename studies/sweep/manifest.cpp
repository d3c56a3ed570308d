// SPDX-License-Identifier: MIT
#include "studies/sweep/manifest.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/settings/settings_file.h"
#include "studies/sweep/file_record.h"

namespace inkbench {

std::vector<std::pair<std::string, std::string>> study_versions() {
  const RendererInfo renderer = renderer_info();
  return {{"inkbench", INKBENCH_VERSION},
          {"renderer", renderer.renderer},
          {"OpenGL", renderer.version},
          {"OpenMesh", INKBENCH_OPENMESH_VERSION},
          {"OpenImageIO", INKBENCH_OPENIMAGEIO_VERSION}};
}

std::string spec_command(const std::string& word, const fs::path& spec_path,
                         const std::vector<std::string>& assignments) {
  const fs::path path = fs::absolute(spec_path).lexically_normal();
  const fs::path within = path.lexically_relative(project_root());
  const bool is_within = !within.empty() && *within.begin() != "..";
  std::string command = "inkbench " + word + " " + shell_word((is_within ? within : path).string());
  for (const std::string& assignment : assignments) command += " --set " + shell_word(assignment);
  return command;
}

std::string study_command(const StudySpec& spec) {
  return spec_command("study", spec.path, spec.assignments);
}

std::string made_by(const StudySpec& spec, const ReportExtras& extras) {
  return extras.command.empty() ? study_command(spec) : extras.command;
}

namespace {

/// All that a run has written besides the pictures, which the journal knows.
std::vector<FileRecord> written_files(const fs::path& folder, const StudyResult& result) {
  std::vector<fs::path> paths{folder / "data.csv", folder / "journal.jsonl"};
  paths.insert(paths.end(), result.grids.begin(), result.grids.end());
  for (const DrawnChart& chart : result.charts)
    paths.insert(paths.end(), {chart.script, chart.svg, chart.png});
  if (!result.page.empty()) paths.push_back(result.page);
  std::vector<FileRecord> files;
  for (const fs::path& path : paths)
    files.push_back(record_file(folder, path.lexically_relative(folder).string()));
  return files;
}

/// Puts `to` over the text `from`, which is as long, in the open file. False where it is not there.
bool replace_in_place(const Descriptor& file, const std::string& content, std::string_view from,
                      std::string_view to) {
  const size_t at = content.find(from);
  if (at == std::string::npos) return false;
  return pwrite(file.number(), to.data(), to.size(), static_cast<off_t>(at)) ==
         static_cast<ssize_t>(to.size());
}

}  // namespace

void mark_stopped(const fs::path& folder) noexcept {
  try {
    const fs::path path = folder / "manifest.json";
    const Descriptor file(open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC));
    const std::string content = read_file(path);
    if (!replace_in_place(file, content, R"("state": "running")", R"("state": "stopped")"))
      replace_in_place(file, content, R"("state": "finished")", R"("state": "stopped" )");
  } catch (const std::exception&) {
  }
}

void write_manifest(const fs::path& folder, const StudySpec& spec, const std::string& command,
                    const StudyResult& result, const std::string& state) {
  const RendererInfo renderer = renderer_info();
  nlohmann::ordered_json versions;
  for (const auto& [name, version] : study_versions()) versions[name] = version;
  std::vector<std::string> grids;
  for (const fs::path& grid : result.grids) grids.push_back(grid.filename().string());
  std::vector<std::string> charts;
  for (const DrawnChart& chart : result.charts) charts.push_back(chart.name);
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  const nlohmann::ordered_json manifest{
      {"title", spec.title},
      {"state", state},
      {"version", INKBENCH_VERSION},
      {"command", command},
      {"renderer", {{"name", renderer.renderer}, {"vendor", renderer.vendor}, {"opengl", renderer.version}}},
      {"versions", versions},
      {"cells", result.progress.total},
      {"failures", result.failures},
      {"files", json_of(state == "running" ? std::vector<FileRecord>() : written_files(folder, result))},
      {"grids", grids},
      {"charts", charts},
      {"spec_file", spec.path.filename().string()},
      {"spec", spec.text},
      {"base_settings", settings_text(spec.base)},
      {"times",
       {{"written", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now))},
        {"cells_drawn", result.progress.drawn},
        {"cells_measured", result.progress.measured},
        {"pictures_decoded", result.pictures_decoded},
        {"seconds", result.progress.seconds}}}};
  write_file_atomically(folder / "manifest.json",
                        manifest.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace inkbench
