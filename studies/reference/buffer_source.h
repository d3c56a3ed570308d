// Every buffer by its name: the pipeline's framebuffers, and `reference`, the lines in object space that a
// perfect edge filter would draw. In: settings. Out: pictures, raw values, polylines.
#pragma once

#include <filesystem>
#include <map>

#include "pipeline/pipeline.h"
#include "studies/reference/features.h"
#include "studies/reference/reference_lines.h"
#include "studies/reference/topology.h"

namespace inkbench {

class BufferSource {
 public:
  /// The pipeline must outlive it.
  explicit BufferSource(Pipeline& pipeline) : pipeline_(pipeline) {}

  /// H x W x 3. Errors: as `Pipeline::picture`.
  Picture picture(const Settings& settings, BufferName buffer);

  /// As `Pipeline::raw`; of `reference` H x W x 1: 0 where there is no line, else the place of the first
  /// class that has one there, from 1 on, in `kLineClasses`.
  Image raw(const Settings& settings, BufferName buffer);

  /// The visible reference lines of the scene as it is drawn, its mesh level included; creases and tier 2 are
  /// those of the full mesh. Kept until other settings are asked for.
  const ReferenceLines& reference(const Settings& settings);

  /// Decides what `reference` gives.
  Key reference_key(const Settings& settings);

  Pipeline& pipeline() { return pipeline_; }

 private:
  struct FullMesh {
    Bounds bounds;
    MeshFeatures features;
  };
  struct Part {
    const FullMesh* full;
    const MeshTopology* drawn;
  };
  Part part(const ModelParams& model, const MeshParams& level);
  void free_unused(const Settings& settings);

  Pipeline& pipeline_;
  std::map<Key, FullMesh> full_;
  std::map<Key, MeshTopology> drawn_;
  Stage<ReferenceLines> lines_;
};

/// Writes the buffer as an image file, by the path's ending: `.png` is its picture, `.exr` its raw values,
/// `.svg` the reference's lines. Errors (input): another ending, `.svg` of another buffer; as
/// `Pipeline::picture`; (work): the file cannot be written.
void write_buffer(BufferSource& source, const Settings& settings, BufferName buffer,
                  const std::filesystem::path& path);

}  // namespace inkbench
