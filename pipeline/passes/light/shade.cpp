// SPDX-License-Identifier: MIT
#include "pipeline/passes/light/shade.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/params/glsl_block.h"

namespace inkbench {
namespace {

constexpr BufferInfo kShaded{.name = "shaded",
                             .help = "Light through the ramps, without ink.",
                             .number_key = 6,
                             .channels = 3,
                             .shown_as = ShownAs::colour,
                             .is_supersampled = true};
constexpr BufferInfo kBlinnPhong{.name = "blinn_phong",
                                 .help = "Plain Blinn-Phong light, whatever the ramps.",
                                 .number_key = 8,
                                 .channels = 3,
                                 .shown_as = ShownAs::colour,
                                 .is_supersampled = true};

/// All that light depends on besides the G-buffer.
struct ShadeInput {
  bool with_ramps = true;

  ShadeInput bind(Flow&) const { return *this; }
  std::vector<PassInput> told() const {
    std::vector<PassInput> groups{{SceneParams::description().group},
                                  {LightParams::description().group},
                                  {MaterialParams::description().group}};
    if (with_ramps) groups.push_back({RampParams::description().group});
    return groups;
  }
  ShadeParams get(const FrameState& frame) const {
    const Settings& settings = frame.settings;
    ShadeParams params{settings.camera, settings.scene, settings.lights, {}, settings.ramp, frame.window};
    for (const ModelParams& model : settings.models) params.materials.push_back(model.material);
    params.ramp.enabled = params.ramp.enabled && with_ramps;
    return params;
  }
  /// Camera and window are in the G-buffer's key.
  void fold(KeyBuilder& key, const FrameState& frame) const {
    const Settings& settings = frame.settings;
    key.add(group_text(settings.scene));
    for (const LightParams& light : settings.lights) key.add(group_text(light));
    for (const ModelParams& model : settings.models) key.add(group_text(model.material));
    if (!with_ramps || !settings.ramp.enabled) return;
    key.add(group_text(settings.ramp));
    for (const Ramp& ramp : {settings.ramp.diffuse, settings.ramp.specular})
      key.add(ramp.image.empty() ? "" : read_file(ramp.image, kMostImageBytes));
  }
};

/// view_block of shaders/shade.frag in std140.
struct ViewBlock {
  glm::vec3 eye;
  float far;
  alignas(16) glm::vec3 eye_right;
  alignas(16) glm::vec3 eye_up;
  alignas(16) glm::vec3 ray_corner;
  alignas(16) glm::vec3 ray_right;
  alignas(16) glm::vec3 ray_up;
  alignas(16) glm::vec3 ambient;
  alignas(16) glm::vec3 background;
  int use_ramps;
  int light_count;
  int first_material;
  glm::vec2 corner_px;
  glm::vec2 whole_size_px;
};

ViewBlock make_view_block(const ShadeParams& params) {
  const ViewRays rays = view_rays(params.camera, params.window.whole_aspect());
  ViewBlock block{};
  block.eye = rays.eye;
  block.far = params.camera.far;
  block.eye_right = rays.eye_right;
  block.eye_up = rays.eye_up;
  block.ray_corner = rays.ray;
  block.ray_right = rays.ray_right;
  block.ray_up = rays.ray_up;
  block.ambient = params.scene.ambient;
  block.background = params.scene.background;
  block.use_ramps = params.ramp.enabled ? 1 : 0;
  block.corner_px = params.window.corner_px();
  block.whole_size_px = params.window.whole_size_px();
  block.light_count = static_cast<int>(params.lights.size());
  return block;
}

template <class Item>
size_t list_bytes(int capacity) {
  return std140_size(Item::description()) * static_cast<size_t>(capacity);
}

/// A uniform buffer of `capacity` packed structs, the first ones from `items`, which are no more than that.
template <class Item>
Buffer make_list(const std::string& label, std::span<const Item> items, int capacity) {
  const size_t stride = std140_size(Item::description());
  std::vector<uint8_t> bytes(list_bytes<Item>(capacity));
  for (size_t i = 0; i < items.size(); ++i) {
    const std::vector<uint8_t> packed = pack_std140(Item::description(), &items[i]);
    std::copy(packed.begin(), packed.end(), bytes.begin() + static_cast<std::ptrdiff_t>(i * stride));
  }
  return {label, bytes};
}

Texture make_ramp_texture(const RampParams& ramp) {
  Image table(kRampTexels, 2, 4, 1.0F);
  const auto fill = [&](int row, const std::vector<glm::vec3>& colours) {
    for (int x = 0; x < kRampTexels; ++x) {
      for (int c = 0; c < 3; ++c) table.at(x, row, c) = colours[x][c];
    }
  };
  // Images have row 0 on top and textures at the bottom, so the diffuse ramp, texture row 0, is the lower
  // one.
  if (ramp.enabled) fill(1, ramp_table(ramp.diffuse));
  if (ramp.enabled) fill(0, ramp_table(ramp.specular));
  Texture texture("ramps", TextureFormat::rgba32f, kRampTexels, 2);
  texture.upload(table);
  return texture;
}

}  // namespace

constinit const BufferName BufferName::shaded{kShaded};
constinit const BufferName BufferName::blinn_phong{kBlinnPhong};

const PassKind& ShadePass::kind() {
  static const PassKind kKind = describe_pass<ShadePass>(
      "shade", 8, {shows(BufferName::shaded)}, ShadeInput{.with_ramps = true}, value_of<GBufferPass>());
  return kKind;
}

const PassKind& BlinnPhong::kind() {
  static const PassKind kKind =
      describe_pass<BlinnPhong>("blinn_phong", 8, {shows(BufferName::blinn_phong)},
                                ShadeInput{.with_ramps = false}, value_of<GBufferPass>());
  return kKind;
}

ShadePass::ShadePass(const GeneratedSources& generated)
    : program_("full_screen.vert", "shade.frag",
               {.samplers = {"normal_and_depth_map", "object_id_map", "ramp_table"},
                .uniform_blocks = {{"view_block", sizeof(ViewBlock)},
                                   {"light_list", list_bytes<LightParams>(kMaxLights)},
                                   {"material_list", list_bytes<MaterialParams>(kMaterialsAtOnce)}}},
               generated) {}

Texture ShadePass::run(const ShadeParams& params, const GBuffer& gbuffer) const {
  if (params.lights.size() > kMaxLights) {
    throw input_error("scene", fmt::format("has {} lights", params.lights.size()),
                      fmt::format("at most {}", kMaxLights));
  }
  const int width_px = gbuffer.object_id.width_px();
  const int height_px = gbuffer.object_id.height_px();
  Texture shaded("shaded", TextureFormat::rgba32f, width_px, height_px);
  ViewBlock block = make_view_block(params);
  const Buffer lights = make_list("lights", std::span(params.lights), kMaxLights);
  const Texture ramps = make_ramp_texture(params.ramp);
  const RenderTarget target({&shaded}, nullptr);
  program_.use();
  bind_textures({&gbuffer.normal_and_depth, &gbuffer.object_id, &ramps});
  // Each go draws the pixels of its own materials, the first one also the background.
  std::span<const MaterialParams> left(params.materials);
  do {
    const auto now = left.first(std::min<size_t>(left.size(), kMaterialsAtOnce));
    const Buffer view = uniform_buffer("view block", block);
    const Buffer materials = make_list("materials", now, kMaterialsAtOnce);
    bind_uniform_blocks({&view, &lights, &materials});
    draw_full_screen();
    left = left.subspan(now.size());
    block.first_material += kMaterialsAtOnce;
  } while (!left.empty());
  return shaded;
}

}  // namespace inkbench
