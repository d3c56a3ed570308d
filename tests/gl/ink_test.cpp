// SPDX-License-Identifier: MIT
// The ink pass against 3.5 on uploaded maps.
#include "pipeline/passes/ink/ink.h"

#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

Image run_ink(const InkParams& params, const Image& shaded, const Image& edges) {
  const GeneratedSources generated = generated_sources();
  return InkPass(generated).run({.ink = params}, to_texture(shaded), to_texture(edges)).read(0, 3);
}

TEST(Ink, equals_reference_on_noise_of_any_size) {
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {317, 203}}) {
    const Image shaded = noise(width, height, 3, 5, 0.0F, 3.0F);
    Image edges = noise(width, height, 1, 6);
    for (float& edge : edges.samples) edge = edge < 0.5F ? 0.0F : edge;
    const InkParams params{.colour = {0.25F, 0.5F, 0.75F}};
    // Nothing is computed, values are copied: they are equal.
    EXPECT_TRUE(is_near(run_ink(params, shaded, edges),
                        reference::ink(reference::to_map(shaded), reference::to_map(edges), params), 0.0));
  }
}

TEST(Ink, covers_the_shading_wherever_an_edge_is_not_zero) {
  Image edges(3, 1, 1);
  edges.at(1, 0) = 1e-3F;
  edges.at(2, 0) = 1.0F;
  const Image result = run_ink({}, Image(3, 1, 3, 0.8F), edges);
  EXPECT_EQ(result.at(0, 0, 0), 0.8F);
  EXPECT_EQ(result.at(1, 0, 0), 0.0F);
  EXPECT_EQ(result.at(2, 0, 0), 0.0F);
}

TEST(Lines, are_1_exactly_where_the_ink_lies) {
  Settings settings = small_scene();
  settings.ink.colour = {0.0F, 1.0F, 0.25F};  // no light has it
  for (const Precision precision : {Precision::float32, Precision::unorm8}) {
    settings.image.precision = precision;
    for (const float threshold : {0.75F, 0.05F}) {  // below 0.5 a line's strength is no share of ink
      settings.combine.threshold = threshold;
      Pipeline pipeline;
      const Image lines = pipeline.at(settings).raw(BufferName::lines);
      const Image final = pipeline.at(settings).raw(BufferName::final);
      int count = 0;
      for (int y = 0; y < lines.height_px; ++y) {
        for (int x = 0; x < lines.width_px; ++x) {
          const bool inked = final.at(x, y, 0) == 0.0F && final.at(x, y, 1) == 1.0F;
          ASSERT_EQ(lines.at(x, y), inked ? 1.0F : 0.0F) << x << ", " << y;
          count += inked ? 1 : 0;
        }
      }
      EXPECT_GT(count, 50);
    }
  }
}

}  // namespace
}  // namespace inkbench
