// SPDX-License-Identifier: MIT
// Pictures made in memory, onto the GPU.
#pragma once

#include <string>

#include "pipeline/gl/texture.h"
#include "pipeline/image/image.h"

namespace inkbench {

/// An rgba8 texture of an H x W x 3 or H x W x 4 picture; opaque where it does not say. Errors (work): larger
/// than the driver allows.
Texture texture_of(const std::string& label, const Picture& picture);

}  // namespace inkbench
