// SPDX-License-Identifier: MIT
// The sum behind a pixel: worked out by hand, and against the equations on noise. The GPU's numbers:
// tests/gl/paper_sum_test.cpp.
#include "pipeline/passes/edges/paper_sum.h"

#include <cmath>

#include "tests/unit/support.h"

namespace inkbench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// 3 x 3, all 0.25 but for what is given.
Image edges(std::initializer_list<std::pair<Offset, float>> values) {
  Image image(3, 3, 1, 0.25F);
  for (const auto& [offset, value] : values) image.at(1 + offset.dx, 1 + offset.dy) = value;
  return image;
}

const CombineParams kHalf{.k_depth = 0.5F, .k_normal = 0.5F};

TEST(PixelWhy, names_the_neighbours_that_decided) {
  const Image depth = edges({{{1, 0}, 0.5F}, {{-1, 1}, 0.125F}});
  const Image normal = edges({{{0, 0}, 0.75F}, {{0, -1}, 0.0F}});
  const PixelWhy why = why_pixel({depth, normal}, kHalf, 1, 1);
  EXPECT_EQ(why.depth.max_at, (Offset{1, 0}));
  EXPECT_EQ(why.depth.min_at, (Offset{-1, 1}));
  EXPECT_EQ(why.depth.gmax, 0.5F);
  EXPECT_EQ(why.depth.gmin, 0.125F);
  EXPECT_EQ(why.depth.ratio, 0.75F);
  EXPECT_EQ(why.depth.p, 0.5625F);
  EXPECT_EQ(why.normal.max_at, (Offset{0, 0}));
  EXPECT_EQ(why.normal.min_at, (Offset{0, -1}));
  EXPECT_EQ(why.normal.ratio, 1.5F);
  EXPECT_EQ(why.normal.p, 1.0F);
  EXPECT_EQ(why.sum, 1.5625F);
  EXPECT_EQ(why.edge, 1.0F);
  EXPECT_TRUE(why.inked);
}

TEST(PixelWhy, among_equal_neighbours_the_nearest_is_named) {
  const Image flat = edges({});
  const PixelWhy why = why_pixel({flat, flat}, kHalf, 1, 1);
  EXPECT_EQ(why.depth.max_at, Offset{});
  EXPECT_EQ(why.depth.min_at, Offset{});
  const Image corner_and_side = edges({{{-1, -1}, 0.5F}, {{0, 1}, 0.5F}});
  EXPECT_EQ(why_pixel({corner_and_side, flat}, kHalf, 1, 1).depth.max_at, (Offset{0, 1}));
}

TEST(PixelWhy, terms_that_are_off_add_nothing_but_keep_their_numbers) {
  const Image step = edges({{{1, 0}, 1.0F}});
  CombineParams params = kHalf;
  params.use_depth = false;
  const PixelWhy why = why_pixel({step, edges({})}, params, 1, 1);
  EXPECT_EQ(why.depth.p, 0.0F);
  EXPECT_EQ(why.depth.ratio, 1.5F);
  EXPECT_FALSE(why.inked);
}

TEST(PixelWhy, neighbours_outside_the_image_do_not_count) {
  Image image(2, 1, 1);
  image.at(1, 0) = 1.0F;
  const PixelWhy why = why_pixel({image, image}, kHalf, 0, 0);
  EXPECT_EQ(why.depth.max_at, (Offset{1, 0}));
  EXPECT_EQ(why.depth.gmin, 0.0F);
  const Image one(1, 1, 1, 0.5F);
  EXPECT_EQ(why_pixel({one, one}, kHalf, 0, 0).sum, 0.0F);
}

TEST(PixelWhy, a_sum_equal_to_the_threshold_is_a_line_and_zero_never_is) {
  const Image half = edges({{{1, 0}, 0.5F}});  // ratio 0.5, p 0.25
  CombineParams params = kHalf;
  params.threshold = 0.25F;
  EXPECT_TRUE(why_pixel({half, edges({})}, params, 1, 1).inked);
  params.threshold = 0.0F;
  const PixelWhy none = why_pixel({edges({}), edges({})}, params, 1, 1);
  EXPECT_FALSE(none.inked);
  EXPECT_THAT(verdict_text(none), StartsWith("No line, because both terms are 0."));
}

TEST(PixelWhy, eight_bits_can_lose_a_faint_line) {
  const Image faint = edges({{{1, 0}, 0.27F}});  // p = 0.0016, under half of 1/255
  CombineParams params = kHalf;
  params.threshold = 0.001F;
  EXPECT_TRUE(why_pixel({faint, edges({})}, params, 1, 1).inked);
  const PixelWhy why = why_pixel({faint, edges({})}, params, 1, 1, Precision::unorm8);
  EXPECT_FALSE(why.inked);
  EXPECT_THAT(verdict_text(why), HasSubstr("rounds to 0 in eight bits"));
}

/// Two objects, the right one farther away and turned by 90 degrees.
struct Corner {
  Image depth = Image(4, 3, 1, 0.5F), normal = Image(4, 3, 3, 0.5F), object_id = Image(4, 3, 1, 1.0F);
  Corner() {
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 4; ++x) {
        const bool right = x >= 2;
        if (right) depth.at(x, y) = 0.75F;
        if (right) object_id.at(x, y) = 2.0F;
        normal.at(x, y, right ? 0 : 2) = 1.0F;
      }
    }
  }
};

TEST(PixelWhy, says_what_made_the_gradient) {
  const Corner corner;
  Image depth_edges(4, 3, 1);
  Image normal_edges(4, 3, 1);
  depth_edges.at(1, 1) = 0.125F;
  normal_edges.at(2, 1) = 0.125F;
  const EdgeBuffers buffers{depth_edges, normal_edges, &corner.depth, &corner.normal, &corner.object_id};
  const PixelWhy why = why_pixel(buffers, kHalf, 1, 1);
  ASSERT_TRUE(why.depth.step);
  EXPECT_EQ(why.depth.step->to, (Offset{1, 0}));
  EXPECT_EQ(why.depth.step->from_depth, 0.5F);
  EXPECT_EQ(why.depth.step->to_depth, 0.75F);
  EXPECT_EQ(why.depth.step->share, 0.5F) << "weights 1, 2, 1 to the right";
  ASSERT_TRUE(why.normal.step);
  EXPECT_EQ(why.normal.step->to, (Offset{-1, 0}))
      << "seen from the pixel on the right, which has the gradient";
  EXPECT_NEAR(why.normal.step->angle_deg, 90, 1e-3);
  EXPECT_EQ(why.normal.step->from_object, 2);
  EXPECT_EQ(why.normal.step->to_object, 1);
  const std::vector<std::string> names{"rabbit", "room"};
  EXPECT_EQ(cause_text(*why.depth.step, true, names),
            "a step in depth from 0.5 to 0.75 between rabbit and room");
  EXPECT_EQ(cause_text(*why.normal.step, false), "normals 90 degrees apart between object 2 and object 1");
}

TEST(PixelWhy, says_why_there_is_a_line_or_none) {
  const Image depth = edges({{{1, 0}, 0.2525F}});
  const Image normal = edges({{{-1, -1}, 0.0F}});
  EXPECT_EQ(verdict_text(why_pixel({depth, normal}, {}, 1, 1)),
            "A line, because the sum of the terms, 1.694, reaches the threshold 0.75.");
  EXPECT_EQ(verdict_text(why_pixel({edges({}), edges({})}, {}, 1, 1)),
            "No line, because the sum of the terms, 0, is below the threshold 0.75.");
}

TEST(PixelWhy, a_sum_close_to_the_threshold_shows_all_its_digits) {
  CombineParams params = kHalf;
  params.threshold = std::nextafter(0.25F, 1.0F);
  EXPECT_THAT(verdict_text(why_pixel({edges({{{1, 0}, 0.5F}}), edges({})}, params, 1, 1)),
              StartsWith("No line, because the sum of the terms, 0.25, is below the threshold"));
  params.threshold = 0.25001F;
  EXPECT_THAT(verdict_text(why_pixel({edges({{{1, 0}, 0.50001F}}), edges({})}, params, 1, 1)),
              HasSubstr("0.25002003, reaches the threshold 0.25001."));
}

}  // namespace
}  // namespace inkbench
