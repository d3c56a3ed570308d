#include "pipeline/pipeline.h"

#include <fmt/format.h>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/gl/context.h"
#include "pipeline/params/glsl_block.h"

namespace inkbench {
namespace {

/// The canonical text of a described struct: what a key folds of it.
std::string group_text(const Description& description, const void* owner) {
  std::string text;
  for (const Field& field : description.fields)
    text += fmt::format("{} = {}\n", field.name, to_text(field.get(owner)));
  return text;
}

template <class Params>
std::string group_text(const Params& params) {
  return group_text(Params::description(), &params);
}

std::string ramp_content(const Ramp& ramp) {
  return ramp.image.empty() ? "" : read_file(ramp.image);
}

ShadeParams shade_params(const Settings& settings) {
  ShadeParams params{settings.camera, settings.scene, settings.lights, {}, settings.ramp};
  for (const ModelParams& model : settings.models) params.materials.push_back(model.material);
  return params;
}

Key shade_key(const ShadeParams& params, const Key& gbuffer, const Key& program) {
  KeyBuilder builder;
  builder.add("shade").add(program).add(gbuffer).add(group_text(params.scene));
  for (const LightParams& light : params.lights) builder.add(group_text(light));
  for (const MaterialParams& material : params.materials) builder.add(group_text(material));
  builder.add(params.ramp.enabled ? group_text(params.ramp) : "no ramps");
  if (params.ramp.enabled)
    builder.add(ramp_content(params.ramp.diffuse)).add(ramp_content(params.ramp.specular));
  return builder.key();
}

}  // namespace

GeneratedSources generated_sources() {
  return {
      {"generated/combine.glsl", glsl_uniform_block(CombineParams::description(), "combine")},
      {"generated/ink.glsl", glsl_uniform_block(InkParams::description(), "ink")},
      {"generated/light.glsl", glsl_choices(LightParams::description(), "light") +
                                   glsl_struct(LightParams::description(), "Light") +
                                   fmt::format("const int max_lights = {};\n", kMaxLights)},
      {"generated/material.glsl", glsl_struct(MaterialParams::description(), "Material") +
                                      fmt::format("const int max_models = {};\n", kMaxModels)},
  };
}

Pipeline::Pipeline() {
  throw_gl_errors("making the programs");
}

PassKeys Pipeline::keys(const Settings& settings) {
  PassKeys keys;
  const std::string size = fmt::format("{} x {}", settings.image.width, settings.image.height);
  const std::string_view precision =
      ChoiceNames<Precision>::names[static_cast<size_t>(settings.image.precision)];
  KeyBuilder meshes;
  KeyBuilder gbuffer;
  gbuffer.add("gbuffer").add(gbuffer_pass_.program().key()).add(size).add(group_text(settings.camera));
  for (size_t i = 0; i < settings.models.size(); ++i) {
    const ModelParams& model = settings.models[i];
    gbuffer.add(group_text(model));
    if (model.visible) meshes.add(meshes_.identity(model, level_of(settings, i)));
  }
  keys.meshes = meshes.key();
  keys.gbuffer = gbuffer.add(keys.meshes).key();
  keys.picture = picture_pass_.program().key();
  keys.quantise = KeyBuilder().add("quantise").add(quantise_pass_.program().key()).add(keys.gbuffer).key();
  const bool is_float = settings.image.precision == Precision::float32;
  keys.gradient = KeyBuilder()
                      .add("gradient")
                      .add(gradient_pass_.program().key())
                      .add(is_float ? keys.gbuffer : keys.quantise)
                      .add(precision)
                      .key();
  keys.range = KeyBuilder().add("range").add(range_pass_.program().key()).add(keys.gradient).key();
  keys.combine = KeyBuilder()
                     .add("combine")
                     .add(combine_pass_.program().key())
                     .add(keys.range)
                     .add(precision)
                     .add(group_text(settings.combine))
                     .key();
  ShadeParams shade = shade_params(settings);
  keys.shade = shade_key(shade, keys.gbuffer, shade_pass_.program().key());
  shade.ramp.enabled = false;
  keys.blinn_phong = shade_key(shade, keys.gbuffer, shade_pass_.program().key());
  keys.ink = KeyBuilder()
                 .add("ink")
                 .add(ink_pass_.program().key())
                 .add(keys.shade)
                 .add(keys.combine)
                 .add(group_text(settings.ink))
                 .key();
  return keys;
}

std::vector<DrawItem> Pipeline::draw_items(const Settings& settings) {
  std::vector<DrawItem> items;
  std::vector<Key> used;
  for (size_t i = 0; i < settings.models.size(); ++i) {
    if (settings.models[i].visible)
      used.push_back(meshes_.identity(settings.models[i], level_of(settings, i)));
  }
  meshes_.keep_only(used);
  for (size_t i = 0; i < settings.models.size(); ++i) {
    const ModelParams& model = settings.models[i];
    if (!model.visible) continue;
    const GpuMesh& mesh = meshes_.get(model, level_of(settings, i));
    items.push_back({&mesh, model_matrix(model, mesh.placement()), static_cast<int>(i) + 1});
  }
  return items;
}

const GBuffer& Pipeline::gbuffer(const Settings& settings, const PassKeys& keys) {
  return gbuffer_.get(keys.gbuffer, [&] {
    check_settings(settings);
    return gbuffer_pass_.run(settings.camera, draw_items(settings), settings.image.width,
                             settings.image.height);
  });
}

const Texture& Pipeline::maps(const Settings& settings, const PassKeys& keys) {
  const Texture& exact = gbuffer(settings, keys).normal_and_depth;
  if (settings.image.precision == Precision::float32) return exact;
  return quantised_.get(keys.quantise, [&] { return quantise_pass_.run(exact); });
}

const Texture& Pipeline::gradient(const Settings& settings, const PassKeys& keys) {
  const Texture& normal_and_depth = maps(settings, keys);
  return gradient_.get(keys.gradient,
                       [&] { return gradient_pass_.run(normal_and_depth, settings.image.precision); });
}

const Texture& Pipeline::range(const Settings& settings, const PassKeys& keys) {
  const Texture& g = gradient(settings, keys);
  return range_.get(keys.range, [&] { return range_pass_.run(g); });
}

const Texture& Pipeline::combined(const Settings& settings, const PassKeys& keys) {
  const Texture& r = range(settings, keys);
  return combined_.get(keys.combine,
                       [&] { return combine_pass_.run(settings.combine, r, settings.image.precision); });
}

const Texture& Pipeline::shaded(const Settings& settings, const PassKeys& keys) {
  const GBuffer& g = gbuffer(settings, keys);
  return shaded_.get(keys.shade, [&] { return shade_pass_.run(shade_params(settings), g); });
}

const Texture& Pipeline::blinn_phong(const Settings& settings, const PassKeys& keys) {
  const GBuffer& g = gbuffer(settings, keys);
  return blinn_phong_.get(keys.blinn_phong, [&] {
    ShadeParams plain = shade_params(settings);
    plain.ramp.enabled = false;
    return shade_pass_.run(plain, g);
  });
}

const Texture& Pipeline::final(const Settings& settings, const PassKeys& keys) {
  const Texture& light = shaded(settings, keys);
  const Texture& edges = combined(settings, keys);
  return final_.get(keys.ink, [&] { return ink_pass_.run(settings.ink, light, edges); });
}

Pipeline::View Pipeline::view(const Settings& settings, BufferName buffer) {
  const PassKeys k = keys(settings);
  const DisplayParams& display = settings.display;
  constexpr int kColour = PictureView::kColour;
  switch (buffer) {
    case BufferName::normal:
      return {&maps(settings, k), 0, 3, {1.0F, kColour}};
    case BufferName::depth:
      return {&maps(settings, k), 3, 1, {display.depth_gain, 3}};
    case BufferName::normal_edges:
      return {&gradient(settings, k), 1, 1, {display.normal_edges_gain, 1}};
    case BufferName::depth_edges:
      return {&gradient(settings, k), 0, 1, {display.depth_edges_gain, 0}};
    case BufferName::combined_edges:
      return {&combined(settings, k), 0, 1, {1.0F, 0}};
    case BufferName::shaded:
      return {&shaded(settings, k), 0, 3, {1.0F, kColour}};
    case BufferName::final:
      return {&final(settings, k), 0, 3, {1.0F, kColour}};
    case BufferName::blinn_phong:
      return {&blinn_phong(settings, k), 0, 3, {1.0F, kColour}};
    case BufferName::reference:
      throw work_error("reference", "is made from the meshes and not by the pipeline");
    case BufferName::object_id:
      return {&gbuffer(settings, k).object_id, 0, 1, {1.0F, PictureView::kObjectId}};
  }
  return {};
}

void Pipeline::draw(const Settings& settings, BufferName buffer) {
  view(settings, buffer);
  throw_gl_errors(std::string(name_of(buffer)));
}

Picture Pipeline::picture(const Settings& settings, BufferName buffer) {
  const View shown = view(settings, buffer);
  Picture picture = picture_pass_.run(shown.picture, *shown.texture).read_picture();
  throw_gl_errors(std::string(name_of(buffer)));
  return picture;
}

Image Pipeline::raw(const Settings& settings, BufferName buffer) {
  const View shown = view(settings, buffer);
  Image image = shown.texture->read(shown.first_channel, shown.channels);
  throw_gl_errors(std::string(name_of(buffer)));
  return image;
}

void Pipeline::forget_results() {
  gbuffer_.forget();
  for (Stage<Texture>* stage :
       {&quantised_, &gradient_, &range_, &combined_, &shaded_, &blinn_phong_, &final_})
    stage->forget();
  clear_texture_pool();
}

std::map<std::string, StageCount> Pipeline::counts() const {
  return {{"gbuffer", gbuffer_.count()},   {"quantise", quantised_.count()},
          {"gradient", gradient_.count()}, {"range", range_.count()},
          {"combine", combined_.count()},  {"shade", shaded_.count()},
          {"ink", final_.count()},         {"blinn_phong", blinn_phong_.count()}};
}

void Pipeline::reload_changed_shaders() {
  for (Program* program : {&gbuffer_pass_.program(), &quantise_pass_.program(), &gradient_pass_.program(),
                           &range_pass_.program(), &combine_pass_.program(), &shade_pass_.program(),
                           &ink_pass_.program(), &picture_pass_.program()}) {
    program->reload_if_changed(generated_);
  }
}

}  // namespace inkbench
