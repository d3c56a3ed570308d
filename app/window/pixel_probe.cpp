#include "app/window/pixel_probe.h"

#include <algorithm>

namespace inkbench {
namespace {

/// A gradient's neighbour is one pixel away, and the maps that it compares are one more.
constexpr int kReach = 2;

struct Part {
  int x, y, width, height;
};

Part around(const ImageParams& image, int x, int y) {
  const int left = std::max(x - kReach, 0);
  const int top = std::max(y - kReach, 0);
  return {left, top, std::min(x + kReach + 1, image.width) - left,
          std::min(y + kReach + 1, image.height) - top};
}

Neighbourhood neighbours(const Image& image, int x, int y) {
  Neighbourhood result;
  for (int i = 0; i < 9; ++i) {
    const int nx = x + i % 3 - 1;
    const int ny = y + i / 3 - 1;
    if (nx >= 0 && nx < image.width_px && ny >= 0 && ny < image.height_px)
      result[static_cast<size_t>(i)] = image.at(nx, ny);
  }
  return result;
}

ProbedPixel read_pixel(const Frame& frame, int x, int y) {
  const Settings& settings = frame.settings();
  const Part part = around(settings.image, x, y);
  const auto read = [&](BufferName buffer) {
    return frame.raw_part(buffer, part.x, part.y, part.width, part.height);
  };
  const Image depth_edges = read(BufferName::depth_edges);
  const Image normal_edges = read(BufferName::normal_edges);
  const Image depth = read(BufferName::depth);
  const Image normal = read(BufferName::normal);
  const Image object_id = read(BufferName::object_id);
  const int in_x = x - part.x;
  const int in_y = y - part.y;
  ProbedPixel probed;
  probed.why = why_pixel({depth_edges, normal_edges, &depth, &normal, &object_id}, settings.combine, in_x,
                         in_y, settings.image.precision);
  probed.why.x = x;
  probed.why.y = y;
  probed.depth_edges = neighbours(depth_edges, in_x, in_y);
  probed.normal_edges = neighbours(normal_edges, in_x, in_y);
  probed.drawn = frame.pixel(BufferName::combined_edges, x, y).at(0, 0);
  return probed;
}

}  // namespace

const ProbedPixel& PixelProbe::probe(const Frame& frame, int x, int y) {
  const Key key = frame.key(BufferName::combined_edges);
  if (key == key_ && x == x_ && y == y_) return probed_;
  probed_ = read_pixel(frame, x, y);
  key_ = key;
  x_ = x;
  y_ = y;
  return probed_;
}

}  // namespace inkbench
