// SPDX-License-Identifier: MIT
// Whether two renderers draw the same: every method's lines and final image at 960 x 540 px, as
// `METHOD_lines.png` and `METHOD_final.png` in a folder.
#pragma once

#include <string>
#include <string_view>

#include "pipeline/pipeline.h"

namespace inkbench {

Settings with_method(Settings settings, std::string_view method);

/// Errors (work): the folder cannot be written.
void write_pictures(Pipeline& pipeline, const Settings& settings, const std::string& folder);

/// Draws them again and prints for each the share of the folder's line pixels that differ; whether none is
/// above `tolerance`. Errors (input): a picture is not there or has another size.
bool draws_as_written(Pipeline& pipeline, const Settings& settings, const std::string& folder,
                      double tolerance);

}  // namespace inkbench
