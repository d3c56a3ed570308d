// SPDX-License-Identifier: MIT
// What workbench tests share: scenes without files beyond the project's own.
#pragma once

#include <gmock/gmock.h>

#include <string>

#include "pipeline/base/files.h"
#include "pipeline/settings/settings_file.h"
#include "tests/unit/support.h"

namespace inkbench {

inline Settings paper_settings() {
  return load_settings(project_file("data/scenes/paper.toml"));
}

inline void set(Settings& settings, const std::string& key, const Value& value) {
  find_param(settings, key, "test").set(value, "test");
}

/// Settings by all their text: independent of the code under test.
inline std::string text(const Settings& settings) {
  return settings_text(settings);
}

}  // namespace inkbench
