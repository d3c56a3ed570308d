// SPDX-License-Identifier: MIT
// Uniform blocks from descriptions: their GLSL text, which shaders include, and the bytes that fill them
// (std140).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/params/description.h"

namespace inkbench {

/// The members that a shader can read, one a line: "float k_depth;". Booleans and choices are ints; texts and
/// ramps are left out.
std::string glsl_members(const Description& description);

/// `struct NAME { members };`, for lists of lights and materials.
std::string glsl_struct(const Description& description, const std::string& name);

/// `layout(std140) uniform NAME_block { members } NAME;`
std::string glsl_uniform_block(const Description& description, const std::string& name);

/// `const int PREFIX_NAME = 0;` for each choice of each field: "light_type_point".
std::string glsl_choices(const Description& description, const std::string& prefix);

/// The values as std140 bytes, padded to 16: what `glsl_members` lays out, and the stride of an array of
/// them.
std::vector<uint8_t> pack_std140(const Description& description, const void* owner);

/// How many bytes `pack_std140` gives.
size_t std140_size(const Description& description);

}  // namespace inkbench
