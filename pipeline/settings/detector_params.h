// SPDX-License-Identifier: MIT
// The numbers of the detectors other than the paper's (whose are in combine_params.h) and `dihedral`
// (dihedral_params.h).
#pragma once

#include "pipeline/params/description.h"

namespace inkbench {

/// Decaudin (1996).
struct DecaudinParams {
  float k_depth = 0.003F;
  float k_normal = 0.2F;
  bool thin = false;

  static const Description& description();
};

/// Saito and Takahashi (1990).
struct SaitoTakahashiParams {
  float profile = 0.02F;
  float crease = 0.003F;
  bool thin = false;

  static const Description& description();
};

/// Mitchell, Brennan and Card (2002).
struct MitchellParams {
  float angle = 40.0F;
  float depth = 0.005F;
  bool use_ids = true;
  float albedo = 0.1F;
  bool thin = false;

  static const Description& description();
};

/// The second difference of 1/z.
struct LaplacianParams {
  float bend = 1.0F;

  static const Description& description();
};

}  // namespace inkbench
