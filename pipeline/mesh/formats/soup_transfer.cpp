// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/soup_transfer.h"

#include <array>
#include <cstring>
#include <numeric>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

/// Lengths of the four arrays in order, then the two counts.
using Head = std::array<uint64_t, 6>;

template <class T>
std::span<const uint8_t> bytes_of(const T& array) {
  return {reinterpret_cast<const uint8_t*>(array.data()), array.size() * sizeof(array[0])};
}

Error damaged() {
  return work_error("", "the mesh reader's answer is damaged");
}

template <class T>
void take(std::span<const uint8_t>& bytes, uint64_t length, std::vector<T>& array) {
  if (length > bytes.size() / sizeof(T)) throw damaged();
  array.resize(length);
  if (length > 0) std::memcpy(array.data(), bytes.data(), length * sizeof(T));
  bytes = bytes.subspan(length * sizeof(T));
}

}  // namespace

void send_soup(const PolygonSoup& soup, const ByteSink& sink) {
  const Head head{soup.points.size(),  soup.normals.size(), soup.corner_counts.size(),
                  soup.corners.size(), soup.empty_polygons, soup.corner_normals.size()};
  sink(bytes_of(head));
  sink(bytes_of(soup.points));
  sink(bytes_of(soup.normals));
  sink(bytes_of(soup.corner_counts));
  sink(bytes_of(soup.corners));
  sink(bytes_of(soup.corner_normals));
}

PolygonSoup receive_soup(std::span<const uint8_t> bytes) {
  Head head{};
  if (bytes.size() < sizeof(head)) throw damaged();
  std::memcpy(head.data(), bytes.data(), sizeof(head));
  bytes = bytes.subspan(sizeof(head));
  PolygonSoup soup;
  take(bytes, head[0], soup.points);
  take(bytes, head[1], soup.normals);
  take(bytes, head[2], soup.corner_counts);
  take(bytes, head[3], soup.corners);
  take(bytes, head[5], soup.corner_normals);
  soup.empty_polygons = head[4];
  const uint64_t corners = std::accumulate(soup.corner_counts.begin(), soup.corner_counts.end(), uint64_t{0});
  const bool normals_match = soup.corner_normals.empty() || soup.corner_normals.size() == corners;
  if (!bytes.empty() || corners != soup.corners.size() || !normals_match) throw damaged();
  return soup;
}

}  // namespace inkbench
