// SPDX-License-Identifier: MIT
#include "pipeline/vector_export.h"

#include <algorithm>

#include "pipeline/base/error.h"
#include "pipeline/export.h"
#include "pipeline/lines/drawing.h"
#include "pipeline/passes/curves/curves.h"
#include "pipeline/passes/lines/reference.h"
#include "pipeline/passes/strokes/stroke_colours.h"
#include "pipeline/passes/strokes/strokes.h"
#include "pipeline/vectors/curves_svg.h"
#include "pipeline/vectors/regions_svg.h"
#include "pipeline/vectors/strokes_svg.h"

namespace inkbench {
namespace {

VectorPage page_of(const Frame& frame, BufferName buffer) {
  const Settings& settings = frame.settings();
  VectorPage page{settings.image.width, settings.image.height, {}, {}};
  page.about = export_text(settings, buffer, frame.used_files());
  for (const ModelParams& model : settings.models) page.object_names.push_back(model.name);
  return page;
}

/// What the strokes' colours are taken from, where they are not their own.
SurfaceColours surface_of(const Frame& frame, const Strokes& strokes) {
  const StrokeColour colour = frame.settings().stroke.colour;
  if (colour != StrokeColour::material && colour != StrokeColour::shading) return {};
  float widest = 0.0F;
  for (const Stroke& stroke : strokes.strokes) {
    for (const StrokePoint& point : stroke.points) widest = std::max(widest, 2.0F * point.radius_px);
  }
  return {frame.raw(colour == StrokeColour::material ? BufferName::albedo : BufferName::shaded),
          frame.raw(BufferName::depth), frame.raw(BufferName::object_id), surface_reach_px(widest)};
}

std::string strokes_text(const Frame& frame, const std::string& below) {
  const Settings& settings = frame.settings();
  const auto strokes = frame.value<StrokesPass>();
  const StrokeInk ink{settings.stroke, settings.stroke_classes, settings.ink, surface_of(frame, *strokes)};
  return strokes_svg(*strokes, ink, page_of(frame, BufferName::strokes), below);
}

Error no_lines(BufferName buffer) {
  return input_error(std::string(name_of(buffer)), "is not made of lines",
                     "curves, strokes and reference leave as vectors; write others as png or exr");
}

}  // namespace

bool is_of_lines(BufferName buffer) {
  return buffer == BufferName::reference || buffer == BufferName::curves || buffer == BufferName::strokes;
}

std::string vector_text(const Frame& frame, BufferName buffer, const std::string& below) {
  if (buffer == BufferName::reference) return reference_svg(*frame.value<ReferencePass>());
  if (buffer == BufferName::strokes) return strokes_text(frame, below);
  if (buffer != BufferName::curves) throw no_lines(buffer);
  const Settings& settings = frame.settings();
  return curves_svg(*frame.value<CurvesPass>(), settings.stroke.hidden, settings.stroke_classes,
                    page_of(frame, buffer), below);
}

Plot plot_of(const Frame& frame, BufferName buffer, double width_mm) {
  const PlotOptions options{width_mm, frame.settings().stroke.hidden};
  const VectorPage page = page_of(frame, buffer);
  if (buffer == BufferName::strokes)
    return plot_svg(plot_drawing(*frame.value<StrokesPass>()), options, page);
  if (buffer == BufferName::curves) return plot_svg(plot_drawing(*frame.value<CurvesPass>()), options, page);
  throw no_lines(buffer);
}

std::string shading_regions(Pipeline& pipeline, const Settings& settings) {
  Settings finer = settings;
  const bool is_finer = 2 * std::max(settings.image.width, settings.image.height) <= kMostFinerPx;
  if (is_finer) {
    finer.image.width *= 2;
    finer.image.height *= 2;
  }
  pipeline.check_room(finer.image);
  const Frame frame = pipeline.at(finer);
  return regions_svg(traced_regions(frame.raw(BufferName::shaded), frame.raw(BufferName::object_id),
                                    {.sample_px = is_finer ? 0.5 : 1.0}));
}

}  // namespace inkbench
