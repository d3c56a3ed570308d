// SPDX-License-Identifier: MIT
// SVG files made fit for standing in one HTML page together. In and out: text.
#pragma once

#include <string>
#include <string_view>

namespace inkbench {

/// Puts `scope` and '-' before every id and every reference to one, and `title` into the SVG's title.
std::string scoped_svg(std::string_view svg, std::string_view scope, std::string_view title);

}  // namespace inkbench
