// SPDX-License-Identifier: MIT
// Pictures: raw values times a gain, clamped, at eight bits; object ids in colours of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "pipeline/base/error.h"
#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

double expected_gain(const DisplayParams& display, BufferName buffer) {
  if (buffer == BufferName::depth) return display.depth_gain;
  if (buffer == BufferName::edge_strength) return display.strength_gain;
  if (buffer == BufferName::depth_edges) return display.depth_edges_gain;
  if (buffer == BufferName::normal_edges) return display.normal_edges_gain;
  return 1.0;
}

TEST(Picture, is_the_raw_buffer_times_its_gain) {
  Settings settings = analytic_scene();
  settings.display = {1.7F, 20.0F, 3.0F};
  Pipeline pipeline;
  for (const BufferName buffer : framebuffers()) {
    if (!has_range(buffer)) continue;  // in colours of its own
    const Image raw = pipeline.at(settings).raw(buffer);
    const Picture picture = pipeline.at(settings).picture(buffer);
    for (int y = 0; y < raw.height_px; ++y) {
      for (int x = 0; x < raw.width_px; ++x) {
        for (int c = 0; c < 3; ++c) {
          const double value =
              raw.at(x, y, raw.channels >= 3 ? c : 0) * expected_gain(settings.display, buffer);
          ASSERT_NEAR(picture.at(x, y, c), 255.0 * std::clamp(value, 0.0, 1.0), 0.51)
              << name_of(buffer) << " at " << x << ", " << y;
        }
      }
    }
  }
}

TEST(Picture, gain_range_shows_the_picture_of_the_gains) {
  Settings settings = analytic_scene();
  settings.display = {1.7F, 20.0F, 3.0F};
  Pipeline pipeline;
  for (const BufferName buffer : {BufferName::depth, BufferName::depth_edges, BufferName::normal_edges,
                                  BufferName::combined_edges, BufferName::shaded}) {
    const Picture with_gains = pipeline.at(settings).picture(buffer);
    const Picture with_range = pipeline.at(settings)
                                   .picture_texture(buffer, gain_range(settings.display, buffer))
                                   .texture->read_picture();
    int largest = 0;
    for (size_t i = 0; i < with_gains.samples.size(); ++i)
      largest = std::max(largest, std::abs(with_gains.samples[i] - with_range.samples[i]));
    EXPECT_LE(largest, 1) << name_of(buffer) << ": a gain and its reciprocal round differently";
  }
}

TEST(Picture, part_of_a_raw_buffer_is_that_part) {
  const Settings settings = analytic_scene();
  Pipeline pipeline;
  const int width = settings.image.width;
  const int height = settings.image.height;
  for (const BufferName buffer : {BufferName::normal, BufferName::depth_edges, BufferName::object_id}) {
    const Image raw = pipeline.at(settings).raw(buffer);
    for (const auto& [left, top, part_width, part_height] :
         {std::array{0, 0, 5, 3}, {width - 4, height - 5, 4, 5}, {60, 40, 7, 9}, {0, height - 1, width, 1}}) {
      const Image part = pipeline.at(settings).raw_part(buffer, left, top, part_width, part_height);
      ASSERT_EQ(part.width_px, part_width);
      ASSERT_EQ(part.height_px, part_height);
      for (int y = 0; y < part_height; ++y) {
        for (int x = 0; x < part_width; ++x) {
          for (int c = 0; c < raw.channels; ++c)
            ASSERT_EQ(part.at(x, y, c), raw.at(left + x, top + y, c))
                << name_of(buffer) << " " << x << " " << y;
        }
      }
    }
  }
}

TEST(Picture, gives_each_object_a_colour_of_its_own) {
  const Settings settings = analytic_scene();
  Pipeline pipeline;
  const Image ids = pipeline.at(settings).raw(BufferName::object_id);
  const Picture picture = pipeline.at(settings).picture(BufferName::object_id);
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
  const Picture picture = pipeline.at(settings).picture(BufferName::object_id);
  EXPECT_GT(picture.at(24, 5, 0), 0);
  EXPECT_EQ(picture.at(24, 35, 0), 0);
}

TEST(Picture, left_on_the_gpu_is_the_same_and_kept_until_something_changes) {
  Settings settings = analytic_scene();
  Pipeline pipeline;
  for (const BufferName buffer : framebuffers()) {
    const Picture expected = pipeline.at(settings).picture(buffer);
    EXPECT_EQ(pipeline.at(settings).picture_texture(buffer).texture->read_picture(), expected)
        << name_of(buffer);
  }
  EXPECT_EQ(pipeline.counts().at("picture").runs, std::ssize(framebuffers()));
  const Key before = pipeline.at(settings).picture_texture(BufferName::depth).key;
  EXPECT_EQ(pipeline.counts().at("picture").runs, std::ssize(framebuffers()));
  settings.display.depth_gain = 2.0F;
  EXPECT_NE(pipeline.at(settings).picture_texture(BufferName::depth).key, before);
  EXPECT_EQ(pipeline.counts().at("picture").runs, std::ssize(framebuffers()) + 1);
}

TEST(Picture, shows_a_range_from_black_to_white) {
  const Settings settings = analytic_scene();
  Pipeline pipeline;
  const Image raw = pipeline.at(settings).raw(BufferName::depth);
  const auto [low, high] = std::minmax_element(raw.samples.begin(), raw.samples.end());
  const Picture picture = pipeline.at(settings)
                              .picture_texture(BufferName::depth, ShownRange{*low, *high})
                              .texture->read_picture();
  for (int y = 0; y < raw.height_px; ++y) {
    for (int x = 0; x < raw.width_px; ++x) {
      const double expected = 255.0 * (raw.at(x, y) - *low) / (*high - *low);
      ASSERT_NEAR(picture.at(x, y, 0), expected, 0.51) << x << ", " << y;
    }
  }
}

TEST(Picture, that_cannot_be_made_leaves_the_last_one) {
  Settings settings = analytic_scene();
  Pipeline pipeline;
  const Texture* texture = pipeline.at(settings).picture_texture(BufferName::final).texture;
  const Picture before = texture->read_picture();
  settings.models.front().shape = Shape::mesh;
  settings.models.front().mesh = "/no/such/mesh.obj";
  EXPECT_THROW(pipeline.at(settings).picture_texture(BufferName::final), Error);
  EXPECT_EQ(texture->read_picture(), before);
}

class ToldPasses : public PassObserver {
 public:
  void begin_pass(std::string_view name) override { begun.emplace_back(name); }
  void end_pass() override { ++ended; }
  std::vector<std::string> begun;
  size_t ended = 0;
};

TEST(Picture, observer_is_told_of_the_passes_that_run) {
  Settings settings = analytic_scene();
  Pipeline pipeline;
  pipeline.at(settings).picture_texture(BufferName::final);
  ToldPasses names;
  pipeline.observe(&names);
  pipeline.at(settings).picture_texture(BufferName::final);
  EXPECT_TRUE(names.begun.empty());
  settings.combine.threshold = 0.2F;
  pipeline.at(settings).picture_texture(BufferName::final);
  EXPECT_EQ(names.begun, (std::vector<std::string>{"combine", "ink", "picture"}));
  EXPECT_EQ(names.ended, names.begun.size());
}

}  // namespace
}  // namespace inkbench
