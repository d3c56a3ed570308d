// SPDX-License-Identifier: MIT
// What the paper says of its figures, held to in the figures' own studies at their own size (1024 x 1024).
// Every test prints the numbers that docs/figures.md quotes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <set>

#include "pipeline/base/files.h"
#include "pipeline/gl/context.h"
#include "pipeline/mesh/levels/model_mesh.h"
#include "pipeline/pipeline.h"
#include "studies/sweep/spec.h"
#include "tests/golden/line_measures.h"

namespace inkbench {
namespace {

constexpr float kRabbit = 1, kBox = 2, kRoom = 3;  // object ids: the scene's order

class FigureClaims : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    context_ = std::make_unique<HeadlessContext>();
    pipeline_ = std::make_unique<Pipeline>();
  }
  static void TearDownTestSuite() {
    pipeline_.reset();
    context_.reset();
  }

  static Settings figure(int number, size_t cell = 0) {
    const StudySpec spec = load_spec(project_file(fmt::format("studies/figures/figure_{:02}.toml", number)));
    return cell_settings(spec, make_cell(spec, cell));
  }
  static Image raw(const Settings& settings, BufferName buffer) {
    return pipeline_->at(settings).raw(buffer);
  }
  static Mask ink(const Settings& settings) { return ink_of(raw(settings, BufferName::combined_edges)); }
  static Mask pixels_of(float id) { return pixels_of_object(raw(figure(1), BufferName::object_id), id); }
  static Pipeline& pipeline() { return *pipeline_; }

 private:
  static inline std::unique_ptr<HeadlessContext> context_;
  static inline std::unique_ptr<Pipeline> pipeline_;
};

double share(const Mask& part, const Mask& whole) {
  return static_cast<double>(count(both(part, whole))) / static_cast<double>(count(whole));
}

/// The place of a world point in the picture, in px from the upper left corner, and its distance along the
/// view axis.
struct Projected {
  glm::vec2 at_px;
  float distance;
};
Projected project(const Settings& settings, glm::vec3 world) {
  const glm::vec2 size(settings.image.width, settings.image.height);
  const glm::vec4 clip = projection_matrix(settings.camera, size.x / size.y) * view_matrix(settings.camera) *
                         glm::vec4(world, 1.0F);
  const glm::vec2 ndc = glm::vec2(clip) / clip.w;
  return {glm::vec2(0.5F + 0.5F * ndc.x, 0.5F - 0.5F * ndc.y) * size, clip.w};
}

ModelParams box_of(const Settings& settings) {
  return *std::find_if(settings.models.begin(), settings.models.end(),
                       [](const ModelParams& model) { return model.name == "box"; });
}

glm::vec3 on_box(const Settings& settings, glm::vec3 place) {
  const ModelParams box = box_of(settings);
  return glm::vec3(model_matrix(box, bounds_of(make_model_mesh(box))) * glm::vec4(place, 1.0F));
}

/// The box's corner nearest to the eye, as its signs in the box's own coordinates.
glm::vec3 nearest_corner(const Settings& settings) {
  glm::vec3 nearest(0.5F);
  for (int i = 0; i < 8; ++i) {
    const glm::vec3 corner((i & 1) - 0.5F, ((i >> 1) & 1) - 0.5F, ((i >> 2) & 1) - 0.5F);
    const auto distance = [&](glm::vec3 c) {
      return glm::distance(on_box(settings, c), settings.camera.eye);
    };
    if (distance(corner) < distance(nearest)) nearest = corner;
  }
  return nearest;
}

/// Share of ink along each of the three edges that meet in the nearest corner, without the last sixth, where
/// the outline's own ink begins.
std::array<double, 3> ink_along_nearest_edges(const Settings& settings, const Mask& drawn) {
  std::array<double, 3> shares{};
  const glm::vec3 corner = nearest_corner(settings);
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 end = corner;
    end[axis] *= 1.0F - 2.0F * 5.0F / 6.0F;
    shares[axis] = inked_share(drawn, project(settings, on_box(settings, corner)).at_px,
                               project(settings, on_box(settings, end)).at_px);
  }
  return shares;
}

TEST_F(FigureClaims, farther_is_brighter) {
  const Settings settings = figure(6);
  const Image depth = raw(settings, BufferName::depth);
  const Picture shown = pipeline().at(settings).picture(BufferName::depth);
  // Points whose distance is known: the middles of the box's three visible sides, and its nearest corner.
  const glm::vec3 corner = nearest_corner(settings);
  std::vector<Projected> known{project(settings, on_box(settings, corner * 0.98F))};
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 middle(0.0F);
    middle[axis] = corner[axis];
    known.push_back(project(settings, on_box(settings, middle)));
  }
  std::sort(known.begin(), known.end(),
            [](const Projected& a, const Projected& b) { return a.distance < b.distance; });
  float last = 0.0F;
  for (const Projected& point : known) {
    const float value = depth.at(static_cast<int>(point.at_px.x), static_cast<int>(point.at_px.y));
    EXPECT_NEAR(value * settings.camera.far, point.distance, 0.03) << "linear depth, in world units";
    EXPECT_GT(value, last);
    last = value;
  }
  for (size_t i = 0; i < depth.samples.size(); ++i)
    ASSERT_NEAR(shown.samples[3 * i], depth.samples[i] * 255.0F, 1.0F) << i;
}

TEST_F(FigureClaims, room_behind_the_rabbit_and_the_box_is_brighter_all_around_them) {
  const Settings settings = figure(6);
  const Image depth = raw(settings, BufferName::depth);
  const Image ids = raw(settings, BufferName::object_id);
  std::map<float, double> sum;
  std::map<float, double> number;
  for (size_t i = 0; i < ids.samples.size(); ++i) {
    sum[ids.samples[i]] += depth.samples[i];
    number[ids.samples[i]] += 1;
  }
  int pairs = 0;
  for (int y = 0; y < ids.height_px; ++y) {
    for (int x = 0; x + 1 < ids.width_px; ++x) {
      const float left = ids.at(x, y), right = ids.at(x + 1, y);
      if (left == right || (left != kRoom && right != kRoom)) continue;
      const float room = left == kRoom ? depth.at(x, y) : depth.at(x + 1, y);
      const float front = left == kRoom ? depth.at(x + 1, y) : depth.at(x, y);
      ASSERT_GT(room, front) << x << ", " << y;
      ++pairs;
    }
  }
  fmt::print(
      "mean depth: rabbit {:.4f}, box {:.4f}, room {:.4f}; {} pairs across an outline, the room brighter in "
      "each\n",
      sum[kRabbit] / number[kRabbit], sum[kBox] / number[kBox], sum[kRoom] / number[kRoom], pairs);
  EXPECT_GT(pairs, 500);
  EXPECT_LT(sum[kBox] / number[kBox], sum[kRabbit] / number[kRabbit]) << "the box stands nearer";
  EXPECT_LT(sum[kRabbit] / number[kRabbit], sum[kRoom] / number[kRoom]);
}

TEST_F(FigureClaims, depth_term_alone_misses_the_boxs_nearest_corner_and_edges_and_both_terms_find_them) {
  const Settings settings = figure(8);
  const Mask depth_alone = ink(settings);
  const Mask together = ink(figure(1));
  const std::array<double, 3> missed = ink_along_nearest_edges(settings, depth_alone);
  const std::array<double, 3> found = ink_along_nearest_edges(settings, together);
  const glm::vec2 corner = project(settings, on_box(settings, nearest_corner(settings))).at_px;
  fmt::print(
      "nearest corner at ({:.0f}, {:.0f}); ink along its three edges: depth alone {:.1f} %, {:.1f} %, {:.1f} "
      "%; both {:.1f} %, "
      "{:.1f} %, {:.1f} %\n",
      corner.x, corner.y, 100 * missed[0], 100 * missed[1], 100 * missed[2], 100 * found[0], 100 * found[1],
      100 * found[2]);
  EXPECT_EQ(inked_share(depth_alone, corner, corner + 1.0F), 0.0);
  EXPECT_EQ(inked_share(together, corner, corner + 1.0F), 1.0);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(missed[axis], 0.0);
    EXPECT_EQ(found[axis], 1.0);
  }
}

TEST_F(FigureClaims, depth_term_alone_draws_the_boxs_outline_against_the_room) {
  const Mask room = pixels_of(kRoom);
  const Mask not_room = without(Mask(room.width_px, room.height_px, 1, 1), room);
  const Mask beside_room = without(not_room, at_least_deep(depth_inside(not_room), 2));
  const Mask outline = both(pixels_of(kBox), beside_room);
  const double inked = share(ink(figure(8)), outline);
  fmt::print("depth alone inks {:.2f} % of the box's {} outline pixels against the room\n", 100 * inked,
             count(outline));
  EXPECT_GT(inked, 0.98);
}

TEST_F(FigureClaims, depth_term_draws_a_line_where_the_ear_covers_what_is_behind_it) {
  const Mask deep = at_least_deep(depth_inside(pixels_of(kRabbit)), 8);
  const Mask inner = both(ink(figure(8)), deep);
  fmt::print("depth alone inks {} pixels 8 px or more inside the rabbit, in {} pieces\n", count(inner),
             pieces(inner));
  EXPECT_GT(count(inner), 100U);
}

/// What the ink along the rabbit's outline is like.
struct OutlineInk {
  double gap_share = 0.0;
  int gaps = 0;
  Thickness thickness;
};

OutlineInk measure_outline(const std::string& name, const Mask& outline, const Mask& drawn) {
  const Mask bare = without(outline, drawn);
  const OutlineInk result{static_cast<double>(count(bare)) / static_cast<double>(count(outline)),
                          pieces(bare), thickness_at(drawn, outline)};
  fmt::print(
      "rabbit's outline, {} px, {}: {} px without ink ({:.2f} %) in {} gaps; thickness {:.2f} px, variation "
      "{:.3f}\n",
      count(outline), name, count(bare), 100 * result.gap_share, result.gaps, result.thickness.mean_px,
      result.thickness.variation);
  return result;
}

// The paper finds the normal term alone "splotty and inconsistent around the silhouette". In this scene it is
// uneven but leaves no gap, and cannot: at an outline the rabbit's normal stands across the view and that of
// the sphere's far wall faces it, so their difference is far over what k_normal asks for. docs/figures.md
// says so.
TEST_F(FigureClaims, normal_term_alone_leaves_the_outline_uneven_but_without_gaps) {
  const Mask outline = border_of(pixels_of(kRabbit));
  const OutlineInk depth = measure_outline("depth alone", outline, ink(figure(8)));
  const OutlineInk normal = measure_outline("normal alone", outline, ink(figure(10)));
  measure_outline("both", outline, ink(figure(1)));
  EXPECT_GT(normal.thickness.variation, 1.3 * depth.thickness.variation);
  EXPECT_LT(normal.gap_share, 0.005);
}

TEST_F(FigureClaims, depth_term_alone_leaves_a_gap_where_the_tail_runs_into_the_box) {
  const Mask outline = border_of(pixels_of(kRabbit));
  const OutlineInk depth = measure_outline("depth alone", outline, ink(figure(8)));
  const OutlineInk together = measure_outline("both", outline, ink(figure(1)));
  EXPECT_GT(depth.gap_share, 0.01);
  EXPECT_EQ(together.gaps, 0);
}

TEST_F(FigureClaims, both_terms_hold_the_outline_where_a_large_k_breaks_the_normal_term) {
  Settings normal = figure(10);
  Settings together = figure(1);
  normal.combine.k_normal = together.combine.k_normal = 0.15F;
  const Mask outline = border_of(pixels_of(kRabbit));
  EXPECT_GT(measure_outline("normal alone, k_normal = 0.15", outline, ink(normal)).gaps, 5);
  EXPECT_EQ(measure_outline("both, k_normal = 0.15", outline, ink(together)).gaps, 0);
}

TEST_F(FigureClaims, smaller_k_draws_more_lines) {
  for (const auto& [key, values] : std::map<std::string, std::array<float, 3>>{
           {"combine.k_depth", {0.005F, 0.003F, 0.001F}}, {"combine.k_normal", {0.025F, 0.0125F, 0.005F}}}) {
    size_t last = 0;
    for (const float k : values) {
      Settings settings = figure(1);
      find_param(settings, key, key).set(k, key);
      const size_t inked = count(ink(settings));
      fmt::print("{} = {}: {} px of ink, {:.2f} %\n", key, k, inked, 100.0 * inked / (1024 * 1024));
      EXPECT_GT(inked, last) << key << " = " << k;
      last = inked;
    }
  }
}

TEST_F(FigureClaims, ink_is_closed_around_the_rabbit) {
  const Settings settings = figure(1);
  ASSERT_EQ(settings.combine.k_depth, 0.003F);
  ASSERT_EQ(settings.combine.k_normal, 0.0125F);
  const Mask drawn = ink(settings);
  const Mask free = without(Mask(drawn.width_px, drawn.height_px, 1, 1), drawn);
  const ImageOf<int> depth = depth_inside(pixels_of(kRabbit));
  const Mask everywhere = flood(pixels_of(kRoom), Mask(drawn.width_px, drawn.height_px, 1, 1), 4);
  ASSERT_EQ(count(everywhere), everywhere.samples.size()) << "without ink nothing stops the flood";
  for (const int neighbours : {4, 8}) {
    const Mask reached = flood(pixels_of(kRoom), free, neighbours);
    int deepest = 0;
    for (size_t i = 0; i < reached.samples.size(); ++i) {
      if (reached.samples[i] != 0) deepest = std::max(deepest, depth.samples[i]);
    }
    fmt::print("from the room, over paper without ink, {} neighbours: reaches {} px into the rabbit\n",
               neighbours, deepest);
    EXPECT_LT(deepest, 6);
  }
}

TEST_F(FigureClaims, up_is_green) {
  const Settings settings = figure(5);
  const Image normal = raw(settings, BufferName::normal);
  const glm::vec2 top = project(settings, on_box(settings, {0.0F, 0.5F, 0.0F})).at_px;
  const glm::vec3 colour(normal.at(int(top.x), int(top.y), 0), normal.at(int(top.x), int(top.y), 1),
                         normal.at(int(top.x), int(top.y), 2));
  EXPECT_LT(glm::distance(colour, glm::vec3(0.5F, 1.0F, 0.5F)), 1e-5F) << "the box's upper side";
  const glm::vec3 corner = nearest_corner(settings);
  for (const glm::vec3 side : {glm::vec3(corner.x, 0, 0), glm::vec3(0, 0, corner.z)}) {
    const glm::vec2 at = project(settings, on_box(settings, side)).at_px;
    EXPECT_NEAR(normal.at(int(at.x), int(at.y), 1), 0.5F, 1e-5F)
        << "its upright sides are neither up nor down";
  }
  EXPECT_GT(normal.at(512, 1023, 1), normal.at(512, 0, 1))
      << "the inside-out sphere is greener below than above";
  EXPECT_GT(normal.at(512, 1023, 1), 0.5F);
}

TEST_F(FigureClaims, toon_light_has_few_levels_where_blinn_phong_has_many) {
  const Mask rabbit = pixels_of_object(raw(figure(4), BufferName::object_id), kRabbit);
  std::map<int, size_t> levels;
  for (const int number : {2, 4}) {
    const Picture shaded = pipeline().at(figure(number)).picture(BufferName::shaded);
    std::set<std::array<uint8_t, 3>> colours;
    for (size_t i = 0; i < rabbit.samples.size(); ++i) {
      if (rabbit.samples[i] != 0)
        colours.insert({shaded.samples[3 * i], shaded.samples[3 * i + 1], shaded.samples[3 * i + 2]});
    }
    levels[number] = colours.size();
  }
  fmt::print("distinct colours on the rabbit: Blinn-Phong {}, toon {}\n", levels[2], levels[4]);
  EXPECT_GT(levels[2], 200U);
  EXPECT_LE(levels[4], 8U) << "four steps of diffuse light times two of specular";
  EXPECT_GE(levels[4], 4U);
}

TEST_F(FigureClaims, lighting_ramp_rises_in_steps) {
  const Settings settings = figure(3);
  const Picture strip = pipeline().at(settings).picture(BufferName::shaded);
  std::vector<int> steps;
  for (int x = 0; x < strip.width_px; ++x) {
    const int value = strip.at(x, strip.height_px / 2);
    if (!steps.empty() && value < steps.back()) ADD_FAILURE() << "falls at " << x;
    if (steps.empty() || value != steps.back()) steps.push_back(value);
  }
  fmt::print("the ramp's steps: {}\n", fmt::join(steps, ", "));
  EXPECT_EQ(steps.size(), settings.ramp.diffuse.stops.size());
}

TEST_F(FigureClaims, receding_surfaces_have_a_depth_gradient_of_their_own) {
  const Settings settings = figure(7);
  const Image edges = raw(settings, BufferName::depth_edges);
  for (const auto& [name, id] :
       std::map<std::string, float>{{"rabbit", kRabbit}, {"box", kBox}, {"room", kRoom}}) {
    const Mask inside = at_least_deep(depth_inside(pixels_of(id)), 6);
    std::vector<float> values;
    for (size_t i = 0; i < inside.samples.size(); ++i) {
      if (inside.samples[i] != 0) values.push_back(edges.samples[i]);
    }
    std::sort(values.begin(), values.end());
    const float median = values[values.size() / 2];
    const auto zeros = std::count(values.begin(), values.end(), 0.0F);
    fmt::print(
        "depth gradient inside the {}: median {:.6f}, which x {} shows as {:.0f} of 255; {:.2f} % are 0\n",
        name, median, settings.display.depth_edges_gain, 255 * median * settings.display.depth_edges_gain,
        100.0 * zeros / values.size());
    EXPECT_GT(median * settings.display.depth_edges_gain * 255.0F, 1.0F) << name;
  }
}

// The paper reports points on the background sphere that are taken for edges. With float buffers there are
// none; with eight bits, which the paper may have used, the bands of the depth map make many.
TEST_F(FigureClaims, background_sphere_has_points_with_eight_bit_buffers_only) {
  const Mask background = at_least_deep(depth_inside(pixels_of(kRoom)), 8);
  std::map<std::string, size_t> inked;
  for (const char* precision : {"float", "unorm8"}) {
    Settings settings = figure(11);
    set_param_text(settings, "image.precision", precision, "");
    const Mask points = both(ink(settings), background);
    inked[precision] = count(points);
    fmt::print(
        "{} buffers: {} of {} pixels of the room, 8 px or more from all else, are inked ({:.2f} %), in {} "
        "pieces\n",
        precision, count(points), count(background), 100.0 * count(points) / count(background),
        pieces(points));
  }
  EXPECT_EQ(inked["float"], 0U);
  EXPECT_GT(inked["unorm8"], 100U);
}

}  // namespace
}  // namespace inkbench
