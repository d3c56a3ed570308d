// SPDX-License-Identifier: MIT
// A program that finds nothing of inkbench, linked as from a package: prints what is said of that.
#include <cstdio>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"

int main() {
  try {
    inkbench::project_root();
  } catch (const inkbench::Error& error) {
    std::puts(error.what());
  }
}
