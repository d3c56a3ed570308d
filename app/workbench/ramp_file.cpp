// SPDX-License-Identifier: MIT
#include "app/workbench/ramp_file.h"

#include <algorithm>
#include <cmath>

#include "app/workbench/ramp_edit.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/image/image_file.h"
#include "pipeline/params/toml_value.h"

namespace inkbench {
namespace {

constexpr int kPictureHeightPx = 64;  // high enough to see; only the first row is read
constexpr const char* kStopsEntry = "stops";

Param stops_param() {
  static RampParams owner;
  const std::vector<Field>& fields = RampParams::description().fields;
  const auto field = std::find_if(fields.begin(), fields.end(),
                                  [](const Field& candidate) { return candidate.type == FieldType::ramp; });
  return {kStopsEntry, &*field, &owner};
}

Image table_image(const Ramp& ramp, int height_px) {
  const std::vector<glm::vec3> table = ramp_table(ramp);
  Image image(kRampTexels, height_px, 3);
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < kRampTexels; ++x) {
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = table[static_cast<size_t>(x)][c];
    }
  }
  return image;
}

Picture to_picture(const Image& image) {
  Picture picture(image.width_px, image.height_px, image.channels);
  std::transform(image.samples.begin(), image.samples.end(), picture.samples.begin(), [](float value) {
    return static_cast<uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
  });
  return picture;
}

}  // namespace

void save_ramp(const fs::path& path, const Ramp& ramp) {
  const std::string extension = path.extension().string();
  if (extension == ".toml") {
    const Ramp stops = with_stops(ramp);
    write_file_atomically(
        path, std::string("# inkbench ramp\n") + kStopsEntry + " = " + to_text(Value(stops)) + "\n");
  } else if (extension == ".png") {
    write_png(path, to_picture(table_image(ramp, kPictureHeightPx)), {});
  } else if (extension == ".exr") {
    write_exr(path, table_image(ramp, 1), {});
  } else {
    throw input_error(path.string(), "a ramp is not written as '" + extension + "'",
                      "name it .toml (stops), .png or .exr (an image)");
  }
}

Ramp load_ramp(const fs::path& path) {
  if (path.extension() == ".toml")
    return parse_ramp(parse_toml(read_file(path, kMostTextBytes), path.string()), path.string());
  Ramp ramp;
  ramp.image = fs::absolute(path).lexically_normal().string();
  ramp_table(ramp);  // it must be readable
  return ramp;
}

bool is_ramp_document(const TomlNode& document) {
  return document.find(kStopsEntry) != nullptr;
}

Ramp parse_ramp(const TomlNode& document, const std::string& name) {
  const auto at = [&](const TomlNode& node) { return name + ":" + std::to_string(node.line); };
  const TomlNode* stops = document.find(kStopsEntry);
  if (stops == nullptr)
    throw input_error(name, "holds no ramp", "it needs stops = [{position = 0, ...}, ...]");
  for (const auto& [key, node] : document.entries) {
    if (key != kStopsEntry)
      throw input_error(at(node), "unknown entry '" + key + "'", "a ramp has stops alone");
  }
  if (!stops->is_array())
    throw input_error(at(*stops), "stops is " + stops->kind_name(), "it must be a list");
  const Param param = stops_param();
  const Value value = value_from_toml(param, *stops, at(*stops), "/");
  check_value(*param.field, param.key, value, at(*stops));
  return std::get<Ramp>(value);
}

}  // namespace inkbench
