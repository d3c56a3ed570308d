// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/gltf_buffers.h"

#include <nlohmann/json.hpp>
#include <string>

#include "pipeline/mesh/formats/uri_escapes.h"

namespace inkbench {

std::vector<std::filesystem::path> gltf_buffers(std::string_view text) {
  std::vector<std::filesystem::path> files;
  const nlohmann::json document = nlohmann::json::parse(text, nullptr, false);
  if (!document.is_object()) return files;
  const auto buffers = document.find("buffers");
  if (buffers == document.end() || !buffers->is_structured()) return files;
  for (const nlohmann::json& buffer : *buffers) {  // a list in version 2, by name in version 1
    const auto uri = buffer.is_object() ? buffer.find("uri") : buffer.end();
    if (!buffer.is_object() || uri == buffer.end() || !uri->is_string()) continue;
    const std::string& place = uri->get_ref<const std::string&>();
    if (!place.empty() && !place.starts_with("data:")) files.emplace_back(without_escapes(place));
  }
  return files;
}

}  // namespace inkbench
