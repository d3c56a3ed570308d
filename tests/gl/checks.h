// SPDX-License-Identifier: MIT
// What the GL tests share: images to try, textures from images, comparisons that name the worst pixel,
// temporary folders and environment variables.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "pipeline/base/error.h"
#include "pipeline/base/scratch_folder.h"
#include "pipeline/buffers.h"
#include "pipeline/gl/texture.h"
#include "tests/gl/cpu_reference.h"

namespace inkbench {

/// Values from `low` to `high` that differ from pixel to pixel; the same seed gives the same image.
Image noise(int width_px, int height_px, int channels, uint32_t seed, float low = 0.0F, float high = 1.0F);

/// One channel, `value(x, y)`.
Image make_image(int width_px, int height_px, const std::function<double(int x, int y)>& value);

/// A normal map with a depth map in its alpha, as the edge passes read them.
Image with_depth(const Image& normal, const Image& depth);

/// A texture that holds the image: 1 channel r32f, 2 rg32f, 4 rgba32f; 3 channels go to rgba32f with alpha 1.
Texture to_texture(const Image& image);

/// Whether no sample differs by more than the tolerance; pixels whose mask is not 0 do not count.
testing::AssertionResult is_near(const Image& actual, const Image& expected, double tolerance,
                                 const ImageOf<uint8_t>* leave_out = nullptr);
testing::AssertionResult is_near(const Image& actual, const reference::Map& expected, double tolerance,
                                 const ImageOf<uint8_t>* leave_out = nullptr);

/// Share of the mask's pixels that are not 0: a comparison that leaves most of the image out shows nothing.
double share_of(const ImageOf<uint8_t>& mask);

/// Largest difference between two images of one size.
double largest_difference(const Image& a, const Image& b);

/// The buffers that are textures, in the table's order.
std::vector<BufferName> framebuffers();

/// What the action throws as an input error, or nothing and a test failure.
std::string input_error_of(const std::function<void()>& action);

class TempFolder {
 public:
  const std::filesystem::path& path() const { return scratch_.path(); }
  /// Writes a file inside the folder, each time with a later time of change; returns its path.
  std::filesystem::path write(const std::string& name, std::string_view content);

 private:
  ScratchFolder scratch_;
  int writes_ = 0;
};

/// Sets an environment variable for as long as the object lives.
class ScopedVariable {
 public:
  ScopedVariable(const char* name, const std::string& value);
  ScopedVariable(const ScopedVariable&) = delete;
  ScopedVariable& operator=(const ScopedVariable&) = delete;
  ~ScopedVariable();

 private:
  const char* name_;
  std::optional<std::string> before_;
};

}  // namespace inkbench
