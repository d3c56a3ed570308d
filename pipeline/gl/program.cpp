// SPDX-License-Identifier: MIT
#include "pipeline/gl/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "pipeline/base/error.h"
#include "pipeline/gl/gl_context.h"
#include "pipeline/params/glsl_block.h"

namespace inkbench {
namespace {

struct ShaderDeleter {
  static void destroy(GLuint id) { glDeleteShader(id); }
};
using ShaderName = GlName<&ShaderDeleter::destroy>;

ShaderName compile(GLenum stage, const ShaderSource& source) {
  ShaderName shader(glCreateShader(stage));
  const char* text = source.text.c_str();
  glShaderSource(shader.id(), 1, &text, nullptr);
  glCompileShader(shader.id());
  GLint ok = GL_FALSE;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &ok);
  if (ok == GL_TRUE) return shader;
  std::array<char, 8192> log{};
  glGetShaderInfoLog(shader.id(), static_cast<GLsizei>(log.size()), nullptr, log.data());
  discard_gl_errors();
  throw input_error("", name_log_lines(log.data(), source.names));
}

std::string resource_name(GLuint program, GLenum kind, GLint index) {
  std::array<char, 256> name{};
  glGetProgramResourceName(program, kind, index, static_cast<GLsizei>(name.size()), nullptr, name.data());
  return name.data();
}

using Sources = std::span<const ShaderSource* const>;

std::string place_in(Sources sources, const std::string& name) {
  for (const ShaderSource* source : sources) {
    if (std::string where = find_word(*source, name); !where.empty()) return where;
  }
  return "";
}

/// The place among what is supplied, whose names `projection` gives.
template <class Known, class Projection>
GLint place_of(const std::string& name, const Known& known, Projection projection, Sources sources) {
  const auto found = std::ranges::find(known, name, projection);
  if (found != known.end()) return static_cast<GLint>(found - known.begin());
  throw input_error(place_in(sources, name), "nothing supplies '" + name + "'",
                    "put it into a described parameter group, or remove it");
}

/// Drivers may or may not count what fills the last 16 bytes.
size_t padded(size_t bytes) {
  return (bytes + 15) / 16 * 16;
}

void check_block_size(GLuint program, GLuint index, const UniformBlock& block, Sources sources) {
  GLint bytes = 0;
  glGetActiveUniformBlockiv(program, index, GL_UNIFORM_BLOCK_DATA_SIZE, &bytes);
  if (padded(static_cast<size_t>(bytes)) == padded(block.bytes)) return;
  throw input_error(place_in(sources, block.name),
                    fmt::format("'{}' has {} bytes, but {} are supplied", block.name, bytes, block.bytes),
                    "its members must be those of its C++ side, in the same order");
}

}  // namespace

UniformBlock block_of(const Description& description) {
  return {std::string(description.group) + "_block", std140_size(description)};
}

Program::Program(const std::string& vertex, const std::string& fragment, ProgramInputs inputs,
                 const GeneratedSources& generated)
    : vertex_name_(vertex), fragment_name_(fragment), inputs_(std::move(inputs)) {
  const ShaderSource vertex_source = expand_shader(vertex_name_, generated);
  const ShaderSource fragment_source = expand_shader(fragment_name_, generated);
  name_ = link(vertex_source, fragment_source);
  remember(vertex_source, fragment_source);
}

/// OpenGL keeps a deleted program for as long as it is the current one: who saves the current program and
/// puts it back, as a window's toolkit does, would put back one that is gone by then.
void Program::destroy(GLuint id) {
  GLint current = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &current);
  if (static_cast<GLuint>(current) == id) glUseProgram(0);
  glDeleteProgram(id);
}

bool Program::reload_if_changed(const GeneratedSources& generated) {
  const Key times = changes();
  if (times == file_times_) return false;
  file_times_ = times;  // an error is told once, not every frame
  try {
    reload(generated);
  } catch (const Error& error) {
    problem_ = error.what();
    throw;
  }
  problem_.clear();
  return true;
}

void Program::reload(const GeneratedSources& generated) {
  const ShaderSource vertex = expand_shader(vertex_name_, generated);
  const ShaderSource fragment = expand_shader(fragment_name_, generated);
  watch(vertex, fragment);  // before linking: mending a file that the broken edit includes counts
  Name fresh = link(vertex, fragment);
  name_ = std::move(fresh);
  remember(vertex, fragment);
}

Program::Name Program::link(const ShaderSource& vertex, const ShaderSource& fragment) const {
  const ShaderName vertex_shader = compile(GL_VERTEX_SHADER, vertex);
  const ShaderName fragment_shader = compile(GL_FRAGMENT_SHADER, fragment);
  Name program(glCreateProgram());
  label_object(GL_PROGRAM, program.id(), vertex_name_ + " + " + fragment_name_);
  glAttachShader(program.id(), vertex_shader.id());
  glAttachShader(program.id(), fragment_shader.id());
  glLinkProgram(program.id());
  GLint ok = GL_FALSE;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &ok);
  if (ok != GL_TRUE) {
    std::array<char, 8192> log{};
    glGetProgramInfoLog(program.id(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    discard_gl_errors();
    throw input_error("shaders/" + fragment_name_, log.data());
  }
  const ShaderSource* const sources[] = {&vertex, &fragment};
  bind_samplers(program.id(), sources);
  bind_blocks(program.id(), sources);
  return program;
}

void Program::bind_samplers(GLuint program, Sources sources) const {
  GLint count = 0;
  glGetProgramInterfaceiv(program, GL_UNIFORM, GL_ACTIVE_RESOURCES, &count);
  for (GLint i = 0; i < count; ++i) {
    const GLenum properties[] = {GL_BLOCK_INDEX, GL_LOCATION};
    GLint values[2] = {};
    glGetProgramResourceiv(program, GL_UNIFORM, i, 2, properties, 2, nullptr, values);
    if (values[0] >= 0) continue;
    const std::string name = resource_name(program, GL_UNIFORM, i);
    glProgramUniform1i(program, values[1], place_of(name, inputs_.samplers, std::identity(), sources));
  }
}

void Program::bind_blocks(GLuint program, Sources sources) const {
  GLint count = 0;
  glGetProgramInterfaceiv(program, GL_UNIFORM_BLOCK, GL_ACTIVE_RESOURCES, &count);
  for (GLint i = 0; i < count; ++i) {
    const std::string name = resource_name(program, GL_UNIFORM_BLOCK, i);
    const auto binding =
        static_cast<GLuint>(place_of(name, inputs_.uniform_blocks, &UniformBlock::name, sources));
    check_block_size(program, static_cast<GLuint>(i), inputs_.uniform_blocks[binding], sources);
    glUniformBlockBinding(program, static_cast<GLuint>(i), binding);
  }
}

void Program::remember(const ShaderSource& vertex, const ShaderSource& fragment) {
  key_ = KeyBuilder().add(vertex.key).add(fragment.key).key();
  watch(vertex, fragment);
}

void Program::watch(const ShaderSource& vertex, const ShaderSource& fragment) {
  files_ = vertex.files;
  files_.insert(files_.end(), fragment.files.begin(), fragment.files.end());
  file_times_ = changes();
}

Key Program::changes() const {
  KeyBuilder builder;
  for (const std::filesystem::path& file : files_) {
    std::error_code error;
    const auto time = std::filesystem::last_write_time(file, error);
    builder.add(std::to_string(error ? 0 : time.time_since_epoch().count()));
  }
  return builder.key();
}

void bind_textures(std::initializer_list<const Texture*> textures) {
  GLuint unit = 0;
  for (const Texture* texture : textures) glBindTextureUnit(unit++, texture->id());
}

void bind_uniform_blocks(std::initializer_list<const Buffer*> buffers) {
  bind_uniform_blocks(std::span(buffers.begin(), buffers.size()));
}

void bind_uniform_blocks(std::span<const Buffer* const> buffers) {
  GLuint binding = 0;
  for (const Buffer* buffer : buffers) glBindBufferBase(GL_UNIFORM_BUFFER, binding++, buffer->id());
}

}  // namespace inkbench
