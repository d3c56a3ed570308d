// SPDX-License-Identifier: MIT
#include "app/panels/study/studies_menu.h"

#include <imgui.h>

#include <algorithm>

#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/widgets.h"
#include "pipeline/base/files.h"

namespace inkbench {
namespace {

/// A spec, or the folder of a study that ran.
void open_path(Studies& studies, const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    studies.open_folder(path);
  } else {
    studies.open_spec(path);
  }
}

}  // namespace

/// Once: reading a spec reads its scene, too.
void StudiesMenu::read_bundled() {
  if (bundled_) return;
  bundled_.emplace();
  for (const auto& [label, place] :
       {std::pair{"Bundled", "studies"}, {"The paper's figures", "studies/figures"}}) {
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(project_root() / place, error)) {
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    Folder folder{label, {}};
    for (const fs::path& file : files) {
      try {
        const StudySpec spec = load_spec(file);
        folder.studies.push_back(
            {file, spec.title.empty() ? file.stem().string() : spec.title, spec.purpose});
      } catch (const Error& problem) {
        folder.studies.push_back({file, file.filename().string(), problem.what()});
      }
    }
    bundled_->push_back(std::move(folder));
  }
}

void StudiesMenu::draw_menu() {
  const bool open = ImGui::BeginMenu("Studies");
  ui_map_.mark_item("menu:Studies");
  if (!open) return;
  Studies& studies = studies_;
  if (menu_item(ui_map_, "Show the studies", "F3", studies.page_open)) studies.page_open = !studies.page_open;
  if (menu_item(ui_map_, "New study")) attempt(problems_, [&] { studies.new_form(document_.settings()); });
  if (menu_item(ui_map_, "Open a spec or results..."))
    question_.ask({"Open a study", "A spec (.toml), or the folder of a study that ran.", "Open"},
                  [this](const std::string& path) { open_path(studies_, path); });
  ImGui::Separator();
  read_bundled();
  for (const Folder& folder : *bundled_) {
    const bool below = ImGui::BeginMenu(folder.label.c_str());
    ui_map_.mark_item("menu:" + folder.label);
    if (!below) continue;
    for (const Bundled& study : folder.studies) {
      if (menu_item(ui_map_, study.title.c_str())) attempt(problems_, [&] { studies.open_spec(study.file); });
      help_for_item(study.purpose);
    }
    ImGui::EndMenu();
  }
  ImGui::EndMenu();
}

}  // namespace inkbench
