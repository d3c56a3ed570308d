// SPDX-License-Identifier: MIT
// No pass depends on OpenGL state that someone else left, such as a window's toolkit between two frames.
#include <gtest/gtest.h>

#include <epoxy/gl.h>

#include "pipeline/gl/gl_context.h"
#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

/// Draws with the state in force, and compares with a drawing before it.
void expect_same_with(const std::function<void()>& set_state, const std::function<void()>& restore) {
  const Settings settings = small_scene();
  const Image normal = Pipeline().at(settings).raw(BufferName::normal);
  const Image final = Pipeline().at(settings).raw(BufferName::final);
  Pipeline pipeline;
  set_state();
  EXPECT_TRUE(is_near(pipeline.at(settings).raw(BufferName::normal), normal, 0.0));
  EXPECT_TRUE(is_near(pipeline.at(settings).raw(BufferName::final), final, 0.0));
  restore();
  throw_gl_errors("test");
}

TEST(GlState, blending_does_not_matter) {
  expect_same_with(
      [] {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
      },
      [] {
        glDisable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ZERO);
      });
}

TEST(GlState, culling_does_not_matter) {
  expect_same_with(
      [] {
        glEnable(GL_CULL_FACE);
        glCullFace(GL_FRONT_AND_BACK);
      },
      [] {
        glDisable(GL_CULL_FACE);
        glCullFace(GL_BACK);
      });
}

TEST(GlState, scissor_and_viewport_do_not_matter) {
  expect_same_with(
      [] {
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 3, 3);
        glViewport(1, 1, 2, 2);
      },
      [] { glDisable(GL_SCISSOR_TEST); });
}

TEST(GlState, depth_state_does_not_matter) {
  expect_same_with(
      [] {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_NEVER);
        glDepthMask(GL_FALSE);
      },
      [] {
        glDisable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        glDepthMask(GL_TRUE);
      });
}

TEST(GlState, bound_program_textures_and_samplers_do_not_matter) {
  GLuint sampler = 0;
  GLuint texture = 0;
  expect_same_with(
      [&] {
        glCreateSamplers(1, &sampler);
        glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glCreateTextures(GL_TEXTURE_2D, 1, &texture);
        glTextureStorage2D(texture, 1, GL_RGBA8, 5, 5);
        for (GLuint unit = 0; unit < 4; ++unit) {
          glBindSampler(unit, sampler);
          glBindTextureUnit(unit, texture);
        }
        glUseProgram(0);
        glPixelStorei(GL_PACK_ALIGNMENT, 8);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
      },
      [&] {
        for (GLuint unit = 0; unit < 4; ++unit) glBindSampler(unit, 0);
        glDeleteSamplers(1, &sampler);
        glDeleteTextures(1, &texture);
      });
}

TEST(GlState, colour_mask_and_polygon_mode_do_not_matter) {
  expect_same_with(
      [] {
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
      },
      [] {
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
      });
}

TEST(GlState, deleted_programs_are_not_left_current) {
  const auto current = [] {
    GLint program = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    return program;
  };
  {
    Pipeline pipeline;
    pipeline.at(small_scene()).draw(BufferName::final);
    EXPECT_NE(current(), 0) << "a pass leaves its program";
  }
  EXPECT_EQ(current(), 0);
}

}  // namespace
}  // namespace inkbench
