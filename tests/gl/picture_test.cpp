// Pictures: raw values times a gain, clamped, at eight bits; object ids in colours of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

double gain_of(const DisplayParams& display, BufferName buffer) {
  if (buffer == BufferName::depth) return display.depth_gain;
  if (buffer == BufferName::depth_edges) return display.depth_edges_gain;
  if (buffer == BufferName::normal_edges) return display.normal_edges_gain;
  return 1.0;
}

TEST(Picture, is_the_raw_buffer_times_its_gain) {
  Settings settings = analytic_scene();
  settings.display = {1.7F, 20.0F, 3.0F};
  Pipeline pipeline;
  for (size_t i = 0; i + 1 < kFramebufferCount; ++i) {
    const auto buffer = static_cast<BufferName>(i);
    const Image raw = pipeline.raw(settings, buffer);
    const Picture picture = pipeline.picture(settings, buffer);
    for (int y = 0; y < raw.height_px; ++y) {
      for (int x = 0; x < raw.width_px; ++x) {
        for (int c = 0; c < 3; ++c) {
          const double value = raw.at(x, y, raw.channels == 3 ? c : 0) * gain_of(settings.display, buffer);
          ASSERT_NEAR(picture.at(x, y, c), 255.0 * std::clamp(value, 0.0, 1.0), 0.51)
              << name_of(buffer) << " at " << x << ", " << y;
        }
      }
    }
  }
}

TEST(Picture, gives_each_object_a_colour_of_its_own) {
  const Settings settings = analytic_scene();
  Pipeline pipeline;
  const Image ids = pipeline.raw(settings, BufferName::object_id);
  const Picture picture = pipeline.picture(settings, BufferName::object_id);
  std::map<float, std::set<std::array<int, 3>>> colours;
  std::set<std::array<int, 3>> all;
  for (int y = 0; y < ids.height_px; ++y) {
    for (int x = 0; x < ids.width_px; ++x) {
      const std::array<int, 3> colour{picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)};
      colours[ids.at(x, y)].insert(colour);
      all.insert(colour);
    }
  }
  for (const auto& [id, found] : colours) EXPECT_EQ(found.size(), 1U) << id;
  EXPECT_EQ(all.size(), colours.size());
  EXPECT_EQ(*colours[0.0F].begin(), (std::array<int, 3>{0, 0, 0}));
}

TEST(Picture, has_its_top_row_first) {
  Settings settings = small_scene();
  settings.models[0].position = {0.0F, 1.2F, 0.0F};
  settings.scene.background = glm::vec3(0.0F);
  Pipeline pipeline;
  const Picture picture = pipeline.picture(settings, BufferName::object_id);
  EXPECT_GT(picture.at(24, 5, 0), 0);
  EXPECT_EQ(picture.at(24, 35, 0), 0);
}

}  // namespace
}  // namespace inkbench
