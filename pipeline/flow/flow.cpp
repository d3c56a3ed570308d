// SPDX-License-Identifier: MIT
#include "pipeline/flow/flow.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/params/glsl_block.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

void Flow::add(const PassKind& kind) {
  kind.add_node(*this);
  for (const BufferName buffer : kind.buffers) buffers_[buffer] = nodes_.back().get();
}

void Flow::add_node(std::type_index tag, std::unique_ptr<NodeBase> node) {
  tagged_[tag] = node.get();
  nodes_.push_back(std::move(node));
}

bool Flow::looks_back() const {
  return std::any_of(nodes_.begin(), nodes_.end(), [](const auto& node) { return node->looks_back(); });
}

GeneratedSources generated_sources() {
  GeneratedSources sources;
  const Settings settings;
  for (const ConstParamGroup& group : list_groups(settings)) {
    const std::string name(group.description->group);
    if (!glsl_members(*group.description).empty()) {
      sources[fmt::format("generated/{}.glsl", name)] =
          glsl_choices(*group.description, name) + glsl_uniform_block(*group.description, name);
    }
  }
  sources["generated/light.glsl"] = glsl_choices(LightParams::description(), "light") +
                                    glsl_struct(LightParams::description(), "Light") +
                                    fmt::format("const int max_lights = {};\n", kMaxLights);
  sources["generated/material.glsl"] = glsl_struct(MaterialParams::description(), "Material") +
                                       fmt::format("const int materials_at_once = {};\n", kMaterialsAtOnce);
  return sources;
}

}  // namespace inkbench
