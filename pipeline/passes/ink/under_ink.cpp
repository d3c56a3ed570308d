// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/under_ink.h"

#include <array>

#include "pipeline/flow/describe_choice.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/passes/light/shade.h"

namespace inkbench {

const PassKind& PaperPass::kind() {
  static const PassKind kKind =
      describe_pass<PaperPass>("paper", 1, {}, part<&Settings::ink, &InkParams::paper>(), WindowInput{});
  return kKind;
}

Texture PaperPass::run(const glm::vec3& colour, const ImageWindow& window) const {
  Texture paper("paper", TextureFormat::rgba32f, window.width, window.height);
  const RenderTarget target({&paper}, nullptr);
  const std::array<float, 4> value{colour.x, colour.y, colour.z, 1.0F};
  glClearBufferfv(GL_COLOR, 0, value.data());
  return paper;
}

const PassKind& UnderInk::kind() {
  static const PassKind kKind =
      describe_choice<UnderInk, ShadePass, PaperPass>("under_ink", InkParams::description().group, {});
  return kKind;
}

}  // namespace inkbench
