#include "studies/report/scaling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace inkbench {
namespace {

float decoded(double code) {
  return static_cast<float>(code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4));
}

using SampleTable = std::array<float, 256>;

/// What each code counts as in a mean.
const SampleTable& sample_table(Averaging averaging) {
  static const auto kTables = [] {
    std::array<SampleTable, 2> tables{};
    for (int code = 0; code < 256; ++code) {
      tables[0][code] = decoded(code / 255.0);
      tables[1][code] = static_cast<float>(code);
    }
    return tables;
  }();
  return kTables[averaging == Averaging::light ? 0 : 1];
}

/// The sRGB code whose light is nearest in code space, by a table fine enough for the steepest part, near
/// black.
uint8_t encoded(float light) {
  static constexpr int kSteps = 1 << 14;
  static const std::vector<uint8_t> kTable = [] {
    std::vector<uint8_t> table(kSteps + 1);
    for (int i = 0, code = 0; i <= kSteps; ++i) {
      while (code < 255 && decoded((code + 0.5) / 255.0) < static_cast<float>(i) / kSteps) ++code;
      table[i] = static_cast<uint8_t>(code);
    }
    return table;
  }();
  return kTable[static_cast<size_t>(std::clamp(light, 0.0F, 1.0F) * kSteps + 0.5F)];
}

uint8_t rounded(float code) {
  return static_cast<uint8_t>(std::clamp(code, 0.0F, 255.0F) + 0.5F);
}

/// The old samples one new sample covers, [first, first + weights.size()), and their shares of it.
struct Cover {
  int first = 0;
  std::vector<float> weights;
};

std::vector<Cover> covers(int old_size, int new_size) {
  std::vector<Cover> all(new_size);
  const double step = static_cast<double>(old_size) / new_size;
  for (int i = 0; i < new_size; ++i) {
    const double begin = i * step, end = begin + step;
    const int first = static_cast<int>(begin);
    const int last = std::min(old_size, static_cast<int>(std::ceil(end - 1e-9)));
    all[i].first = first;
    for (int j = first; j < std::max(last, first + 1); ++j) {
      all[i].weights.push_back(
          static_cast<float>((std::min(end, j + 1.0) - std::max(begin, 1.0 * j)) / step));
    }
  }
  return all;
}

/// One row of `picture`, its samples taken through `table`, at the width of `columns`.
std::vector<float> scaled_row(const Picture& picture, int y, const std::vector<Cover>& columns,
                              const SampleTable& table) {
  const int channels = picture.channels;
  std::vector<float> row(columns.size() * channels, 0.0F);
  for (size_t x = 0; x < columns.size(); ++x) {
    const uint8_t* sample = &picture.samples[picture.index(columns[x].first, y)];
    for (const float weight : columns[x].weights) {
      for (int i = 0; i < channels; ++i) row[x * channels + i] += weight * table[*sample++];
    }
  }
  return row;
}

}  // namespace

Picture scaled(const Picture& picture, int width_px, int height_px, Averaging averaging) {
  if (picture.width_px == width_px && picture.height_px == height_px) return picture;
  const SampleTable& table = sample_table(averaging);
  const std::vector<Cover> columns = covers(picture.width_px, width_px);
  const std::vector<Cover> rows = covers(picture.height_px, height_px);
  Picture result(width_px, height_px, picture.channels);
  auto out = result.samples.begin();
  for (const Cover& cover : rows) {
    std::vector<float> sum(columns.size() * picture.channels, 0.0F);
    for (size_t j = 0; j < cover.weights.size(); ++j) {
      const std::vector<float> row = scaled_row(picture, cover.first + static_cast<int>(j), columns, table);
      for (size_t i = 0; i < sum.size(); ++i) sum[i] += cover.weights[j] * row[i];
    }
    out = averaging == Averaging::light ? std::transform(sum.begin(), sum.end(), out, encoded)
                                        : std::transform(sum.begin(), sum.end(), out, rounded);
  }
  return result;
}

}  // namespace inkbench
