// SPDX-License-Identifier: MIT
#include "pipeline/image/image_codecs.h"

#include <dlfcn.h>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"

namespace inkbench {
namespace {

/// The module stays open until the program ends: OpenImageIO's libraries cannot be unloaded.
const ImageCodecs* open_module() {
  const std::string path = module_file("inkbench_image_codecs.so").string();
  const auto failed = [&] {
    const char* reason = dlerror();
    return work_error(path,
                      std::string("images cannot be read or written: ") + (reason == nullptr ? "" : reason),
                      "build or install inkbench again, with Debian's package libopenimageio2.4 in place");
  };
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw failed();
  void* symbol = dlsym(library, "inkbench_image_codecs");
  if (symbol == nullptr) throw failed();
  return reinterpret_cast<decltype(&inkbench_image_codecs)>(symbol)();
}

}  // namespace

const ImageCodecs& image_codecs() {
  static const ImageCodecs* const codecs = open_module();  // once, whichever thread is first
  return *codecs;
}

}  // namespace inkbench
