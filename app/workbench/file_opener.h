// SPDX-License-Identifier: MIT
// Opening files in the window, by what they hold: scenes, presets, exported images, meshes, ramps, studies.
// In: paths. Out: a changed document, or what other parts of the window are handed.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/workbench/document.h"
#include "app/workbench/opened_file.h"
#include "pipeline/mesh/mesh.h"

namespace inkbench {

/// Who takes what is not the document's. All must be there; what they throw is told as the file's problem.
struct FileTakers {
  /// A mesh that is about to be this model's, so that it is not read again.
  std::function<void(const ModelParams&, const std::shared_ptr<Mesh>&)> mesh;
  /// The buffer that an exported image shows.
  std::function<void(BufferName)> buffer;
  std::function<void(const OpenedFile&)> study;
  /// Each file that was opened.
  std::function<void(const std::filesystem::path&)> opened;
};

/// What an image without parameters can be taken for.
enum class ImageUse { nothing, diffuse_ramp, specular_ramp };

class FileOpener {
 public:
  /// `document` and `problems` must outlive it. A preset of that folder is a layer on the scene; elsewhere
  /// the same file is a scene.
  FileOpener(Document& document, Problems& problems, std::filesystem::path presets_folder, FileTakers takers);

  /// What cannot be opened is told as a problem and changes nothing.
  void open(const std::string& path) { open_all({path}); }
  /// One after the other; what could not be opened is told even where another could.
  void open_all(const std::vector<std::string>& paths);

  /// The first of the images without parameters that were opened: it changes nothing until a person has said
  /// what it is. Null where there is none.
  const OpenedFile* asked() const { return asked_.empty() ? nullptr : &asked_.front(); }
  /// Takes the image that is asked about so; there must be one.
  void answer(ImageUse use);

 private:
  std::string open_one(const std::string& path);
  void take(const OpenedFile& file);
  void take_scene(const OpenedFile& file);
  void take_mesh(const OpenedFile& file);
  void take_ramp(const OpenedFile& file, Ramp RampParams::*ramp, const char* name);
  void tell_opened(const OpenedFile& file);
  void take_ramp(const OpenedFile& file);
  bool is_kept_preset(const std::filesystem::path& file) const;

  Document& document_;
  Problems& problems_;
  std::filesystem::path presets_folder_;
  FileTakers takers_;
  std::vector<OpenedFile> asked_;
};

}  // namespace inkbench
