// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/scene_transfer.h"

#include <numeric>

#include "pipeline/mesh/formats/byte_stream.h"

namespace inkbench {
namespace {

// Each of these names the members once, for the way there and the way back.

template <class Stream, class Soup>
void pass_soup(Stream& stream, Soup& soup) {
  stream.array(soup.points);
  stream.array(soup.corner_counts);
  stream.array(soup.corners);
  stream.array(soup.normals);
  stream.array(soup.corner_normals);
  stream.array(soup.smoothing_groups);
  stream.value(soup.corners_are_rounded);
  stream.value(soup.is_flat);
  stream.value(soup.empty_polygons);
  stream.list(soup.notes, [&](auto& note) { stream.array(note); });
}

template <class Stream, class Camera>
void pass_camera(Stream& stream, Camera& camera) {
  stream.array(camera.name);
  stream.value(camera.eye);
  stream.value(camera.direction);
  stream.value(camera.up);
  stream.value(camera.horizontal_fov_deg);
  stream.value(camera.aspect);
  stream.value(camera.view_height);
}

template <class Stream, class Light>
void pass_light(Stream& stream, Light& light) {
  stream.array(light.name);
  stream.value(light.type);
  stream.value(light.position);
  stream.value(light.direction);
  stream.value(light.intensity);
}

template <class Stream, class Scene>
void pass_scene(Stream& stream, Scene& scene) {
  stream.list(scene.parts, [&](auto& part) {
    stream.array(part.name);
    pass_soup(stream, part.soup);
    stream.value(part.colour);
  });
  stream.list(scene.cameras, [&](auto& camera) { pass_camera(stream, camera); });
  stream.list(scene.lights, [&](auto& light) { pass_light(stream, light); });
  stream.list(scene.notes, [&](auto& note) { stream.array(note); });
  stream.list(scene.view_notes, [&](auto& note) { stream.array(note); });
}

bool is_consistent(const PolygonSoup& soup) {
  const uint64_t corners = std::accumulate(soup.corner_counts.begin(), soup.corner_counts.end(), uint64_t{0});
  const auto fits = [](const auto& array, size_t size) { return array.empty() || array.size() == size; };
  return corners == soup.corners.size() && fits(soup.corner_normals, soup.corners.size()) &&
         fits(soup.smoothing_groups, soup.corner_counts.size());
}

}  // namespace

void send_scene(const ImportedScene& scene, const ByteSink& sink) {
  ByteWriter writer(sink);
  pass_scene(writer, scene);
}

ImportedScene receive_scene(std::span<const uint8_t> bytes) {
  ByteReader reader(bytes);
  ImportedScene scene;
  pass_scene(reader, scene);
  reader.check_all_taken();
  for (const ImportedPart& part : scene.parts) {
    if (!is_consistent(part.soup)) throw ByteReader::damaged();
  }
  for (const ImportedLight& light : scene.lights) {
    if (light.type > ImportedLightType::point) throw ByteReader::damaged();
  }
  return scene;
}

}  // namespace inkbench
