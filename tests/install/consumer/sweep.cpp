// SPDX-License-Identifier: MIT
// A program outside the tree that reads a bundled study: prints its cells' count, and where the package's
// files are.
#include <cstdio>

#include "pipeline/base/files.h"
#include "studies/sweep/spec.h"

int main() {
  const inkbench::StudySpec spec = inkbench::load_spec(inkbench::project_file("studies/k_sweep.toml"));
  std::printf("%zu\n%s\n", inkbench::cell_count(spec), inkbench::project_root().c_str());
  std::printf("%s\n", inkbench::module_file("inkbench_image_codecs.so").c_str());
}
