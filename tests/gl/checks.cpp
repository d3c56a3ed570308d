// SPDX-License-Identifier: MIT
#include "tests/gl/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>

#include "pipeline/base/files.h"

namespace inkbench {

Image noise(int width_px, int height_px, int channels, uint32_t seed, float low, float high) {
  std::mt19937 random(seed);
  Image image(width_px, height_px, channels);
  // Not std::uniform_real_distribution, whose results depend on the library.
  for (float& value : image.samples)
    value = low + (high - low) * (static_cast<float>(random() >> 8) / 16777216.0F);
  return image;
}

Image make_image(int width_px, int height_px, const std::function<double(int x, int y)>& value) {
  Image image(width_px, height_px, 1);
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; ++x) image.at(x, y) = static_cast<float>(value(x, y));
  }
  return image;
}

Image with_depth(const Image& normal, const Image& depth) {
  Image both(normal.width_px, normal.height_px, 4);
  for (int y = 0; y < both.height_px; ++y) {
    for (int x = 0; x < both.width_px; ++x) {
      for (int c = 0; c < 3; ++c) both.at(x, y, c) = normal.at(x, y, c);
      both.at(x, y, 3) = depth.at(x, y);
    }
  }
  return both;
}

Texture to_texture(const Image& image) {
  const int channels = image.channels == 3 ? 4 : image.channels;
  Image padded(image.width_px, image.height_px, channels, 1.0F);
  for (int y = 0; y < image.height_px; ++y) {
    for (int x = 0; x < image.width_px; ++x) {
      for (int c = 0; c < image.channels; ++c) padded.at(x, y, c) = image.at(x, y, c);
    }
  }
  const TextureFormat formats[] = {TextureFormat::r32f, TextureFormat::rg32f, TextureFormat::rgba32f,
                                   TextureFormat::rgba32f};
  Texture texture("test", formats[channels - 1], image.width_px, image.height_px);
  texture.upload(padded);
  return texture;
}

testing::AssertionResult is_near(const Image& actual, const reference::Map& expected, double tolerance,
                                 const ImageOf<uint8_t>* leave_out) {
  if (actual.width_px != expected.width_px || actual.height_px != expected.height_px ||
      actual.channels != expected.channels) {
    return testing::AssertionFailure()
           << fmt::format("{} x {} x {} is not {} x {} x {}", actual.width_px, actual.height_px,
                          actual.channels, expected.width_px, expected.height_px, expected.channels);
  }
  double worst = 0.0;
  std::string worst_place;
  size_t wrong = 0;
  for (int y = 0; y < actual.height_px; ++y) {
    for (int x = 0; x < actual.width_px; ++x) {
      if (leave_out != nullptr && leave_out->at(x, y) != 0) continue;
      for (int c = 0; c < actual.channels; ++c) {
        const double difference = std::abs(actual.at(x, y, c) - expected.at(x, y, c));
        if (difference <= tolerance) continue;  // a NaN goes on, and counts as wrong
        ++wrong;
        if (difference <= worst) continue;
        worst = difference;
        worst_place = fmt::format("at x {}, y {}, channel {}: {} instead of {}", x, y, c, actual.at(x, y, c),
                                  expected.at(x, y, c));
      }
    }
  }
  if (wrong == 0) return testing::AssertionSuccess();
  return testing::AssertionFailure() << fmt::format("{} samples are off by more than {}; worst {}", wrong,
                                                    tolerance, worst_place);
}

testing::AssertionResult is_near(const Image& actual, const Image& expected, double tolerance,
                                 const ImageOf<uint8_t>* leave_out) {
  return is_near(actual, reference::to_map(expected), tolerance, leave_out);
}

double share_of(const ImageOf<uint8_t>& mask) {
  const auto count =
      std::count_if(mask.samples.begin(), mask.samples.end(), [](uint8_t value) { return value != 0; });
  return static_cast<double>(count) / static_cast<double>(mask.samples.size());
}

double largest_difference(const Image& a, const Image& b) {
  double largest = 0.0;
  for (size_t i = 0; i < a.samples.size(); ++i) {
    largest = std::max(largest, std::abs(static_cast<double>(a.samples[i]) - b.samples[i]));
  }
  return largest;
}

std::vector<BufferName> framebuffers() {
  std::vector<BufferName> buffers = all_buffers();
  std::erase_if(buffers, [](BufferName buffer) { return buffer.info().shown_as == ShownAs::drawing; });
  return buffers;
}

std::string input_error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

fs::path TempFolder::write(const std::string& name, std::string_view content) {
  const fs::path file = path() / name;
  write_file_atomically(file, content);
  // A file system's clock may not move between two quick writes.
  fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::seconds(++writes_));
  return file;
}

ScopedVariable::ScopedVariable(const char* name, const std::string& value) : name_(name) {
  if (const char* before = std::getenv(name)) before_ = before;
  setenv(name, value.c_str(), 1);
}

ScopedVariable::~ScopedVariable() {
  if (before_)
    setenv(name_, before_->c_str(), 1);
  else
    unsetenv(name_);
}

}  // namespace inkbench
