#include "studies/reference/buffer_source.h"

#include <set>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/export.h"
#include "studies/reference/drawing.h"

namespace inkbench {
namespace {

/// Features depend on the mesh and on how it is stretched.
Key full_key(MeshStore& meshes, const ModelParams& model) {
  return KeyBuilder().add(meshes.full_identity(model)).add(to_text(Value(model.scale))).key();
}

/// An eight-bit depth step is larger than the visibility test's slack.
Settings exact(Settings settings) {
  settings.image.precision = Precision::float32;
  return settings;
}

}  // namespace

BufferSource::Part BufferSource::part(const ModelParams& model, const MeshParams& level) {
  MeshStore& meshes = pipeline_.meshes();
  const Key full = full_key(meshes, model);
  const Key drawn = meshes.identity(model, level);
  if (!full_.contains(full)) {
    const Mesh mesh = meshes.full_mesh(model);
    MeshTopology topology = make_topology(mesh);
    FeatureParams params;
    for (int axis = 0; axis < 3; ++axis) params.stretch[axis][axis] = model.scale[axis];
    full_.emplace(full, FullMesh{bounds_of(mesh), make_features(topology, params)});
    if (level == MeshParams{})
      drawn_.try_emplace(drawn, std::move(topology));  // the full mesh is what is drawn
  }
  if (!drawn_.contains(drawn)) drawn_.emplace(drawn, make_topology(meshes.drawn_mesh(model, level)));
  return {&full_.at(full), &drawn_.at(drawn)};
}

void BufferSource::free_unused(const Settings& settings) {
  std::set<Key> used;
  for (size_t i = 0; i < settings.models.size(); ++i) {
    if (!settings.models[i].visible) continue;
    used.insert(full_key(pipeline_.meshes(), settings.models[i]));
    used.insert(pipeline_.meshes().identity(settings.models[i], level_of(settings, i)));
  }
  std::erase_if(full_, [&](const auto& entry) { return !used.contains(entry.first); });
  std::erase_if(drawn_, [&](const auto& entry) { return !used.contains(entry.first); });
}

Key BufferSource::reference_key(const Settings& settings) {
  return pipeline_.keys(exact(settings)).gbuffer;
}

const ReferenceLines& BufferSource::reference(const Settings& settings) {
  const Settings exact = inkbench::exact(settings);
  return lines_.get(pipeline_.keys(exact).gbuffer, [&] {
    free_unused(exact);
    std::vector<SceneMesh> scene;
    for (size_t i = 0; i < exact.models.size(); ++i) {
      const ModelParams& model = exact.models[i];
      if (!model.visible) continue;
      const Part part = this->part(model, level_of(exact, i));
      scene.push_back({part.drawn, model_matrix(model, part.full->bounds), static_cast<int>(i) + 1,
                       &part.full->features});
    }
    const Image depth = pipeline_.raw(exact, BufferName::depth);
    return reference_lines(scene, exact.camera, depth, pipeline_.raw(exact, BufferName::object_id));
  });
}

Picture BufferSource::picture(const Settings& settings, BufferName buffer) {
  return buffer == BufferName::reference ? draw_reference(reference(settings))
                                         : pipeline_.picture(settings, buffer);
}

Image BufferSource::raw(const Settings& settings, BufferName buffer) {
  if (buffer != BufferName::reference) return pipeline_.raw(settings, buffer);
  const ReferenceLines& lines = reference(settings);
  Image image(lines.width_px, lines.height_px, 1, 0.0F);
  for (size_t i = kLineClasses.size(); i-- > 0;) {
    const LineMap map = class_map(lines, kLineClasses[i]);
    for (int y = 0; y < image.height_px; ++y) {
      for (int x = 0; x < image.width_px; ++x) {
        if (map.at(x, y)) image.at(x, y) = static_cast<float>(i + 1);
      }
    }
  }
  return image;
}

void write_buffer(BufferSource& source, const Settings& settings, BufferName buffer, const fs::path& path) {
  const std::string format = path.extension().string();
  if (format == ".svg" && buffer == BufferName::reference) {
    write_file_atomically(path, reference_svg(source.reference(settings)));
  } else if (format == ".exr") {
    write_exr(path, source.raw(settings, buffer), export_text(settings, buffer));
  } else if (format == ".png") {
    write_png(path, source.picture(settings, buffer), export_text(settings, buffer));
  } else {
    throw input_error(path.string(), "is no name for an image of " + std::string(name_of(buffer)),
                      "end it in .png or .exr, or .svg for reference");
  }
}

}  // namespace inkbench
