// SPDX-License-Identifier: MIT
#include "studies/report/svg_text.h"

#include <algorithm>

namespace inkbench {
namespace {

/// Puts `prefix` behind each of the marks that an id follows.
std::string scoped_tag(std::string_view tag, const std::string& prefix) {
  std::string result;
  while (!tag.empty()) {
    size_t end = std::string_view::npos;
    for (const std::string_view mark : {" id='", " id=\"", "href='#", "href=\"#", "url(#"}) {
      const size_t at = tag.find(mark);
      if (at != std::string_view::npos) end = std::min(end, at + mark.size());
    }
    result += tag.substr(0, end);
    if (end == std::string_view::npos) break;
    result += prefix;
    tag.remove_prefix(end);
  }
  return result;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  return result;
}

}  // namespace

std::string scoped_svg(std::string_view svg, std::string_view scope, std::string_view title) {
  const std::string prefix = std::string(scope) + "-";
  std::string result;
  bool in_title = false;
  while (!svg.empty()) {
    const size_t open = std::min(svg.find('<'), svg.size());
    if (!in_title) result += svg.substr(0, open);
    svg.remove_prefix(open);
    const size_t close = std::min(svg.find('>'), svg.size());
    const std::string_view tag = svg.substr(0, std::min(close + 1, svg.size()));
    result += scoped_tag(tag, prefix);
    in_title = tag == "<title>";
    if (in_title) result += escaped(title);
    svg.remove_prefix(tag.size());
  }
  return result;
}

}  // namespace inkbench
