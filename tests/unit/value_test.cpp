// SPDX-License-Identifier: MIT
// Values and their text: every type reads back as written, and nothing that a parameter does not accept gets
// in.
#include "pipeline/params/toml_value.h"

#include <gmock/gmock.h>

#include <limits>
#include <random>

#include "pipeline/settings/settings.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kAwkward[] = {"plain",
                                "",
                                "with \"quotes\" and 'others'",
                                "back\\slash \\n \\u0041",
                                "two\nlines\r\n\ttab",
                                "caf\xc3\xa9 \xe5\x85\x94 \xf0\x9f\x90\x87",
                                std::string("nul\0\x01\x1f\x7f end", 12),
                                "# no comment, [no] {list} = 1",
                                "\"\"\" ''' ",
                                " spaces at both ends "};

Settings value_scene() {
  Settings settings;
  settings.models.emplace_back().name = "rabbit";
  settings.lights.emplace_back().name = "key";
  return settings;
}

class ValueText : public ::testing::Test {
 protected:
  Value set(const std::string& key, const std::string& text) {
    set_param_text(settings_, key, text, "here");
    return find_param(settings_, key, "here").value();
  }
  std::string set_error(const std::string& key, const std::string& text) {
    const Value before = find_param(settings_, key, "here").value();
    const std::string message = error_of([&] { set_param_text(settings_, key, text, "here"); });
    EXPECT_EQ(find_param(settings_, key, "here").value(), before) << "an error must not change " << key;
    return message;
  }
  Settings settings_ = value_scene();
};

TEST(Value, text_is_toml_as_a_person_would_write_it) {
  EXPECT_EQ(to_text(Value(true)), "true");
  EXPECT_EQ(to_text(Value(false)), "false");
  EXPECT_EQ(to_text(Value(-7)), "-7");
  EXPECT_EQ(to_text(Value(0.003F)), "0.003");
  EXPECT_EQ(to_text(Value(glm::vec3(0, 1, -0.5F))), "[0, 1, -0.5]");
  EXPECT_EQ(to_text(Value(std::string("box"))), "\"box\"");
  EXPECT_EQ(to_text(Value(std::string("a\"b\\c\nd"))), "\"a\\\"b\\\\c\\u000ad\"");
  EXPECT_EQ(to_text(Value(Ramp{{{0.5F, glm::vec3(1), false}}, ""})),
            "[{position = 0.5, colour = [1, 1, 1], stepped = false}]");
  EXPECT_EQ(to_text(Value(Ramp{{{0.5F, glm::vec3(1), false}}, "/a/b.png"})), "\"/a/b.png\"");
}

TEST(Value, awkward_texts_read_back_as_written) {
  for (const std::string& text : kAwkward) {
    const TomlNode document = parse_toml("value = " + to_text(Value(text)), "here");
    ASSERT_EQ(document.entries.size(), 1U) << text;
    EXPECT_EQ(document.entries[0].node.text, text);
  }
}

TEST_F(ValueText, every_parameters_default_reads_back_from_its_text) {
  for (const Param& param : list_params(settings_)) {
    const Value value = param.value();
    EXPECT_EQ(value_from_text(param, to_text(value), "here"), value) << param.key;
  }
}

TEST_F(ValueText, random_numbers_read_back_exactly) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> position(-1e6F, 1e6F);
  for (int i = 0; i < 2000; ++i) {
    const glm::vec3 value(position(random), position(random), position(random));
    EXPECT_EQ(set("camera.eye", to_text(Value(value))), Value(value));
    EXPECT_EQ(set("camera.eye.y", to_text(Value(value.x))), Value(value.x));
  }
}

TEST_F(ValueText, booleans_are_true_or_false_and_nothing_else) {
  EXPECT_EQ(set("combine.use_depth", "false"), Value(false));
  EXPECT_EQ(set("combine.use_depth", " true "), Value(true));
  for (const char* text : {"1", "0", "yes", "True", "\"true\"", "", "[true]"}) {
    EXPECT_THAT(set_error("combine.use_depth", text),
                AllOf(StartsWith("here: combine.use_depth is "), HasSubstr("true or false")));
  }
}

TEST_F(ValueText, integers_may_be_written_as_whole_reals) {
  EXPECT_EQ(set("image.width", "3"), Value(3));
  EXPECT_EQ(set("image.width", "3.0"), Value(3));
  EXPECT_EQ(set("image.width", "1_024"), Value(1024));
  EXPECT_EQ(set("image.width", "1e3"), Value(1000));
  EXPECT_EQ(set("image.width", "0x10"), Value(16));
}

TEST_F(ValueText, integers_that_are_none_or_too_large_are_refused) {
  for (const char* text :
       {"3.5", "4294967297", "1e300", "-1e300", "9223372036854775807", "9223372036854775808", "nan", "inf",
        "\"3\"", "three", "true", "[3]", "", "2e9", "-2147483648"}) {
    EXPECT_THAT(set_error("image.width", text),
                AllOf(StartsWith("here: image.width "), HasSubstr("a whole number from 1 to 32768 px")))
        << text;
  }
}

TEST_F(ValueText, integers_stop_at_their_limits) {
  EXPECT_EQ(set("image.width", "32768"), Value(32768));
  EXPECT_EQ(set("image.width", "1"), Value(1));
  EXPECT_EQ(set_error("image.width", "32769"),
            "here: image.width = 32769 is out of range; it must be a whole number from 1 to 32768 px");
  EXPECT_THAT(set_error("image.width", "16777217"), HasSubstr("image.width = 16777217 is out of range"))
      << "shown as it is";
  EXPECT_THAT(set_error("image.width", "0"), HasSubstr("image.width = 0 is out of range"));
}

TEST_F(ValueText, reals_stop_at_their_limits) {
  EXPECT_EQ(set("combine.k_depth", "1e-6"), Value(1e-6F)) << "the limit itself, though 1e-6 is no float";
  EXPECT_EQ(set("combine.k_depth", "1"), Value(1.0F));
  EXPECT_EQ(set_error("combine.k_depth", "0"),
            "here: combine.k_depth = 0 is out of range; it must be a number from 1e-06 to 1");
  EXPECT_THAT(set_error("combine.k_depth", "1.0000002"), HasSubstr("out of range"));
  EXPECT_THAT(set_error("combine.k_depth", "9e-7"), HasSubstr("out of range"));
}

TEST_F(ValueText, what_is_not_finite_is_refused_everywhere) {
  for (const char* text : {"nan", "-nan", "inf", "-inf", "1e39", "-1e39", "1e400"}) {
    set_error("combine.k_depth", text);
    set_error("camera.fov", text);
    set_error("camera.eye.x", text);
    set_error("camera.eye", text);
    set_error("camera.eye", std::string("[0, ") + text + ", 0]");
    set_error("ink.colour", std::string("[0, ") + text + ", 0]");
    set_error("ramp.diffuse", std::string("[{position = ") + text + ", colour = [0, 0, 0]}]");
    set_error("ramp.diffuse", std::string("[{position = 0, colour = [0, 0, ") + text + "]}]");
  }
}

TEST_F(ValueText, a_vector_is_three_numbers_or_one_for_all) {
  EXPECT_EQ(set("camera.eye", "[1, 2.5, -3]"), Value(glm::vec3(1, 2.5F, -3)));
  EXPECT_EQ(set("camera.eye", "1, 2, 3"), Value(glm::vec3(1, 2, 3)));
  EXPECT_EQ(set("camera.eye", "0.5"), Value(glm::vec3(0.5F)));
  for (const char* text :
       {"[1, 2]", "[1, 2, 3, 4]", "1, 2", "[1, 2, \"3\"]", "[[1, 2, 3]]", "[]", "", "one", "[1, 2, true]"}) {
    EXPECT_THAT(set_error("camera.eye", text),
                HasSubstr("three numbers [x, y, z], each from -1000000 to 1000000 world units"))
        << text;
  }
}

TEST_F(ValueText, one_bad_component_refuses_the_vector) {
  EXPECT_THAT(set_error("light.key.direction", "[0, 1.5, 0]"),
              HasSubstr("light.key.direction = 1.5 is out of range"));
  EXPECT_THAT(set_error("light.key.direction", "[0, 0, -2]"), HasSubstr("out of range"));
}

TEST_F(ValueText, components_are_set_one_by_one) {
  set("camera.eye", "[1, 2, 3]");
  EXPECT_EQ(set("camera.eye.x", "10"), Value(10.0F));
  EXPECT_EQ(set("camera.eye.z", "30"), Value(30.0F));
  EXPECT_EQ(settings_.camera.eye, glm::vec3(10, 2, 30));
  set("ink.colour.g", "0.5");
  EXPECT_EQ(settings_.ink.colour, glm::vec3(0, 0.5F, 0));
  EXPECT_THAT(set_error("ink.colour.r", "1.5"), HasSubstr("out of range"));
  EXPECT_THAT(set_error("camera.eye.x", "[1, 2, 3]"),
              HasSubstr("a number from -1000000 to 1000000 world units"));
}

TEST_F(ValueText, colours_read_web_notation) {
  EXPECT_EQ(set("ink.colour", "#ff8000"), Value(glm::vec3(255, 128, 0) / 255.0F));
  EXPECT_EQ(set("ink.colour", "\"#0000FF\""), Value(glm::vec3(0, 0, 1)));
  for (const char* text : {"#ff80", "#ff80000", "#gg0000", "ff8000", "#", "\"#12345 \"", "# ff800"}) {
    EXPECT_THAT(set_error("ink.colour", text), HasSubstr("or \"#rrggbb\"")) << text;
  }
}

TEST_F(ValueText, web_notation_is_for_colours_only) {
  set_error("camera.eye", "#ff8000");
}

TEST_F(ValueText, choices_are_taken_by_name_with_or_without_quotes) {
  EXPECT_EQ(set("model.rabbit.shape", "torus"), Value(std::string("torus")));
  EXPECT_EQ(settings_.models[0].shape, Shape::torus);
  EXPECT_EQ(set("model.rabbit.shape", "\"box\""), Value(std::string("box")));
  EXPECT_EQ(set("image.precision", "float"), Value(std::string("float")));
  EXPECT_EQ(set_error("model.rabbit.shape", "ball"),
            "here: model.rabbit.shape = \"ball\" is not one of its choices; one of: mesh, box, rounded_box, "
            "sphere, "
            "inside_out_sphere, torus, plane");
  for (const char* text : {"", "1", "Box", "box ,", "\"box", "[\"box\"]"})
    set_error("model.rabbit.shape", text);
}

TEST_F(ValueText, texts_are_taken_with_or_without_quotes) {
  const auto mesh_from = [&](const std::string& text) {
    return std::get<std::string>(set("model.rabbit.mesh", text));
  };
  const std::string here = fs::current_path().string();
  EXPECT_EQ(mesh_from("/a/b.obj"), "/a/b.obj");
  EXPECT_EQ(mesh_from("\"/a/b c.obj\""), "/a/b c.obj");
  EXPECT_EQ(mesh_from("rabbit"), "rabbit");
  EXPECT_EQ(mesh_from("\"rabbit\""), "rabbit");
  EXPECT_EQ(mesh_from("true"), here + "/true") << "a word that TOML would read otherwise is still a name";
  EXPECT_EQ(mesh_from("7"), here + "/7");
  EXPECT_EQ(mesh_from("inf"), here + "/inf");
  EXPECT_EQ(mesh_from("1979-05-27"), here + "/1979-05-27");
  EXPECT_EQ(mesh_from("[a]"), here + "/[a]");
  EXPECT_EQ(mesh_from("a,b.obj"), here + "/a,b.obj");
  EXPECT_EQ(mesh_from("../../../../../../../../../../../../../../../../../../../a.obj"), "/a.obj");
}

TEST_F(ValueText, a_text_cannot_smuggle_in_another_key) {
  EXPECT_EQ(std::get<std::string>(set("model.rabbit.mesh", "\"/a\"\nother = 1")),
            fs::current_path().string() + "/\"/a\"\nother = 1");
  set_error("combine.k_depth", "1\nother = 1");
  set_error("combine.k_depth", "0.5\nvalue.x = 1");
}

TEST_F(ValueText, awkward_file_names_survive) {
  for (const std::string& text : kAwkward) {
    if (text.empty()) continue;
    const Value value = set("model.rabbit.mesh", to_text(Value("/folder/" + text)));
    EXPECT_EQ(value, Value("/folder/" + text));
    EXPECT_EQ(set("model.rabbit.mesh", to_text(value)), value);
  }
}

TEST_F(ValueText, what_is_not_utf8_is_refused_since_no_file_could_hold_it) {
  EXPECT_EQ(set_error("model.rabbit.mesh", "/a/\xff.obj"), "here: model.rabbit.mesh is not UTF-8 text");
  set_error("model.rabbit.mesh", "\"/a/\xc3\"");
  set_error("ramp.diffuse", "\xed\xa0\x80.png");
}

TEST_F(ValueText, ramps_are_lists_of_stops) {
  const auto ramp =
      std::get<Ramp>(set("ramp.diffuse",
                         "[{position = 0, colour = 0.5}, {position = 0.5, colour = \"#ff0000\", "
                         "stepped = false}, {position = 1, colour = [0, 1, 0]}]"));
  EXPECT_EQ(ramp, (Ramp{{{0.0F, glm::vec3(0.5F), true},
                         {0.5F, glm::vec3(1, 0, 0), false},
                         {1.0F, glm::vec3(0, 1, 0), true}},
                        ""}));
  EXPECT_EQ(set("ramp.specular", to_text(Value(ramp))), Value(ramp));
}

TEST_F(ValueText, malformed_ramps_are_refused) {
  for (const char* text : {"[]", "\"\"", "1", "true", "[1]", "[{}]", "[{position = 0}]", "[{colour = 0}]",
                           "{position = 0, colour = 0}", "[{position = 0, colour = 0, extra = 1}]",
                           "[{position = \"0\", colour = 0}]", "[{position = 0, colour = [0, 0]}]",
                           "[{position = 0, colour = 0, stepped = 1}]", "[[{position = 0, colour = 0}]]"}) {
    EXPECT_THAT(set_error("ramp.diffuse", text),
                HasSubstr("a list of stops {position = 0.5, colour = [1, 1, 1], stepped = true}"))
        << text;
  }
}

TEST_F(ValueText, a_mistyped_list_of_stops_is_no_images_name) {
  EXPECT_THAT(set_error("ramp.diffuse", "[{position = 0 colour = 0}]"), HasSubstr("not valid TOML"));
}

TEST_F(ValueText, ramp_positions_rise_from_0_to_1) {
  EXPECT_EQ(set_error("ramp.diffuse", "[{position = 0.5, colour = 0}, {position = 0.25, colour = 1}]"),
            "here: ramp.diffuse has a stop at 0.25 after 0.5; positions rise from 0 to 1");
  EXPECT_THAT(set_error("ramp.diffuse", "[{position = -0.1, colour = 0}]"),
              HasSubstr("positions rise from 0 to 1"));
  EXPECT_THAT(set_error("ramp.diffuse", "[{position = 1.1, colour = 0}]"),
              HasSubstr("positions rise from 0 to 1"));
  set("ramp.diffuse",
      "[{position = 0, colour = 0}, {position = 0, colour = 0.5}, {position = 1, colour = 1}]");
}

TEST_F(ValueText, ramp_colours_are_from_0_to_1) {
  EXPECT_EQ(set_error("ramp.diffuse", "[{position = 0, colour = [0, 1.5, 0]}]"),
            "here: ramp.diffuse has a colour component 1.5; components are from 0 to 1");
  set_error("ramp.diffuse", "[{position = 0, colour = -1}]");
}

TEST_F(ValueText, a_ramp_may_be_an_image) {
  const std::string here = fs::current_path().string();
  EXPECT_EQ(set("ramp.diffuse", "a.png"), Value(Ramp{{}, here + "/a.png"}));
  EXPECT_EQ(set("ramp.diffuse", "\"/r/../a.png\""), Value(Ramp{{}, "/a.png"}));
  EXPECT_EQ(set("ramp.diffuse", "rabbit"), Value(Ramp{{}, here + "/rabbit"}))
      << "the rabbit is a mesh, not an image";
}

TEST(ValueToml, relative_paths_start_from_the_folder_given) {
  Settings settings = value_scene();
  const auto value_of = [&](const std::string& key, const std::string& text) {
    const TomlNode document = parse_toml("v = " + to_text(Value(text)), "here");
    return value_from_toml(find_param(settings, key, ""), document.entries[0].node, "here", "/scenes/one");
  };
  EXPECT_EQ(value_of("model.rabbit.mesh", "a.obj"), Value(std::string("/scenes/one/a.obj")));
  EXPECT_EQ(value_of("model.rabbit.mesh", "../a.obj"), Value(std::string("/scenes/a.obj")));
  EXPECT_EQ(value_of("model.rabbit.mesh", "/a.obj"), Value(std::string("/a.obj")));
  EXPECT_EQ(value_of("model.rabbit.mesh", "rabbit"), Value(std::string("rabbit")));
  EXPECT_EQ(value_of("model.rabbit.mesh", "./rabbit"), Value(std::string("/scenes/one/rabbit")));
  EXPECT_EQ(value_of("ramp.diffuse", "a.png"), Value(Ramp{{}, "/scenes/one/a.png"}));
}

TEST(Param, overlaps_what_it_shares_a_number_with) {
  Settings settings = value_scene();
  const auto overlap = [&](const std::string& a, const std::string& b) {
    return find_param(settings, a, "").overlaps(find_param(settings, b, ""));
  };
  EXPECT_TRUE(overlap("camera.eye", "camera.eye"));
  EXPECT_TRUE(overlap("camera.eye", "camera.eye.x"));
  EXPECT_TRUE(overlap("camera.eye.x", "camera.eye"));
  EXPECT_TRUE(overlap("camera.eye.x", "camera.eye.r"));
  EXPECT_FALSE(overlap("camera.eye.x", "camera.eye.y"));
  EXPECT_FALSE(overlap("camera.eye", "camera.target"));
  settings.models.emplace_back().name = "other";
  EXPECT_FALSE(overlap("model.rabbit.size", "model.other.size"));
}

}  // namespace
}  // namespace inkbench
