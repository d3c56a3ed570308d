// SPDX-License-Identifier: MIT
// An image in memory: H x W x C samples, row 0 on top, channels interleaved.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace inkbench {

template <class Sample>
struct ImageOf {
  int width_px = 0;
  int height_px = 0;
  int channels = 0;
  std::vector<Sample> samples;  ///< H x W x C, row 0 on top.

  ImageOf() = default;
  ImageOf(int width, int height, int channel_count, Sample fill = Sample{})
      : width_px(width),
        height_px(height),
        channels(channel_count),
        samples(static_cast<size_t>(width) * height * channel_count, fill) {}

  size_t index(int x, int y, int channel = 0) const {
    assert(x >= 0 && x < width_px && y >= 0 && y < height_px && channel >= 0 && channel < channels);
    return (static_cast<size_t>(y) * width_px + x) * channels + channel;
  }
  Sample& at(int x, int y, int channel = 0) { return samples[index(x, y, channel)]; }
  const Sample& at(int x, int y, int channel = 0) const { return samples[index(x, y, channel)]; }
  bool operator==(const ImageOf&) const = default;
};

using Image = ImageOf<float>;      ///< Raw values, as a pass wrote them.
using Picture = ImageOf<uint8_t>;  ///< Display values, 0 to 255, sRGB as shown.

}  // namespace inkbench
