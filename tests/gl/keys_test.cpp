// SPDX-License-Identifier: MIT
// What runs again after a change: what lies downstream of it and nothing else.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"
#include "tests/gl/scenes.h"
#include "tests/written_gltf.h"

namespace inkbench {
namespace {

using Names = std::set<std::string>;

const Names kFloatChain{"gbuffer", "gradient", "range", "combine", "shade", "ink"};

Names with_meshes(Names names) {
  names.insert("meshes");
  return names;
}

/// The passes that ran while the action did.
Names passes_run_by(const Pipeline& pipeline, const std::function<void()>& action) {
  const std::map<std::string, StageCount> before = pipeline.counts();
  action();
  Names names;
  for (const auto& [name, count] : pipeline.counts()) {
    if (count.runs != before.at(name).runs) names.insert(name);
    EXPECT_LE(count.runs, before.at(name).runs + 1) << name << " ran more than once";
  }
  return names;
}

/// The passes that a final image needs again after `change`.
Names passes_after(const std::function<void(Settings&)>& change) {
  Settings settings = small_scene();
  Pipeline pipeline;
  pipeline.at(settings).draw(BufferName::final);
  change(settings);
  return passes_run_by(pipeline, [&] { pipeline.at(settings).draw(BufferName::final); });
}

TEST(Keys, unchanged_settings_run_nothing) {
  EXPECT_EQ(passes_after([](Settings&) {}), Names{});
}

TEST(Keys, combine_parameters_run_combine_and_ink) {
  const Names expected{"combine", "ink"};
  EXPECT_EQ(passes_after([](Settings& s) { s.combine.k_depth *= 2.0F; }), expected);
  EXPECT_EQ(passes_after([](Settings& s) { s.combine.k_normal *= 2.0F; }), expected);
  EXPECT_EQ(passes_after([](Settings& s) { s.combine.threshold = 0.5F; }), expected);
  EXPECT_EQ(passes_after([](Settings& s) { s.combine.use_depth = false; }), expected);
  EXPECT_EQ(passes_after([](Settings& s) { s.combine.use_normal = false; }), expected);
}

TEST(Keys, ramps_lights_and_materials_run_no_edge_pass) {
  const Names expected{"shade", "ink"};
  EXPECT_EQ(passes_after([](Settings& s) { s.ramp.enabled = false; }), expected);
  EXPECT_EQ(passes_after([](Settings& s) { s.ramp.diffuse.stops[1].position = 0.3F; }), expected);
  EXPECT_EQ(passes_after([](Settings& s) { s.ramp.specular.stops[1].colour.y = 0.5F; }), expected);
  EXPECT_EQ(passes_after([](Settings& s) { s.lights[0].diffuse.x = 0.5F; }), expected);
  EXPECT_EQ(passes_after([](Settings& s) { s.lights.push_back({.name = "second"}); }), expected);
  EXPECT_EQ(passes_after([](Settings& s) { s.lights.clear(); }), expected);
  EXPECT_EQ(passes_after([](Settings& s) { s.models[0].material.exponent = 5.0F; }), expected);
  EXPECT_EQ(passes_after([](Settings& s) { s.scene.background = {0.1F, 0.2F, 0.3F}; }), expected);
}

TEST(Keys, ink_colour_runs_ink) {
  EXPECT_EQ(passes_after([](Settings& s) { s.ink.colour.x = 0.5F; }), Names{"ink"});
}

TEST(Keys, camera_models_and_size_run_everything) {
  EXPECT_EQ(passes_after([](Settings& s) { s.camera.eye.x = 0.5F; }), kFloatChain);
  EXPECT_EQ(passes_after([](Settings& s) { s.models[0].position.x = 0.5F; }), kFloatChain);
  EXPECT_EQ(passes_after([](Settings& s) { s.models[0].segments = 12; }), with_meshes(kFloatChain));
  EXPECT_EQ(passes_after([](Settings& s) { s.models[0].visible = false; }), with_meshes(kFloatChain));
  EXPECT_EQ(passes_after([](Settings& s) { s.image.width += 1; }), kFloatChain);
  EXPECT_EQ(passes_after([](Settings& s) { s.image.height += 1; }), kFloatChain);
}

TEST(Keys, precision_keeps_the_gbuffer_and_the_shading) {
  EXPECT_EQ(passes_after([](Settings& s) { s.image.precision = Precision::unorm8; }),
            (Names{"quantise", "gradient", "range", "combine", "ink"}));
}

TEST(Keys, display_gains_run_no_pass) {
  EXPECT_EQ(passes_after([](Settings& s) { s.display = {2.0F, 3.0F, 4.0F}; }), Names{});
  Settings settings = small_scene();
  Pipeline pipeline;
  const Picture before = pipeline.at(settings).picture(BufferName::depth);
  settings.display.depth_gain = 2.0F;
  Picture after;
  EXPECT_EQ(passes_run_by(pipeline, [&] { after = pipeline.at(settings).picture(BufferName::depth); }),
            Names{});
  EXPECT_FALSE(before == after);
}

TEST(Keys, placing_width_and_look_are_steps_of_their_own) {
  Settings settings = small_scene();
  settings.edges.method = EdgeMethod::laplacian;
  const auto passes = [&](const std::function<void(Settings&)>& change) {
    Pipeline pipeline;
    pipeline.at(settings).raw(BufferName::final);
    Settings changed = settings;
    change(changed);
    return passes_run_by(pipeline, [&] { pipeline.at(changed).raw(BufferName::final); });
  };
  EXPECT_EQ(passes([](Settings& s) { s.laplacian.bend *= 2.0F; }),
            (Names{"laplacian", "edge_tiles", "edge_class", "candidates", "place", "line_tiles", "line_bits",
                   "narrow_coverage", "ink"}));
  EXPECT_EQ(passes([](Settings& s) { s.edges.min_length = 5.0F; }),
            (Names{"connect", "line_tiles", "line_bits", "narrow_coverage", "ink"}));
  EXPECT_EQ(passes([](Settings& s) { s.line.width = 3.0F; }), (Names{"narrow_coverage", "ink"}));
  EXPECT_EQ(passes([](Settings& s) { s.line.width = 5.0F; }), (Names{"seeds", "flood", "coverage", "ink"}));
  EXPECT_EQ(passes([](Settings& s) { s.line.antialias = false; }), (Names{"narrow_coverage", "ink"}));
  EXPECT_EQ(passes([](Settings& s) { s.class_looks[0].opacity = 0.5F; }), (Names{"ink"}));
  EXPECT_EQ(passes([](Settings& s) { s.class_looks[0].colour.x = 0.5F; }), Names{}) << "colours are off";
  EXPECT_EQ(passes([](Settings& s) { s.combine.k_depth *= 2.0F; }), Names{}) << "another method's";
}

TEST(Keys, a_strokes_course_width_paint_and_colour_are_steps_of_their_own) {
  Settings settings = small_scene();
  settings.ink.from = InkFrom::strokes;
  const auto passes = [&](const std::function<void(Settings&)>& change) {
    Pipeline pipeline;
    pipeline.at(settings).raw(BufferName::final);
    Settings changed = settings;
    change(changed);
    return passes_run_by(pipeline, [&] { pipeline.at(changed).raw(BufferName::final); });
  };
  const Names coloured{"stroke_colours", "strokes_over"};
  Names painted = coloured, stroked;
  painted.insert("stroke_paint");
  stroked = painted;
  stroked.insert("strokes");
  EXPECT_EQ(passes([](Settings& s) { s.ink.colour.x = 0.5F; }), coloured);
  EXPECT_EQ(passes([](Settings& s) { s.stroke.opacity = 0.5F; }), coloured);
  EXPECT_EQ(passes([](Settings& s) { s.stroke.brush = Brush::pencil; }), painted);
  EXPECT_EQ(passes([](Settings& s) { s.stroke.width = 5.0F; }), stroked);
  EXPECT_EQ(passes([](Settings& s) { s.stroke.grain = 0.1F; }), Names{}) << "a solid brush has none";
  EXPECT_EQ(passes([](Settings& s) { s.combine.k_depth *= 2.0F; }), Names{}) << "the filter's";
}

TEST(Keys, the_papers_method_has_nothing_to_do_with_the_others_parameters) {
  EXPECT_EQ(passes_after([](Settings& s) {
              s.line.width = 4.0F;
              s.laplacian.bend = 3.0F;
              s.edges.min_length = 9.0F;
              s.class_looks[1].opacity = 0.1F;
            }),
            Names{});
}

TEST(Keys, each_buffer_alone_computes_only_what_it_needs) {
  const std::map<BufferName, Names> needs{
      {BufferName::normal, {"meshes", "gbuffer"}},
      {BufferName::depth, {"meshes", "gbuffer"}},
      {BufferName::object_id, {"meshes", "gbuffer"}},
      {BufferName::normal_edges, {"meshes", "gbuffer", "gradient"}},
      {BufferName::depth_edges, {"meshes", "gbuffer", "gradient"}},
      {BufferName::combined_edges, {"meshes", "gbuffer", "gradient", "range", "combine"}},
      {BufferName::lines, {"meshes", "gbuffer", "gradient", "range", "combine", "lines"}},
      {BufferName::coverage, {"meshes", "gbuffer", "gradient", "range", "combine", "lines"}},
      {BufferName::edge_strength, {"meshes", "gbuffer", "gradient", "range", "paper_strength"}},
      {BufferName::edge_class,
       {"meshes", "gbuffer", "gradient", "range", "paper_strength", "edge_tiles", "edge_class"}},
      {BufferName::motion, {"meshes", "gbuffer", "motion"}},
      {BufferName::visible_depth, {"meshes", "gbuffer", "visible_range", "visible_depth"}},
      {BufferName::albedo, {"meshes", "gbuffer", "albedo"}},
      {BufferName::material_id, {"meshes", "gbuffer", "albedo"}},
      {BufferName::pair_angles, {"meshes", "gbuffer", "pairs"}},
      {BufferName::pair_gaps, {"meshes", "gbuffer", "pairs"}},
      {BufferName::shaded, {"meshes", "gbuffer", "shade"}},
      {BufferName::blinn_phong, {"meshes", "gbuffer", "blinn_phong"}},
      {BufferName::curves,
       {"meshes", "object_curves", "curves", "curve_lines", "curve_paint", "curve_colours"}},
      {BufferName::strokes,
       {"meshes", "object_curves", "curves", "strokes", "stroke_paint", "stroke_colours"}},
      {BufferName::final, with_meshes(kFloatChain)}};
  ASSERT_EQ(needs.size(), framebuffers().size());
  for (const auto& [buffer, expected] : needs) {
    Pipeline pipeline;
    EXPECT_EQ(passes_run_by(pipeline, [&, buffer = buffer] { pipeline.at(small_scene()).raw(buffer); }),
              expected)
        << name_of(buffer);
  }
}

TEST(Keys, all_buffers_together_run_each_pass_once) {
  Pipeline pipeline;
  Names expected = with_meshes(kFloatChain);
  expected.insert({"blinn_phong", "lines", "paper_strength", "edge_tiles", "edge_class", "motion",
                   "visible_range", "visible_depth", "albedo", "pairs", "object_curves", "curves",
                   "curve_lines", "curve_paint", "curve_colours", "strokes", "stroke_paint",
                   "stroke_colours"});
  EXPECT_EQ(passes_run_by(pipeline,
                          [&] {
                            for (const BufferName buffer : framebuffers())
                              pipeline.at(small_scene()).raw(buffer);
                          }),
            expected);
}

TEST(Keys, a_rewritten_mesh_file_runs_everything) {
  TempFolder folder;
  Settings settings = small_scene();
  settings.models[0].shape = Shape::mesh;
  settings.models[0].mesh = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").string();
  Pipeline pipeline;
  const Image before = pipeline.at(settings).raw(BufferName::final);
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  Image after;
  EXPECT_EQ(passes_run_by(pipeline, [&] { after = pipeline.at(settings).raw(BufferName::final); }),
            with_meshes(kFloatChain));
  EXPECT_FALSE(before == after);
}

TEST(Keys, a_failed_draw_leaves_the_pipeline_usable) {
  Settings settings = small_scene();
  Pipeline pipeline;
  const Image before = pipeline.at(settings).raw(BufferName::final);
  Settings broken = settings;
  broken.models[0].shape = Shape::mesh;
  broken.models[0].mesh = "/nowhere/mesh.obj";
  EXPECT_NE(input_error_of([&] { pipeline.at(broken).raw(BufferName::final); }).find("/nowhere/mesh.obj"),
            std::string::npos);
  broken = settings;
  broken.camera.target = broken.camera.eye;
  EXPECT_NE(input_error_of([&] { pipeline.at(broken).raw(BufferName::final); }).find("camera.eye"),
            std::string::npos);
  EXPECT_TRUE(is_near(pipeline.at(settings).raw(BufferName::final), before, 0.0));
}

TEST(Keys, the_buffer_of_a_gltf_decides_its_mesh) {
  const TempFolder folder;
  Settings settings = small_scene();
  settings.models[0].shape = Shape::mesh;
  settings.models[0].mesh = write_gltf(folder.path()).string();
  Pipeline pipeline;
  const std::string before = pipeline.at(settings).key(BufferName::final).text();
  EXPECT_EQ(pipeline.at(settings).key(BufferName::final).text(), before);
  std::filesystem::resize_file(folder.path() / "square.bin", 61);
  EXPECT_NE(pipeline.at(settings).key(BufferName::final).text(), before);
}

}  // namespace
}  // namespace inkbench
