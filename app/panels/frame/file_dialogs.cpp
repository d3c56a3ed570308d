// SPDX-License-Identifier: MIT
#include "app/panels/frame/file_dialogs.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/listed_buffers.h"
#include "app/window/theme.h"
#include "app/workbench/render_command_text.h"
#include "app/workbench/scene_base.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/export.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/settings/settings_file.h"
#include "pipeline/vector_export.h"

namespace inkbench {
namespace {

constexpr std::array<std::string_view, 10> kOpened{".toml", ".png", ".exr", ".jpg", ".tif",
                                                   ".tiff", ".hdr", ".bmp", ".tga", ".webp"};

void write_settings(Document& document, Problems& problems, const fs::path& path) {
  write_file_atomically(path, preset_text(path.stem().string(), with_absolute_paths(document.settings())));
  document.saved_as(path);
  problems.tell(Severity::note, "saved the settings as " + path.string());
}

fs::path start_folder(const Document& document) {
  if (!document.scene().empty()) return document.scene().parent_path();
  return project_file("data/scenes");
}

ChooserQuestion open_question(const Document& document) {
  std::vector<std::string_view> extensions = mesh_endings();
  extensions.insert(extensions.end(), kOpened.begin(), kOpened.end());
  return {.title = "Open",
          .help =
              "Scenes, presets, studies and ramps (.toml), exported images (.png, .exr), meshes (.obj, "
              ".ply, .off, .stl, .gltf, .glb, .fbx and more).",
          .button = "Open",
          .extensions = std::move(extensions),
          .folder = start_folder(document)};
}

ChooserQuestion save_question(const Document& document, const Keeping& keeping) {
  return {.title = "Save the settings",
          .help =
              "All settings as one scene file (.toml), which `inkbench render --scene` and studies read, "
              "too. In the folder of presets it is listed as a preset.",
          .button = "Save",
          .extensions = {".toml"},
          .folder =
              is_preset_file(document.scene()) ? document.scene().parent_path() : keeping.presets().folder(),
          .saves = true,
          .name = is_preset_file(document.scene()) ? document.scene().filename().string() : "scene.toml"};
}

ChooserQuestion image_question(const ComparedPicture& picture, const fs::path& folder) {
  return {.title = picture.pinned ? "Save a picture of the pinned state" : "Save a picture",
          .help =
              "The bytes that `inkbench render` writes: .png is the picture with the display gains, .exr "
              "the raw values, which carry all settings; .svg and .pdf are lines as vectors.",
          .button = "Save",
          .extensions = {".png", ".exr", ".svg", ".pdf"},
          .folder = folder,
          .saves = true,
          .name = std::string(name_of(picture.buffer)) + ".png"};
}

}  // namespace

void FileDialogs::begin(FileDialog dialog) {
  dialog_ = dialog;
  std::error_code error;
  if (image_folder_.empty()) image_folder_ = fs::current_path(error);
  if (dialog == FileDialog::open) chooser_.ask(open_question(document_));
  if (dialog == FileDialog::save_settings) {
    fs::create_directories(keeping_.presets().folder(), error);  // where it cannot be, saving tells why
    chooser_.ask(save_question(document_, keeping_));
  }
  if (dialog != FileDialog::save_image) return;
  picture_ = meant_picture(view_);
  chooser_.ask(image_question(picture_, image_folder_));
}

void FileDialogs::set_image_ending(std::string_view ending) {
  chooser_.name() = fs::path(chooser_.name()).stem().string() + std::string(ending);
}

void FileDialogs::draw_image_choice() {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Buffer");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(scaled(160));
  const bool open = ImGui::BeginCombo("##buffer", std::string(name_of(picture_.buffer)).c_str());
  ui_map_.mark_item("image:buffer");
  for (const BufferName buffer : all_buffers()) {
    if (!open) break;
    const std::string name(name_of(buffer));
    if (ImGui::Selectable(name.c_str(), buffer == picture_.buffer)) {
      const fs::path typed(chooser_.name());
      if (typed.stem() == name_of(picture_.buffer)) chooser_.name() = name + typed.extension().string();
      picture_.buffer = buffer;
    }
    ui_map_.mark_item("image:" + name);
  }
  if (open) ImGui::EndCombo();
  const std::string ending = lower_extension(chooser_.name());
  const bool lines = is_of_lines(picture_.buffer);
  for (const std::string_view format : {".png", ".exr", ".svg", ".pdf"}) {
    if (!lines && (format == ".svg" || format == ".pdf")) continue;
    ImGui::SameLine();
    const std::string name(format.substr(1));
    if (toggle_button(name.c_str(), ending == format)) set_image_ending(format);
    ui_map_.mark_item("image:" + name);
  }
}

void FileDialogs::finish(const fs::path& path) {
  if (dialog_ == FileDialog::open) return files_.open(path.string());
  attempt(problems_, [&] {
    if (dialog_ == FileDialog::save_settings) return write_settings(document_, problems_, path);
    write_buffer(pictures_.pipeline().at(settings_of(picture_, document_, pictures_)), picture_.buffer, path);
    image_folder_ = path.parent_path();
    problems_.tell(Severity::note, fmt::format("saved {} as {}", name_of(picture_.buffer), path.string()));
  });
}

void FileDialogs::draw() {
  if (const auto wanted = std::exchange(wanted_dialog_, std::nullopt); wanted && !chooser_.is_open())
    begin(*wanted);
  const bool asks_buffer = dialog_ == FileDialog::save_image;
  const auto path = asks_buffer ? chooser_.draw([&] { draw_image_choice(); }) : chooser_.draw();
  if (path) finish(*path);
}

void save_settings(Document& document, Problems& problems, WantedDialog& wanted_dialog) {
  if (!is_preset_file(document.scene())) {
    wanted_dialog = FileDialog::save_settings;
    return;
  }
  attempt(problems, [&] { write_settings(document, problems, document.scene()); });
}

}  // namespace inkbench
