// SPDX-License-Identifier: MIT
#include "pipeline/image/image_codecs.h"

#include "pipeline/base/module.h"

namespace inkbench {

const ImageCodecs& image_codecs() {
  // Once, whichever thread is first. OpenImageIO's libraries cannot be unloaded.
  static const ImageCodecs* const codecs = reinterpret_cast<decltype(&inkbench_image_codecs)>(
      open_module("inkbench_image_codecs.so", "inkbench_image_codecs",
                  {.what_fails = "images cannot be read or written", .package = "libopenimageio2.4"}))();
  return *codecs;
}

}  // namespace inkbench
