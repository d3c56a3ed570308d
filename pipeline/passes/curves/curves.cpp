// SPDX-License-Identifier: MIT
#include "pipeline/passes/curves/curves.h"

#include <cassert>

#include "pipeline/curves/unexplained.h"
#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/curves/object_curves_pass.h"
#include "pipeline/passes/curves/traced_curves.h"

namespace inkbench {
namespace {

bool from_objects(const Settings& settings) {
  return settings.curves.from != CurvesFrom::image;
}
bool from_image(const Settings& settings) {
  return settings.curves.from != CurvesFrom::object;
}

}  // namespace

const PassKind& CurvesPass::kind() {
  static const PassKind kKind =
      describe_pass<CurvesPass>("curves", 1, {}, value_when<ObjectCurvesPass, from_objects>(),
                                value_when<TracedCurvesPass, from_image>());
  return kKind;
}

Curves CurvesPass::run(const Curves* of_objects, const Curves* traced) const {
  assert(of_objects != nullptr || traced != nullptr);
  if (of_objects == nullptr) return *traced;
  Curves curves = *of_objects;
  if (traced == nullptr) return curves;
  const uint32_t first = curves.curves.empty() ? 0 : curves.curves.back().chain + 1;
  for (const Curve& curve : unexplained(*traced, *of_objects)) {
    curves.curves.push_back(curve);
    curves.curves.back().chain += first;
  }
  curves.notes.insert(curves.notes.end(), traced->notes.begin(), traced->notes.end());
  return curves;
}

}  // namespace inkbench
