// SPDX-License-Identifier: MIT
#include "pipeline/base/module.h"

#include <dlfcn.h>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"

namespace inkbench {

void* open_module(const std::string& file, const char* symbol, const ModuleTexts& texts) {
  const std::string path = module_file(file).string();
  const auto failed = [&] {
    const char* const reason = dlerror();
    return work_error(
        path, texts.what_fails + ": " + (reason == nullptr ? "" : reason),
        "build or install inkbench again, with Debian's package " + texts.package + " in place");
  };
  void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw failed();
  void* const function = dlsym(library, symbol);
  if (function == nullptr) throw failed();
  return function;
}

}  // namespace inkbench
