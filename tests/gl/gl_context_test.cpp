// SPDX-License-Identifier: MIT
// What belongs to an OpenGL context: textures for reuse, which pipelines do not take from each other, and
// the empty vertex array. Targets that no renderer can draw into.
#include <gtest/gtest.h>

#include "pipeline/base/error.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/gl/gl_context.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/pipeline.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

class Pool : public testing::Test {
 protected:
  /// Draws frames in each of which every pass runs.
  void draw(Pipeline& pipeline, int frames) {
    for (int i = 0; i < frames; ++i) {
      settings_.camera.fov += 0.1F;
      pipeline.at(settings_).draw(BufferName::final);
    }
  }
  /// How many textures are made while two more frames are drawn.
  long made_by_frames_of(Pipeline& pipeline) {
    const long before = context_.textures().made_count();
    draw(pipeline, 2);
    return context_.textures().made_count() - before;
  }

  GlContext context_;  // of its own, whatever other tests left in the run's
  Settings settings_ = small_scene();
};

TEST_F(Pool, frames_of_one_size_make_textures_once) {
  Pipeline pipeline;
  EXPECT_GT(made_by_frames_of(pipeline), 5);
  EXPECT_EQ(made_by_frames_of(pipeline), 0);
}

TEST_F(Pool, a_pipeline_that_ends_leaves_the_others_textures_alone) {
  Pipeline kept;
  draw(kept, 2);
  {
    Pipeline other;
    draw(other, 2);
  }
  EXPECT_EQ(made_by_frames_of(kept), 0);
}

TEST_F(Pool, a_pipeline_that_forgets_leaves_the_others_textures_alone) {
  Pipeline kept;
  Pipeline other;
  draw(kept, 2);
  draw(other, 2);
  other.forget_results();
  EXPECT_EQ(made_by_frames_of(kept), 0);
}

TEST_F(Pool, a_pipeline_that_forgets_frees_all_that_it_made) {
  Pipeline kept;
  Pipeline other;
  draw(kept, 2);
  const long before = context_.textures().alive_count();
  draw(other, 2);
  other.at(settings_).picture(BufferName::final);
  other.at(settings_).picture_texture(BufferName::normal);
  other.at(settings_).value<GBufferPass>();
  EXPECT_GT(context_.textures().alive_count(), before);
  other.forget_results();
  EXPECT_EQ(context_.textures().alive_count(), before);
}

TEST_F(Pool, what_a_finished_pipeline_left_is_used_by_the_next_one) {
  {
    Pipeline pipeline;
    draw(pipeline, 2);
  }
  Pipeline next;
  EXPECT_EQ(made_by_frames_of(next), 0);
}

TEST_F(Pool, a_value_that_outlives_its_pipeline_is_anyones_when_it_goes) {
  std::shared_ptr<const GBuffer> held;
  {
    Pipeline pipeline;
    held = pipeline.at(settings_).value<GBufferPass>();
  }
  const GLuint id = held->object_id.id();
  const int width_px = held->object_id.width_px();
  const int height_px = held->object_id.height_px();
  held.reset();
  EXPECT_EQ(Texture("next", TextureFormat::r32f, width_px, height_px).id(), id);
}

TEST_F(Pool, textures_of_a_hundred_sizes_are_not_all_kept) {
  for (int size = 1; size <= 100; ++size) Texture("texture", TextureFormat::r8, size, size);
  EXPECT_EQ(context_.textures().made_count(), 100);
  EXPECT_LE(context_.textures().alive_count(), 12);
}

TEST_F(Pool, a_texture_goes_back_to_the_context_that_it_was_made_in) {
  std::optional<Texture> texture(std::in_place, "texture", TextureFormat::r8, 4, 4);
  {
    GlContext inner;
    texture.reset();
    EXPECT_EQ(inner.textures().alive_count(), 0);
  }
  const Texture again("again", TextureFormat::r8, 4, 4);
  EXPECT_EQ(context_.textures().made_count(), 1);
}

TEST(GlContextEnd, deletes_idle_textures_and_the_vertex_array) {
  GLuint texture = 0;
  GLuint vertex_array = 0;
  {
    const GlContext context;
    texture = Texture("texture", TextureFormat::r8, 4, 4).id();
    vertex_array = context.empty_vertex_array().id();
    EXPECT_TRUE(glIsTexture(texture) && glIsVertexArray(vertex_array)) << "kept until then";
  }
  EXPECT_FALSE(glIsTexture(texture));
  EXPECT_FALSE(glIsVertexArray(vertex_array));
}

TEST(RenderTargets, that_cannot_be_drawn_into_are_an_error_with_label_and_status) {
  const Texture depth("distances", TextureFormat::depth32f, 8, 8);
  try {
    const RenderTarget target({&depth}, nullptr);
    FAIL() << "a depth texture as a colour target";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::work);
    EXPECT_EQ(std::string(error.what()).find("distances: "), 0U) << error.what();
    EXPECT_NE(std::string(error.what()).find("GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT"), std::string::npos)
        << error.what();
  }
  throw_gl_errors("after it");
}

}  // namespace
}  // namespace inkbench
