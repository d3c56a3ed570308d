// SPDX-License-Identifier: MIT
// Short names of keys and values, and paths in data.csv.
#include "studies/sweep/labels.h"

#include <gmock/gmock.h>

#include "pipeline/mesh/formats/mesh_file.h"
#include "studies/report/chart_text.h"
#include "studies/sweep/data_columns.h"
#include "studies/sweep/study_grid.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using testing::ElementsAre;

std::vector<std::string> labels_of(const std::vector<Value>& values) {
  return label_texts(values);
}

Value text(const char* value) {
  return std::string(value);
}

TEST(Labels, files_of_one_name_are_told_apart_by_the_folders_that_differ) {
  EXPECT_THAT(labels_of({text("/m/part.obj"), text("/m/sub/part.obj"), text("/m/hare.obj")}),
              ElementsAre("m/part.obj", "sub/part.obj", "hare.obj"));
  EXPECT_THAT(labels_of({text("/a/x/y/part.obj"), text("/b/x/y/part.obj")}),
              ElementsAre("a/x/y/part.obj", "b/x/y/part.obj"));
  EXPECT_THAT(labels_of({text("/y/part.obj"), text("/x/y/part.obj")}),
              ElementsAre("y/part.obj", "x/y/part.obj"));
}

TEST(Labels, numbers_that_look_alike_get_more_digits) {
  EXPECT_THAT(labels_of({1.00001F, 1.00002F, 2.5F}), ElementsAre("1.00001", "1.00002", "2.5"));
  EXPECT_THAT(labels_of({glm::vec3(1, 0, 1.00001F), glm::vec3(1, 0, 1)}),
              ElementsAre("1, 0, 1.00001", "1, 0, 1"));
}

TEST(Labels, ramps_of_as_many_stops_are_numbered) {
  const Ramp dark{{{0, glm::vec3(0), true}, {0.5F, glm::vec3(0.5F), true}}, ""};
  const Ramp light{{{0, glm::vec3(0.5F), true}, {0.5F, glm::vec3(1), true}}, ""};
  const Ramp three{{{}, {}, {}}, ""};
  EXPECT_THAT(labels_of({dark, light, three, dark}),
              ElementsAre("2 stops (1)", "2 stops (2)", "3 stops", "2 stops (1)"));
  EXPECT_THAT(labels_of({Ramp{{}, "/a/r.png"}, Ramp{{}, "/b/r.png"}}), ElementsAre("a/r.png", "b/r.png"));
}

TEST(Labels, equal_values_have_one_label) {
  EXPECT_THAT(labels_of({text("/m/part.obj"), text("/m/part.obj"), 3.0F, 3.0F}),
              ElementsAre("part.obj", "part.obj", "3", "3"));
}

TEST(Labels, keys_have_the_fewest_parts_that_tell_them_apart) {
  const auto labels = [](const std::vector<std::string>& keys) { return key_labels(keys); };
  EXPECT_THAT(labels({"combine.k_depth", "combine.k_normal"}), ElementsAre("k_depth", "k_normal"));
  EXPECT_THAT(labels({"camera.eye.y"}), ElementsAre("eye.y"));
  EXPECT_THAT(labels({"camera.eye.y", "camera.target.y", "mesh.faces"}),
              ElementsAre("eye.y", "target.y", "faces"));
  EXPECT_THAT(labels({"model.a.mesh", "model.b.mesh", "mesh.faces"}),
              ElementsAre("a.mesh", "b.mesh", "faces"));
  EXPECT_THAT(labels({"model.a.position.x", "model.b.position.x"}),
              ElementsAre("a.position.x", "b.position.x"));
  EXPECT_THAT(labels({"light.a.direction", "light.b.direction", "light.b.colour"}),
              ElementsAre("a.direction", "b.direction", "colour"));
}

class StudyLabels : public testing::Test {
 protected:
  StudyLabels() {
    folder_.write("scene.toml", "[[model]]\nname = \"m\"\nmesh = \"part.obj\"\n");
    for (const char* name : {"meshes/part.obj", "studies/part.obj", "studies/sub/part.obj", "studies/r.png"})
      folder_.write(name, "v 0 0 0\n");
  }
  StudySpec spec(const std::string& body) const {
    return parse_spec("scene = \"../scene.toml\"\n" + body, folder_.path() / "studies/s.toml", {});
  }
  std::vector<std::string> column(const StudySpec& spec, const std::string& name) const {
    const CsvTable table = planned_table(spec);
    const auto place = std::find(table.columns.begin(), table.columns.end(), name) - table.columns.begin();
    std::vector<std::string> fields;
    for (const auto& row : table.rows) fields.push_back(row.at(static_cast<size_t>(place)));
    return fields;
  }

  TemporaryFolder folder_;
};

TEST_F(StudyLabels, columns_and_cells_of_two_meshes_with_one_file_name_differ) {
  const StudySpec two = spec("[[axis]]\nkey = \"model.m.mesh\"\nvalues = [\"part.obj\", \"sub/part.obj\"]\n");
  EXPECT_THAT(grid_axis(two, 0).values, ElementsAre("studies/part.obj", "sub/part.obj"));
  EXPECT_EQ(make_cell(two, 0).name, "mesh = studies/part.obj");
  EXPECT_EQ(make_cell(two, 1).name, "mesh = sub/part.obj");
}

TEST_F(StudyLabels, axes_of_components_name_their_vector) {
  const StudySpec two = spec(
      "[[axis]]\nkey = \"camera.eye.y\"\nvalues = [1, 2]\n"
      "[[axis]]\nkey = \"camera.target.y\"\nvalues = [0, 1]\nlabel = \"looking up\"\n");
  EXPECT_EQ(grid_axis(two, 0).label, "eye.y");
  EXPECT_EQ(grid_axis(two, 1).label, "looking up");
  EXPECT_EQ(make_cell(two, 3).name, "eye.y = 2, target.y = 1");
  EXPECT_EQ(chart_columns(two)[1].label, "eye.y");
  EXPECT_EQ(chart_columns(two)[2].label, "looking up");
}

TEST_F(StudyLabels, files_in_the_data_are_relative_to_the_spec_where_they_can_be) {
  const std::string elsewhere = find_rabbit().string();  // no way there but through the root
  const StudySpec three = spec(
      "[[axis]]\nkey = \"model.m.mesh\"\n"
      "values = [\"part.obj\", \"sub/part.obj\", \"../meshes/part.obj\", \"" +
      elsewhere + "\", \"rabbit\"]\n");
  EXPECT_THAT(column(three, "model.m.mesh"),
              ElementsAre("part.obj", "sub/part.obj", "../meshes/part.obj", elsewhere, "rabbit"));
  const StudySpec ramps =
      spec("[[axis]]\nkey = \"ramp.diffuse\"\nvalues = [\"r.png\", [{position = 0, colour = [1, 1, 1]}]]\n");
  EXPECT_THAT(column(ramps, "ramp.diffuse"),
              ElementsAre("r.png", "[{position = 0, colour = [1, 1, 1], stepped = true}]"));
}

TEST_F(StudyLabels, charts_call_files_and_ramps_as_the_grid_does) {
  const StudySpec two = spec("[[axis]]\nkey = \"model.m.mesh\"\nvalues = [\"part.obj\", \"sub/part.obj\"]\n");
  const ChartColumn column = chart_columns(two)[1];
  EXPECT_EQ(readable_field(column, "part.obj"), "studies/part.obj");
  EXPECT_EQ(readable_field(column, "sub/part.obj"), "sub/part.obj");
}

}  // namespace
}  // namespace inkbench
