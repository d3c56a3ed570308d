// SPDX-License-Identifier: MIT
// Opens libraries of the project that are loaded when they are first needed (`module_file`). In: the file and
// the function that it exports. Out: that function, untyped.
#pragma once

#include <string>

namespace inkbench {

struct ModuleTexts {
  std::string what_fails;  ///< "images cannot be read or written"
  std::string package;     ///< Debian's package that must be in place.
};

/// The module stays open until the program ends. Errors (work): it is missing or cannot be opened.
void* open_module(const std::string& file, const char* symbol, const ModuleTexts& texts);

}  // namespace inkbench
