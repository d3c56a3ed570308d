// SPDX-License-Identifier: MIT
#include "app/window/workbench.h"

#include "app/window/window.h"
#include "pipeline/base/log.h"

namespace inkbench {

Workbench::Workbench(const Session& session, Keeping& kept)
    : keeping(kept),
      layout(session.layout),
      document(session.settings, session.scene, problems, session.marks),
      news(wake_window),
      viewer(document, problems, layout, view, news),
      files(document, problems, kept.presets().folder(), takers()) {
  set_log_sink([this](const std::string& text) { log.add(Severity::note, text); });
}

Workbench::~Workbench() {
  set_log_sink({});
}

FileTakers Workbench::takers() {
  return {.mesh =
              [this](const ModelParams& model, const std::shared_ptr<Mesh>& mesh) {
                viewer.pictures.pipeline().meshes().take_full(model, mesh);
              },
          .buffer =
              [this](BufferName buffer) {
                view.selected = buffer;
                if (view.filled) view.filled = buffer;
              },
          .study = [this](const OpenedFile& file) { studies.open_spec(file.path); },
          .opened = [this](const std::filesystem::path& file) { keeping.add_recent(file); }};
}

}  // namespace inkbench
