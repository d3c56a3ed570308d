// SPDX-License-Identifier: MIT
#include "pipeline/passes/lines/reference.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/lines/drawing.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/meshes.h"

namespace inkbench {
namespace {

constexpr BufferInfo kReference{
    .name = "reference",
    .help = "The lines of the meshes themselves, by class: what a perfect filter would draw.",
    .number_key = 0,
    .shown_as = ShownAs::drawing,
    .as_lines = ReadAsLines::classes};

/// Features depend on the mesh, on how it is stretched and on what counts as one.
Key full_key(MeshStore& meshes, const ModelParams& model, const JudgeParams& judge) {
  return KeyBuilder()
      .add(meshes.full_identity(model))
      .add(to_text(Value(model.scale)))
      .add(lines_text(judge))
      .key();
}

/// The G-buffer and the judge decide all lines; its float depth is read whatever `image.precision` says,
/// since an eight-bit step is larger than the visibility test's slack.
struct BoundLineRequest {
  Flow* flow = nullptr;
  BoundValue<GBufferPass> gbuffer;

  void fold(KeyBuilder& key, const FrameState& frame) const {
    gbuffer.fold(key, frame);
    key.add(lines_text(frame.settings.judge));
  }
  LineRequest get(const FrameState& frame) const { return ReferencePass::request(*flow, frame); }
};
struct LineRequestInput {
  BoundLineRequest bind(Flow& flow) const { return {&flow, value_of<GBufferPass>().bind(flow)}; }
  static std::vector<PassInput> told() {
    std::vector<PassInput> told = decltype(value_of<GBufferPass>())::told();
    told.push_back({JudgeParams::description().group});
    return told;
  }
};

}  // namespace

constinit const BufferName BufferName::reference{kReference};

const PassKind& ReferencePass::kind() {
  static const PassKind kKind = describe_pass<ReferencePass>(
      "reference", 60, {shows_drawing(BufferName::reference, draw_reference, class_image)},
      LineRequestInput{});
  return kKind;
}

LineRequest ReferencePass::request(Flow& flow, const FrameState& frame) {
  const std::shared_ptr<const GBuffer> gbuffer = flow.node<GBufferPass>().get(frame);
  const Settings& settings = frame.settings;
  MeshStore& meshes = flow.shared<MeshStore>();
  LineRequest request{.key = frame.keys[flow.node<ReferencePass>().index()],
                      .camera = settings.camera,
                      .judge = settings.judge};
  request.depth = gbuffer->normal_and_depth.read(3, 1);
  request.object_id = gbuffer->object_id.read(0, 1);
  for (size_t i = 0; i < settings.models.size(); ++i) {
    const ModelParams& model = settings.models[i];
    if (!model.visible) continue;
    const MeshParams level = level_of(settings, i);
    const bool is_full = level == MeshParams{};
    std::shared_ptr<const Mesh> drawn = meshes.drawn_mesh(model, level);
    request.models.push_back({.params = model,
                              .object_id = static_cast<int>(i) + 1,
                              .full = is_full ? drawn : meshes.full_mesh(model),
                              .drawn = drawn,
                              .full_key = full_key(meshes, model, settings.judge),
                              .drawn_key = meshes.identity(model, level)});
  }
  return request;
}

}  // namespace inkbench
