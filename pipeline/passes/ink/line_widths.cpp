// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/line_widths.h"

#include <algorithm>

namespace inkbench {

WidthParams widths_of(const Settings& settings) {
  WidthParams widths{settings.line, {}, settings.image.height};
  for (size_t i = 0; i < kEdgeClasses; ++i) widths.of_class[i] = settings.class_looks[i].width;
  // What is no width.
  widths.line.taper = 0;
  widths.line.antialias = true;
  widths.line.colour_by_class = false;
  return widths;
}

bool widths_need_range(const Settings& settings) {
  return settings.line.unit == WidthUnit::world || settings.line.depth_taper > 0;
}

void WidthInput::fold(KeyBuilder& key, const FrameState& frame) const {
  const WidthParams widths = get(frame);
  key.add(group_text(widths.line));
  if (widths.line.unit == WidthUnit::percent) key.add(std::to_string(widths.height_px));
  key.add_bytes({reinterpret_cast<const uint8_t*>(widths.of_class.data()), sizeof widths.of_class});
}

WidthParams ClassWidthInput::get(const FrameState& frame) const {
  return {{}, widths_of(frame.settings).of_class, 0};
}

void ClassWidthInput::fold(KeyBuilder& key, const FrameState& frame) const {
  const WidthParams widths = get(frame);
  key.add_bytes({reinterpret_cast<const uint8_t*>(widths.of_class.data()), sizeof widths.of_class});
}

float widest_half_px(const WidthParams& widths, const LensBlock& lens, const glm::vec2& visible) {
  float width = widths.line.width;
  if (widths.line.unit == WidthUnit::percent) width *= static_cast<float>(widths.height_px) / 100.0F;
  if (widths.line.unit == WidthUnit::world) {
    if (visible.x > visible.y) return 0.0F;
    width /= lens.is_orthographic != 0 ? lens.pixel_size : lens.pixel_size * visible.x;
  }
  return 0.5F * width * *std::max_element(widths.of_class.begin(), widths.of_class.end());
}

float widest_half_px(const WidthParams& widths, const LensBlock& lens, const Texture* visible) {
  if (widths.line.unit != WidthUnit::world) return widest_half_px(widths, lens, glm::vec2(0.0F));
  const Image range = visible->read(0, 2);
  return widest_half_px(widths, lens, glm::vec2(range.at(0, 0, 0), range.at(0, 0, 1)));
}

Buffer widths_buffer(const WidthParams& widths, bool need_distance) {
  WidthsBlock block{};
  std::copy(widths.of_class.begin(), widths.of_class.end(), block.of_class);
  block.height_px = static_cast<float>(widths.height_px);
  block.need_distance = need_distance ? 1 : 0;
  return uniform_buffer("widths block", block);
}

}  // namespace inkbench
