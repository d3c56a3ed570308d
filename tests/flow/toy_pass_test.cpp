// SPDX-License-Identifier: MIT
// A pass that only this file knows: one parameter, one buffer, one shader. Everything else finds it by
// itself.
#include <gtest/gtest.h>

#include <set>

#include "pipeline/export.h"
#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/params/glsl_block.h"
#include "pipeline/pass_list.h"
#include "pipeline/passes/ink/ink.h"
#include "pipeline/pipeline.h"
#include "pipeline/settings/params_table.h"
#include "pipeline/settings/settings_file.h"
#include "studies/sweep/run_study.h"
#include "tests/gl/scenes.h"
#include "tests/gl/shader_folder.h"

namespace inkbench {
namespace {

struct ToyParams {
  float strength = 0.5F;
  static const Description& description() {
    static const Description kDescription{
        "toy",
        "A toy",
        {field<&ToyParams::strength>(
            {.name = "strength", .help = "How much of the picture.", .limits = {0, 1}})}};
    return kDescription;
  }
};

constexpr BufferInfo kToyInfo{
    .name = "toy", .help = "The picture, weaker.", .channels = 3, .shown_as = ShownAs::colour};
constexpr BufferName kToy{kToyInfo};
constexpr BufferInfo kTrailInfo{.name = "trail",
                                .help = "The mean of this frame and of those before.",
                                .channels = 3,
                                .shown_as = ShownAs::colour};
constexpr BufferName kTrail{kTrailInfo};

class ToyPass {
 public:
  using Value = Texture;
  static const PassKind& kind() {
    static const PassKind kKind = [] {
      PassKind made =
          describe_pass<ToyPass>("toy", 1, {shows(kToy)}, brought<ToyParams>(), value_of<InkPass>());
      made.bring = BroughtGroups::bring<ToyParams>;
      return made;
    }();
    return kKind;
  }
  explicit ToyPass(const GeneratedSources& generated)
      : program_("full_screen.vert", "toy.frag",
                 {.samplers = {"final_map"}, .uniform_blocks = {block_of(ToyParams::description())}},
                 generated) {}
  Texture run(const ToyParams& params, const Texture& final) const {
    Texture result("toy", TextureFormat::rgba32f, final.width_px(), final.height_px());
    const RenderTarget target({&result}, nullptr);
    const Buffer uniforms("toy block", pack_std140(ToyParams::description(), &params));
    program_.use();
    bind_uniform_blocks({&uniforms});
    bind_textures({&final});
    draw_full_screen();
    return result;
  }
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

/// Reads its own value in the frame before.
class TrailPass {
 public:
  using Value = Texture;
  static const PassKind& kind() {
    static const PassKind kKind = describe_pass<TrailPass>("trail", 1, {shows(kTrail)}, value_of<ToyPass>(),
                                                           past_value_of<TrailPass>());
    return kKind;
  }
  explicit TrailPass(const GeneratedSources& generated)
      : program_("full_screen.vert", "trail.frag", {.samplers = {"now_map", "before_map"}}, generated) {}
  Texture run(const Texture& now, const Texture* before) const {
    Texture result("trail", TextureFormat::rgba32f, now.width_px(), now.height_px());
    const RenderTarget target({&result}, nullptr);
    program_.use();
    bind_textures({&now, before != nullptr ? before : &now});
    draw_full_screen();
    return result;
  }
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

constexpr const char* kToyShader = R"(#version 450 core
#include "generated/toy.glsl"
uniform sampler2D final_map;
layout(location = 0) out vec4 colour;
void main() {
  colour = texelFetch(final_map, ivec2(gl_FragCoord.xy), 0) * toy.strength;
}
)";

constexpr const char* kTrailShader = R"(#version 450 core
uniform sampler2D now_map;
uniform sampler2D before_map;
layout(location = 0) out vec4 colour;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  colour = 0.5 * (texelFetch(now_map, at, 0) + texelFetch(before_map, at, 0));
}
)";

using Names = std::set<std::string>;

class ToyPassTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    add_pass(ToyPass::kind());
    add_pass(TrailPass::kind());
  }
  ToyPassTest() {
    shaders_.write("toy.frag", kToyShader);
    shaders_.write("trail.frag", kTrailShader);
    pipeline_.emplace();
  }
  /// The passes that ran while the action did.
  Names ran(const std::function<void()>& action) {
    const std::map<std::string, StageCount> before = pipeline_->counts();
    action();
    Names names;
    for (const auto& [name, count] : pipeline_->counts()) {
      if (count.runs != before.at(name).runs) names.insert(name);
    }
    return names;
  }
  static Settings with_strength(float strength) {
    Settings settings = small_scene();
    settings.brought.get<ToyParams>().strength = strength;
    return settings;
  }

  ShaderFolder shaders_;
  std::optional<Pipeline> pipeline_;
};

double sum_of(const Image& image) {
  double sum = 0;
  for (const float sample : image.samples) sum += sample;
  return sum;
}

TEST_F(ToyPassTest, is_a_parameter_in_tables_files_and_assignments) {
  EXPECT_NE(params_table(TableFormat::text).find("toy.strength = 0.5"), std::string::npos);
  Settings settings = small_scene();
  apply_assignment(settings, "toy.strength=0.25");
  EXPECT_EQ(settings.brought.get<ToyParams>().strength, 0.25F);
  const Settings again = parse_settings(settings_text(settings), "text", "/");
  EXPECT_EQ(again.brought.get<ToyParams>().strength, 0.25F);
  EXPECT_EQ(small_scene().brought.get<ToyParams>().strength, 0.5F) << "others keep their own value";
}

TEST_F(ToyPassTest, is_a_buffer_after_those_with_number_keys) {
  EXPECT_EQ(parse_buffers({"toy"}, "here"), std::vector{kToy});
  EXPECT_EQ(all_buffers().front(), BufferName::normal);
  EXPECT_TRUE(buffer_list().ends_with(", toy, trail")) << buffer_list();
}

TEST_F(ToyPassTest, is_drawn_shown_and_exported) {
  const Frame frame = pipeline_->at(with_strength(0.5F));
  const Image final = frame.raw(BufferName::final);
  const Image toy = frame.raw(kToy);
  ASSERT_EQ(toy.channels, 3);
  EXPECT_NEAR(sum_of(toy), 0.5 * sum_of(final), 1e-3 * sum_of(final));
  EXPECT_EQ(frame.picture_texture(kToy).texture->read_picture(), frame.picture(kToy));
  TempFolder folder;
  write_buffer(frame, kToy, folder.path() / "toy.png");
  EXPECT_EQ(read_origin(folder.path() / "toy.png").buffer, kToy);
}

TEST_F(ToyPassTest, is_counted_and_runs_only_where_its_inputs_changed) {
  pipeline_->at(with_strength(0.5F)).draw(kToy);
  EXPECT_EQ(ran([&] { pipeline_->at(with_strength(0.5F)).draw(kToy); }), Names{});
  EXPECT_EQ(ran([&] { pipeline_->at(with_strength(0.75F)).draw(kToy); }), Names{"toy"});
  Settings inked = with_strength(0.75F);
  inked.ink.colour.x = 0.5F;
  EXPECT_EQ(ran([&] { pipeline_->at(inked).draw(kToy); }), (Names{"ink", "toy"}));
  pipeline_->forget_results();
  EXPECT_TRUE(ran([&] { pipeline_->at(inked).draw(kToy); }).contains("toy"));
}

TEST_F(ToyPassTest, is_timed) {
  struct Watch : PassObserver {
    Names names;
    void begin_pass(std::string_view name) override { names.emplace(name); }
    void end_pass() override {}
  } watch;
  pipeline_->observe(&watch);
  pipeline_->at(with_strength(0.5F)).draw(kToy);
  pipeline_->observe(nullptr);
  EXPECT_TRUE(watch.names.contains("toy"));
  const std::vector<std::string> names = pipeline_->pass_names();
  EXPECT_EQ(std::count(names.begin(), names.end(), "toy"), 1) << "the window's timings list it";
}

TEST_F(ToyPassTest, is_reloaded_when_its_shader_is_edited) {
  const double before = sum_of(pipeline_->at(with_strength(0.5F)).raw(kToy));
  shaders_.edit("toy.frag", "* toy.strength", "* 0.5 * toy.strength");
  EXPECT_TRUE(pipeline_->reload_changed_shaders());
  EXPECT_EQ(ran([&] {
              EXPECT_NEAR(sum_of(pipeline_->at(with_strength(0.5F)).raw(kToy)), before / 2, 1e-3 * before);
            }),
            Names{"toy"});
  shaders_.edit("toy.frag", "void main", "broken void main");
  EXPECT_NE(input_error_of([&] { pipeline_->reload_changed_shaders(); }).find("shaders/toy.frag"),
            std::string::npos);
  EXPECT_NE(pipeline_->shader_problem().find("shaders/toy.frag"), std::string::npos);
}

StudySpec toy_study(const std::string& more) {
  return parse_spec("title = \"toys\"\nshow = [\"toy\"]\n[set]\nimage.width = 24\nimage.height = 16\n" + more,
                    fs::absolute("toys.toml"), {});
}

TEST_F(ToyPassTest, is_swept_innermost_where_it_is_the_cheapest) {
  const StudySpec spec = toy_study(
      "[[axis]]\nkey = \"combine.k_normal\"\nvalues = [0.01, 0.02]\n"
      "[[axis]]\nkey = \"toy.strength\"\nvalues = [0.25, 0.5, 1]\n");
  const std::vector<CellView> order = run_order(*pipeline_, spec);
  ASSERT_EQ(order.size(), 6U);
  EXPECT_EQ(make_cell(spec, order[0].cell).row, 0);
  EXPECT_EQ(make_cell(spec, order[1].cell).row, 1) << "the next cell has the next strength";
  EXPECT_EQ(make_cell(spec, order[2].cell).row, 2);
  EXPECT_EQ(make_cell(spec, order[3].cell).column, 1);
}

TEST_F(ToyPassTest, is_part_of_a_cells_key) {
  TempFolder folder;
  const auto drawn = [&] {
    return run_study(*pipeline_, toy_study("[[axis]]\nkey = \"combine.k_normal\"\nvalues = [0.01, 0.02]\n"),
                     {.folder = folder.path() / "study"})
        .progress.drawn;
  };
  EXPECT_EQ(drawn(), 2U);
  EXPECT_EQ(drawn(), 0U);
  shaders_.edit("toy.frag", "* toy.strength", "* 0.5 * toy.strength");
  pipeline_->reload_changed_shaders();
  EXPECT_EQ(drawn(), 2U) << "an edited shader of the pass makes the cells other ones";
}

TEST_F(ToyPassTest, of_which_one_sees_the_frame_before) {
  const Frame first = pipeline_->at(with_strength(1.0F));
  const double full = sum_of(first.raw(kTrail));
  const Frame second = pipeline_->at(with_strength(0.5F), first);
  EXPECT_NEAR(sum_of(second.raw(kTrail)), 0.75 * full, 1e-3 * full);
  EXPECT_NE(second.key(kTrail), pipeline_->at(with_strength(0.5F)).key(kTrail)) << "its key folds the past";
  EXPECT_EQ(second.key(kToy), pipeline_->at(with_strength(0.5F)).key(kToy));
  const Frame third = pipeline_->at(with_strength(0.5F), second);
  EXPECT_NEAR(sum_of(third.raw(kTrail)), 0.625 * full, 1e-3 * full);
}

TEST_F(ToyPassTest, past_values_that_nothing_holds_are_made_again) {
  const Frame first = pipeline_->at(with_strength(1.0F));
  const Frame second = pipeline_->at(with_strength(0.5F), first);
  const Image drawn_in_order = second.raw(kTrail);
  pipeline_->forget_results();
  EXPECT_TRUE(second.raw(kTrail) == drawn_in_order);
}

TEST_F(ToyPassTest, a_long_chain_of_frames_is_let_go) {
  auto frame = std::make_unique<Frame>(pipeline_->at(with_strength(1.0F)));
  for (int i = 0; i < 20000; ++i) frame = std::make_unique<Frame>(pipeline_->at(with_strength(1.0F), *frame));
  frame.reset();
}

}  // namespace
}  // namespace inkbench
