// SPDX-License-Identifier: MIT
#include "pipeline/pass_list.h"

#include <algorithm>

#include "pipeline/passes/curves/curves.h"
#include "pipeline/passes/curves/object_curves_pass.h"
#include "pipeline/passes/curves/traced_curves.h"
#include "pipeline/passes/edges/combine.h"
#include "pipeline/passes/edges/decaudin.h"
#include "pipeline/passes/edges/decaudin_gradient.h"
#include "pipeline/passes/edges/dihedral.h"
#include "pipeline/passes/edges/found_edges.h"
#include "pipeline/passes/edges/gradient.h"
#include "pipeline/passes/edges/laplacian.h"
#include "pipeline/passes/edges/mitchell.h"
#include "pipeline/passes/edges/pairs.h"
#include "pipeline/passes/edges/paper_strength.h"
#include "pipeline/passes/edges/range.h"
#include "pipeline/passes/edges/saito_takahashi.h"
#include "pipeline/passes/edges/shaded_pairs.h"
#include "pipeline/passes/gbuffer/albedo.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/meshes.h"
#include "pipeline/passes/gbuffer/motion.h"
#include "pipeline/passes/gbuffer/quantise.h"
#include "pipeline/passes/gbuffer/quantise_planes.h"
#include "pipeline/passes/gbuffer/visible_depth.h"
#include "pipeline/passes/gbuffer/visible_range.h"
#include "pipeline/passes/ink/both_inks.h"
#include "pipeline/passes/ink/coverage.h"
#include "pipeline/passes/ink/drawn_ink.h"
#include "pipeline/passes/ink/drawn_lines.h"
#include "pipeline/passes/ink/flood.h"
#include "pipeline/passes/ink/ink.h"
#include "pipeline/passes/ink/line_bits.h"
#include "pipeline/passes/ink/narrow_coverage.h"
#include "pipeline/passes/ink/published_look.h"
#include "pipeline/passes/ink/seeds.h"
#include "pipeline/passes/ink/strokes_over.h"
#include "pipeline/passes/ink/under_ink.h"
#include "pipeline/passes/light/shade.h"
#include "pipeline/passes/lines/reference.h"
#include "pipeline/passes/placing/candidates.h"
#include "pipeline/passes/placing/connect.h"
#include "pipeline/passes/placing/dihedral_place.h"
#include "pipeline/passes/placing/dihedral_tiles.h"
#include "pipeline/passes/placing/edge_classes.h"
#include "pipeline/passes/placing/edge_tiles.h"
#include "pipeline/passes/placing/line_tiles.h"
#include "pipeline/passes/placing/place.h"
#include "pipeline/passes/placing/placed_lines.h"
#include "pipeline/passes/strokes/curve_lines.h"
#include "pipeline/passes/strokes/stroke_colours.h"
#include "pipeline/passes/strokes/stroke_ink.h"
#include "pipeline/passes/strokes/stroke_paint.h"
#include "pipeline/passes/strokes/strokes.h"

namespace inkbench {
namespace {

std::vector<const PassKind*>& list() {
  // clang-format off
  static std::vector<const PassKind*> passes{
      // scene to maps
      &MeshesPass::kind(), &GBufferPass::kind(), &QuantisePass::kind(), &QuantisePlanesPass::kind(), &VisibleRangePass::kind(),
      &VisibleDepthPass::kind(), &AlbedoPass::kind(),
      // the paper's method
      &GradientPass::kind(), &RangePass::kind(), &CombinePass::kind(), &PaperStrengthPass::kind(),
      // the others
      &DecaudinGradientPass::kind(), &DecaudinPass::kind(), &SaitoTakahashiPass::kind(), &MitchellPass::kind(),
      &LaplacianPass::kind(),
      &PairsPass::kind(), &ShadedPairsPass::kind(), &DihedralPass::kind(),
      &FoundEdges::kind(), &EdgeTilesPass::kind(), &EdgeClassPass::kind(),
      // where lines run
      &CandidatesPass::kind(), &PlacePass::kind(), &PairTilesPass::kind(), &DihedralTilesPass::kind(), &DihedralPlacePass::kind(), &PlacedLines::kind(), &ConnectPass::kind(),
      // how wide they are, and what of each pixel they cover
      &SeedsPass::kind(), &FloodPass::kind(), &CoveragePass::kind(),
      &LineTilesPass::kind(), &LineTiles::kind(), &LineBitsPass::kind(), &NarrowCoveragePass::kind(), &LineCoverage::kind(),
      &AliasedCoverage::kind(), &SampledCoverage::kind(),
      &PublishedLookPass::kind(), &FilterInk::kind(),
      // light
      &ShadePass::kind(), &BlinnPhong::kind(),
      // curves and strokes
      &ObjectCurvesPass::kind(), &TracedCurvesPass::kind(), &CurvesPass::kind(), &CurveLinesPass::kind(), &CurvePaint::kind(), &CurveColours::kind(),
      &StrokesPass::kind(), &StrokePaint::kind(), &StrokeInkPass::kind(), &StrokeColours::kind(),
      // what is drawn over the shading
      &BothInksPass::kind(), &DrawnInk::kind(), &LinesPass::kind(),
      &PaperPass::kind(), &UnderInk::kind(), &InkPass::kind(), &BelowStrokes::kind(), &StrokesOverPass::kind(), &FinalImage::kind(),
      // beside the chain
      &ReferencePass::kind(), &MotionPass::kind(),
  };
  // clang-format on
  return passes;
}

}  // namespace

std::vector<const PassKind*> all_passes() {
  return list();
}

void add_pass(const PassKind& kind) {
  if (std::find(list().begin(), list().end(), &kind) != list().end()) return;
  list().push_back(&kind);
  if (kind.bring != nullptr) kind.bring();
}

}  // namespace inkbench
