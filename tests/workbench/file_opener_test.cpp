// SPDX-License-Identifier: MIT
// Opening files: what each kind does to the document, who is handed the rest, what a bad file leaves alone.
#include "app/workbench/file_opener.h"

#include "app/workbench/presets.h"
#include "app/workbench/ramp_file.h"
#include "pipeline/export.h"
#include "pipeline/image/image_file.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class FileOpenerTest : public testing::Test {
 protected:
  fs::path presets() const { return folder_.path() / "presets"; }
  std::string problem() const {
    const auto found = problems_.all().find(ProblemKind::input);
    return found == problems_.all().end() ? "" : found->second;
  }
  fs::path scene(const std::string& name, float k_depth) const {
    Settings settings = paper_settings();
    settings.combine.k_depth = k_depth;
    return folder_.write(name, settings_text(settings));
  }

  TemporaryFolder folder_;
  MessageLog log_;
  Problems problems_{log_};
  Document document_{paper_settings(), project_file("data/scenes/paper.toml"), problems_};
  std::vector<fs::path> opened_;
  std::vector<std::string> meshes_, studies_;
  std::vector<BufferName> buffers_;
  FileOpener opener_{document_,
                     problems_,
                     presets(),
                     {.mesh = [this](const ModelParams& model,
                                     const std::shared_ptr<Mesh>&) { meshes_.push_back(model.mesh); },
                      .buffer = [this](BufferName buffer) { buffers_.push_back(buffer); },
                      .study = [this](const OpenedFile& file) { studies_.push_back(file.study->title); },
                      .opened = [this](const fs::path& file) { opened_.push_back(file); }}};
};

TEST_F(FileOpenerTest, a_preset_brings_its_marks_in_one_step_and_one_without_leaves_those_that_are_there) {
  const PaintedMarks mine{{{}, 2, 1, "wu"}}, others{{{}, 2, 1, "uW"}};
  const PresetStore store(presets());
  store.save("marked", paper_settings(), false, mine);
  store.save("plain", paper_settings());
  document_.set_marks(others, "paint");
  opener_.open(store.path_of("plain").string());
  EXPECT_TRUE(same_marks(document_.marks(), others));
  opener_.open(store.path_of("marked").string());
  EXPECT_TRUE(same_marks(document_.marks(), mine));
  document_.undo();
  EXPECT_TRUE(same_marks(document_.marks(), others));
}

TEST_F(FileOpenerTest, a_scene_has_no_marks_and_undo_brings_them_back) {
  const PaintedMarks mine{{{}, 2, 1, "wu"}};
  document_.set_marks(mine, "paint");
  opener_.open(scene("a.toml", 0.5F).string());
  EXPECT_TRUE(document_.marks().empty());
  document_.undo();
  EXPECT_TRUE(same_marks(document_.marks(), mine));
}

TEST_F(FileOpenerTest, a_scene_is_where_the_settings_come_from) {
  const fs::path file = scene("a.toml", 0.5F);
  opener_.open(file.string());
  EXPECT_EQ(document_.scene(), file);
  EXPECT_EQ(document_.settings().combine.k_depth, 0.5F);
  EXPECT_EQ(document_.baseline().combine.k_depth, 0.5F);
  EXPECT_THAT(document_.history().step_names(), ElementsAre("open a.toml"));
  EXPECT_THAT(opened_, ElementsAre(file));
}

TEST_F(FileOpenerTest, a_kept_preset_is_a_layer_on_the_scene) {
  Settings settings = paper_settings();
  settings.combine.k_depth = 0.5F;
  PresetStore(presets()).save("mine", settings);
  opener_.open((presets() / "mine.toml").string());
  EXPECT_EQ(document_.scene_name(), "paper.toml");
  EXPECT_NE(document_.baseline().combine.k_depth, 0.5F);
  EXPECT_EQ(document_.settings().combine.k_depth, 0.5F);
}

TEST_F(FileOpenerTest, the_same_preset_elsewhere_is_a_scene) {
  PresetStore(folder_.path() / "elsewhere").save("mine", paper_settings());
  opener_.open((folder_.path() / "elsewhere/mine.toml").string());
  EXPECT_EQ(document_.scene_name(), "mine.toml");
}

TEST_F(FileOpenerTest, an_exported_image_gives_its_settings_and_its_buffer) {
  Settings settings = paper_settings();
  settings.combine.k_depth = 0.5F;
  write_png(folder_.path() / "a.png", Picture(4, 4, 3), export_text(settings, BufferName::depth));
  opener_.open((folder_.path() / "a.png").string());
  EXPECT_EQ(document_.settings().combine.k_depth, 0.5F);
  EXPECT_EQ(document_.scene_name(), "a.png");
  EXPECT_EQ(document_.scene(), "") << "no file holds it as a scene";
  EXPECT_THAT(buffers_, ElementsAre(BufferName::depth));
}

TEST_F(FileOpenerTest, a_mesh_takes_the_main_models_place_and_is_handed_on) {
  const fs::path file = folder_.write("t.obj", kTriangle);
  opener_.open(file.string());
  Settings settings = document_.settings();
  EXPECT_EQ(main_model(settings).mesh, file);
  EXPECT_THAT(meshes_, ElementsAre(file.string()));
}

TEST_F(FileOpenerTest, a_mesh_that_cannot_be_read_changes_nothing) {
  opener_.open(folder_.write("t.obj", "f 1 2 3\n").string());
  EXPECT_THAT(problem(), HasSubstr("t.obj"));
  EXPECT_EQ(text(document_.settings()), text(paper_settings()));
  EXPECT_THAT(meshes_, IsEmpty());
  EXPECT_THAT(opened_, IsEmpty());
}

TEST_F(FileOpenerTest, a_ramp_becomes_the_diffuse_one_and_is_switched_on) {
  const Ramp ramp{{{0.25F, glm::vec3(1), true}}, ""};
  save_ramp(folder_.path() / "r.toml", ramp);
  opener_.open((folder_.path() / "r.toml").string());
  EXPECT_EQ(document_.settings().ramp.diffuse, ramp);
  EXPECT_TRUE(document_.settings().ramp.enabled);
}

TEST_F(FileOpenerTest, an_image_without_parameters_waits_for_an_answer) {
  const fs::path image = folder_.path() / "photo.png";
  write_png(image, Picture(8, 2, 3, 100), {});
  opener_.open_all({image, image, image});
  EXPECT_FALSE(document_.history().can_undo());
  EXPECT_THAT(opened_, IsEmpty());
  ASSERT_NE(opener_.asked(), nullptr);
  EXPECT_EQ(opener_.asked()->path, image);

  opener_.answer(ImageUse::nothing);
  EXPECT_FALSE(document_.history().can_undo());
  opener_.answer(ImageUse::specular_ramp);
  EXPECT_EQ(document_.settings().ramp.specular.image, image);
  EXPECT_EQ(document_.settings().ramp.diffuse, paper_settings().ramp.diffuse);
  opener_.answer(ImageUse::diffuse_ramp);
  EXPECT_EQ(document_.settings().ramp.diffuse.image, image);
  EXPECT_EQ(opener_.asked(), nullptr);
  EXPECT_THAT(document_.history().step_names(),
              ElementsAre("specular ramp from photo.png", "diffuse ramp from photo.png"));
  EXPECT_THAT(opened_, ElementsAre(image, image));
}

TEST_F(FileOpenerTest, a_study_leaves_the_document_alone) {
  const fs::path file =
      folder_.write("s.toml", "title = \"T\"\n[[axis]]\nkey = \"camera.fov\"\nvalues = [20, 30]\n");
  opener_.open(file.string());
  EXPECT_THAT(studies_, ElementsAre("T"));
  EXPECT_FALSE(document_.history().can_undo());
}

TEST_F(FileOpenerTest, of_several_files_the_bad_ones_are_told_and_the_others_opened) {
  const fs::path good = scene("good.toml", 0.5F);
  opener_.open_all({folder_.path() / "none.png", good.string(), folder_.write("diary", "dear diary\n")});
  EXPECT_THAT(problem(), AllOf(HasSubstr("none.png"), HasSubstr("diary")));
  EXPECT_EQ(document_.scene(), good);
}

TEST_F(FileOpenerTest, opening_well_dismisses_the_last_problem_and_opening_nothing_does_not) {
  opener_.open("/no/such/file");
  ASSERT_NE(problem(), "");
  opener_.open_all({});
  EXPECT_NE(problem(), "");
  opener_.open(scene("a.toml", 0.5F).string());
  EXPECT_EQ(problem(), "");
}

TEST_F(FileOpenerTest, a_held_slider_is_let_go_first) {
  save_ramp(folder_.path() / "r.toml", Ramp{{{0.25F, glm::vec3(1), true}}, ""});
  document_.begin_edit();
  document_.change("combine.k_depth", 0.25F);
  opener_.open((folder_.path() / "r.toml").string());
  EXPECT_FALSE(document_.is_editing());
  document_.undo();
  EXPECT_EQ(document_.settings().combine.k_depth, 0.25F) << "the ramp is a step of its own";
}

}  // namespace
}  // namespace inkbench
