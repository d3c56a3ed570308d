// SPDX-License-Identifier: MIT
// Why a pixel is a line, of a frame and of what is kept of it when it is gone.
#include "pipeline/explain.h"

#include <gtest/gtest.h>

#include "pipeline/base/error.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

TEST(Explain, kept_maps_say_what_the_frame_said_also_at_the_images_edges) {
  const Settings settings = analytic_scene();
  Pipeline pipeline;
  const Frame frame = pipeline.at(settings);
  const KeptMaps kept = keep_maps(frame);
  const int right = settings.image.width - 1, bottom = settings.image.height - 1;
  bool any_line = false;
  for (int x = 0; x <= right; x += 5) {
    for (const int y : {0, 1, bottom / 2, bottom}) {
      const Explanation now = explain_pixel(frame, x, y);
      EXPECT_EQ(explanation_json(explain_pixel(kept, x, y)), explanation_json(now));
      any_line |= now.is_line;
    }
  }
  EXPECT_TRUE(any_line);
  EXPECT_THROW(explain_pixel(kept, right + 1, 0), Error);
}

}  // namespace
}  // namespace inkbench
