// SPDX-License-Identifier: MIT
#include "pipeline/pass_list.h"

#include <algorithm>

#include "pipeline/passes/edges/combine.h"
#include "pipeline/passes/edges/drawn_lines.h"
#include "pipeline/passes/edges/gradient.h"
#include "pipeline/passes/edges/range.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/meshes.h"
#include "pipeline/passes/gbuffer/quantise.h"
#include "pipeline/passes/ink/ink.h"
#include "pipeline/passes/light/shade.h"
#include "pipeline/passes/lines/reference.h"

namespace inkbench {
namespace {

std::vector<const PassKind*>& list() {
  static std::vector<const PassKind*> passes{
      &MeshesPass::kind(),   &GBufferPass::kind(),    // scene to maps
      &QuantisePass::kind(),                          //
      &GradientPass::kind(), &RangePass::kind(),      // maps to edges
      &CombinePass::kind(),  &LinesPass::kind(),      //
      &ShadePass::kind(),    &InkPass::kind(),        // light, and ink over it
      &BlinnPhong::kind(),   &ReferencePass::kind(),  // beside the chain
  };
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
