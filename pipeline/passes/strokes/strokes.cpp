// SPDX-License-Identifier: MIT
#include "pipeline/passes/strokes/strokes.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/curves/curves.h"
#include "pipeline/passes/gbuffer/visible_range.h"
#include "pipeline/passes/light/shade.h"

namespace inkbench {
namespace {

bool widths_follow_distance(const Settings& settings) {
  return settings.stroke.unit == WidthUnit::world || settings.stroke.depth_taper > 0.0F;
}

bool widths_follow_light(const Settings& settings) {
  return settings.stroke.shadow_width != 0.0F;
}

struct StrokeCourseInput {
  StrokeCourseInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() { return {{StrokeParams::description().group}}; }
  StrokeCourseParams get(const FrameState& frame) const { return stroke_course(frame.settings); }
  void fold(KeyBuilder& key, const FrameState& frame) const {
    const StrokeCourseParams params = get(frame);
    key.add(group_text(params.stroke));
    for (const StrokeClassParams& of_class : params.classes) key.add(group_text(of_class));
    if (params.stroke.unit == WidthUnit::percent) key.add(std::to_string(params.height_px));
    if (params.stroke.unit == WidthUnit::world) LensInput{}.fold(key, frame);
  }
};

/// The frame before's strokes where paint stays on the line; else null. Run with: const Strokes*.
struct BoundStrokesBefore {
  static constexpr bool kLooksBack = true;
  BoundPastValue<StrokesPass> past;

  void fold(KeyBuilder& key, const FrameState& frame) const {
    if (frame.settings.stroke.coherent)
      past.fold(key, frame);
    else
      key.add("each frame anew");
  }
  PastValue<StrokesPass> get(const FrameState& frame) const {
    return frame.settings.stroke.coherent ? past.get(frame) : PastValue<StrokesPass>{};
  }
};
struct StrokesBeforeInput {
  BoundStrokesBefore bind(Flow& flow) const { return {past_value_of<StrokesPass>().bind(flow)}; }
  static std::vector<PassInput> told() { return decltype(past_value_of<StrokesPass>())::told(); }
};

Image luminance_map(const Texture& shaded) {
  const Image colours = shaded.read(0, 3);
  Image luminance(colours.width_px, colours.height_px, 1);
  for (size_t i = 0; i < luminance.samples.size(); ++i)
    luminance.samples[i] =
        luminance_of(colours.samples[3 * i], colours.samples[3 * i + 1], colours.samples[3 * i + 2]);
  return luminance;
}

}  // namespace

StrokeCourseParams stroke_course(const Settings& settings) {
  const StrokeParams plain;
  StrokeCourseParams params{settings.stroke, settings.stroke_classes, settings.image.height,
                            lens_of(settings.camera, settings.image.height)};
  StrokeParams& stroke = params.stroke;
  stroke.colour = plain.colour;
  stroke.darken = plain.darken;
  stroke.opacity = plain.opacity;
  stroke.brush = plain.brush;
  stroke.brush_image = plain.brush_image;
  stroke.brush_length = plain.brush_length;
  stroke.brush_fit = plain.brush_fit;
  stroke.grain = plain.grain;
  stroke.hidden_opacity = plain.hidden_opacity;
  for (StrokeClassParams& of_class : params.classes) of_class = {.width = of_class.width};
  return params;
}

bool draws_strokes(const Settings& settings) {
  return settings.ink.from != InkFrom::filter;
}

bool draws_filter(const Settings& settings) {
  return settings.ink.from != InkFrom::strokes;
}

const PassKind& StrokesPass::kind() {
  static const PassKind kKind = describe_pass<StrokesPass>(
      "strokes", 2, {}, value_of<CurvesPass>(), StrokeCourseInput{},
      value_when<VisibleRangePass, widths_follow_distance>(), value_when<ShadePass, widths_follow_light>(),
      value_when<GBufferPass, widths_follow_light>(), StrokesBeforeInput{});
  return kKind;
}

Strokes StrokesPass::run(const Curves& curves, const StrokeCourseParams& params, const Texture* visible,
                         const Texture* shaded, const GBuffer* gbuffer, const Strokes* before) const {
  StrokeSurroundings around{.height_px = params.height_px,
                            .pixel_size = params.lens.pixel_size,
                            .is_orthographic = params.lens.is_orthographic != 0};
  if (visible != nullptr) {
    const Image range = visible->read(0, 2);
    around.visible = {range.at(0, 0, 0), range.at(0, 0, 1)};
  }
  Image luminance, object_id;
  if (shaded != nullptr && gbuffer != nullptr) {
    luminance = luminance_map(*shaded);
    object_id = gbuffer->object_id.read(0, 1);
    around.luminance = &luminance;
    around.object_id = &object_id;
  }
  return make_strokes(curves, params.stroke, params.classes, around, before);
}

Strokes enlarged(const Strokes& strokes, int times) {
  const auto factor = static_cast<float>(times);
  Strokes large = strokes;
  large.width_px *= times;
  large.height_px *= times;
  for (Stroke& stroke : large.strokes) {
    stroke.start_px *= factor;
    stroke.end_px *= factor;
    for (StrokePoint& point : stroke.points) {
      point.at *= factor;
      point.radius_px *= factor;
      point.along_px *= factor;
    }
  }
  return large;
}

}  // namespace inkbench
