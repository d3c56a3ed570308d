// SPDX-License-Identifier: MIT
// Pairs of neighbours with the angles between the normals that light sees, where `dihedral.normals` asks for
// them. In: pairs, the normal map. Out: pairs.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/gl/texture.h"

namespace inkbench {

class ShadedPairsPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit ShadedPairsPass(const GeneratedSources& generated);
  /// Where the triangles' own normals are wanted, the pairs are handed on.
  static bool hands_on(const Settings& settings) { return settings.dihedral.normals == BendNormals::surface; }
  static const Texture& handed(const Texture& pairs) { return pairs; }
  static PassInput handed_by() { return {DihedralParams::description().group}; }
  /// In: pairs (pairs.h). Out: the same with the angles of the normal map, or with the larger of both.
  Texture run(const Texture& pairs, BendNormals normals, const Texture& normal_and_depth) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
