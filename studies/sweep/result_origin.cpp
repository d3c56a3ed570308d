// SPDX-License-Identifier: MIT
#include "studies/sweep/result_origin.h"

#include "pipeline/gl/context.h"

namespace inkbench {

ResultOrigin this_origin() {
  const RendererInfo info = renderer_info();
  return {kDrawingSources, kMeasuringSources, info.renderer + ", OpenGL " + info.version};
}

}  // namespace inkbench
