// SPDX-License-Identifier: MIT
// Compiled into every program that the package is linked to, so that the libraries find shaders, scenes and
// modules where the package lies, wherever it was moved to. Weak, since several parts of a program may have
// it.
extern "C" [[gnu::weak]] const char* inkbench_package_prefix();

const char* inkbench_package_prefix() {
  return INKBENCH_PACKAGE_PREFIX;
}
