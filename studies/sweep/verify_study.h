// SPDX-License-Identifier: MIT
// Whether a study's folder still holds what was written: by the hashes of journal and manifest. In: the
// folder. Out: what was looked at, and what is wrong with it. Nothing is changed, and no spec is needed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace inkbench {

struct StudyCheck {
  std::string state;                  ///< As the manifest says: "finished", "stopped" or "running".
  size_t cells = 0;                   ///< Finished ones, by the journal.
  size_t files = 0;                   ///< That were read and compared.
  std::vector<std::string> problems;  ///< "cells/0001_final.png was changed"; empty where all is as written.
};

/// Errors (input): the folder holds no study.
StudyCheck verify_study(const std::filesystem::path& folder);

}  // namespace inkbench
