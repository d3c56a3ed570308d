// Settings to buffers, the paper's whole chain. Asking for a buffer computes what it needs and nothing else;
// what an earlier call computed from the same inputs is used again.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/flow/buffer_names.h"
#include "pipeline/flow/pass_observer.h"
#include "pipeline/flow/stage.h"
#include "pipeline/passes/edges/combine.h"
#include "pipeline/passes/edges/gradient.h"
#include "pipeline/passes/edges/range.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/quantise.h"
#include "pipeline/passes/ink/ink.h"
#include "pipeline/passes/light/shade.h"
#include "pipeline/passes/picture/picture.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// The key of each stage's output for some settings. Stages whose keys are equal need not run again.
struct PassKeys {
  Key meshes;  ///< Of the visible models' meshes.
  Key gbuffer, quantise, gradient, range, combine, shade, blinn_phong, ink;
  Key picture;  ///< Of the program that makes pictures.
};

/// The passes by the names that counts and observers use, in the order of the chain.
constexpr std::array<std::string_view, 9> kPassNames{
    "gbuffer", "quantise", "gradient", "range", "combine", "shade", "ink", "blinn_phong", "picture"};

/// Values of a buffer to show as black and as white, instead of what the display gains make of them.
struct ShownRange {
  float black = 0.0F, white = 1.0F;
  bool operator==(const ShownRange&) const = default;
};

/// A picture on the GPU, rgba8, and the key of all that decided it. Valid until another is asked for with the
/// same buffer's name.
struct PictureTexture {
  const Texture* texture = nullptr;
  Key key;
};

/// GLSL of the uniform blocks and structs, generated from the parameters' descriptions.
GeneratedSources generated_sources();

/// Needs a current OpenGL 4.5 context for its whole life.
class Pipeline {
 public:
  /// Errors (input): a shader does not compile.
  Pipeline();
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  /// The buffer's picture, H x W x 3, with the display gains. Errors (input): the settings' meshes, ramps or
  /// size; (work): what OpenGL reports, with the pass.
  Picture picture(const Settings& settings, BufferName buffer);

  /// The same picture left on the GPU, kept by its key; `range` shows other values than the gains do (not for
  /// object_id). If it cannot be made, the buffer's last one is kept. Errors as `picture`.
  PictureTexture picture_texture(const Settings& settings, BufferName buffer,
                                 const std::optional<ShownRange>& range = std::nullopt);

  /// The buffer's raw values, the ones that the next pass reads: H x W x 3 for normal, shaded, final and
  /// blinn_phong, else H x W x 1. Errors as `picture`.
  Image raw(const Settings& settings, BufferName buffer);

  /// The raw values of a rectangle inside the image; (0, 0) is the top left pixel. Errors as `picture`.
  Image raw_part(const Settings& settings, BufferName buffer, int x, int y, int width_px, int height_px);

  /// The same of one pixel.
  Image pixel(const Settings& settings, BufferName buffer, int x, int y);

  /// What the display gains show as black and as white.
  static ShownRange gain_range(const Settings& settings, BufferName buffer);

  /// Computes the buffer without reading it back.
  void draw(const Settings& settings, BufferName buffer);

  /// Drops every stage's value and its memory, so that the next call runs each pass it needs; meshes and
  /// programs stay.
  void forget_results();

  PassKeys keys(const Settings& settings);

  /// The key of the buffer's raw values. Errors (input): a mesh file cannot be read.
  Key buffer_key(const Settings& settings, BufferName buffer);

  /// The meshes that the G-buffer draws, by model and level.
  MeshStore& meshes() { return meshes_; }

  /// What the G-buffer draws: the visible models with their meshes, which stay until other settings are
  /// drawn. Errors (input): a mesh cannot be read.
  std::vector<DrawItem> draw_items(const Settings& settings);

  /// How often each pass ran and was reused, by the pass's name; "picture" counts those of
  /// `picture_texture`.
  std::map<std::string, StageCount> counts() const;

  /// Tells `observer` (or nobody, for nullptr) of every pass that runs from now on.
  void observe(PassObserver* observer) { observer_ = observer; }

  /// Compiles changed shaders again. Errors (input): the first that fails, which keeps its last good program.
  /// Returns whether any program is another one now.
  bool reload_changed_shaders();

  /// Of the first program whose files do not compile as they are now; empty where all do.
  std::string shader_problem();

 private:
  std::array<Program*, 8> programs();

  struct View {
    const Texture* texture;
    int first_channel, channels;
    PictureView picture;
  };

  /// The stage's value for the key; `make` is the pass, told to the observer when it runs.
  template <class Value, class Make>
  const Value& stage(Stage<Value>& stage, std::string_view name, const Key& key, const Make& make) {
    return stage.get(key, [&] {
      const PassScope scope(observer_, name);
      return make();
    });
  }

  const GBuffer& gbuffer(const Settings& settings, const PassKeys& keys);
  /// The normal map, with the depth map in alpha, that the edge passes read.
  const Texture& maps(const Settings& settings, const PassKeys& keys);
  const Texture& gradient(const Settings& settings, const PassKeys& keys);
  const Texture& range(const Settings& settings, const PassKeys& keys);
  const Texture& combined(const Settings& settings, const PassKeys& keys);
  const Texture& shaded(const Settings& settings, const PassKeys& keys);
  const Texture& blinn_phong(const Settings& settings, const PassKeys& keys);
  const Texture& final(const Settings& settings, const PassKeys& keys);
  View view(const Settings& settings, const PassKeys& keys, BufferName buffer);

  /// First, so that it is destroyed last, after the stages have given their textures back.
  struct PoolGuard {
    ~PoolGuard() { clear_texture_pool(); }
  } pool_guard_;
  GeneratedSources generated_ = generated_sources();
  MeshStore meshes_;
  GBufferPass gbuffer_pass_{generated_};
  QuantisePass quantise_pass_{generated_};
  GradientPass gradient_pass_{generated_};
  RangePass range_pass_{generated_};
  CombinePass combine_pass_{generated_};
  ShadePass shade_pass_{generated_};
  InkPass ink_pass_{generated_};
  PicturePass picture_pass_{generated_};

  Stage<GBuffer> gbuffer_;
  Stage<Texture> quantised_, gradient_, range_, combined_, shaded_, blinn_phong_, final_;
  std::array<Stage<Texture>, kFramebufferCount> pictures_;
  PassObserver* observer_ = nullptr;
};

}  // namespace inkbench
