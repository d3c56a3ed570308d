// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/found_edges.h"

#include "pipeline/flow/describe_choice.h"
#include "pipeline/passes/edges/decaudin.h"
#include "pipeline/passes/edges/dihedral.h"
#include "pipeline/passes/edges/laplacian.h"
#include "pipeline/passes/edges/mitchell.h"
#include "pipeline/passes/edges/paper_strength.h"
#include "pipeline/passes/edges/saito_takahashi.h"

namespace inkbench {
namespace {

constexpr BufferInfo kEdgeStrength{
    .name = "edge_strength",
    .help = "How much of what makes a line the detector sees: 1 is at the limit; it has no upper end.",
    .gain = &DisplayParams::strength_gain,
    .limit = 1.0F};

}  // namespace

constinit const BufferName BufferName::edge_strength{kEdgeStrength};

const PassKind& FoundEdges::kind() {
  static const PassKind kKind =
      describe_choice<FoundEdges, PaperStrengthPass, DecaudinPass, SaitoTakahashiPass, MitchellPass,
                      LaplacianPass, DihedralPass>("edges", EdgesParams::description().group,
                                                   {shows(BufferName::edge_strength)});
  return kKind;
}

}  // namespace inkbench
