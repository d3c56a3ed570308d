// SPDX-License-Identifier: MIT
// Uniform blocks: the bytes lie where std140 puts the members that the GLSL text declares.
#include "pipeline/params/glsl_block.h"

#include <gmock/gmock.h>

#include <cstring>
#include <map>
#include <sstream>

#include "pipeline/base/text.h"
#include "pipeline/settings/settings.h"

namespace inkbench {
namespace {

using ::testing::HasSubstr;

struct Member {
  std::string type;
  std::string name;
  size_t offset = 0;
};

/// Base alignments and sizes of OpenGL 4.5, 7.6.2.2: scalars 4 and 4, vec3 16 and 12; a structure rounds up
/// to 16.
std::vector<Member> std140_layout(const std::string& glsl, size_t* size) {
  const std::map<std::string, size_t> alignments{{"int", 4}, {"float", 4}, {"vec3", 16}};
  const std::map<std::string, size_t> sizes{{"int", 4}, {"float", 4}, {"vec3", 12}};
  std::vector<Member> members;
  size_t end = 0;
  std::istringstream lines(glsl);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Member member;
    words >> member.type >> member.name;
    EXPECT_TRUE(member.name.ends_with(';')) << line;
    member.name.pop_back();
    const size_t alignment = alignments.at(member.type);
    while (end % alignment != 0) ++end;
    member.offset = end;
    end += sizes.at(member.type);
    members.push_back(member);
  }
  while (end % 16 != 0) ++end;
  *size = end;
  return members;
}

template <class T>
T read_at(const std::vector<uint8_t>& bytes, size_t offset) {
  T value{};
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

/// A value that no other field has, so that a member in a wrong place is seen.
Value distinct_value(const Field& field, int number) {
  const float base = static_cast<float>(number) * 3.0F + 1.25F;
  switch (field.type) {
    case FieldType::boolean:
      return number % 2 == 0;
    case FieldType::integer:
      return number + 1000;
    case FieldType::real:
      return base;
    case FieldType::vector:
    case FieldType::colour:
      return glm::vec3(base, base + 1, base + 2);
    case FieldType::choice:
      return std::string(field.choices.back());
    case FieldType::text:
      return std::string("text");
    case FieldType::ramp:
      return Ramp{};
  }
  return {};
}

void expect_packed(const Description& description, void* owner) {
  for (size_t i = 0; i < description.fields.size(); ++i) {
    description.fields[i].set(owner, distinct_value(description.fields[i], static_cast<int>(i)));
  }
  size_t size = 0;
  const std::vector<Member> members = std140_layout(glsl_members(description), &size);
  const std::vector<uint8_t> bytes = pack_std140(description, owner);
  ASSERT_EQ(bytes.size(), size) << description.group;
  ASSERT_EQ(std140_size(description), size) << description.group;
  size_t next = 0;
  for (const Field& field : description.fields) {
    if (field.type == FieldType::text || field.type == FieldType::ramp) continue;
    ASSERT_LT(next, members.size());
    const Member& member = members[next++];
    EXPECT_EQ(member.name, field.name);
    const Value value = field.get(owner);
    if (const auto* real = std::get_if<float>(&value)) {
      EXPECT_EQ(member.type, "float");
      EXPECT_EQ(read_at<float>(bytes, member.offset), *real) << member.name;
    } else if (const auto* vector = std::get_if<glm::vec3>(&value)) {
      EXPECT_EQ(member.type, "vec3");
      EXPECT_EQ(read_at<glm::vec3>(bytes, member.offset), *vector) << member.name;
    } else {
      EXPECT_EQ(member.type, "int");
      const auto* boolean = std::get_if<bool>(&value);
      const auto* integer = std::get_if<int>(&value);
      const int expected = boolean   ? *boolean
                           : integer ? *integer
                                     : static_cast<int>(field.choices.size()) - 1;
      EXPECT_EQ(read_at<int>(bytes, member.offset), expected) << member.name;
    }
  }
  EXPECT_EQ(next, members.size()) << "members without a field";
}

TEST(GlslBlock, every_group_is_packed_where_std140_puts_its_members) {
  Settings settings;
  settings.models.emplace_back().name = "m";
  settings.lights.emplace_back().name = "l";
  for (const ParamGroup& group : list_groups(settings)) expect_packed(*group.description, group.owner);
}

struct Mixed {
  float before = 0;
  glm::vec3 vector{0.0F};
  float in_its_padding = 0;
  bool flag = false;
  glm::vec3 colour{0.0F};
  glm::vec3 next_vector{0.0F};
  std::string text;
  int last = 0;
  LightType type = LightType::directional;
};

Description mixed() {
  return {"mixed",
          "",
          {field<&Mixed::before>({.name = "before"}), field<&Mixed::vector>({.name = "vector"}),
           field<&Mixed::in_its_padding>({.name = "in_its_padding"}), field<&Mixed::flag>({.name = "flag"}),
           colour_field<&Mixed::colour>({.name = "colour"}),
           field<&Mixed::next_vector>({.name = "next_vector"}), field<&Mixed::text>({.name = "text"}),
           field<&Mixed::last>({.name = "last"}), field<&Mixed::type>({.name = "type"})}};
}

TEST(GlslBlock, vectors_scalars_and_what_shaders_cannot_read_mix) {
  Mixed values;
  expect_packed(mixed(), &values);
}

TEST(GlslBlock, known_offsets) {
  Mixed values;
  values.vector = {1, 2, 3};
  values.in_its_padding = 4;
  values.flag = true;
  const std::vector<uint8_t> bytes = pack_std140(mixed(), &values);
  EXPECT_EQ(bytes.size(), 96U);
  EXPECT_EQ(read_at<glm::vec3>(bytes, 16), glm::vec3(1, 2, 3));
  EXPECT_EQ(read_at<float>(bytes, 28), 4.0F);
  EXPECT_EQ(read_at<int>(bytes, 32), 1);
}

TEST(GlslBlock, texts_declare_structs_blocks_and_choices) {
  const Description description{
      "light", "", {field<&Mixed::type>({.name = "type"}), field<&Mixed::before>({.name = "before"})}};
  EXPECT_EQ(glsl_struct(description, "Light"), "struct Light {\n  int type;\n  float before;\n};\n");
  EXPECT_EQ(glsl_uniform_block(description, "light"),
            "layout(std140) uniform light_block {\n  int type;\n  float before;\n} light;\n");
  EXPECT_EQ(glsl_choices(description, "light"),
            "const int light_type_directional = 0;\nconst int light_type_point = 1;\n");
}

}  // namespace
}  // namespace inkbench
