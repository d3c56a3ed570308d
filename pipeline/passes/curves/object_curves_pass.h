// SPDX-License-Identifier: MIT
// The curves of the meshes, as a pass. In: the meshes as they are drawn, the camera. Out: curves of all
// classes in the whole image's pixels, whatever part of it is drawn.
#pragma once

#include "pipeline/curves/curve_finder.h"
#include "pipeline/flow/flow.h"

namespace inkbench {

class ObjectCurvesPass {
 public:
  using Value = Curves;
  static const PassKind& kind();
  explicit ObjectCurvesPass(Flow& flow) : finder_(flow.sharing<CurveFinder>()) {}
  Curves run(const CurveRequest& request) const { return finder_->find(request); }

 private:
  std::shared_ptr<CurveFinder> finder_;
};

}  // namespace inkbench
