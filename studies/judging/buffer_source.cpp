#include "studies/judging/buffer_source.h"

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/export.h"
#include "pipeline/lines/drawing.h"

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

Key BufferSource::reference_key(const Settings& settings) {
  return pipeline_.keys(exact(settings)).gbuffer;
}

LineRequest BufferSource::line_request(const Settings& settings) {
  const Settings exact = inkbench::exact(settings);
  MeshStore& meshes = pipeline_.meshes();
  LineRequest request{.key = reference_key(settings), .camera = exact.camera};
  request.depth = pipeline_.raw(exact, BufferName::depth);
  request.object_id = pipeline_.raw(exact, BufferName::object_id);
  for (size_t i = 0; i < exact.models.size(); ++i) {
    const ModelParams& model = exact.models[i];
    if (!model.visible) continue;
    const MeshParams level = level_of(exact, i);
    const bool is_full = level == MeshParams{};
    std::shared_ptr<const Mesh> drawn = meshes.drawn_mesh(model, level);
    request.models.push_back({.params = model,
                              .object_id = static_cast<int>(i) + 1,
                              .full = is_full ? drawn : meshes.full_mesh(model),
                              .drawn = drawn,
                              .full_key = full_key(meshes, model),
                              .drawn_key = meshes.identity(model, level)});
  }
  return request;
}

const ReferenceLines& BufferSource::reference(const Settings& settings) {
  return lines_.get(reference_key(settings), [&] { return finder_->find(line_request(settings)); });
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
