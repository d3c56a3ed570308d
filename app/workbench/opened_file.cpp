// SPDX-License-Identifier: MIT
#include "app/workbench/opened_file.h"

#include <algorithm>
#include <array>

#include "app/workbench/folder_listing.h"
#include "app/workbench/presets.h"
#include "app/workbench/ramp_file.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/log.h"
#include "pipeline/base/text.h"
#include "pipeline/export.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {
namespace {

constexpr const char* kKnownKinds =
    "inkbench opens images (PNG, EXR, ...), meshes (OBJ, PLY, OFF, STL, glTF, FBX, ...) and TOML files: "
    "scenes, "
    "presets, studies, ramps";
constexpr size_t kMaxTomlBytes = size_t{16} << 20;

void check_is_file(const fs::path& path) {
  if (!is_utf8(path.string())) throw input_error("this file", "has a name that is not UTF-8", "rename it");
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw input_error(path.string(), "no such file");
  if (fs::is_directory(status)) throw input_error(path.string(), "is a folder", kKnownKinds);
  if (!fs::is_regular_file(status)) throw input_error(path.string(), "is not a regular file", kKnownKinds);
  if (fs::file_size(path, error) == 0) throw input_error(path.string(), "is empty", kKnownKinds);
}

std::string head_of(const fs::path& path) {
  return read_file_part(path, 0, 4096);
}

/// By a signature that nothing else opens with. Other images are found by trying.
bool looks_like_image(const std::string& head) {
  constexpr std::array<std::string_view, 3> kSignatures{"\x89PNG", "\x76\x2f\x31\x01", "\xff\xd8\xff"};
  return std::any_of(kSignatures.begin(), kSignatures.end(),
                     [&](std::string_view signature) { return head.starts_with(signature); });
}

bool is_text(const std::string& head) {
  return head.find('\0') == std::string::npos;
}

/// Entries that only a study's spec has; `scene` is a path there and a table in a scene file.
bool is_study(const TomlNode& document) {
  for (const char* key : {"axis", "variant", "show", "measure", "set", "size", "purpose", "path"}) {
    if (document.find(key) != nullptr) return true;
  }
  const TomlNode* scene = document.find("scene");
  return scene != nullptr && scene->is_text();
}

OpenedFile open_image(OpenedFile file) {
  if (const std::string spec = read_image_text(file.path, "inkbench:spec"); !spec.empty()) {
    file.kind = FileKind::study;
    file.study = parse_spec(spec, file.path, {});
    return file;
  }
  if (!has_origin(file.path)) {
    file.kind = FileKind::ramp_image;
    file.ramp = load_ramp(file.path);
    return file;
  }
  ImageOrigin origin = read_origin(file.path);
  for (const std::string& note : notes_on_changed_files(file.path, origin, origin.settings)) log_note(note);
  file.kind = FileKind::exported_image;
  file.settings = std::move(origin.settings);
  file.buffer = origin.buffer;
  return file;
}

OpenedFile open_toml(OpenedFile file) {
  const std::string text = read_file(file.path, kMostTextBytes);
  if (text.size() > kMaxTomlBytes)
    throw input_error(file.path.string(), "is too large for a TOML file of inkbench");
  const TomlNode document = parse_toml(text, file.path.string());
  if (is_ramp_document(document)) {
    file.kind = FileKind::ramp;
    file.ramp = parse_ramp(document, file.path.string());
  } else if (is_study(document)) {
    file.kind = FileKind::study;
    file.study = parse_spec(text, file.path, {});
  } else {
    file.kind = text.starts_with(kPresetMark) ? FileKind::preset : FileKind::scene;
    file.settings = load_settings(file.path);
    check_settings(*file.settings);
  }
  return file;
}

}  // namespace

std::string_view name_of(FileKind kind) {
  constexpr std::array<std::string_view, 7> kNames{
      "an exported image", "a scene", "a preset", "a study", "a ramp", "an image", "a mesh"};
  return kNames[static_cast<size_t>(kind)];
}

OpenedFile open_file(const fs::path& path) {
  check_is_file(path);
  OpenedFile file;
  file.path = fs::absolute(path).lexically_normal();
  const std::string head = head_of(file.path);
  if (looks_like_image(head)) return open_image(std::move(file));
  if (is_mesh_name(file.path)) {
    file.kind = FileKind::mesh;
    return file;
  }
  if (lower_extension(file.path) == ".toml" && is_text(head)) return open_toml(std::move(file));
  try {
    return is_text(head) ? open_toml(file) : open_image(file);
  } catch (const Error&) {
    throw input_error(file.path.string(), "is no file that inkbench can open", kKnownKinds);
  }
}

}  // namespace inkbench
