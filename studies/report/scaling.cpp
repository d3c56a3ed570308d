// SPDX-License-Identifier: MIT
#include "studies/report/scaling.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

namespace inkbench {
namespace {

float decoded(double code) {
  return static_cast<float>(code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4));
}

using LightTable = std::array<float, 256>;

/// The light of each code.
const LightTable& light_table() {
  static const LightTable kTable = [] {
    LightTable table{};
    for (int code = 0; code < 256; ++code) table[code] = decoded(code / 255.0);
    return table;
  }();
  return kTable;
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

/// Shares of the old samples that new samples cover, one new sample after the other.
struct Cover {
  Samples old;
  const float* shares;
};

class Covers {
 public:
  /// Of the new samples from `first` up to `end`.
  Covers(int old_size, int new_size, int first, int end) {
    const double step = static_cast<double>(old_size) / new_size;
    for (int i = first; i < end; ++i) {
      const double begin = i * step;
      olds_.push_back(covered_samples(old_size, new_size, i));
      starts_.push_back(shares_.size());
      for (int j = olds_.back().first; j < olds_.back().end; ++j) {
        shares_.push_back(
            static_cast<float>((std::min(begin + step, j + 1.0) - std::max(begin, 1.0 * j)) / step));
      }
    }
  }
  size_t size() const { return olds_.size(); }
  Cover operator[](size_t i) const { return {olds_[i], &shares_[starts_[i]]}; }

 private:
  std::vector<Samples> olds_;
  std::vector<size_t> starts_;
  std::vector<float> shares_;
};

/// Adds to `sums` a share of the light of each of a row's samples.
void add_row(const uint8_t* samples, const LightTable& table, float share, std::vector<float>& sums) {
  for (size_t i = 0; i < sums.size(); ++i) sums[i] += share * table[samples[i]];
}

/// Of each sample's code itself.
void add_row(const uint8_t* samples, float share, std::vector<float>& sums) {
  for (size_t i = 0; i < sums.size(); ++i) sums[i] += share * static_cast<float>(samples[i]);
}

/// A row of sums, `kChannels` each, at the columns' width, to `row`; the sums begin with old column `origin`.
template <int kChannels>
void scale_row(const std::vector<float>& sums, int origin, const Covers& columns, float* row) {
  for (size_t x = 0; x < columns.size(); ++x) {
    const Cover cover = columns[x];
    const float* sample = sums.data() + static_cast<ptrdiff_t>(cover.old.first - origin) * kChannels;
    std::array<float, kChannels> sum{};
    for (int j = 0; j < cover.old.end - cover.old.first; ++j, sample += kChannels) {
      for (int i = 0; i < kChannels; ++i) sum[i] += cover.shares[j] * sample[i];
    }
    row = std::copy(sum.begin(), sum.end(), row);
  }
}

using RowScaler = void (*)(const std::vector<float>&, int, const Covers&, float*);

RowScaler row_scaler(int channels) {
  return channels == 1 ? scale_row<1> : channels == 3 ? scale_row<3> : scale_row<4>;
}

/// Columns as they are, where nothing is scaled.
Picture columns_of(const Picture& part, int first, int end) {
  Picture result(end - first, part.height_px, part.channels);
  for (int y = 0; y < part.height_px && first < end; ++y) {
    std::copy_n(&part.samples[part.index(first, y)], static_cast<size_t>(end - first) * part.channels,
                &result.samples[result.index(0, y)]);
  }
  return result;
}

}  // namespace

Samples covered_samples(int old_size, int new_size, int index) {
  const double step = static_cast<double>(old_size) / new_size;
  const double begin = index * step;
  const int first = static_cast<int>(begin);
  const int last = std::min(old_size, static_cast<int>(std::ceil(begin + step - 1e-9)));
  return {first, std::max(last, first + 1)};
}

Picture scaled_columns(const Picture& part, int origin, const Scaling& scaling, Samples wanted,
                       Averaging averaging) {
  assert(part.channels == 1 || part.channels == 3 || part.channels == 4);
  if (scaling.old_width_px == scaling.width_px && part.height_px == scaling.height_px)
    return columns_of(part, wanted.first - origin, wanted.end - origin);
  const LightTable& table = light_table();
  const Covers columns(scaling.old_width_px, scaling.width_px, wanted.first, wanted.end);
  const Covers rows(part.height_px, scaling.height_px, 0, scaling.height_px);
  const RowScaler scale = row_scaler(part.channels);
  Picture result(wanted.end - wanted.first, scaling.height_px, part.channels);
  std::vector<float> sums(static_cast<size_t>(part.width_px) * part.channels);
  std::vector<float> row(columns.size() * part.channels);
  auto out = result.samples.begin();
  for (size_t y = 0; y < rows.size() && !row.empty(); ++y) {
    const Cover cover = rows[y];
    std::fill(sums.begin(), sums.end(), 0.0F);
    for (int j = cover.old.first; j < cover.old.end; ++j) {
      const uint8_t* samples = &part.samples[part.index(0, j)];
      const float share = cover.shares[j - cover.old.first];
      if (averaging == Averaging::light)
        add_row(samples, table, share, sums);
      else
        add_row(samples, share, sums);
    }
    scale(sums, origin, columns, row.data());
    out = averaging == Averaging::light ? std::transform(row.begin(), row.end(), out, encoded)
                                        : std::transform(row.begin(), row.end(), out, rounded);
  }
  return result;
}

Picture scaled(const Picture& picture, int width_px, int height_px, Averaging averaging) {
  return scaled_columns(picture, 0, {picture.width_px, width_px, height_px}, {0, width_px}, averaging);
}

}  // namespace inkbench
