// SPDX-License-Identifier: MIT
#include "pipeline/passes/curves/object_curves_pass.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/gbuffer/meshes.h"

namespace inkbench {
namespace {

struct BoundCurveRequest {
  Flow* flow = nullptr;
  BoundDrawItems drawn;

  void fold(KeyBuilder& key, const FrameState& frame) const {
    const Settings& settings = frame.settings;
    CurvesParams curves = settings.curves;
    curves.from = {};
    curves.image_smoothing = 0.0F;
    key.add(group_text(settings.camera))
        .add(group_text(curves))
        .add(std::to_string(settings.image.width))
        .add(std::to_string(settings.image.height));
    drawn.fold(key, frame);
  }
  CurveRequest get(const FrameState& frame) const {
    const Settings& settings = frame.settings;
    MeshStore& meshes = flow->shared<MeshStore>();
    CurveRequest request{.models = {},
                         .camera = settings.camera,
                         .params = settings.curves,
                         .width_px = settings.image.width,
                         .height_px = settings.image.height};
    for (const DrawItem& item : drawn.get(frame).items) {
      const auto index = static_cast<size_t>(item.object_id - 1);
      const ModelParams& model = settings.models[index];
      const MeshParams level = level_of(settings, index);
      request.models.push_back({meshes.drawn_mesh(model, level), meshes.identity(model, level),
                                item.model_to_world, item.object_id});
    }
    return request;
  }
};
struct CurveRequestInput {
  BoundCurveRequest bind(Flow& flow) const { return {&flow, DrawItemsInput{}.bind(flow)}; }
  static std::vector<PassInput> told() {
    std::vector<PassInput> told = DrawItemsInput::told();
    for (const Description* description :
         {&CameraParams::description(), &CurvesParams::description(), &ImageParams::description()})
      told.push_back({description->group});
    return told;
  }
};

}  // namespace

const PassKind& ObjectCurvesPass::kind() {
  static const PassKind kKind = describe_pass<ObjectCurvesPass>("object_curves", 30, {}, CurveRequestInput{});
  return kKind;
}

}  // namespace inkbench
