// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/mesh_reader.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <array>
#include <cassert>
#include <glm/geometric.hpp>
#include <istream>
#include <limits>
#include <sstream>
#include <streambuf>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

using namespace OpenMesh;  // the importer's interface speaks of little else

float coordinate(float value) {
  return value == kNotFinite ? std::numeric_limits<float>::quiet_NaN() : value;
}

glm::vec3 to_vec3(const Vec3f& v) {
  return {coordinate(v[0]), coordinate(v[1]), coordinate(v[2])};
}

/// Takes down what a reader finds, without half-edges, which would refuse non-manifold faces.
class SoupImporter : public IO::BaseImporter {
 public:
  PolygonSoup take_soup() {
    if (!soup_.normals.empty()) soup_.corner_normals = soup_.corners;
    return std::move(soup_);
  }

  VertexHandle add_vertex(const Vec3f& point) override {
    soup_.points.emplace_back(to_vec3(point));
    if (!soup_.normals.empty()) soup_.normals.emplace_back(0.0F);
    return VertexHandle(static_cast<int>(soup_.points.size()) - 1);
  }
  VertexHandle add_vertex(const Vec3d& point) override { return add_vertex(Vec3f(point)); }
  VertexHandle add_vertex() override { return add_vertex(Vec3f(0.0F, 0.0F, 0.0F)); }
  void set_point(VertexHandle vertex, const Vec3f& point) override {
    if (is_vertex(vertex)) soup_.points[index(vertex)] = to_vec3(point);
  }

  FaceHandle add_face(const VHandles& corners) override {
    for (const VertexHandle corner : corners) soup_.corners.push_back(corner.idx());
    soup_.corner_counts.push_back(static_cast<uint32_t>(corners.size()));
    return FaceHandle(static_cast<int>(soup_.corner_counts.size()) - 1);
  }

  /// OBJ gives normals corner by corner. Where two faces give one vertex different ones, no single one is
  /// right.
  void set_normal(VertexHandle vertex, const Vec3f& value) override {
    if (!is_vertex(vertex)) return;
    soup_.normals.resize(soup_.points.size(), glm::vec3(0.0F));
    soup_.normals[index(vertex)] = to_vec3(value);
  }
  void set_normal(VertexHandle vertex, const Vec3d& normal) override { set_normal(vertex, Vec3f(normal)); }

  size_t n_vertices() const override { return soup_.points.size(); }
  size_t n_faces() const override { return soup_.corner_counts.size(); }
  size_t n_edges() const override { return 0; }

  // What a picture of lines does not need.
  HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
  FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f>&) override {}
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec3f>&) override {}
  void set_face_texindex(FaceHandle, int) override {}
  void set_halfedge(VertexHandle, HalfedgeHandle) override {}
  void set_color(VertexHandle, const Vec3uc&) override {}
  void set_color(VertexHandle, const Vec4uc&) override {}
  void set_color(VertexHandle, const Vec3f&) override {}
  void set_color(VertexHandle, const Vec4f&) override {}
  void set_texcoord(VertexHandle, const Vec2f&) override {}
  void set_texcoord(HalfedgeHandle, const Vec2f&) override {}
  void set_texcoord(VertexHandle, const Vec3f&) override {}
  void set_texcoord(HalfedgeHandle, const Vec3f&) override {}
  void set_status(VertexHandle, const Attributes::StatusInfo&) override {}
  void set_status(HalfedgeHandle, const Attributes::StatusInfo&) override {}
  void set_status(EdgeHandle, const Attributes::StatusInfo&) override {}
  void set_status(FaceHandle, const Attributes::StatusInfo&) override {}
  void set_next(HalfedgeHandle, HalfedgeHandle) override {}
  void set_face(HalfedgeHandle, FaceHandle) override {}
  void request_face_texcoords2D() override {}
  void set_color(EdgeHandle, const Vec3uc&) override {}
  void set_color(EdgeHandle, const Vec4uc&) override {}
  void set_color(EdgeHandle, const Vec3f&) override {}
  void set_color(EdgeHandle, const Vec4f&) override {}
  void set_normal(FaceHandle, const Vec3f&) override {}
  void set_normal(FaceHandle, const Vec3d&) override {}
  void set_color(FaceHandle, const Vec3uc&) override {}
  void set_color(FaceHandle, const Vec4uc&) override {}
  void set_color(FaceHandle, const Vec3f&) override {}
  void set_color(FaceHandle, const Vec4f&) override {}
  void add_texture_information(int, std::string) override {}

 private:
  static size_t index(VertexHandle vertex) { return static_cast<size_t>(vertex.idx()); }
  bool is_vertex(VertexHandle vertex) const {
    return vertex.idx() >= 0 && index(vertex) < soup_.points.size();
  }

  PolygonSoup soup_;
};

/// A read-only stream over bytes that stay where they are.
class ViewBuffer : public std::streambuf {
 public:
  explicit ViewBuffer(std::string_view bytes) {
    char* begin = const_cast<char*>(bytes.data());  // streambuf has no const get area; nothing writes
    setg(begin, begin, begin + bytes.size());
  }

 private:
  pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override {
    off_type start = 0;
    if (from == std::ios_base::cur) start = gptr() - eback();
    if (from == std::ios_base::end) start = egptr() - eback();
    return seekpos(start + offset, std::ios_base::in);
  }
  pos_type seekpos(pos_type position, std::ios_base::openmode) override {
    const off_type target = position;
    if (target < 0 || target > egptr() - eback()) return off_type(-1);
    setg(eback(), eback() + target, egptr());
    return position;
  }
};

/// The readers choose by extension.
const char* file_name_for(MeshFormat format) {
  switch (format) {
    case MeshFormat::obj:
      return "mesh.obj";
    case MeshFormat::ply:
      return "mesh.ply";
    case MeshFormat::off:
      return "mesh.off";
    case MeshFormat::stl:
      return "mesh.stl";
  }
  assert(false && "unknown mesh format");
  return "";
}

/// OpenMesh's complaints while this lives.
class CapturedMessages {
 public:
  CapturedMessages() {
    for (mostream* stream : streams()) stream->connect(text_);
  }
  CapturedMessages(const CapturedMessages&) = delete;
  CapturedMessages& operator=(const CapturedMessages&) = delete;
  ~CapturedMessages() {
    for (mostream* stream : streams()) stream->disconnect(text_);
  }
  std::string text() const { return std::string(trim(text_.str())); }

 private:
  static std::array<mostream*, 3> streams() { return {&omlog(), &omout(), &omerr()}; }
  std::ostringstream text_;
};

}  // namespace

PolygonSoup read_with_openmesh(const MeshSource& source) {
  const CapturedMessages messages;
  ViewBuffer buffer(source.bytes);
  std::istream stream(&buffer);
  SoupImporter importer;
  IO::Options options(IO::Options::VertexNormal);
  if (source.binary) options += IO::Options::Binary;
  if (!IO::IOManager().read(stream, file_name_for(source.format), importer, options)) {
    throw input_error("", "OpenMesh cannot read it: " + messages.text());
  }
  return importer.take_soup();
}

}  // namespace inkbench
