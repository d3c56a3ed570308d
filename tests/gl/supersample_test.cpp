// SPDX-License-Identifier: MIT
// Supersampled pictures: the means of what is drawn larger, whatever the tiles, with lines as wide as before;
// and nothing else changes.
#include "pipeline/supersample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "pipeline/passes/ink/coverage.h"
#include "studies/judging/drawing_meter.h"
#include "tests/gl/checks.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

Settings supersampled_scene(int times, EdgeMethod method = EdgeMethod::dihedral) {
  Settings settings = analytic_scene();
  settings.image.supersample = times;
  settings.edges.method = method;
  return settings;
}

/// Means of `times` x `times` clamped samples as display values, 0 to 255.
Image mean_of(const Image& large, int times) {
  Image means(large.width_px / times, large.height_px / times, large.channels);
  for (int y = 0; y < large.height_px; ++y) {
    for (int x = 0; x < large.width_px; ++x) {
      for (int c = 0; c < large.channels; ++c) {
        means.at(x / times, y / times, c) +=
            255.0F * std::clamp(large.at(x, y, c), 0.0F, 1.0F) / static_cast<float>(times * times);
      }
    }
  }
  return means;
}

Image values_of(const Picture& picture, int channels) {
  Image values(picture.width_px, picture.height_px, channels);
  for (int y = 0; y < picture.height_px; ++y) {
    for (int x = 0; x < picture.width_px; ++x) {
      for (int c = 0; c < channels; ++c) values.at(x, y, c) = picture.at(x, y, c);
    }
  }
  return values;
}

Picture in_tiles(Pipeline& pipeline, const Settings& settings, BufferName buffer, int most_px) {
  pipeline.set_tile_px(most_px);
  return pipeline.at(settings).picture(buffer);
}

/// Pixels that differ by more than a display value.
int64_t differing(const Picture& a, const Picture& b) {
  EXPECT_EQ(a.samples.size(), b.samples.size());
  int64_t count = 0;
  for (size_t i = 0; i < a.samples.size(); ++i) count += std::abs(a.samples[i] - b.samples[i]) > 1;
  return count;
}

TEST(Supersample, picture_is_the_mean_of_the_larger_ones_display_values) {
  Pipeline pipeline;
  for (const EdgeMethod method : {EdgeMethod::paper, EdgeMethod::laplacian, EdgeMethod::dihedral}) {
    Settings settings = supersampled_scene(3, method);
    for (const BufferName buffer :
         {BufferName::shaded, BufferName::final, BufferName::blinn_phong, BufferName::coverage}) {
      const Image large = Pipeline().at(enlarged(settings, 3)).raw(buffer);
      const Image picture = values_of(pipeline.at(settings).picture(buffer), large.channels);
      EXPECT_TRUE(is_near(picture, mean_of(large, 3), 0.51)) << name_of(buffer);
    }
  }
}

TEST(Supersample, no_seam_shows_between_tiles_of_any_size) {
  Settings small = supersampled_scene(3);
  small.image.width = 100;
  small.image.height = 75;
  std::vector<Settings> drawn(5, small);
  drawn[1].edges.method = EdgeMethod::paper;
  drawn[2].line.width = 9.0F;  // by a flood
  drawn[3].line.unit = WidthUnit::world;
  drawn[3].line.width = 0.03F;
  drawn[3].line.depth_taper = 0.8F;
  drawn[4].camera.projection = CameraProjection::orthographic;
  drawn[4].line.unit = WidthUnit::percent;
  drawn[4].line.width = 1.0F;
  Pipeline pipeline;
  for (size_t i = 0; i < drawn.size(); ++i) {
    const Picture whole = in_tiles(pipeline, drawn[i], BufferName::final, 2048);
    for (const int most_px : {110, 170}) {
      EXPECT_GT(plan_tiles(drawn[i], BufferName::final, {3.0F, 12.0F}, most_px).tiles(drawn[i].image).size(),
                1U);
      EXPECT_EQ(differing(in_tiles(pipeline, drawn[i], BufferName::final, most_px), whole), 0)
          << "settings " << i << ", tiles of " << most_px << " px";
    }
  }
}

TEST(Supersample, part_of_an_image_is_drawn_as_the_whole_has_it_there) {
  for (const CameraProjection projection : {CameraProjection::perspective, CameraProjection::orthographic}) {
    Settings settings = analytic_scene();
    settings.camera.projection = projection;
    Pipeline pipeline;
    const ImageWindow part{37, 21, 70, 55, settings.image.width, settings.image.height, std::nullopt};
    for (const BufferName buffer : {BufferName::depth, BufferName::normal, BufferName::shaded}) {
      const Image drawn = Pipeline().at(settings, part).raw(buffer);
      const int top = settings.image.height - part.bottom - part.height;
      const Image expected = pipeline.at(settings).raw_part(buffer, part.left, top, part.width, part.height);
      EXPECT_TRUE(is_near(drawn, expected, 2e-3)) << name_of(buffer);  // slivers of triangles
    }
  }
}

TEST(Supersample, part_too_large_for_a_viewport_is_projected_by_itself) {
  const CameraParams camera = analytic_scene().camera;
  const ImageWindow part{20000, 3000, 2000, 1000, 40000, 30000, std::nullopt};
  EXPECT_EQ(projected_window(part, 40000).width, 40000);
  const ImageWindow projected = projected_window(part, 16384);
  EXPECT_EQ(projected.width, 2000);
  const glm::vec4 point(0.3F, -0.2F, -5.0F, 1.0F);
  const glm::vec4 in_whole = projection_matrix(camera, 4.0F / 3.0F) * point;
  const glm::vec4 in_part = projection_matrix(camera, projected) * point;
  EXPECT_NEAR((in_part.x / in_part.w + 1.0F) * 1000.0F + 20000.0F,
              (in_whole.x / in_whole.w + 1.0F) * 20000.0F, 0.05);
  EXPECT_NEAR((in_part.y / in_part.w + 1.0F) * 500.0F + 3000.0F, (in_whole.y / in_whole.w + 1.0F) * 15000.0F,
              0.05);
  EXPECT_EQ(in_part.z, in_whole.z);
  EXPECT_EQ(in_part.w, in_whole.w);
}

TEST(Supersample, lines_have_the_width_and_length_that_they_had) {
  Settings settings = supersampled_scene(1);
  settings.models.erase(settings.models.begin(), settings.models.begin() + 1);  // the floor's border is cut
  settings.line.width = 3.0F;
  settings.edges.min_length = 20.0F;
  settings.line.taper = 15.0F;
  const auto ink = [&](int times) {
    settings.image.supersample = times;
    const Picture picture = Pipeline().at(settings).picture(BufferName::coverage);
    double sum = 0;
    for (const uint8_t sample : picture.samples) sum += sample;
    return sum / 255.0 / picture.channels;
  };
  const double once = ink(1);
  EXPECT_GT(once, 500.0);
  for (const int times : {2, 4}) EXPECT_NEAR(ink(times) / once, 1.0, 0.05) << times;
}

/// What a line of 1.5 px covers of each pixel whose middle runs along a circle about the image's middle.
Image circle_coverage(int side_px, double radius_px) {
  constexpr int kSamples = 32;
  Image coverage(side_px, side_px, 1);
  for (int y = 0; y < side_px; ++y) {
    for (int x = 0; x < side_px; ++x) {
      int covered = 0;
      for (int s = 0; s < kSamples * kSamples; ++s) {
        const glm::dvec2 place(x + (s % kSamples + 0.5) / kSamples, y + (s / kSamples + 0.5) / kSamples);
        covered += std::abs(glm::length(place - 0.5 * side_px) - radius_px) <= 0.75 ? 1 : 0;
      }
      coverage.at(x, y) = static_cast<float>(covered) / (kSamples * kSamples);
    }
  }
  return coverage;
}

TEST(Supersample, twice_the_samples_halve_the_error_against_a_balls_exact_outline) {
  constexpr int kSide = 128;
  Settings settings;
  settings.image.width = settings.image.height = kSide;
  settings.models = {{.name = "ball", .shape = Shape::sphere, .segments = 256, .size = 2.0F}};
  settings.edges.method = EdgeMethod::dihedral;
  settings.line.antialias = false;
  settings.line.width = 1.5F;
  const double tangent = 1.0 / std::sqrt(24.0);  // of a ball of radius 1, 5 away
  const double radius_px = tangent / pixel_size(settings.camera, 1.0, kSide);
  std::vector<double> errors;
  for (const int times : {2, 4, 8}) {
    settings.image.supersample = times;
    Image drawn = values_of(Pipeline().at(settings).picture(BufferName::coverage), 1);
    for (float& value : drawn.samples) value /= 255.0F;
    // A step's line lies half a sample inside.
    errors.push_back(
        *tally_antialiasing(drawn, drawn, circle_coverage(kSide, radius_px - 0.5 / times)).drawn_rms());
  }
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(errors[i] / errors[i + 1], 2.0, 0.5);
  EXPECT_LT(errors[2], 0.03);
}

TEST(Supersample, error_is_of_the_picture_against_the_same_lines_at_size_one) {
  Pipeline pipeline;
  MeasureNeeds needs;
  needs.antialiasing = true;
  DrawingMeter meter(pipeline, needs);
  const Frame once = pipeline.at(supersampled_scene(1)), twice = pipeline.at(supersampled_scene(2));
  EXPECT_NE(meter.key(once), meter.key(twice));
  const auto of_once = meter.tally(once).antialiasing, of_twice = meter.tally(twice).antialiasing;
  EXPECT_EQ(of_once->pixels, of_twice->pixels);
  EXPECT_EQ(of_once->aliased_squares, of_twice->aliased_squares);
  Image drawn = values_of(twice.picture(BufferName::coverage), 1);
  for (float& value : drawn.samples) value /= 255.0F;
  const Image wanted = once.value<SampledCoverage>()->read(0, 1);
  EXPECT_EQ(of_twice->drawn_squares, tally_antialiasing(drawn, drawn, wanted).drawn_squares);
  EXPECT_NE(of_twice->drawn_squares, of_once->drawn_squares);
}

TEST(Supersample, changes_pictures_of_colours_and_nothing_else) {
  Pipeline pipeline;
  const Settings before = supersampled_scene(1), after = supersampled_scene(2);
  EXPECT_EQ(pipeline.at(before).pass_keys(), pipeline.at(after).pass_keys());
  EXPECT_NE(pipeline.at(before).key(), pipeline.at(after).key());
  for (const BufferName buffer : all_buffers()) {
    const bool follows = buffer.info().is_supersampled;
    EXPECT_EQ(pipeline.at(before).picture_key(buffer) != pipeline.at(after).picture_key(buffer), follows);
    if (buffer.info().shown_as == ShownAs::drawing) continue;
    EXPECT_EQ(pipeline.at(before).raw(buffer), pipeline.at(after).raw(buffer)) << name_of(buffer);
    EXPECT_EQ(pipeline.at(before).picture(buffer) == pipeline.at(after).picture(buffer), !follows)
        << name_of(buffer);
  }
}

TEST(Supersample, picture_leaves_what_the_frames_passes_hold) {
  Pipeline pipeline;
  const Settings settings = supersampled_scene(2);
  pipeline.at(settings).raw(BufferName::final);
  pipeline.at(settings).picture(BufferName::final);
  std::map<std::string, StageCount> before = pipeline.counts();
  pipeline.at(settings).raw(BufferName::final);
  for (const auto& [name, count] : pipeline.counts()) EXPECT_EQ(count.runs, before.at(name).runs) << name;
}

TEST(Supersample, texture_on_the_gpu_is_the_picture_and_is_kept) {
  Pipeline pipeline;
  const Settings settings = supersampled_scene(2);
  const PictureTexture first = pipeline.at(settings).picture_texture(BufferName::final);
  EXPECT_EQ(first.key, pipeline.at(settings).picture_key(BufferName::final));
  EXPECT_EQ(first.texture->read_picture(), pipeline.at(settings).picture(BufferName::final));
  const long runs = pipeline.counts().at("picture").runs;
  pipeline.at(settings).picture_texture(BufferName::final);
  EXPECT_EQ(pipeline.counts().at("picture").runs, runs);
}

TEST(Supersample, tiles_bound_what_is_drawn_at_once_at_any_size) {
  Settings settings = supersampled_scene(8);
  settings.image.width = settings.image.height = 4096;
  const TilePlan plan = plan_tiles(settings, BufferName::final, {1.0F, 10.0F}, 2048);
  int64_t pixels = 0;
  for (const ImageWindow& tile : plan.tiles(settings.image)) {
    const ImageWindow drawn = plan.drawn_for(tile);
    EXPECT_LE(std::max(drawn.width, drawn.height), 2048);
    pixels += int64_t{tile.width} * tile.height;
  }
  EXPECT_EQ(pixels, int64_t{4096} * 4096);
}

TEST(Supersample, what_needs_the_whole_image_says_so_where_that_is_too_large) {
  Settings settings = supersampled_scene(8);
  settings.image.width = settings.image.height = 16384;
  settings.edges.min_length = 5.0F;
  settings.models.clear();
  EXPECT_EQ(plan_tiles(settings, BufferName::final, {1.0F, 10.0F}, 2048).tiles(settings.image).size(), 1U);
  EXPECT_GT(plan_tiles(settings, BufferName::shaded, {1.0F, 10.0F}, 2048).tiles(settings.image).size(), 1U);
  Supersampler supersampler(std::make_shared<LineFinder>(), std::make_shared<MeshStore>());
  const std::string error = input_error_of([&] {
    supersampler.draw(settings, {1.0F, 10.0F}, {}, BufferName::final, {}, BoxFilterPass(generated_sources()),
                      2048);
  });
  EXPECT_NE(error.find("image.supersample"), std::string::npos) << error;
  EXPECT_NE(error.find("edges.min_length"), std::string::npos) << error;
}

}  // namespace
}  // namespace inkbench
