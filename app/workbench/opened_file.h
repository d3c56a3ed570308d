// SPDX-License-Identifier: MIT
// What a file is that was dropped on the window or opened by name, told by its content. In: a path. Out: its
// kind and what it holds, read and checked whole.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "pipeline/buffers.h"
#include "pipeline/settings/settings.h"
#include "studies/sweep/spec.h"

namespace inkbench {

enum class FileKind {
  exported_image,  ///< A PNG or EXR with its parameters: `settings`, `buffer`.
  scene,           ///< A scene file: `settings`.
  preset,          ///< A preset: `settings`.
  study,           ///< A study's spec, or the grid of one, which carries it: `study`.
  ramp,            ///< Stops in TOML: `ramp`.
  ramp_image,      ///< Any other image; a person says whether its first row is a ramp: `ramp`.
  mesh,            ///< By its name's ending; it is read when it is drawn.
};

/// "an exported image", "a study": for messages.
std::string_view name_of(FileKind kind);

struct OpenedFile {
  FileKind kind{};
  std::filesystem::path path;  ///< Absolute.
  std::optional<Settings> settings;
  std::optional<BufferName> buffer;
  std::optional<StudySpec> study;
  std::optional<Ramp> ramp;
};

/// Errors (input): not there, none of the kinds (saying what is), damaged, with file:line where there are
/// lines; a path that is not UTF-8, which no settings could name.
OpenedFile open_file(const std::filesystem::path& path);

}  // namespace inkbench
