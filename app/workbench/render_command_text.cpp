// SPDX-License-Identifier: MIT
#include "app/workbench/render_command_text.h"

#include <unistd.h>

#include <cstdlib>

#include "app/workbench/own_program.h"
#include "app/workbench/scene_base.h"
#include "pipeline/base/error.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

bool is_own_program(const std::filesystem::path& file) {
  std::error_code error;
  return access(file.c_str(), X_OK) == 0 && std::filesystem::equivalent(file, own_program(), error);
}

}  // namespace

std::string program_word() {
  const char* searched = std::getenv("PATH");
  for (const std::string& folder : split(searched == nullptr ? "" : searched, ':')) {
    const std::filesystem::path file = std::filesystem::path(folder) / "inkbench";
    if (is_own_program(file)) return "inkbench";
    if (access(file.c_str(), X_OK) == 0) break;  // the shell would take that one
  }
  return shell_word(own_program().string());
}

std::string assignment_text(const Field& field, const std::string& key, const Value& value) {
  const bool is_choice = field.type == FieldType::choice;
  return key + "=" + (is_choice ? std::get<std::string>(value) : to_text(value));
}

RenderCommand render_command(const Settings& settings, const std::filesystem::path& scene,
                             const std::vector<BufferName>& buffers, const std::filesystem::path& out,
                             const std::string& program) {
  const SceneBase base = find_base(settings, scene);
  if (base.scene.empty())
    throw input_error("command", "no scene file has these models and lights",
                      "save the settings as a preset and open that as the scene");
  RenderCommand command;
  command.scene = base.scene;
  command.text = program + " render";
  if (base.scene != default_scene().lexically_normal())
    command.text += " --scene " + shell_word(base.scene.string());
  for (const NarrowChange& change : base.changes) {
    const Field& field = *find_param(settings, change.key, "command").field;
    command.assignments.push_back(assignment_text(field, change.key, change.after));
    command.text += " --set " + shell_word(command.assignments.back());
  }
  std::vector<std::string> names;
  for (const BufferName buffer : buffers) names.emplace_back(name_of(buffer));
  command.text += " --buffers " + join(names, ",") + " --out " + shell_word(out.string());
  return command;
}

}  // namespace inkbench
