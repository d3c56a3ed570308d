#include "pipeline/pipeline.h"

#include <fmt/format.h>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/gl/context.h"
#include "pipeline/mesh/levels/model_mesh.h"
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

/// Of the maps that the edge passes read.
const Key& maps_key(const Settings& settings, const PassKeys& keys) {
  return settings.image.precision == Precision::float32 ? keys.gbuffer : keys.quantise;
}

const Key& key_of(const Settings& settings, const PassKeys& keys, BufferName buffer) {
  switch (buffer) {
    case BufferName::normal:
    case BufferName::depth:
      return maps_key(settings, keys);
    case BufferName::normal_edges:
    case BufferName::depth_edges:
      return keys.gradient;
    case BufferName::combined_edges:
      return keys.combine;
    case BufferName::shaded:
      return keys.shade;
    case BufferName::final:
      return keys.ink;
    case BufferName::blinn_phong:
      return keys.blinn_phong;
    case BufferName::object_id:
    case BufferName::reference:
      break;  // the lines are found for what the G-buffer shows
  }
  return keys.gbuffer;
}

float gain_of(const DisplayParams& display, BufferName buffer) {
  switch (buffer) {
    case BufferName::depth:
      return display.depth_gain;
    case BufferName::normal_edges:
      return display.normal_edges_gain;
    case BufferName::depth_edges:
      return display.depth_edges_gain;
    default:
      return 1.0F;
  }
}

/// The gain and offset that show the range, if one is wanted.
PictureView with_range(PictureView view, const std::optional<ShownRange>& range) {
  if (!range || view.channel == PictureView::kObjectId) return view;
  const float width = range->white - range->black;
  view.low = range->black;
  view.gain = width > 0.0F ? 1.0F / width : 1.0F;
  return view;
}

Key picture_key(const PictureView& view, const Key& buffer, const Key& program) {
  return KeyBuilder()
      .add("picture")
      .add(program)
      .add(buffer)
      .add(fmt::format("{} {} {}", view.channel, view.gain, view.low))
      .key();
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
  keys.gradient = KeyBuilder()
                      .add("gradient")
                      .add(gradient_pass_.program().key())
                      .add(maps_key(settings, keys))
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
  return stage(gbuffer_, "gbuffer", keys.gbuffer, [&] {
    check_settings(settings);
    return gbuffer_pass_.run(settings.camera, draw_items(settings), settings.image.width,
                             settings.image.height);
  });
}

const Texture& Pipeline::maps(const Settings& settings, const PassKeys& keys) {
  const Texture& exact = gbuffer(settings, keys).normal_and_depth;
  if (settings.image.precision == Precision::float32) return exact;
  return stage(quantised_, "quantise", keys.quantise, [&] { return quantise_pass_.run(exact); });
}

const Texture& Pipeline::gradient(const Settings& settings, const PassKeys& keys) {
  const Texture& normal_and_depth = maps(settings, keys);
  return stage(gradient_, "gradient", keys.gradient,
               [&] { return gradient_pass_.run(normal_and_depth, settings.image.precision); });
}

const Texture& Pipeline::range(const Settings& settings, const PassKeys& keys) {
  const Texture& g = gradient(settings, keys);
  return stage(range_, "range", keys.range, [&] { return range_pass_.run(g); });
}

const Texture& Pipeline::combined(const Settings& settings, const PassKeys& keys) {
  const Texture& r = range(settings, keys);
  return stage(combined_, "combine", keys.combine,
               [&] { return combine_pass_.run(settings.combine, r, settings.image.precision); });
}

const Texture& Pipeline::shaded(const Settings& settings, const PassKeys& keys) {
  const GBuffer& g = gbuffer(settings, keys);
  return stage(shaded_, "shade", keys.shade, [&] { return shade_pass_.run(shade_params(settings), g); });
}

const Texture& Pipeline::blinn_phong(const Settings& settings, const PassKeys& keys) {
  const GBuffer& g = gbuffer(settings, keys);
  return stage(blinn_phong_, "blinn_phong", keys.blinn_phong, [&] {
    ShadeParams plain = shade_params(settings);
    plain.ramp.enabled = false;
    return shade_pass_.run(plain, g);
  });
}

const Texture& Pipeline::final(const Settings& settings, const PassKeys& keys) {
  const Texture& light = shaded(settings, keys);
  const Texture& edges = combined(settings, keys);
  return stage(final_, "ink", keys.ink, [&] { return ink_pass_.run(settings.ink, light, edges); });
}

Pipeline::View Pipeline::view(const Settings& settings, const PassKeys& k, BufferName buffer) {
  const float gain = gain_of(settings.display, buffer);
  constexpr int kColour = PictureView::kColour;
  switch (buffer) {
    case BufferName::normal:
      return {&maps(settings, k), 0, 3, {1.0F, kColour}};
    case BufferName::depth:
      return {&maps(settings, k), 3, 1, {gain, 3}};
    case BufferName::normal_edges:
      return {&gradient(settings, k), 1, 1, {gain, 1}};
    case BufferName::depth_edges:
      return {&gradient(settings, k), 0, 1, {gain, 0}};
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

Key Pipeline::buffer_key(const Settings& settings, BufferName buffer) {
  return key_of(settings, keys(settings), buffer);
}

void Pipeline::draw(const Settings& settings, BufferName buffer) {
  view(settings, keys(settings), buffer);
  throw_gl_errors(std::string(name_of(buffer)));
}

Picture Pipeline::picture(const Settings& settings, BufferName buffer) {
  const View shown = view(settings, keys(settings), buffer);
  Picture picture = picture_pass_.run(shown.picture, *shown.texture).read_picture();
  throw_gl_errors(std::string(name_of(buffer)));
  return picture;
}

PictureTexture Pipeline::picture_texture(const Settings& settings, BufferName buffer,
                                         const std::optional<ShownRange>& range) {
  const PassKeys k = keys(settings);
  const View shown = view(settings, k, buffer);
  const PictureView with = with_range(shown.picture, range);
  const Key key = picture_key(with, key_of(settings, k, buffer), k.picture);
  const Texture& texture = stage(pictures_[static_cast<size_t>(buffer)], "picture", key,
                                 [&] { return picture_pass_.run(with, *shown.texture); });
  throw_gl_errors(std::string(name_of(buffer)));
  return {&texture, key};
}

Image Pipeline::raw(const Settings& settings, BufferName buffer) {
  const View shown = view(settings, keys(settings), buffer);
  Image image = shown.texture->read(shown.first_channel, shown.channels);
  throw_gl_errors(std::string(name_of(buffer)));
  return image;
}

Image Pipeline::raw_part(const Settings& settings, BufferName buffer, int x, int y, int width_px,
                         int height_px) {
  const View shown = view(settings, keys(settings), buffer);
  Image image = shown.texture->read_part(x, y, width_px, height_px, shown.first_channel, shown.channels);
  throw_gl_errors(std::string(name_of(buffer)));
  return image;
}

Image Pipeline::pixel(const Settings& settings, BufferName buffer, int x, int y) {
  return raw_part(settings, buffer, x, y, 1, 1);
}

ShownRange Pipeline::gain_range(const Settings& settings, BufferName buffer) {
  return {0.0F, 1.0F / gain_of(settings.display, buffer)};
}

void Pipeline::forget_results() {
  gbuffer_.forget();
  for (Stage<Texture>* stage :
       {&quantised_, &gradient_, &range_, &combined_, &shaded_, &blinn_phong_, &final_})
    stage->forget();
  for (Stage<Texture>& picture : pictures_) picture.forget();
  clear_texture_pool();
}

std::map<std::string, StageCount> Pipeline::counts() const {
  StageCount pictures;
  for (const Stage<Texture>& picture : pictures_) {
    pictures.runs += picture.count().runs;
    pictures.reuses += picture.count().reuses;
  }
  return {
      {"gbuffer", gbuffer_.count()}, {"quantise", quantised_.count()},      {"gradient", gradient_.count()},
      {"range", range_.count()},     {"combine", combined_.count()},        {"shade", shaded_.count()},
      {"ink", final_.count()},       {"blinn_phong", blinn_phong_.count()}, {"picture", pictures}};
}

std::array<Program*, 8> Pipeline::programs() {
  return {&gbuffer_pass_.program(), &quantise_pass_.program(), &gradient_pass_.program(),
          &range_pass_.program(),   &combine_pass_.program(),  &shade_pass_.program(),
          &ink_pass_.program(),     &picture_pass_.program()};
}

bool Pipeline::reload_changed_shaders() {
  bool any = false;
  for (Program* program : programs()) any |= program->reload_if_changed(generated_);
  return any;
}

std::string Pipeline::shader_problem() {
  for (const Program* program : programs()) {
    if (!program->problem().empty()) return program->problem();
  }
  return "";
}

}  // namespace inkbench
