// SPDX-License-Identifier: MIT
// A linked program from two shader files, and what it may read: samplers and uniform blocks by name.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pipeline/base/key.h"
#include "pipeline/gl/object.h"
#include "pipeline/gl/shader_source.h"
#include "pipeline/gl/texture.h"
#include "pipeline/params/description.h"

namespace inkbench {

/// A uniform block and how many bytes a pass supplies for it.
struct UniformBlock {
  std::string name;
  size_t bytes = 0;
};

/// The block that is generated for a group of parameters: "combine_block" for "combine".
UniformBlock block_of(const Description& description);

/// What a pass supplies; each list's place is the unit or binding.
struct ProgramInputs {
  std::vector<std::string> samplers;
  std::vector<UniformBlock> uniform_blocks;
};

class Program {
 public:
  /// Compiles shaders/`vertex` and shaders/`fragment`. Errors (input): file and line of what the compiler
  /// objects to; an active uniform or block that is not among the inputs; a block of another size than what
  /// is supplied.
  Program(const std::string& vertex, const std::string& fragment, ProgramInputs inputs,
          const GeneratedSources& generated);

  /// Compiles again if a file changed since; on an error the last good program stays and the error is thrown
  /// once. Returns whether the program is another one now.
  bool reload_if_changed(const GeneratedSources& generated);

  /// Why the files as they are now do not make a program; empty where they do.
  const std::string& problem() const { return problem_; }

  /// Of both expanded sources: part of every key of what the program draws.
  const Key& key() const { return key_; }

  void use() const { glUseProgram(name_.id()); }

 private:
  static void destroy(GLuint id);
  using Name = GlName<&Program::destroy>;

  void reload(const GeneratedSources& generated);
  Name link(const ShaderSource& vertex, const ShaderSource& fragment) const;
  void bind_samplers(GLuint program, std::span<const ShaderSource* const> sources) const;
  void bind_blocks(GLuint program, std::span<const ShaderSource* const> sources) const;
  void remember(const ShaderSource& vertex, const ShaderSource& fragment);
  void watch(const ShaderSource& vertex, const ShaderSource& fragment);
  Key changes() const;

  std::string vertex_name_, fragment_name_;
  ProgramInputs inputs_;
  Name name_;
  Key key_;
  std::vector<std::filesystem::path> files_;
  Key file_times_;
  std::string problem_;
};

/// Binds textures to units 0, 1, ... in the order of the program's samplers.
void bind_textures(std::initializer_list<const Texture*> textures);

/// Binds buffers to uniform bindings 0, 1, ... in the order of the program's blocks.
void bind_uniform_blocks(std::span<const Buffer* const> buffers);
void bind_uniform_blocks(std::initializer_list<const Buffer*> buffers);

}  // namespace inkbench
