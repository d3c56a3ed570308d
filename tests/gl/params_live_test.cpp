// SPDX-License-Identifier: MIT
// Every parameter does something: changed from its value it changes a stage's key and an image; one of the
// judge changes the key of the numbers, and the reference lines or a number. The test walks the descriptions,
// so a parameter added tomorrow is tried without a line here.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "pipeline/base/text.h"
#include "pipeline/image/image_file.h"
#include "pipeline/mesh/shapes/primitives.h"
#include "pipeline/passes/lines/reference.h"
#include "pipeline/pipeline.h"
#include "studies/judging/drawing_meter.h"
#include "tests/gl/checks.h"
#include "tests/written_gltf.h"

namespace inkbench {
namespace {

std::vector<Condition> conditions_of(const Settings& settings, const std::string& key) {
  for (const ConstParamGroup& group : list_groups(settings)) {
    for (const Field& field : group.description->fields) {
      const std::string whole = group.prefix + "." + std::string(field.name);
      if (key == whole || (key.starts_with(whole + ".") && key.size() == whole.size() + 2))
        return conditions_of(group, field);
    }
  }
  throw std::runtime_error("no parameter " + key);
}

/// The values of what the condition names that meet it, or that do not.
std::vector<std::string> values_for(Settings settings, const Condition& condition, bool met) {
  const Field& named = *find_param(settings, condition.key, "test").field;
  std::vector<std::string> all(named.choices.begin(), named.choices.end());
  if (named.type == FieldType::boolean) all = {"false", "true"};
  if (all.empty()) {
    for (const char* number : {"0", "1", "2"}) {
      const double value = std::stod(number);
      if (value >= named.limits.low && value <= named.limits.high) all.emplace_back(number);
    }
  }
  std::vector<std::string> result;
  for (const std::string& value : all) {
    const bool is_named =
        std::find(condition.values.begin(), condition.values.end(), value) != condition.values.end();
    if ((is_named != condition.is_unequal) == met) result.push_back(value);
  }
  return result;
}

/// All ways of setting what the parameter's conditions name, so that they are met; the settings as they are
/// first where that is one. With `met` false: so that the last one is not.
std::vector<Settings> arrangements(const Settings& settings, const std::string& key, bool met = true) {
  const std::vector<Condition> conditions = conditions_of(settings, key);
  std::vector<Settings> result{settings};
  for (size_t i = 0; i < conditions.size(); ++i) {
    std::vector<Settings> next;
    for (const Settings& before : result) {
      for (const std::string& value : values_for(before, conditions[i], met || i + 1 < conditions.size())) {
        next.push_back(before);
        set_param_text(next.back(), conditions[i].key, value, "test");
      }
    }
    result = std::move(next);
  }
  return result;
}

float changed_number(const Field& field, float value) {
  const auto inside = [&](float candidate) {
    return field.limits.low == field.limits.high ||
           (candidate >= field.limits.low && candidate <= field.limits.high);
  };
  if (field.scale == Scale::log && value != 0.0F) return inside(value * 1.5F) ? value * 1.5F : value / 1.5F;
  const auto step = static_cast<float>(0.13 * (field.slider.high - field.slider.low));
  return inside(value + step) ? value + step : value - step;
}

/// Another value of the parameter. Errors (test): a type that it knows no other value for.
Value another(const Field& field, const Value& value, const std::string& other_mesh) {
  if (field.name == "profile" && field.type == FieldType::text) return std::string("0 0.2, 1 1");
  if (field.name == "brush_image") return fs::path(other_mesh).replace_filename("brush.png").string();
  if (const auto* boolean = std::get_if<bool>(&value)) return !*boolean;
  if (const auto* integer = std::get_if<int>(&value)) {
    const int other = static_cast<int>(changed_number(field, static_cast<float>(*integer)));
    return other != *integer                                ? other
           : *integer < static_cast<int>(field.limits.high) ? *integer + 1
                                                            : *integer - 1;
  }
  if (const auto* real = std::get_if<float>(&value)) return changed_number(field, *real);
  if (!field.choices.empty()) {
    const auto here = std::find(field.choices.begin(), field.choices.end(), std::get<std::string>(value));
    return std::string(here + 1 == field.choices.end() ? field.choices.front() : *(here + 1));
  }
  if (field.type == FieldType::text) return field.is_path ? other_mesh : "2";  // the number of a part
  if (field.type == FieldType::ramp) {
    Ramp ramp = std::get<Ramp>(value);
    for (RampStop& stop : ramp.stops) stop.colour *= 0.7F;
    return ramp;
  }
  throw std::runtime_error("no other value is known for " + std::string(field.name));
}

/// Vectors count as three parameters.
std::vector<std::string> all_keys(Settings settings) {
  std::vector<std::string> keys;
  for (const Param& param : list_params(settings)) {
    const bool is_colour = param.field->type == FieldType::colour;
    if (is_colour || param.field->type == FieldType::vector) {
      for (const char component : std::string(is_colour ? "rgb" : "xyz"))
        keys.push_back(param.key + "." + component);
    } else {
      keys.push_back(param.key);
    }
  }
  return keys;
}

/// Other values of the parameter: of a choice all, since one may be the same as another here.
std::vector<Value> others(const Field& field, const Value& value, const std::string& other_mesh) {
  if (field.choices.empty()) return {another(field, value, other_mesh)};
  std::vector<Value> values;
  for (const std::string_view choice : field.choices) {
    if (choice != std::get<std::string>(value)) values.emplace_back(std::string(choice));
  }
  return values;
}

/// Differences of rounding do not count, nor single pixels of an edge.
bool differ(const Image& a, const Image& b) {
  if (a.samples.size() != b.samples.size() || a.width_px != b.width_px) return true;
  int different = 0;
  for (size_t i = 0; i < a.samples.size(); ++i) different += std::abs(a.samples[i] - b.samples[i]) > 1e-4F;
  return different >= 3;
}

/// A mesh with triangles to spare, whose every level and subdivision looks different, as an OBJ file.
std::string bumpy_sphere(float waves, int segments = 16, bool inside_out = false) {
  const Mesh sphere = make_sphere(segments);
  std::string text;
  for (const glm::vec3& p : sphere.positions) {
    const glm::vec3 bumpy = p * (1.0F + 0.2F * std::sin(waves * p.x) * std::sin(waves * p.y + 1.0F));
    text += "v " + shortest(bumpy.x) + " " + shortest(bumpy.y) + " " + shortest(bumpy.z) + "\n";
  }
  for (const auto& t : sphere.triangles) {
    text += "f";
    for (const int i : inside_out ? std::array{0, 2, 1} : std::array{0, 1, 2})
      text += " " + std::to_string(t[i] + 1);
    text += "\n";
  }
  return text;
}

class ParamsLive : public testing::Test {
 protected:
  ParamsLive() {
    // Inside out, so that it matters which side is the front.
    first_mesh_ = folder_.write("first.obj", bumpy_sphere(5.0F, 16, true)).string();
    mesh_of_parts_ =
        write_gltf(folder_.path(), {.nodes = R"({"mesh": 0}, {"mesh": 0, "translation": [0.5, 2, -1]})",
                                    .scene_nodes = "0, 1"})
            .string();
    other_mesh_ = folder_.write("other.obj", bumpy_sphere(3.0F)).string();
    rich_ = make_rich_scene();
    Picture brush(8, 4, 1, 255);
    for (int x = 0; x < 4; ++x) brush.at(x, 1) = 0;
    write_png(folder_.path() / "brush.png", brush, {});
    judged_ = rich_;  // where the lines of the full mesh are seen, those of its smooth bends too
    judged_.image = {320, 240, Precision::float32};
    judged_.mesh.faces = 0;
    for (ModelParams& model : judged_.models) {
      if (model.shape == Shape::mesh) model.mesh = folder_.write("fine.obj", bumpy_sphere(8.0F, 64)).string();
      if (model.shape == Shape::mesh) model.size = 3.0F;
    }
  }

  /// All shapes, both kinds of light, ramps, a free background, and a floor that the near plane cuts.
  Settings make_rich_scene() const;

  bool keys_change(const Settings& before, const Settings& after) {
    return pipeline_.at(before).pass_keys() != pipeline_.at(after).pass_keys();
  }
  bool images_change(const Settings& before, const Settings& after) {
    for (const BufferName buffer :
         {BufferName::shaded, BufferName::final, BufferName::depth, BufferName::normal,
          BufferName::combined_edges, BufferName::depth_edges, BufferName::normal_edges,
          BufferName::blinn_phong, BufferName::object_id, BufferName::edge_strength, BufferName::coverage,
          BufferName::curves, BufferName::strokes}) {
      // The paper's own buffer is there to be seen whatever the method.
      if (buffer == BufferName::combined_edges && before.edges.method != EdgeMethod::paper) continue;
      if (differ(before_.at(before).raw(buffer), pipeline_.at(after).raw(buffer))) return true;
    }
    return false;
  }
  bool pictures_change(const Settings& before, const Settings& after) {
    for (const BufferName buffer : framebuffers()) {
      if (before_.at(before).picture(buffer) != pipeline_.at(after).picture(buffer)) return true;
    }
    return false;
  }
  bool lines_change(const Settings& before, const Settings& after) {
    return pipeline_.at(before).value<ReferencePass>()->polylines !=
           pipeline_.at(after).value<ReferencePass>()->polylines;
  }
  bool judgements_change(const Settings& before, const Settings& after) {
    const std::string numbers = measures_json(all_measures(), meter_.tally(pipeline_.at(before)));
    return measures_json(all_measures(), meter_.tally(pipeline_.at(after))) != numbers ||
           lines_change(before, after);
  }
  bool framebuffer_keys_change(const Frame& before, const Frame& after) const {
    const std::vector<BufferName> buffers = framebuffers();
    return std::any_of(buffers.begin(), buffers.end(),
                       [&](BufferName buffer) { return before.key(buffer) != after.key(buffer); });
  }
  /// A judge changes none of what the scene looks like.
  bool judge_is_live(const Settings& before, const Settings& after) {
    const Frame now = pipeline_.at(before), then = pipeline_.at(after);
    return !framebuffer_keys_change(now, then) && meter_.key(now) != meter_.key(then) &&
           judgements_change(before, after);
  }
  std::vector<Settings> all_changes(const Settings& settings, const std::string& key) const {
    Settings before = settings;
    const Param param = find_param(before, key, "test");
    std::vector<Settings> changes;
    for (const Value& value : others(*param.field, param.value(), other_mesh_)) {
      changes.push_back(settings);
      find_param(changes.back(), key, "test").set(value, "test");
    }
    return changes;
  }
  Settings with_change(const Settings& settings, const std::string& key) const {
    return all_changes(settings, key).front();
  }
  /// Only some formats have parts; materials alone make lines only where models do not, and the other way
  /// round; lines of normals are where a smooth face turns within few pixels.
  std::vector<Settings> bringing_out(const std::string& key, std::vector<Settings> arranged) const {
    for (Settings& settings : arranged) {
      MitchellParams& mitchell = settings.mitchell;
      if (key.starts_with("line.material.")) mitchell.use_ids = false;
      if (key.starts_with("line.material.") || key.starts_with("line.normal.")) mitchell.thin = true;
      if (key.starts_with("line.normal.")) mitchell.angle = 3.0F;
      if (key == "mitchell.use_ids") mitchell.albedo = 2.0F;
      for (ModelParams& model : settings.models) {
        if (key.ends_with(".part")) model.mesh = mesh_of_parts_;
      }
      bring_out_strokes(key, settings);
    }
    return arranged;
  }
  /// Lines of the smooth surface are there only when asked for, and some classes only in traced lines.
  static void bring_out_strokes(const std::string& key, Settings& settings) {
    if (key == "curves.smoothing" || key == "curves.weak_share" || key == "curves.shortest")
      settings.curves.suggestive = settings.curves.ridge = true;
    if (key == "stroke.tip") settings.stroke.taper_in = 20.0F;
    if (key == "stroke.seed") settings.stroke.wobble = 2.0F;
    if (key == "stroke.bridge") settings.curves.from = CurvesFrom::image;
    const size_t dot = key.find('.', 7);  // "stroke.crease.width"
    if (!key.starts_with("stroke.") || dot == std::string::npos) return;
    const std::string of_class = key.substr(7, dot - 7);
    if (has_param(settings, "curves." + of_class) && of_class != "silhouette")
      set_param_text(settings, "curves." + of_class, "true", "test");
    if (of_class != "normal" && of_class != "material") return;
    settings.curves.from = CurvesFrom::image;
    settings.edges.method = EdgeMethod::mitchell;
    settings.mitchell.thin = true;
    settings.mitchell.angle = 3.0F;
    settings.mitchell.use_ids = of_class != "material";
    settings.image = {448, 336, Precision::float32};  // runs of a few pixels are no class of their own
  }
  /// Lines of smooth surfaces are on fine meshes alone.
  static bool is_of_smooth_lines(const std::string& key) {
    for (const char* name :
         {"suggestive", "ridge", "valley", "apparent", "smoothing", "weak_share", "shortest"}) {
      const std::string part(name);
      if (key.starts_with("curves." + part)) return true;
      if (key.starts_with("stroke." + part) && key.find('.', 7) != std::string::npos) return true;
    }
    return false;
  }
  const Settings& scene_for(const std::string& key) const {
    return key.starts_with("judge.") || is_of_smooth_lines(key) ? judged_ : rich_;
  }
  bool is_live(const std::string& key) {
    if (key == "stroke.coherent") return is_live_in_films(key);
    for (const Settings& arranged : bringing_out(key, arrangements(scene_for(key), key))) {
      for (const Settings& after : all_changes(arranged, key)) {
        const bool live = key.starts_with("judge.") ? judge_is_live(arranged, after)
                          : key.starts_with("display.") || key == "image.supersample"
                              ? !keys_change(arranged, after) && pictures_change(arranged, after)
                              : keys_change(arranged, after) && images_change(arranged, after);
        if (live) return true;
      }
    }
    return false;
  }

  /// In the second of two frames.
  bool is_live_in_films(const std::string& key) {
    Settings first = rich_, second = rich_;
    second.camera.eye.x += 0.2F;
    first.stroke.brush = second.stroke.brush = Brush::pencil;
    const Frame before = pipeline_.at(first);
    const Image strokes = pipeline_.at(second, before).raw(BufferName::strokes);
    return differ(strokes, pipeline_.at(with_change(second, key), before).raw(BufferName::strokes));
  }

  TempFolder folder_;
  std::string first_mesh_, other_mesh_, mesh_of_parts_;
  Settings rich_, judged_;
  Pipeline before_;  // keeps the images that changes are compared with
  Pipeline pipeline_;
  DrawingMeter meter_{pipeline_, MeasureNeeds::all()};
};

Settings ParamsLive::make_rich_scene() const {
  Settings settings;
  settings.image = {112, 84, Precision::float32};
  settings.camera = {{0.5F, 2.4F, 7.0F}, {0.2F, 0.3F, 0.1F}, {0.1F, 0.9F, 0.2F}, 45.0F, 4.9F, 20.0F};
  settings.scene = {{0.1F, 0.15F, 0.2F}, {0.9F, 0.8F, 0.7F}};
  for (size_t i = 0; i < ChoiceNames<Shape>::names.size(); ++i) {
    ModelParams model{.name = std::string(ChoiceNames<Shape>::names[i]),
                      .shape = static_cast<Shape>(i),
                      .mesh = first_mesh_,
                      .segments = 10};
    const float column = static_cast<float>(i % 4);
    model.position = {-2.0F + 1.4F * column, i < 4 ? 0.2F : 1.3F, i < 4 ? 1.0F : -1.5F};
    model.rotation = {20.0F, 30.0F + 10.0F * column, 10.0F};
    model.scale = {1.0F, 1.1F, 0.9F};
    model.size = 1.1F;
    model.material = {{0.6F, 0.5F, 0.1F + 0.12F * static_cast<float>(i)}, 0.8F, 0.7F, 0.5F, 3.0F};
    if (model.shape == Shape::plane) {
      model.position = {0.0F, -0.5F, 0.0F};
      model.rotation = {1.0F, 2.0F, 3.0F};
      model.size = 12.0F;
    }
    if (model.shape == Shape::rounded_box) {
      // It goes on from the box, so that only their ids and colours differ.
      model.position = settings.models.back().position + glm::vec3(0.6F, 0.095F, -0.51F);
      model.rotation = settings.models.back().rotation;
    }
    settings.models.push_back(model);
  }
  LightParams sun{.name = "sun", .direction = {0.4F, 0.7F, 0.5F}, .position = {2.0F, 4.0F, 3.0F}};
  sun.ambient = {0.02F, 0.03F, 0.04F};
  LightParams lamp{.name = "lamp",
                   .type = LightType::point,
                   .direction = {-0.4F, 0.7F, 0.5F},
                   .position = {-2.0F, 3.0F, 4.0F}};
  lamp.diffuse = lamp.specular = {0.5F, 0.4F, 0.3F};
  settings.lights = {sun, lamp};
  settings.mesh.faces = 300;
  settings.ramp.diffuse.stops[2].stepped = false;
  settings.ramp.specular.stops = {{0.0F, glm::vec3(0.0F), false}, {0.6F, glm::vec3(1.0F), true}};
  return settings;
}

/// What a built-in shape's own normals and closed surface leave nothing to do for.
bool is_for_mesh_files(const std::string& key) {
  const bool is_of_file = key.starts_with("model.mesh.");
  return !is_of_file && (key.ends_with(".normals") || key.ends_with(".smooth_angle") ||
                         key.ends_with(".orient") || key.ends_with(".two_sided"));
}

TEST_F(ParamsLive, every_parameter_changes_a_key_and_an_image) {
  // A plane has no thickness, so its height cannot be stretched, and the middle of its base is its origin.
  const std::vector<std::string> no_thickness{"model.plane.anchor", "model.plane.scale.y"};
  const std::vector<std::string> keys = all_keys(rich_);
  EXPECT_GT(keys.size(), 200U);
  for (const std::string& key : keys) {
    const bool exempt = std::find(no_thickness.begin(), no_thickness.end(), key) != no_thickness.end();
    const bool is_of_shadows =
        key.starts_with("line.shadow.") || key.starts_with("stroke.shadow.");  // no detector sees any yet
    EXPECT_TRUE(exempt || is_of_shadows || is_for_mesh_files(key) || is_live(key)) << key << " does nothing";
  }
}

TEST_F(ParamsLive, reference_lines_have_another_key_just_where_the_judge_changes_them) {
  for (const std::string& key : all_keys(judged_)) {
    if (!key.starts_with("judge.")) continue;
    const Settings after = with_change(judged_, key);
    EXPECT_EQ(
        pipeline_.at(judged_).key(BufferName::reference) != pipeline_.at(after).key(BufferName::reference),
        lines_change(judged_, after))
        << key;
  }
}

TEST_F(ParamsLive, every_part_of_a_ramp_changes_an_image) {
  Picture strip(3, 1, 3, 90);
  strip.at(1, 0, 0) = 200;
  const std::string path = (folder_.path() / "ramp.png").string();
  write_png(path, strip, {});
  for (const std::string key : {"ramp.diffuse", "ramp.specular"}) {
    const auto expect_live = [&](const std::string& part, const std::function<void(Ramp&)>& change) {
      Settings after = rich_;
      const Param param = find_param(after, key, "test");
      Ramp ramp = std::get<Ramp>(param.value());
      change(ramp);
      param.set(ramp, "test");
      EXPECT_TRUE(keys_change(rich_, after) && images_change(rich_, after)) << key << " " << part;
    };
    for (int c = 0; c < 3; ++c) expect_live("colour", [c](Ramp& ramp) { ramp.stops[1].colour[c] = 0.2F; });
    expect_live("position", [](Ramp& ramp) { ramp.stops[1].position = 0.3F; });
    expect_live("stepped", [](Ramp& ramp) { ramp.stops[0].stepped = !ramp.stops[0].stepped; });
    expect_live("image", [&](Ramp& ramp) { ramp.image = path; });
  }
}

TEST_F(ParamsLive, parameters_do_nothing_where_their_condition_fails) {
  // Otherwise `matters_when` would grey out a slider that works.
  for (const std::string& key : all_keys(rich_)) {
    if (conditions_of(rich_, key).empty()) continue;
    // Meshes would need a file's bytes to differ; which of two files is not drawn makes no difference to any
    // shape.
    const Settings arranged = arrangements(rich_, key, false).front();
    EXPECT_FALSE(images_change(arranged, with_change(arranged, key))) << key;
  }
}

TEST_F(ParamsLive, notices_a_parameter_without_effect) {
  // What keeps the first test honest: a change that no image shows counts as dead.
  Settings after = rich_;
  after.lights[0].position.x += 1.0F;  // of a directional light
  EXPECT_FALSE(images_change(rich_, after));
  after = rich_;
  after.models[0].fillet = 0.3F;  // of a mesh
  EXPECT_FALSE(images_change(rich_, after));
}

}  // namespace
}  // namespace inkbench
