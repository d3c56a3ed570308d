// SPDX-License-Identifier: MIT
#include "app/panels/widgets/clipboard.h"

#include <imgui.h>

#include "app/panels/widgets/attempt.h"
#include "app/window/listed_buffers.h"
#include "app/workbench/folder_listing.h"
#include "app/workbench/render_command_text.h"
#include "app/workbench/scene_base.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {

void copy_render_command(const Document& document, const Pictures& pictures, const ViewState& view,
                         Problems& problems) {
  attempt(problems, [&] {
    const ComparedPicture meant = meant_picture(view);
    const RenderCommand command = render_command(settings_of(meant, document, pictures), document.scene(),
                                                 {meant.buffer}, "out/render", program_word());
    ImGui::SetClipboardText(command.text.c_str());
    problems.tell(Severity::note, "copied: " + command.text);
  });
}

void copy_settings(const Document& document, Problems& problems) {
  ImGui::SetClipboardText(settings_text(with_absolute_paths(document.settings())).c_str());
  problems.tell(Severity::note, "copied all settings as the text of a scene file");
}

void paste(Document& document, FileOpener& files, Problems& problems) {
  const char* held = ImGui::GetClipboardText();
  const std::string text = held == nullptr ? "" : held;
  std::error_code error;
  const fs::path folder = fs::current_path(error);
  const fs::path path = path_from_text(text.substr(0, text.find('\n')), folder);
  const bool is_path = !path.empty() && text.size() < 4096 && fs::exists(path, error);
  if (is_path) return files.open(path.string());
  attempt(problems, [&] {
    if (text.find('=') == std::string::npos)
      throw input_error("the clipboard", "holds neither a file's path nor settings",
                        "copy settings with Edit > Copy settings, or a path");
    const Settings pasted = parse_settings(text, "the clipboard", folder);
    check_settings(pasted);
    document.replace(pasted, "paste settings");
  });
}

}  // namespace inkbench
