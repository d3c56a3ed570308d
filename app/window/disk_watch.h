// SPDX-License-Identifier: MIT
// Edits on disk of what the pictures are made from: shaders, meshes, ramps. In: now and then a look. Out:
// another number after each edit.
#pragma once

#include <string>

#include "app/window/judge_desk.h"
#include "app/window/tile.h"
#include "app/window/wire_painter.h"
#include "app/workbench/document.h"
#include "pipeline/pipeline.h"

namespace inkbench {

class DiskWatch {
 public:
  /// All must outlive it.
  DiskWatch(const Document& document, Problems& problems, Pipeline& pipeline, JudgeDesk& judge,
            TilePainter& tiles, WirePainter& wires);

  /// Takes in what was edited; a shader that does not compile is told as a problem. Returns whether there was
  /// anything.
  bool poll();
  long revision() const { return revision_; }

 private:
  std::string files_state();
  bool take_files_state();
  bool reload_shaders();
  bool reload_changed();
  std::string shader_problem() const;

  const Document& document_;
  Problems& problems_;
  Pipeline& pipeline_;
  JudgeDesk& judge_;
  TilePainter& tiles_;
  WirePainter& wires_;
  long revision_ = 0;
  std::string files_settings_, files_state_;  ///< At the last look.
};

}  // namespace inkbench
