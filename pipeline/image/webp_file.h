// SPDX-License-Identifier: MIT
// Small lossy pictures for inside other files. In: a picture. Out: the bytes of a WebP file.
#pragma once

#include <string>

#include "pipeline/image/image.h"

namespace inkbench {

/// 1 to 16,383 px a side, 3 channels, `quality` 1 to 100. The same picture gives the same bytes. Errors
/// (work): it cannot be encoded.
std::string encode_webp(const Picture& picture, int quality);

}  // namespace inkbench
