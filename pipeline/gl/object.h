// SPDX-License-Identifier: MIT
// Move-only owners of OpenGL names: made whole, deleted in the destructor.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace inkbench {

/// A name and how it is deleted; 0 owns nothing.
template <auto kDelete>
class GlName {
 public:
  GlName() = default;
  explicit GlName(GLuint id) : id_(id) {}
  GlName(GlName&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~GlName() {
    if (id_ != 0) kDelete(id_);
  }
  GLuint id() const { return id_; }

 private:
  GLuint id_ = 0;
};

inline void label_object(GLenum kind, GLuint id, const std::string& label) {
  glObjectLabel(kind, id, static_cast<GLsizei>(label.size()), label.c_str());
}

/// An immutable buffer, filled when made: vertices, indices, uniforms, shader storage.
class Buffer {
 public:
  Buffer() = default;
  Buffer(const std::string& label, std::span<const uint8_t> bytes);
  GLuint id() const { return name_.id(); }

 private:
  static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
  GlName<&Buffer::destroy> name_;
};

template <class T>
std::span<const uint8_t> bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const uint8_t*>(values.data()), values.size_bytes()};
}

/// Of one uniform block, as a struct in std140.
template <class Block>
Buffer uniform_buffer(const std::string& label, const Block& block) {
  return {label, bytes_of(std::span<const Block>(&block, 1))};
}

class VertexArray {
 public:
  explicit VertexArray(const std::string& label);
  GLuint id() const { return name_.id(); }

 private:
  static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
  GlName<&VertexArray::destroy> name_;
};

}  // namespace inkbench
