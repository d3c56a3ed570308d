// SPDX-License-Identifier: MIT
// Judging: live measures against a study's, the pinned state, lines over pictures.
#include <fstream>
#include <sstream>

#include "pipeline/base/files.h"
#include "tests/app/app_test.h"
#include "tests/cli/command.h"
#include "tests/places.h"

namespace inkbench {
namespace {

class AppJudge : public AppTest {
 protected:
  /// Opens the window at its judge and waits for the first measures.
  Json open_judge() {
    open();
    click("tab:Judge");
    return measured();
  }

  Json measured() {
    return wait_for("measures", [](const Json& now) {
      return !now["judge"]["now"].is_null() && now["judge"]["behind"] == false;
    });
  }

  /// Lines of fewer of the paper's terms: whatever draws by the old shader gives others.
  void change_shader_of_lines() {
    const fs::path shader = file("root/shaders/combine.frag");
    std::string text = read_file(shader);
    const std::string sum = "float sum = p.x + p.y;";
    const size_t place = text.find(sum);
    ASSERT_NE(place, std::string::npos);
    write_file_atomically(shader, text.replace(place, sum.size(), "float sum = p.x;"));
  }

  /// What the command line says of the same scene, with these options as well.
  Json measured_by_command(const std::vector<std::string>& options) {
    std::vector<std::string> command{inkbench_program(), "measure", "--scene", file("scene.toml").string(),
                                     "--json"};
    command.insert(command.end(), options.begin(), options.end());
    const CommandResult result = run_command(command, {.environment = environment_});
    if (result.status != 0) throw std::runtime_error(result.err);
    return Json::parse(result.out);
  }

  void set_number(const std::string& key, const std::string& text) {
    type_over("bar:" + key, text);
    wait_for(key, [&](const Json& now) { return parameter(now, key) == text; });
    settled();
  }

  /// data.csv of a study of the same scene: a row's values by column.
  std::vector<std::map<std::string, std::string>> study_rows(const std::string& key,
                                                             const std::string& values) {
    write("study.toml",
          "title = \"Same\"\npurpose = \"The same numbers\"\nscene = \"scene.toml\"\nsize = [96, 96]\n"
          "show = [\"final\"]\nmeasure = true\n[[axis]]\nkey = \"" +
              key + "\"\nvalues = " + values + "\n");
    CommandOptions options;
    options.environment = environment_;
    const CommandResult result = run_command(
        {inkbench_program(), "study", file("study.toml").string(), "--out", file("out").string()}, options);
    EXPECT_EQ(result.status, 0) << result.err;
    std::ifstream stream(file("out") / "data.csv");
    std::string line;
    std::getline(stream, line);
    const std::vector<std::string> columns = fields(line);
    std::vector<std::map<std::string, std::string>> rows;
    while (std::getline(stream, line)) {
      const std::vector<std::string> cells = fields(line);
      std::map<std::string, std::string>& row = rows.emplace_back();
      for (size_t i = 0; i < columns.size() && i < cells.size(); ++i) row[columns[i]] = cells[i];
    }
    return rows;
  }

  static std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> result;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) result.push_back(field);
    return result;
  }

  static void expect_same(const Json& measures, const std::map<std::string, std::string>& row) {
    int compared = 0;
    for (const auto& [name, value] : measures.items()) {
      ASSERT_TRUE(row.contains(name)) << name;
      const std::string& text = row.at(name);
      if (value.is_null()) {
        EXPECT_EQ(text, "") << name;
      } else if (value.is_boolean()) {
        EXPECT_EQ(text, value.get<bool>() ? "true" : "false") << name;
      } else {
        EXPECT_EQ(std::stod(text), value.get<double>()) << name;
        ++compared;
      }
    }
    EXPECT_GT(compared, 20);
  }
};

TEST_F(AppJudge, measures_equal_those_of_a_study_to_the_last_digit) {
  const Json first = open_judge();
  set_number("combine.k_normal", "0.4");
  const Json second = measured();
  const auto rows = study_rows("combine.k_normal", "[0.0125, 0.4]");
  ASSERT_EQ(rows.size(), 2U);
  expect_same(first["judge"]["now"], rows[0]);
  expect_same(second["judge"]["now"], rows[1]);
  EXPECT_NE(first["judge"]["now"]["ink"], second["judge"]["now"]["ink"]);
}

TEST_F(AppJudge, level_is_judged_against_the_full_mesh_as_in_a_study) {
  const Json full = open_judge();
  EXPECT_FALSE(full["judge"]["now"].contains("f1_geometry"));
  set_number("mesh.faces", "120");
  const auto has_ladder = [](const Json& now) {
    return now["judge"]["now"].contains("f1_geometry") && now["judge"]["behind"] == false;
  };
  const Json coarse = wait_for("the full mesh's lines", has_ladder);
  set_number("combine.k_normal", "0.4");
  const Json other_k = wait_for("other measures", [&](const Json& now) {
    return has_ladder(now) && now["judge"]["now"] != coarse["judge"]["now"];
  });
  const auto rows = study_rows("mesh.faces", "[120]");
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].at("faces"), "120");
  expect_same(coarse["judge"]["now"], rows[0]);
  EXPECT_LT(coarse["judge"]["now"]["f1_geometry"], 1.0);
  EXPECT_EQ(other_k["judge"]["now"]["f1_geometry"], coarse["judge"]["now"]["f1_geometry"]);
  EXPECT_EQ(runs(other_k, "gbuffer"), runs(coarse, "gbuffer")) << "the full mesh has passes of its own";
  set_number("mesh.faces", "0");
  EXPECT_FALSE(measured()["judge"]["now"].contains("f1_geometry"));
}

TEST_F(AppJudge, pinned_state_keeps_its_measures) {
  const Json first = open_judge();
  EXPECT_TRUE(first["judge"]["pinned"].is_null());
  click("pin");
  wait_for("the pinned measures", [](const Json& now) { return !now["judge"]["pinned"].is_null(); });
  set_number("combine.k_normal", "0.4");
  const Json now = measured();
  EXPECT_EQ(now["judge"]["pinned"], first["judge"]["now"]);
  EXPECT_NE(now["judge"]["now"], first["judge"]["now"]);
  EXPECT_EQ(now["passes"]["combine"]["runs"], first["passes"]["combine"]["runs"].get<long>() + 1)
      << "the pinned edges are kept";
}

TEST_F(AppJudge, nothing_is_measured_that_nobody_sees) {
  open();
  EXPECT_TRUE(settled()["judge"]["now"].is_null());
}

TEST_F(AppJudge, lines_over_the_pictures_by_key_change_no_picture) {
  open();
  const Json before = settled();
  EXPECT_EQ(before["layout"]["overlay"], "\"none\"");
  for (const char* overlay : {"\"reference\"", "\"matches\"", "\"causes\"", "\"none\""}) {
    keys("l");
    wait_for("the overlay", [&](const Json& now) { return now["layout"]["overlay"] == overlay; });
    EXPECT_EQ(settled()["pictures"], before["pictures"]);
    EXPECT_EQ(settled()["ui"]["tile:final"], before["ui"]["tile:final"]);
  }
  EXPECT_TRUE(state()["problems"].empty());
}

TEST_F(AppJudge, causes_of_the_windows_lines_are_those_that_are_measured_and_its_passes_stay) {
  open();
  click("tab:Judge");
  click("overlay:3");
  const Json first =
      wait_for("causes", [](const Json& now) { return !now["causes"].is_null() && !now["why"].is_object(); });
  const Json measured = measured_by_command({"--causes"});
  int64_t wrong = 0;
  for (const auto& [key, count] : first["causes"].items()) {
    EXPECT_EQ(count, measured[key]) << key;
    wrong += count.get<int64_t>();
  }
  EXPECT_GT(wrong, 0);
  const Json later = settled();
  EXPECT_EQ(later["passes"]["gbuffer"]["runs"], first["passes"]["gbuffer"]["runs"])
      << "the causes are drawn by passes of their own";
  set_number("combine.k_normal", "0.4");
  wait_for("other causes",
           [&](const Json& now) { return !now["causes"].is_null() && now["causes"] != first["causes"]; });
  EXPECT_TRUE(state()["problems"].empty());
}

TEST_F(AppJudge, causes_are_of_the_shaders_as_they_are_now) {
  open_with_own_shaders();
  click("tab:Judge");
  click("overlay:3");
  const Json first = wait_for("causes", [](const Json& now) { return !now["causes"].is_null(); });
  change_shader_of_lines();
  const Json other = wait_for("causes of other lines", [&](const Json& now) {
    return now["pictures"]["lines"] != first["pictures"]["lines"] && !now["causes"].is_null();
  });
  const Json measured = measured_by_command({"--causes"});
  for (const auto& [key, count] : other["causes"].items()) EXPECT_EQ(count, measured[key]) << key;
  EXPECT_NE(other["causes"], first["causes"]);
}

TEST_F(AppJudge, full_mesh_is_drawn_by_the_shaders_as_they_are_now) {
  open_with_own_shaders();
  click("tab:Judge");
  set_number("mesh.faces", "120");
  const auto has_ladder = [](const Json& now) {
    return now["judge"]["now"].contains("f1_geometry") && now["judge"]["behind"] == false;
  };
  const Json first = wait_for("the full mesh's lines", has_ladder);
  change_shader_of_lines();
  const Json other = wait_for("other measures", [&](const Json& now) {
    return now["pictures"]["lines"] != first["pictures"]["lines"] && has_ladder(now);
  });
  const Json measured = measured_by_command({"--set", "mesh.faces=120"});
  for (const auto& [key, value] : other["judge"]["now"].items()) EXPECT_EQ(value, measured[key]) << key;
}

}  // namespace
}  // namespace inkbench
