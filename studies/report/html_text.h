// SPDX-License-Identifier: MIT
// Texts from anywhere made safe inside the report page. In: any bytes. Out: UTF-8 that stays text where it is
// put.
#pragma once

#include <string>
#include <string_view>

namespace inkbench {

/// For elements and quoted attributes: `<`, `>`, `&` and quotes as entities. Bytes that are not UTF-8 and
/// control characters but line breaks and tabs become U+FFFD.
std::string html_text(std::string_view text);

/// A path relative to the page as a URL: all but letters, digits, `-`, `.`, `_`, `~` and `/` as %XX.
std::string url_path(std::string_view path);

/// A JSON string with its quotes that can stand inside <script>: no `<`, `>` or `&`. Bytes that are not UTF-8
/// become U+FFFD.
std::string json_text(std::string_view text);

std::string base64(std::string_view bytes);

}  // namespace inkbench
