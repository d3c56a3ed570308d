// SPDX-License-Identifier: MIT
#include "app/workbench/render_command_text.h"

#include "app/workbench/scene_base.h"
#include "pipeline/base/error.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

bool is_choice(const std::string& key, const Settings& settings) {
  return find_param(settings, key, "command").field->type == FieldType::choice;
}

}  // namespace

RenderCommand render_command(const Settings& settings, const std::filesystem::path& scene,
                             const std::vector<BufferName>& buffers, const std::filesystem::path& out) {
  const SceneBase base = find_base(settings, scene);
  if (base.scene.empty())
    throw input_error("command", "no scene file has these models and lights",
                      "save the settings as a preset and open that as the scene");
  RenderCommand command;
  command.scene = base.scene;
  command.text = "inkbench render";
  if (base.scene != default_scene().lexically_normal())
    command.text += " --scene " + shell_word(base.scene.string());
  for (const NarrowChange& change : base.changes) {
    const std::string value =
        is_choice(change.key, settings) ? std::get<std::string>(change.after) : to_text(change.after);
    command.assignments.push_back(change.key + "=" + value);
    command.text += " --set " + shell_word(command.assignments.back());
  }
  std::vector<std::string> names;
  for (const BufferName buffer : buffers) names.emplace_back(name_of(buffer));
  command.text += " --buffers " + join(names, ",") + " --out " + shell_word(out.string());
  return command;
}

}  // namespace inkbench
