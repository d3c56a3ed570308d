// Every buffer by its name: the pipeline's framebuffers, and `reference`, the lines in object space that a
// perfect edge filter would draw. In: settings. Out: pictures, raw values, polylines.
#pragma once

#include <filesystem>
#include <memory>
#include <utility>

#include "pipeline/lines/line_finder.h"
#include "pipeline/pipeline.h"

namespace inkbench {

class BufferSource {
 public:
  /// The pipeline must outlive it. A finder that another source uses too keeps what both need once.
  explicit BufferSource(Pipeline& pipeline,
                        std::shared_ptr<LineFinder> finder = std::make_shared<LineFinder>())
      : pipeline_(pipeline), finder_(std::move(finder)) {}

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

  /// What `reference` finds its lines from, for finding them on another thread. Errors: as `Pipeline::raw`.
  LineRequest line_request(const Settings& settings);

  /// What `reference` finds its lines with.
  const std::shared_ptr<LineFinder>& finder() const { return finder_; }

  Pipeline& pipeline() { return pipeline_; }

 private:
  Pipeline& pipeline_;
  std::shared_ptr<LineFinder> finder_;
  Stage<ReferenceLines> lines_;
};

/// Writes the buffer as an image file, by the path's ending: `.png` is its picture, `.exr` its raw values,
/// `.svg` the reference's lines. Errors (input): another ending, `.svg` of another buffer; as
/// `Pipeline::picture`; (work): the file cannot be written.
void write_buffer(BufferSource& source, const Settings& settings, BufferName buffer,
                  const std::filesystem::path& path);

}  // namespace inkbench
