// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/albedo.h"

#include <algorithm>
#include <map>

#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"

namespace inkbench {
namespace {

constexpr BufferInfo kAlbedo{.name = "albedo",
                             .help = "The colour of each pixel's material, without light.",
                             .channels = 3,
                             .shown_as = ShownAs::colour};
constexpr BufferInfo kMaterialId{.name = "material_id",
                                 .help = "A colour for each material; models of equal ones share it.",
                                 .first_channel = 3,
                                 .shown_as = ShownAs::object_id};

struct MaterialTableInput {
  MaterialTableInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() { return {{MaterialParams::description().group}}; }
  std::vector<glm::vec4> get(const FrameState& frame) const { return material_table(frame.settings); }
  void fold(KeyBuilder& key, const FrameState& frame) const {
    const std::vector<glm::vec4> table = get(frame);
    key.add_bytes(bytes_of(std::span(table)));
  }
};

/// Of a row of the table's texture: no driver must take one as long as a scene's models are many.
constexpr size_t kRow = 256;

Texture table_texture(const std::vector<glm::vec4>& materials) {
  const size_t rows = std::max<size_t>((materials.size() + kRow - 1) / kRow, 1);
  const auto width = static_cast<int>(kRow), height = static_cast<int>(rows);
  Image table(width, height, 4);
  for (size_t i = 0; i < materials.size(); ++i) {
    const int x = static_cast<int>(i % kRow), row = static_cast<int>(i / kRow);
    for (int c = 0; c < 4; ++c) table.at(x, height - 1 - row, c) = materials[i][c];  // texture row 0 is below
  }
  Texture texture("materials", TextureFormat::rgba32f, width, height);
  texture.upload(table);
  return texture;
}

}  // namespace

constinit const BufferName BufferName::albedo{kAlbedo};
constinit const BufferName BufferName::material_id{kMaterialId};

std::vector<glm::vec4> material_table(const Settings& settings) {
  std::vector<glm::vec4> table;
  std::map<std::string, float> numbers;
  for (const ModelParams& model : settings.models) {
    const auto [found, is_new] = numbers.try_emplace(group_text(model.material), numbers.size() + 1.0F);
    table.emplace_back(model.material.colour, found->second);
  }
  return table;
}

const PassKind& AlbedoPass::kind() {
  static const PassKind kKind =
      describe_pass<AlbedoPass>("albedo", 1, {shows(BufferName::albedo), shows(BufferName::material_id)},
                                MaterialTableInput{}, value_of<GBufferPass>());
  return kKind;
}

AlbedoPass::AlbedoPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "albedo.frag", {.samplers = {"object_id_map", "material_table"}},
               generated) {}

Texture AlbedoPass::run(const std::vector<glm::vec4>& materials, const GBuffer& gbuffer) const {
  const Texture table = table_texture(materials);
  Texture albedo("albedo", TextureFormat::rgba32f, gbuffer.object_id.width_px(),
                 gbuffer.object_id.height_px());
  const RenderTarget target({&albedo}, nullptr);
  program_.use();
  bind_textures({&gbuffer.object_id, &table});
  draw_full_screen();
  return albedo;
}

}  // namespace inkbench
