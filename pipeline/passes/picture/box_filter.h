// SPDX-License-Identifier: MIT
// Pictures of what was drawn several times as large: each pixel the mean of its samples' display values.
#pragma once

#include "pipeline/flow/image_window.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/picture/picture.h"

namespace inkbench {

class BoxFilterPass {
 public:
  explicit BoxFilterPass(const GeneratedSources& generated);
  /// In: a buffer that shows `window` of the image at `times` its size; `view` is grey or colours. Out: the
  /// pixels `part` of `picture`, rgba8, all of whose samples lie in the window.
  void run(const PictureView& view, const Texture& buffer, const ImageWindow& window, int times,
           const ImageWindow& part, const Texture& picture) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
