// SPDX-License-Identifier: MIT
// Settings to buffers. `pipeline.at(settings)` is a frame: asking it for a buffer computes what that needs
// and nothing else; what an earlier frame computed from the same inputs is used again.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/buffers.h"
#include "pipeline/flow/flow.h"
#include "pipeline/flow/stage.h"
#include "pipeline/gl/texture_pool.h"
#include "pipeline/lines/line_finder.h"
#include "pipeline/passes/gbuffer/draw_item.h"
#include "pipeline/passes/picture/picture.h"
#include "pipeline/settings/settings.h"
#include "pipeline/used_files.h"

namespace inkbench {

class BoxFilterPass;
class Pipeline;
class Supersampler;

/// Values of a buffer to show as black and as white, instead of what the display gains make of them.
struct ShownRange {
  float black = 0.0F, white = 1.0F;
  bool operator==(const ShownRange&) const = default;
};

/// What the display gains show as black and as white.
ShownRange gain_range(const DisplayParams& display, BufferName buffer);

/// A picture on the GPU, rgba8, and the key of all that decided it. Valid until another is asked for with the
/// same buffer's name.
struct PictureTexture {
  const Texture* texture = nullptr;
  Key key;
};

/// One image of some settings, whose keys it has worked out. The pipeline must outlive it. Errors of all that
/// draws: (input) the settings' meshes, ramps or size; (work) what OpenGL reports, with the buffer.
class Frame {
 public:
  const Settings& settings() const { return state_->settings; }

  /// The buffer's picture, H x W x 3, with the display gains; by `image.supersample` where it follows that.
  Picture picture(BufferName buffer) const;

  /// The same picture left on the GPU, kept by its key; `range` shows other values than the gains do, where
  /// the buffer has one (`has_range`). Not for drawings. If it cannot be made, the buffer's last one is kept.
  PictureTexture picture_texture(BufferName buffer,
                                 const std::optional<ShownRange>& range = std::nullopt) const;

  /// The buffer's raw values, the ones that the next pass reads: H x W x `channels` of its description.
  Image raw(BufferName buffer) const;

  /// The raw values of a rectangle inside the image; (0, 0) is the top left pixel. Not for drawings.
  Image raw_part(BufferName buffer, int x, int y, int width_px, int height_px) const;

  /// The same of one pixel.
  Image pixel(BufferName buffer, int x, int y) const;

  /// Computes the buffer without reading it back.
  void draw(BufferName buffer) const;

  /// A pass's value, which stays as long as it is held: `frame.value<ReferencePass>()`.
  template <class Tag>
  std::shared_ptr<const typename Tag::Value> value() const;

  /// What the G-buffer draws: the visible models with their meshes, which stay until other settings are
  /// drawn.
  std::vector<DrawItem> draw_items() const;

  /// What the reference lines are found from, for finding them on another thread; its key is theirs.
  LineRequest line_request() const;

  /// The files that its images are made from. Errors (input): one cannot be read.
  std::vector<UsedFile> used_files() const;

  /// Decides the buffer's raw values.
  Key key(BufferName buffer) const;
  /// Decides its picture.
  Key picture_key(BufferName buffer) const;
  /// Decides the pass's value.
  template <class Tag>
  Key key_of() const;
  /// Of every pass, in the order of `Pipeline::pass_names`.
  const std::vector<Key>& pass_keys() const { return state_->keys; }
  /// The same frame, which no longer holds the one before it: for taking as a past in turn, without an end.
  /// What its passes made of their past is there as long as a node holds it; after that it is made without.
  Frame without_past() const;

  /// Decides every buffer's picture.
  Key key() const;
  /// What drawing this frame costs after the other one, by the passes whose keys differ; only the order
  /// matters.
  int cost_after(const Frame& other) const;

 private:
  friend class Pipeline;
  friend class Supersampler;
  Frame(Pipeline& pipeline, std::shared_ptr<const FrameState> state)
      : pipeline_(&pipeline), state_(std::move(state)) {}
  Shown show(BufferName buffer) const;
  template <class Tag>
  GivenValue enlarged_value() const;
  std::vector<GivenValue> enlarged_strokes(BufferName buffer) const;
  Texture supersampled(BufferName buffer, const PictureView& view) const;
  Key picture_key_of(BufferName buffer, const PictureView& view) const;

  Pipeline* pipeline_;
  std::shared_ptr<const FrameState> state_;
};

/// Needs a current OpenGL 4.5 context for its whole life.
class Pipeline {
 public:
  /// Errors (input): a shader does not compile.
  Pipeline();
  /// Another one's lines are found by the same finder, which keeps what both need once.
  explicit Pipeline(std::shared_ptr<LineFinder> finder);
  /// The same with another one's meshes, too.
  Pipeline(std::shared_ptr<LineFinder> finder, std::shared_ptr<MeshStore> meshes);
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;
  ~Pipeline();

  /// The frame of the settings. Errors (input): a file that decides it cannot be read.
  Frame at(const Settings& settings);
  /// The same with a past: passes that look back see the previous frame's values. A frame holds those before
  /// it for as long as it lives.
  Frame at(const Settings& settings, const Frame& previous);
  /// A part of the settings' image, as passes draw it; its buffers have the part's size. Passes whose values
  /// are given do not run.
  Frame at(const Settings& settings, const ImageWindow& part, std::vector<GivenValue> given = {});

  /// Errors (work): frames of that size need more memory than there is, beyond what one drawn before has
  /// taken; with what decides the size and what to do instead. Graphics cards have memory of their own, which
  /// is not asked about.
  void check_room(const ImageParams& image, const std::string& where = "image.width, image.height",
                  const std::string& instead = "choose a smaller image");

  /// The most px a side that are drawn at once for a supersampled picture, as far as that can be.
  void set_tile_px(int px) { tile_px_ = px; }

  /// Keeps what the last `count` different frames' passes made, so that taking turns between so many views
  /// draws nothing again that only a view decides. Takes the memory of so many frames.
  void keep_frames(size_t count);

  /// Drops every pass's value and its memory, so that the next frame runs each pass it needs; meshes and
  /// programs stay, and so does what other pipelines left in the context's pool.
  void forget_results();

  /// The meshes that the G-buffer draws, by model and level.
  MeshStore& meshes() { return flow_.shared<MeshStore>(); }
  /// What finds the reference lines.
  std::shared_ptr<LineFinder> line_finder() { return flow_.sharing<LineFinder>(); }

  /// The passes by name, in the order of the chain; last "picture", which makes pictures of buffers.
  std::vector<std::string> pass_names() const;
  /// How often each ran and was reused; "picture" counts those of `picture_texture`.
  std::map<std::string, StageCount> counts() const;

  /// Tells `observer` (or nobody, for nullptr) of every pass that runs from now on.
  void observe(PassObserver* observer) { flow_.observe(observer); }

  /// Compiles changed shaders again. Errors (input): the first that fails, which keeps its last good program.
  /// Returns whether any program is another one now.
  bool reload_changed_shaders();

  /// Of the first program whose files do not compile as they are now; empty where all do.
  std::string shader_problem();

 private:
  friend class Frame;
  Frame make_frame(std::shared_ptr<FrameState> state);
  Supersampler& supersampler();
  std::vector<Program*> programs();
  PicturePass& picture_pass() { return flow_.shared<PicturePass>(); }
  BoxFilterPass& box_filter();

  PoolUser pool_user_;  ///< First, so that it ends last, after the nodes have given their textures back.
  Flow flow_;
  PerBuffer<Stage<Texture>> pictures_;
  double drawn_px_ = 0;                         ///< Of the largest frame for which there was room.
  std::unique_ptr<Supersampler> supersampler_;  ///< Made when it is first needed.
  int tile_px_ = 2048;
};

template <class Tag>
std::shared_ptr<const typename Tag::Value> Frame::value() const {
  const PoolUser::Scope scope(pipeline_->pool_user_);
  return pipeline_->flow_.template node<Tag>().get(*state_);
}

template <class Tag>
Key Frame::key_of() const {
  return state_->keys[pipeline_->flow_.template node<Tag>().index()];
}

}  // namespace inkbench
